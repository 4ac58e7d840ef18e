# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every kind of light from Python, against closed forms."""

from datetime import datetime, timedelta, timezone
from math import cos, pi, radians

import numpy as np
import pytest

import lumitree
from lumitree.lightspec import parse_light

# A receiver in the origin that looks up: the first point of a small triangle.
HERE = (np.array([(0.0, 0, 0), (1e-6, 0, 0), (0, 1e-6, 0)]), np.array([(0, 1, 2)]))
SQUARE = ((-0.5, -0.5, 1), (-0.5, 0.5, 1), (0.5, -0.5, 1))


def at_origin(*lights):
    return lumitree.irradiance(HERE, list(lights), at="points", shadows=False).values[0]


def field(light, name):
    return light.GetFieldData().GetArray(name).GetValue(0)


def test_closed_forms():
    below = (0, 0, -1)
    assert at_origin(lumitree.spot_light((0, 0, 2), below, intensity=40.0)) == pytest.approx(10.0)
    lobe = lumitree.spot_light((0, 0, 2), below, 1000.0, exponent=20)
    assert at_origin(lobe) == pytest.approx(3342.253804929802 / 4)
    sphere = lumitree.sphere_light((0, 0, 3), 1.0, radiance=100.0)
    assert at_origin(sphere) == pytest.approx(100 * pi / 9)
    disk = lumitree.disk_light((0, 0, 2), below, 1.0, exitance=100.0 * pi)
    assert at_origin(disk) == pytest.approx(62.83185307179586)
    square = lumitree.rectangle_light(*SQUARE, radiance=100.0)
    assert at_origin(square) == pytest.approx(75.22746884541075)
    tube = lumitree.tube_light((0, 0, 2), (1.2, 0, 2), 0.25, radiance=100.0)
    assert at_origin(tube) == pytest.approx(13.12872732613554)
    line = lumitree.line_light((0, 0, 2), (1.2, 0, 2), intensity_per_metre=100.0)
    assert at_origin(line) == pytest.approx(24.53989927147049)
    sun = lumitree.directional_light((0, 3, -4), 1000.0, angular_diameter=0.533)
    assert at_origin(sun) == pytest.approx(800.0)


def test_areas():
    points = np.array([SQUARE[0], SQUARE[1], (0.5, 0.5, 1), SQUARE[2]], dtype=float)
    mesh = (points, np.array([(0, 1, 2), (0, 2, 3)]))
    by_flux = lumitree.area_light(mesh, flux=200.0 * pi, two_sided=True)
    assert at_origin(by_flux) == pytest.approx(75.22746884541075)
    with pytest.raises(ValueError, match="one of radiance, exitance and flux"):
        lumitree.area_light(mesh)
    with pytest.raises(ValueError, match="one of radiance, exitance and flux"):
        lumitree.area_light(mesh, flux=1.0, radiance=1.0)
    with pytest.raises(lumitree.LumitreeError, match="no cell array"):
        lumitree.area_light(mesh, radiance="bright")
    with pytest.raises(ValueError, match="must be a number"):
        lumitree.sphere_light((0, 0, 0), 1.0, radiance="bright")


def test_skies():
    assert at_origin(lumitree.sky_light(zenith_radiance=1.0)) == pytest.approx(pi)
    overcast = lumitree.sky_light("overcast", zenith_radiance=1.0)
    assert at_origin(overcast) == pytest.approx(7 * pi / 9)
    clear = lumitree.sky_light(12, zenith_radiance=1.0, sun_zenith=45, sun_azimuth=123)
    assert at_origin(clear) == pytest.approx(4.848524088837507)
    weather = lumitree.sky_light("all_weather", direct_normal=500.0, horizontal_irradiance=150.0)
    assert at_origin(weather) == pytest.approx(150.0)
    for wrong in ("blue", 0, 16, True):
        with pytest.raises(ValueError, match="model is"):
            lumitree.sky_light(wrong, zenith_radiance=1.0)
    with pytest.raises(ValueError, match="one of zenith_radiance"):
        lumitree.sky_light("uniform")


def test_the_sun_of_golden_colorado():
    """The worked example of NREL's solar position algorithm."""
    when = datetime(2003, 10, 17, 12, 30, 30, tzinfo=timezone(timedelta(hours=-7)))
    sun = lumitree.sun_light(when, 39.742476, -105.1786, 900.0)
    assert field(sun, "SunZenith [deg]") == pytest.approx(50.1116, abs=0.01)
    assert field(sun, "SunAzimuth [deg]") == pytest.approx(194.3402, abs=0.001)
    expected = 900 * cos(radians(field(sun, "SunZenith [deg]")))
    assert at_origin(sun) == pytest.approx(expected)
    night = lumitree.sun_light(when + timedelta(hours=12), 39.742476, -105.1786)
    assert at_origin(night) == 0.0


IES = "IESNA91\nTILT=NONE\n1 -1 1 3 1 1 2 0 0 0 1 1 5\n0 45 90\n0\n100 80 0\n"


def test_photometric_files(tmp_path):
    path = tmp_path / "lamp.ies"
    path.write_text(IES)
    lamp = lumitree.photometric_light(path, (0, 0, 2), scale=2.0)
    assert at_origin(lamp) == pytest.approx(50.0)
    assert lamp.GetFieldData().GetArray("StatedLuminousFlux [lm]") is None
    path.write_text(IES.replace("100 80 0", "100 x 0"))
    with pytest.raises(lumitree.LumitreeError, match="line 6: .*\"x\""):
        lumitree.photometric_light(path, (0, 0, 2))


def test_efficacy():
    wavelengths = np.linspace(360, 780, 85)
    white = lumitree.luminous_efficacy(wavelengths, np.ones(85))
    assert white == pytest.approx(683 * 106.857 / 420, rel=1e-3)
    with pytest.raises(ValueError, match="wavelengths must grow"):
        lumitree.luminous_efficacy([500, 400], [1, 1])
    lamp = lumitree.point_light((0, 0, 2), 4 * pi * 4)
    lumens = lumitree.point_light((0, 0, 2), 4 * pi * 4 * 100, system="photometric")
    with pytest.raises(lumitree.LumitreeError, match="luminous efficacy"):
        at_origin(lamp, lumens)
    assert at_origin(lamp, lumitree.convertible(lumens, 100.0)) == pytest.approx(2 * at_origin(lamp))
    with pytest.raises(ValueError, match="efficacy"):
        lumitree.convertible(lumens, 0.0)


def test_lights_of_the_command_line(tmp_path):
    path = tmp_path / "lamp.ies"
    path.write_text(IES)
    expected = {
        "spot:0,0,2:0,0,-1:100:20,30": None,
        "sun:0,3,-4:1000:0.533": 800.0,
        "sphere:0,0,3:1:100": 100 * pi / 9,
        "rectangle:-.5,-.5,1:-.5,.5,1:.5,-.5,1:100W/m2sr": 75.22746884541075,
        "tube:0,0,2:1.2,0,2:0.25:100cd/m2": 13.12872732613554,
        "sky:overcast:100lx": 100.0,
        "sky:12:100": 100.0,
        f"ies:{path}:0,0,2": 25.0,
    }
    for text, value in expected.items():
        got = at_origin(parse_light(text))
        assert got > 0 if value is None else got == pytest.approx(value), text
    for text in ("ies:lamp", "spot:0,0,2:1", "tube:0,0,0:1", "laser:1"):
        with pytest.raises(ValueError, match="is not written as"):
            parse_light(text)


def test_the_sky_follows_the_sun():
    def sky_at(hour, **options):
        sun = lumitree.sun_light(datetime(2024, 6, 21, hour, tzinfo=timezone.utc), 48.1, 11.6)
        sky = lumitree.sky_light(
            "all_weather", direct_normal=800.0, horizontal_irradiance=100.0, sun=sun, **options
        )
        return sun.GetFieldData(), sky.GetFieldData()

    sun, sky = sky_at(9)
    towards = np.array(sky.GetArray("SkyTowardsSun").GetTuple(0))
    assert towards == pytest.approx(-np.array(sun.GetArray("LightDirection").GetTuple(0)))
    level = "DiffuseHorizontalIrradiance [W/m^2]"
    assert sky.GetArray(level).GetValue(0) == 100.0
    _, night = sky_at(23, ground_radiance=3.0)
    assert night.GetArray(level).GetValue(0) == 0.0
    assert night.GetArray("GroundRadiance [W/(m^2 sr)]").GetValue(0) == 0.0
    with pytest.raises(lumitree.LumitreeError):
        lumitree.sky_light("uniform", zenith_radiance=1.0, sun=lumitree.scene("sphere"))
    with pytest.raises(ValueError):
        lumitree.sky_light("uniform", zenith_radiance=1.0, sun="noon")
