# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two back ends, one set of rays: on which do they differ, and who is right?"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import lumitree

# A sphere with float points; rays from inside at all of its vertices, and at the middles of edges.
ball = lumitree.scene("sphere", resolution=12)
points = vtk_to_numpy(ball.GetPoints().GetData()).astype(np.float32)
triangles = vtk_to_numpy(ball.GetPolys().GetConnectivityArray()).reshape(-1, 3)
inside = np.array([0.31, -0.27, 0.13])
edges = (points[triangles[:, 0]].astype(float) + points[triangles[:, 1]]) / 2
rays = lumitree.rays(inside, np.concatenate([points, edges]) - inside)

for precision in ("fast", "watertight", "exact"):
    found = lumitree.disagreements((points, triangles), rays, "bvh", precision)
    counts = found.counts
    print(
        f"{precision:11}{counts['Agree']:6} of {counts['Rays']} agree with the exact answer;",
        ", ".join(
            f"{counts[kind]} {kind}"
            for kind in ("Missed", "Phantom", "OtherPrimitive", "Far", "Tie")
        ),
    )
    assert len(found.ray_id) == counts["Rays"] - counts["Agree"]
    if precision == "watertight":
        assert counts["Missed"] == 0  # nothing gets through a closed surface
    if precision == "exact":
        assert counts["Agree"] == counts["Rays"]
    if len(sys.argv) > 1 and precision == "fast":
        lumitree.write(found.lines, sys.argv[1])
