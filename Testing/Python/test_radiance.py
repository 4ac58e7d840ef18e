# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Radiance along rays and by direction."""

import numpy as np
import pytest
from meshes import floor

import lumitree
from lumitree.surfaces import as_surface

CEILING = np.array([(-9, -9, 2), (9, -9, 2), (9, 9, 2), (-9, 9, 2)], float), np.array([(0, 1, 2), (0, 2, 3)])


def test_a_panel_before_the_sky():
    panel = lumitree.rectangle_light((-1, -1, 3), (-1, 1, 3), (1, -1, 3), radiance=50.0)
    sky = lumitree.sky_light("uniform", zenith_radiance=2.0)
    seen = lumitree.radiance([(0, 0, 0), (5, 0, 0)], [(0, 0, 0.1), (0, 0, 2)], [panel, sky])
    assert seen.name == "Radiance [W/(m^2 sr)]" and seen.unit == "W/(m^2 sr)"
    level = seen.values[1]
    assert level > 0 and seen.values[0] == pytest.approx(50.0 + level)
    hidden = lumitree.radiance((0, 0, 0), (0, 0, 1), [panel, sky], CEILING)
    assert hidden.values.tolist() == [0.0]
    short = lumitree.radiance((0, 0, 0), (0, 0, 1), [panel, sky], t_max=3.5)
    assert short.values == pytest.approx([50.0])


def test_an_image_of_a_lit_floor():
    lamp = lumitree.point_light((0.5, 0.5, 2), 4000.0 * np.pi, system="photometric")
    camera = lumitree.camera_rays((0.5, 0.5, 1), (0.5, 0.5, 0), up=(0, 1, 0), angle=1, size=(3, 3))
    image = lumitree.radiance(camera, lights=lamp, occluders=floor(), reflectance=0.5)
    assert image.name == "Luminance [cd/m^2]"
    assert image.dataset.GetDimensions() == (3, 3, 1)
    assert image.values[4] == pytest.approx(0.5 * 250.0 / np.pi, rel=1e-6)


def test_directions_add_up_to_the_irradiance():
    sky = lumitree.sky_light("overcast", horizontal_irradiance=10000.0, system="photometric")
    seen = lumitree.radiance_around([(0, 0, 0), (1, 2, 3)], sky, rings=90, sectors=36)
    assert seen.values.shape == (2, 90 * 36)
    assert seen.solid_angles.sum() == pytest.approx(4 * np.pi)
    cosine = np.maximum(0, seen.directions[:, 2])
    assert (seen.values * seen.solid_angles * cosine).sum(axis=1) == pytest.approx(10000.0, rel=1e-3)
    on_floor = lumitree.radiance_around(as_surface(floor()), sky, floor(), rings=4, sectors=4)
    assert (on_floor.values[:, :8] > 0).all() and (on_floor.values[:, 8:] == 0).all()


@pytest.mark.parametrize(
    "wrong",
    [
        lambda sky: lumitree.radiance((0, 0, 0), lights=sky),
        lambda sky: lumitree.radiance((0, 0, 0), (0, 0, 1), ["lamp"]),
        lambda sky: lumitree.radiance((0, 0, 0), (0, 0, 1), sky, reflectance=2),
        lambda sky: lumitree.radiance_around([(0, 0)], sky),
        lambda sky: lumitree.radiance_around([(0, 0, 0)], sky, rings=0),
    ],
)
def test_wrong_arguments(wrong):
    with pytest.raises(ValueError):
        wrong(lumitree.sky_light("uniform", zenith_radiance=1.0))


def test_what_the_filter_refuses():
    with pytest.raises(lumitree.LumitreeError):
        lumitree.radiance((0, 0, 0), (0, 0, 1), [])
    sky = lumitree.sky_light("uniform", zenith_radiance=1.0)
    with pytest.warns(lumitree.LumitreeWarning):
        seen = lumitree.radiance((0, 0, 0), [(0, 0, 1), (0, 0, 0)], sky)
    assert np.isnan(seen.values[1])
