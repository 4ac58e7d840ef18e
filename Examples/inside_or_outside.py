# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which points of a grid lie inside a closed surface? A ray from inside leaves it an odd number of
times, also where it passes exactly through edges and vertices, which counting hits gets wrong."""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

import lumitree

# A ball of triangles whose vertices stand above and beside points of the grid.
ball = lumitree.scene("sphere", resolution=8)
n = 41
grid = vtkImageData()
grid.SetDimensions(n, n, n)
grid.SetOrigin(-1, -1, -1)
grid.SetSpacing(*[2 / (n - 1)] * 3)
points = np.array([grid.GetPoint(i) for i in range(n**3)])

inside = lumitree.inside(ball, points)
print(f"{inside.sum():,} of {n**3:,} points are inside")

# Whatever the direction of the rays, the answer is the same.
for direction in ((1, 0, 0), (0, -1, 0), (1, 1, 1), (0.2, -0.5, 0.7)):
    cast = lumitree.cast(ball, points, direction, query="crossings")
    print(f"along {direction}: {cast.statistics['ExactTests']:,} questions decided exactly")
    assert (cast.inside == inside).all()

# Rays through edges hit two triangles, through vertices five or six: their number tells nothing.
hits = lumitree.cast(ball, points, (0, 0, 1), query="count", precision="exact")
wrong = ((hits.count % 2 == 1) != inside).sum()
print(f"counting hits would have got {wrong:,} points wrong")
assert wrong > 0

# The corners of the ball lie on the unit sphere, its faces a little below.
radius = np.linalg.norm(points, axis=1)
assert inside[radius < 0.97].all() and not inside[radius > 1.0].any()

marks = numpy_to_vtk(inside.astype(np.uint8), deep=1)
marks.SetName("Inside")
grid.GetPointData().SetScalars(marks)
lumitree.write(grid, sys.argv[1] if len(sys.argv) > 1 else "inside.vti")
