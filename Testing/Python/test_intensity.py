# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Solid angles, intensities, sensor grids, and irradiance to a tolerance."""

import numpy as np
import pytest
from meshes import floor

import lumitree

SQUARE = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], float), np.array([(0, 2, 1), (0, 3, 2)])


def test_solid_angle_of_a_square():
    """Six of them are a cube."""
    omega = lumitree.solid_angle([(0.5, 0.5, 0.5), (0.5, 0.5, -0.5)], SQUARE)
    assert omega == pytest.approx([4 * np.pi / 6, -4 * np.pi / 6], rel=1e-12)
    seen = lumitree.solid_angle([(0.5, 0.5, -0.5)], SQUARE, visible=True)
    assert seen == pytest.approx([4 * np.pi / 6], rel=1e-9)


def test_lambertian_square(tmp_path):
    file = tmp_path / "square.ldt"
    light = lumitree.radiant_intensity(SQUARE, 100.0, "radiance", planes=4, steps=90, file=file)
    assert light.values.shape == (91, 4) and light.unit == "W/sr"
    assert light.values[30] == pytest.approx([100 * np.cos(np.radians(60))] * 4, rel=1e-6)
    assert light.emitted_flux == pytest.approx(100 * np.pi)
    assert light.integrated_flux == pytest.approx(light.emitted_flux, rel=1e-3)
    assert light.far_field_distance == pytest.approx(5 * np.sqrt(2))
    assert file.stat().st_size > 1000


@pytest.mark.parametrize("extension", ["ies", "ldt"])
def test_any_light_as_a_photometric_file(tmp_path, extension):
    file = tmp_path / f"lamp.{extension}"
    lumitree.write(lumitree.point_light((1, 2, 3), 1000.0, system="photometric"), file)
    again = lumitree.photometric_light(file, (0, 0, 0))
    assert again.GetFieldData().GetArray("LuminousFlux [lm]").GetValue(0) == pytest.approx(1000.0)
    lumitree.write(again, tmp_path / f"again.{extension}")  # by its own angles
    assert (tmp_path / f"again.{extension}").read_bytes().splitlines()[-30:] == (
        file.read_bytes().splitlines()[-30:]
    )
    solid = lumitree.radiant_intensity(SQUARE, 100.0, "radiance", planes=4, steps=90).solid
    lumitree.write(solid, tmp_path / f"square.{extension}")
    square = lumitree.photometric_light(tmp_path / f"square.{extension}", (0, 0, 0))
    flux = square.GetFieldData().GetArray("LuminousFlux [lm]").GetValue(0)
    assert flux == pytest.approx(100 * np.pi, rel=1e-3)
    for wrong in (lumitree.sky_light("uniform", zenith_radiance=1.0), lumitree.scene("sphere")):
        with pytest.raises(lumitree.LumitreeError):
            lumitree.write(wrong, tmp_path / f"none.{extension}")
    with pytest.raises(lumitree.LumitreeError):
        lumitree.write(again, tmp_path / "nowhere" / f"lamp.{extension}")


def test_sensor_grid_by_the_standard():
    assert lumitree.sensor_grid((0, 0, 0), (5, 0, 0), (0, 4, 0)).GetNumberOfCells() == 63


def test_what_is_asked_for_is_there():
    sun = lumitree.directional_light((0, 3, -4), 1000.0)
    light = lumitree.irradiance(
        floor(), sun, quantities=["back", "scalar", "vector", "cylindrical", "hemispherical", "shadow"]
    )
    assert light.quantities["back"].tolist() == [0.0, 0.0]
    assert light.quantities["scalar"] == pytest.approx([1000.0, 1000.0])
    assert light.quantities["vector"][0] == pytest.approx([0.0, -600.0, 800.0])
    assert light.quantities["cylindrical"] == pytest.approx([600.0 / np.pi] * 2)
    assert light.quantities["hemispherical"] == pytest.approx([450.0] * 2)
    assert light.quantities["shadow"].tolist() == [0, 0]
    assert light.method.tolist() == [lumitree.EstimateMethod.SIGHTLINE] * 2
    assert light.lower == pytest.approx(light.values) and light.upper == pytest.approx(light.values)
    assert light.statistics["Uniformity"] == pytest.approx(1.0)


@pytest.mark.parametrize(
    "wrong",
    [
        lambda: lumitree.solid_angle([(0, 0)], SQUARE),
        lambda: lumitree.solid_angle([(0, 0, 0)], SQUARE, tolerance=2),
        lambda: lumitree.radiant_intensity(SQUARE, -1.0),
        lambda: lumitree.radiant_intensity(SQUARE, emission="power"),
        lambda: lumitree.radiant_intensity(SQUARE, planes=0),
        lambda: lumitree.sensor_grid((0, 0, 0), (1, 0, 0), (0, 1, 0), margin=-1),
        lambda: lumitree.irradiance(
            floor(), lumitree.point_light((0, 0, 1), 1.0), quantities=["glare"]
        ),
        lambda: lumitree.irradiance(floor(), lumitree.point_light((0, 0, 1), 1.0), tolerance="1 %"),
    ],
)
def test_wrong_arguments(wrong):
    with pytest.raises(ValueError):
        wrong()


def test_what_the_filters_refuse():
    with pytest.raises(lumitree.LumitreeError):
        lumitree.sensor_grid((0, 0, 0), (1, 0, 0), (2, 0, 0))
    with pytest.raises(lumitree.LumitreeError):
        lumitree.radiant_intensity(lumitree.directional_light((0, 0, -1), 1.0))
