# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The second plugin adds CGAL to the filters of the first; its hits are those of the exact precision."""

import os

import numpy as np
from paraview import simple

from pvtesting import fetch, load_plugin, point_array

load_plugin()
simple.LoadPlugin(os.path.join(os.environ["LUMITREE_PLUGIN_DIR"], "LumitreeReference", "LumitreeReference.so"))

# Parallel rays in a grid meet edges and corners of the mesh: many ties.
torus = simple.BuiltinScene(Scene="Torus", Resolution=6)
rays = simple.Rays(Origin=[-2, -2, 2], Point1=[-2, 2, 2], Point2=[2, -2, 2], Resolution=[25, 25])
hits = {}
for structure in ("CGAL", "BVH"):
    cast = simple.RayCast(Input=torus, Rays=rays, Query="All", Structure=structure, Precision="Exact")
    hits[structure] = fetch(cast)
    assert hits[structure].GetNumberOfPoints() > 100
for name in ("RayId", "CellId"):
    assert np.array_equal(point_array(hits["CGAL"], name), point_array(hits["BVH"], name)), name
assert np.allclose(point_array(hits["CGAL"], "T"), point_array(hits["BVH"], "T"), rtol=1e-15)
