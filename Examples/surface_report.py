# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether a surface is closed, and what that is worth: rays from inside get out through its holes."""

import numpy as np

import lumitree

ball = lumitree.scene("sphere", resolution=8)
teapot = lumitree.scene("teapot", resolution=8)
try:
    lumitree.surface_report(ball)
except lumitree.LumitreeError as error:
    raise SystemExit(f"skipped: {error}") from None
for name, surface in (("ball", ball), ("teapot", teapot)):
    report = lumitree.surface_report(surface)
    facts = report.facts
    print(f"{name:7}{facts['Verdict']}; {facts['BoundaryLoops']} boundary loops")
    assert bool(facts["BoundaryEdges"]) != bool(facts["WatertightApplies"])

# The promises are kept: from inside the ball every ray meets it, an odd number of times.
directions = np.random.default_rng(1).normal(size=(2000, 3))
caster = lumitree.Caster(ball, precision="exact")
counts = caster.cast(np.zeros(3), directions, query="count").count
assert lumitree.surface_report(ball).facts["InsideOutsideApplies"]
assert (counts % 2 == 1).all()

# A hole: without one of its triangles the ball has a boundary loop of three edges.
from vtkmodules.util.numpy_support import vtk_to_numpy

points = vtk_to_numpy(ball.GetPoints().GetData())
triangles = vtk_to_numpy(ball.GetPolys().GetConnectivityArray()).reshape(-1, 3)
holed = lumitree.surface_report((points, triangles[1:]))
print(f"holed  {holed.facts['Verdict']}; {holed.facts['BoundaryLoops']} boundary loop")
assert holed.edges.GetNumberOfCells() == 1 and holed.edges.GetCell(0).GetNumberOfPoints() == 4

# As in an STL file, where each triangle brings its own points: rays see no difference.
soup = points[triangles.ravel()], np.arange(triangles.size).reshape(-1, 3)
assert lumitree.surface_report(soup).facts["Closed"]
assert not lumitree.surface_report(soup, merge_coincident_points=False).facts["Closed"]
