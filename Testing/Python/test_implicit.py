# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Quadrics from numpy."""

import numpy as np
import pytest
from vtkmodules.vtkCommonDataModel import (
    vtkImplicitBoolean,
    vtkMultiBlockDataSet,
    vtkPerlinNoise,
    vtkSphere,
    vtkSuperquadric,
)

import lumitree


def test_a_sphere_is_met_exactly():
    ball = lumitree.implicit("sphere", (0, 0, 0), radius=0.1)
    hits = lumitree.cast(ball, [(0.0, 0.1, -3.0), (0.0, 0.05, -3.0)], (0, 0, 1), precision="exact")
    assert hits.hit.all()
    assert hits.t[0] == 3.0  # a tangent
    assert hits.t[1] == pytest.approx(3 - np.sqrt(0.0075), rel=1e-15)
    assert hits.normal[1] == pytest.approx((0, 0.5, -np.sqrt(0.75)), abs=1e-12)


def test_one_at_each_center():
    rng = np.random.default_rng(1)
    centers = rng.uniform(-5, 5, (200, 3))
    radii = rng.uniform(0.1, 0.5, 200)
    balls = lumitree.implicit("sphere", centers, radius=radii, preview=0)
    assert balls.GetNumberOfCells() == 200
    origins = rng.uniform(-8, 8, (500, 3))
    directions = rng.normal(size=(500, 3))
    hits = lumitree.cast(balls, origins, directions, precision="exact")
    # By the textbook.
    offset = origins[:, None] - centers
    a = (directions**2).sum(1)[:, None]
    b = (offset * directions[:, None]).sum(2)
    d = b * b - a * ((offset**2).sum(2) - radii**2)
    root = np.sqrt(np.where(d > 0, d, np.nan))
    t = np.stack([(-b - root) / a, (-b + root) / a])
    t = np.where(t >= 0, t, np.inf)
    wanted = np.nanmin(np.where(np.isnan(t), np.inf, t), axis=(0, 2))
    assert hits.t == pytest.approx(wanted, rel=1e-9)
    count = lumitree.cast(balls, origins, directions, precision="exact", query="count").count
    assert (count == (np.isfinite(t) & ~np.isnan(t)).sum((0, 2))).all()


def test_directions_and_shapes():
    centers = np.array([(0.0, 0, 0), (5, 0, 0)])
    tubes = lumitree.implicit(
        "cylinder", centers, radius=[0.5, 0.25], direction=[(0, 0, 1), (1, 0, 0)], capped=False
    )
    hits = lumitree.cast(tubes, centers, (0, 1, 0), precision="exact")
    assert hits.t.tolist() == [0.5, 0.25]
    saddle = lumitree.implicit("quadric", coefficients=(1, -1, 0, 0, 0, 0, 0, 0, -1, 0))
    assert lumitree.cast(saddle, (0.5, 0.25, -3), (0, 0, 1)).t[0] == pytest.approx(3.1875)


def test_survives_a_file_and_stands_beside_a_mesh(tmp_path):
    ball = lumitree.implicit("sphere", (0, 0, 0.1), radius=1 / 3)
    lumitree.write(ball, tmp_path / "ball.vtp")
    again = lumitree.read(tmp_path / "ball.vtp")
    rays = [(0.01 * i, 0.02 * i, -3.0) for i in range(20)]
    wanted = lumitree.cast(ball, rays, (0, 0, 1), precision="exact").t
    assert np.isfinite(wanted[:10]).all()
    assert lumitree.cast(again, rays, (0, 0, 1), precision="exact").t.tolist() == wanted.tolist()
    scene = vtkMultiBlockDataSet()
    scene.SetBlock(0, lumitree.scene("sphere", resolution=10))
    scene.SetBlock(1, again)
    both = lumitree.cast(scene, (0.05, 0.03, -3), (0, 0, 1), query="all")
    assert both.composite_index.tolist() == [1, 2, 2, 1]


def test_references_refuse():
    ball = lumitree.implicit("sphere")
    for structure in ("embree", "cgal"):
        try:
            lumitree.cast(lumitree.scene("sphere"), (0, 0, -3), (0, 0, 1), structure=structure)
        except lumitree.LumitreeError:
            continue  # this build lacks it
        with pytest.raises(lumitree.LumitreeError, match="knows triangles only"):
            lumitree.cast(ball, (0, 0, -3), (0, 0, 1), structure=structure)


def test_functions():
    lens = vtkImplicitBoolean()
    lens.SetOperationTypeToIntersection()
    for x in (-0.25, 0.25):
        ball = vtkSphere()
        ball.SetCenter(x, 0, 0)
        lens.AddFunction(ball)
    body = lumitree.implicit("function", function=lens)
    hits = lumitree.cast(body, (-2, 0, 0), (1, 0, 0), query="all", precision="exact")
    assert hits.t.tolist() == [1.75, 2.25]
    assert hits.flags is None
    assert lumitree.inside(body, [(0, 0, 0), (0.3, 0, 0), (0, 0.4, 0)]).tolist() == [
        True,
        False,
        True,
    ]

    round_one = vtkSuperquadric()
    by_intervals = lumitree.implicit("function", function=round_one)
    hits = lumitree.cast(by_intervals, (-2, 0, 0), (1, 0, 0), query="all", precision="exact")
    assert np.allclose(hits.t, [1.5, 2.5], atol=1e-12) and hits.flags.tolist() == [0, 0]
    assert lumitree.inside(by_intervals, [(0, 0, 0), (0.6, 0, 0)]).tolist() == [True, False]

    noise = vtkPerlinNoise()
    noise.SetFrequency(2, 2, 2)
    sampled = lumitree.implicit("function", function=noise, step=0.01)
    hits = lumitree.cast(sampled, (-2, 0.1, 0.2), (1, 0, 0), query="all", precision="exact")
    assert hits.flags.tolist() == [2] * len(hits.t)
    with pytest.raises(lumitree.LumitreeError, match="only sampled"):
        lumitree.inside(sampled, (0, 0, 0))


def test_wrong_arguments():
    for arguments in (
        {"shape": "cube"},
        {"center": (0, 0)},
        {"radius": [1, 2]},
        {"center": np.zeros((3, 3)), "radius": [1, 2]},
        {"center": np.zeros((3, 3)), "direction": np.zeros((2, 3))},
        {"center": np.zeros((3, 3)), "shape": "box"},
        {"bounds": (0, 1)},
        {"coefficients": (1, 2)},
        {"function": "sphere", "shape": "function"},
        {"preview": 1000},
    ):
        with pytest.raises(ValueError):
            lumitree.implicit(**arguments)
    with pytest.raises(lumitree.LumitreeError, match="no functions"):
        lumitree.implicit("function", function=vtkImplicitBoolean())
    with pytest.raises(lumitree.LumitreeError, match="ImplicitFunction"):
        lumitree.implicit("function")
    never = lumitree.implicit("sphere", radius=-1.0)
    assert not lumitree.cast(never, (0, 0, -3), (0, 0, 1)).hit.any()
