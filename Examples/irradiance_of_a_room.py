# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""A lamp in a closed room: all the light that it emits is received somewhere."""

import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import lumitree

room = lumitree.scene("cornell_box", resolution=64)
lamp = lumitree.point_light(position=(0.5, 0.5, 0.9), flux=100.0)  # W
light = lumitree.irradiance(room, lamp)
print(f"{light.name}: {light.values.min():.1f} to {light.values.max():.1f}")

# Area of each quad, from its diagonals.
corners = vtk_to_numpy(room.GetPoints().GetData())[
    vtk_to_numpy(room.GetPolys().GetConnectivityArray()).reshape(-1, 4)
]
diagonals = corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]
areas = np.linalg.norm(np.cross(*diagonals), axis=1) / 2
received = float(light.values @ areas)
print(f"received in all: {received:.2f} W of 100 W")
assert abs(received - 100.0) < 1.0

lumitree.write(light.dataset, sys.argv[1] if len(sys.argv) > 1 else "irradiance.vtp")
