# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The package inside ParaView's Python."""

import numpy as np
from paraview import simple

import lumitree

sphere = simple.Sphere(Radius=2.0, ThetaResolution=64, PhiResolution=64)
sphere.UpdatePipeline()
mesh = simple.servermanager.Fetch(sphere)
hits = lumitree.cast(mesh, (0.1, 0.2, 5.0), [(0, 0, -1), (0, 0, 1)])
assert hits.hit.tolist() == [True, False], hits.hit
assert abs(hits.t[0] - 3.0) < 0.02 and np.isposinf(hits.t[1])
light = lumitree.irradiance(mesh, lumitree.directional_light((0, 0, -1), 100.0), at="points")
assert abs(np.nanmax(light.values) - 100.0) < 1.0
print("cast and irradiance in pvpython")
