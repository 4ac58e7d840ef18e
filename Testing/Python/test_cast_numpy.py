# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""`cast` against a brute force in numpy."""

import numpy as np
import pytest
from meshes import moller_trumbore, random_rays, random_triangles

import lumitree


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("precision", ["fast", "watertight", "exact"])
def test_every_query_agrees(structure, precision, dtype):
    mesh, rays = random_triangles(300, dtype=dtype), random_rays(400, dtype=dtype)
    t, u, v = moller_trumbore(mesh, *rays)
    nearest = t.argmin(axis=1)
    hit = np.isfinite(t).any(axis=1)
    caster = lumitree.Caster(mesh, structure=structure, precision=precision)

    closest = caster.cast(*rays)
    assert 50 < hit.sum() < 350
    np.testing.assert_array_equal(closest.hit, hit)
    np.testing.assert_array_equal(closest.cell_id, np.where(hit, nearest, -1))
    rows = np.flatnonzero(hit), nearest[hit]
    np.testing.assert_allclose(closest.t[hit], t[rows], rtol=1e-9)
    np.testing.assert_allclose(closest.uv[hit], np.transpose([u[rows], v[rows]]), atol=1e-9)

    everything = caster.cast(*rays, query="all")
    np.testing.assert_array_equal(everything.count, np.isfinite(t).sum(axis=1))
    for ray in range(len(t)):
        order = np.argsort(t[ray])[: everything.count[ray]]
        run = slice(*everything.offsets[ray : ray + 2])
        np.testing.assert_array_equal(everything.cell_id[run], order)
        np.testing.assert_array_equal(everything.ray_id[run], ray)

    np.testing.assert_array_equal(caster.cast(*rays, query="any").hit, hit)
    np.testing.assert_array_equal(caster.cast(*rays, query="count").count, everything.count)


def test_far_coordinates_keep_their_digits():
    """A map in UTM metres: float32 has steps of half a metre there."""
    far = np.array([500000.0, 5400000.0, 300.0])
    points, triangles = random_triangles(300)
    origins, directions = random_rays(400)
    near = lumitree.cast((points, triangles), origins, directions)
    moved = lumitree.cast((points + far, triangles), origins + far, directions)
    np.testing.assert_array_equal(moved.cell_id, near.cell_id)
    np.testing.assert_allclose(moved.t[moved.hit], near.t[near.hit], rtol=1e-6, atol=1e-7)
    assert moved.point.dtype == np.float64
    np.testing.assert_allclose(moved.point[moved.hit] - far, near.point[near.hit], atol=1e-6)
