# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rows of solar panels through a day: sun and sky, and how much the front row takes from the next."""

import numpy as np

import lumitree
from lumitree.vtk import vtkLumiSky, vtkLumiSun


def panel(y, tilt=np.radians(30), depth=2.0, width=20.0, cells=(20, 6)):
    """A row that faces south (-y), as a grid of quads, and the sensors on it."""
    origin = np.array([-width / 2, y, 0.5])
    across = np.array([width, 0, 0])
    up = depth * np.array([0, np.cos(tilt), np.sin(tilt)])
    points = np.array([origin + across * i / cells[0] + up * j / cells[1]
                       for j in range(cells[1] + 1) for i in range(cells[0] + 1)])  # fmt: skip
    a = np.array([j * (cells[0] + 1) + i for j in range(cells[1]) for i in range(cells[0])])
    quads = np.stack([a, a + 1, a + cells[0] + 2, a + cells[0] + 1], axis=1)
    return points, np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


front, back = panel(0.0), panel(3.0)
both = np.concatenate([front[0], back[0]]), np.concatenate([front[1], back[1] + len(front[0])])
sky = vtkLumiSky()
sky.SetModel(vtkLumiSky.Uniform)
sky.SetLevelQuantity(vtkLumiSky.HorizontalIrradiance)
sky.SetLevel(100.0)
sky.Update()

days = {}
for name, row in (("front", front), ("back", back)):
    energy = 0.0
    for hour in range(6, 19):
        sun = vtkLumiSun()
        sun.SetLatitude(47.0)
        sun.SetLongitude(8.0)
        sun.SetDate(2024, 12, 21)
        sun.SetHour(float(hour))
        sun.SetUTCOffset(1.0)
        sun.SetNormalIrradiance(800.0)
        sun.SetAngularDiameter(0.0)
        sun.Update()
        light = lumitree.irradiance(row, [sky.GetOutput(), sun.GetOutput()], occluders=both, tolerance=0.05)
        energy += float(light.values.mean())  # W/m2 for an hour
    days[name] = energy
    print(f"{name} row: {energy / 1000:.2f} kWh/m2 on 21 December")
assert 0.3 * days["front"] < days["back"] < 0.97 * days["front"]
