# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Irradiance against closed forms."""

import numpy as np
import pytest
from meshes import floor, joined
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet

import lumitree
from lumitree.reports import received
from lumitree.surfaces import as_surface


def corner_at(x, y, z=0.0):
    """A triangle facing up whose first point is the receiver."""
    return np.array([(x, y, z), (x + 1e-3, y, z), (x, y + 1e-3, z)]), np.array([(0, 1, 2)])


def test_point_over_a_plane():
    """E = I h / (h^2 + r^2)^(3/2), I = flux / 4 pi, at flux = 1000 W, h = 2 m, r = 1.5 m."""
    light = lumitree.irradiance(
        corner_at(1.5, 0.0), lumitree.point_light((0, 0, 2), 1000.0), at="points"
    )
    assert light.values[0] == pytest.approx(10.1859163578813, rel=1e-12)
    assert light.name == "Irradiance [W/m^2]" and light.unit == "W/m^2" and light.per_light == {}
    assert light.dataset.GetPointData().GetScalars().GetName() == light.name


@pytest.mark.parametrize(
    ("unit", "metres"),
    [("m", 1), ("mm", 1e-3), ("cm", 1e-2), ("km", 1e3), ("in", 0.0254), ("foot", 0.3048)],
)
def test_length_units(unit, metres):
    points, triangles = corner_at(1.5, 0.0)
    lamp = lumitree.point_light((0, 0, 2 / metres), 1000.0)
    light = lumitree.irradiance((points / metres, triangles), lamp, at="points", length_unit=unit)
    assert light.values[0] == pytest.approx(10.1859163578813, rel=1e-9)
    fields = light.dataset.GetFieldData()
    assert fields.GetArray("MetresPerUnit").GetValue(0) == pytest.approx(metres)


def test_parallel_light_falls_with_the_cosine():
    sun = lumitree.directional_light((0, 3, -4), 1000.0)
    assert lumitree.irradiance(floor(), sun).values == pytest.approx([800.0, 800.0])
    from_below = lumitree.directional_light((0, 3, 4), 1000.0)
    assert lumitree.irradiance(floor(), from_below).values.tolist() == [0.0, 0.0]


def test_shadows_and_occluders():
    roof, ground = floor(1.0, size=2.0), floor(0.0, size=1.0)
    sun = lumitree.directional_light((0, 0, -1), 500.0)
    both = joined(roof, ground)
    assert lumitree.irradiance(both, sun).values.tolist() == [500.0, 500.0, 0.0, 0.0]
    assert lumitree.irradiance(both, sun, shadows=False).values.tolist() == [500.0] * 4
    assert lumitree.irradiance(ground, sun).values.tolist() == [500.0, 500.0]
    assert lumitree.irradiance(ground, sun, occluders=roof).values.tolist() == [0.0, 0.0]


def test_photometric_lights_give_lux():
    lamp = lumitree.point_light((0, 0, 2), 1000.0, system="photometric")
    light = lumitree.irradiance(corner_at(1.5, 0.0), lamp, at="points")
    assert light.values[0] == pytest.approx(10.1859163578813, rel=1e-12)
    assert light.name == "Illuminance [lx]" and light.unit == "lx"


def test_each_light_alone():
    lights = [
        lumitree.point_light((0, 0, 2), 1000.0, name="lamp"),
        lumitree.point_light((0, 0, 3), 1000.0, name="lamp"),
        lumitree.directional_light((0, 0, -1), 10.0),
    ]
    light = lumitree.irradiance(floor(), lights, per_light=True)
    assert list(light.per_light) == ["lamp", "lamp 2", "directional"]
    assert sum(light.per_light.values()) == pytest.approx(light.values)
    blocks = vtkMultiBlockDataSet()
    for i, each in enumerate(lights):
        blocks.SetBlock(i, each)
    assert lumitree.irradiance(floor(), blocks).values == pytest.approx(light.values)


def test_a_closed_room_receives_what_its_lamp_emits():
    room = lumitree.scene("cornell_box", resolution=60)
    light = lumitree.irradiance(room, lumitree.point_light((0.5, 0.4, 0.6), 100.0))
    assert received(light.dataset, light.name) == pytest.approx(100.0, rel=0.01)


def test_composite_receivers_come_one_after_the_other():
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, as_surface(floor(0.0, size=1.0)))
    blocks.SetBlock(1, as_surface(floor(1.0, size=2.0)))
    light = lumitree.irradiance(blocks, lumitree.directional_light((0, 0, -1), 7.0))
    assert light.values.tolist() == [0.0, 0.0, 7.0, 7.0]


def test_volumes_receive_from_all_sides():
    voxels = vtkImageData()
    voxels.SetDimensions(2, 2, 2)
    lamp = lumitree.point_light((0.5, 0.5, 2.5), 4 * np.pi)
    light = lumitree.irradiance(voxels, lamp, shadows=False)
    assert light.name == "ScalarIrradiance [W/m^2]"
    assert light.values == pytest.approx([0.25])


def test_no_normal_is_nan_and_told():
    flat = np.zeros((3, 3)), np.array([(0, 1, 2)])
    with pytest.warns(lumitree.LumitreeWarning):
        light = lumitree.irradiance(flat, lumitree.directional_light((0, 0, -1), 1.0))
    assert np.isnan(light.values).all()


def test_threads_do_not_change_a_bit():
    city = lumitree.scene("city", resolution=2)
    lamp = lumitree.point_light((5, 3, 90), 1e5)
    one, three = (lumitree.irradiance(city, lamp, threads=threads).values for threads in (1, 3))
    assert one.tobytes() == three.tobytes()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"at": "faces"}, "at is 'faces'; choose one of: points, cells"),
        ({"length_unit": "yard"}, r"choose one of: m \(metre\), mm \(millimetre\)"),
        ({"lights": ["sun"]}, "lights must be data sets, such as of point_light, not str"),
        ({"structure": "tree"}, "structure is 'tree'"),
        ({"occluders": 3}, "occluders must be a vtkDataSet"),
    ],
)
def test_wrong_arguments(change, message):
    arguments = {"mesh": floor(), "lights": lumitree.point_light((0, 0, 2), 1.0), **change}
    with pytest.raises(ValueError, match=message):
        lumitree.irradiance(**arguments)


def test_what_the_filters_refuse():
    watts = lumitree.point_light((0, 0, 2), 1.0)
    lumens = lumitree.point_light((0, 0, 2), 1.0, system="photometric")
    with pytest.raises(lumitree.LumitreeError):
        lumitree.irradiance(floor(), [watts, lumens])
    with pytest.raises(lumitree.LumitreeError):
        lumitree.irradiance(floor(), [])
    with pytest.raises(lumitree.LumitreeError):
        lumitree.point_light((0, 0, 2), -1.0)
    with pytest.raises(lumitree.LumitreeError):
        lumitree.directional_light((0, 0, 0), 1.0)
    with pytest.raises(ValueError, match="position must be three finite numbers"):
        lumitree.point_light((0, 0), 1.0)
    with pytest.raises(ValueError, match="choose one of: radiometric, photometric"):
        lumitree.point_light((0, 0, 1), 1.0, system="lumens")
