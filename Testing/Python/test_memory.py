# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is shared, what is converted, and what stays alive."""

import gc

import numpy as np
import pytest
from meshes import floor, random_rays, random_triangles
from vtkmodules.util.numpy_support import vtk_to_numpy

import lumitree
from lumitree.surfaces import as_surface


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_arrays_are_shared_not_copied(dtype):
    points, triangles = random_triangles(10, dtype=dtype)
    surface = as_surface((points, triangles))
    stored = vtk_to_numpy(surface.GetPoints().GetData())
    assert stored.dtype == dtype and np.shares_memory(stored, points)

    origins, directions = random_rays(10, dtype=dtype)
    rays = lumitree.rays(origins, directions)
    assert np.shares_memory(vtk_to_numpy(rays.GetPoints().GetData()), origins)
    assert np.shares_memory(vtk_to_numpy(rays.GetPointData().GetArray("RayDirection")), directions)

    hits = lumitree.cast(surface, origins, directions)
    assert hits.point.dtype == dtype
    passed = vtk_to_numpy(hits.rays.GetPointData().GetArray("RayDirection"))
    assert np.shares_memory(passed, directions)
    assert np.shares_memory(hits.t, vtk_to_numpy(hits.rays.GetPointData().GetArray("T")))


def test_double_rays_make_double_points():
    mesh = floor(dtype=np.float32)
    hits = lumitree.cast(mesh, np.array([(0.1, 0.2, 5.0)]), (0, 0, -1))
    assert hits.point.dtype == np.float64


def test_integers_become_float64():
    rays = lumitree.rays([(0, 0, 5)], np.array([(0, 0, -1)], np.int8))
    assert vtk_to_numpy(rays.GetPoints().GetData()).dtype == np.float64
    assert lumitree.cast(floor(), [(1, 2, 5)], [(0, 0, -1)]).t.tolist() == [5.0]


def test_memory_outlives_the_names():
    def caster():
        points, triangles = random_triangles(2000)
        return lumitree.Caster((points.copy(), triangles.copy()))

    def result(held):
        return held.cast(*random_rays(2000))

    held = caster()
    first = result(held)
    copy = first.t.copy(), first.uv.copy(), first.cell_id.copy()
    t, uv, cell_id = first.t, first.uv, first.cell_id
    del first
    gc.collect()
    for _ in range(3):
        result(held)
        np.ones(100000).cumsum()
    gc.collect()
    for kept, expected in zip((t, uv, cell_id), copy):
        np.testing.assert_array_equal(kept, expected)
    np.testing.assert_array_equal(result(held).t, t)
