# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""A solar panel from sunrise to sunset: the sun's position, its direct light, an all-weather sky."""

from datetime import datetime, timedelta, timezone

import numpy as np

import lumitree

LATITUDE, LONGITUDE = 48.1, 11.6
ZONE = timezone(timedelta(hours=2))

# One panel, tilted by 30 degrees to the south (y is north).
slope = np.array([0.0, -np.cos(np.radians(30)), -np.sin(np.radians(30))])
panel = (
    np.array([(0, 0, 1), slope + (0, 0, 1), slope + (1, 0, 1), (1, 0, 1)], dtype=float),
    np.array([(0, 1, 2), (0, 2, 3)]),
)

energy = 0.0
highest = 90.0
for hour in range(5, 22):
    when = datetime(2024, 6, 21, hour, 0, tzinfo=ZONE)
    sun = lumitree.sun_light(when, LATITUDE, LONGITUDE, 800.0, angular_diameter=0.0)
    zenith = sun.GetFieldData().GetArray("SunZenith [deg]").GetValue(0)
    azimuth = sun.GetFieldData().GetArray("SunAzimuth [deg]").GetValue(0)
    if zenith >= 90.0:
        continue
    sky = lumitree.sky_light(
        "all_weather",
        direct_normal=800.0,
        horizontal_irradiance=100.0,
        sun=sun,
    )
    light = lumitree.irradiance(panel, [sun, sky], shadows=False)
    energy += light.values[0] / 1000.0
    highest = min(highest, zenith)
    print(f"{when:%H:%M}  zenith {zenith:5.1f}  azimuth {azimuth:5.1f}  {light.values[0]:6.1f} W/m^2")

print(f"in the day: {energy:.2f} kWh/m^2")
assert abs(highest - (LATITUDE - 23.44)) < 0.5  # noon by the clock is not quite the sun's
assert 5.0 < energy < 10.0
