# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes and a brute force in numpy to test against."""

import numpy as np

Arrays = tuple[np.ndarray, np.ndarray]


def floor(z: float = 0.0, size: float = 10.0, dtype: type = np.float64) -> Arrays:
    """Two triangles: a square in the plane z, facing up."""
    half = size / 2
    points = [(-half, -half, z), (half, -half, z), (half, half, z), (-half, half, z)]
    return np.array(points, dtype), np.array([(0, 1, 2), (0, 2, 3)])


def joined(*meshes: Arrays) -> Arrays:
    """Several meshes as one."""
    starts = np.cumsum([0] + [len(points) for points, _ in meshes])
    triangles = [ids + start for (_, ids), start in zip(meshes, starts)]
    return np.concatenate([points for points, _ in meshes]), np.concatenate(triangles)


def random_triangles(count: int, seed: int = 1, dtype: type = np.float64) -> Arrays:
    """Unconnected triangles in the unit cube."""
    rng = np.random.default_rng(seed)
    centres = rng.random((count, 1, 3))
    points = (centres + 0.3 * (rng.random((count, 3, 3)) - 0.5)).reshape(-1, 3).astype(dtype)
    return points, np.arange(3 * count).reshape(-1, 3)


def random_rays(count: int, seed: int = 2, dtype: type = np.float64) -> Arrays:
    """Rays from in and around the unit cube towards places in it, of any length."""
    rng = np.random.default_rng(seed)
    origins = 3.0 * rng.random((count, 3)) - 1.0
    directions = (rng.random((count, 3)) - origins) * rng.uniform(0.1, 10.0, (count, 1))
    return origins.astype(dtype), directions.astype(dtype)


def moller_trumbore(mesh: Arrays, origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
    """t, u and v of every ray (rows) with the plane of every triangle (columns); t is inf outside
    of it.

    Möller and Trumbore, Fast, minimum storage ray/triangle intersection, 1997; in float64.
    """
    p0, p1, p2 = (mesh[0].astype(float)[mesh[1][:, i]] for i in range(3))
    origins, directions = origins.astype(float), directions.astype(float)
    e1, e2 = p1 - p0, p2 - p0
    across = np.cross(directions[:, None], e2[None])
    determinant = np.einsum("tk,rtk->rt", e1, across)
    to_origin = origins[:, None] - p0[None]
    around = np.cross(to_origin, e1[None])
    with np.errstate(divide="ignore", invalid="ignore"):
        u = np.einsum("rtk,rtk->rt", to_origin, across) / determinant
        v = np.einsum("rk,rtk->rt", directions, around) / determinant
        t = np.einsum("tk,rtk->rt", e2, around) / determinant
        inside = (u >= 0) & (v >= 0) & (u + v <= 1) & (t >= 0)
    return np.where(inside, t, np.inf), u, v
