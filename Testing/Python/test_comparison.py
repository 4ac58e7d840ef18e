# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Structures side by side and rays on which they differ, in Python."""

import numpy as np
import pytest

import lumitree

BALL = lumitree.scene("sphere", resolution=4)
RAYS = lumitree.rays(np.zeros(3), np.random.default_rng(1).normal(size=(200, 3)))


def test_all_structures():
    table = lumitree.compare_structures(
        BALL, RAYS, precision="exact", truth="brute_force", repetitions=1, threads=1
    )
    assert "bvh" in table["Structure"] and "brute_force" not in table["Structure"]
    assert (table["Disagreements"] == 0).all()
    assert (table["HitRays"] == 200).all()
    assert len(table["Parameters"]) == len(table["NodesPerRay"])


def test_grid_sweep():
    table = lumitree.compare_structures(
        BALL, RAYS, "grid_cells", minimum=0.1, maximum=10, steps=3, repetitions=1
    )
    assert table["GridCells"][0] == 1
    assert (np.diff(table["GridCells"]) > 0).all()
    assert np.isnan(table["Disagreements"]).all()


def test_disagreements():
    same = lumitree.disagreements(BALL, RAYS, "kd_tree", "exact")
    assert same.counts["Agree"] == same.counts["Rays"] == 200
    assert same.counts["OtherStructure"] == "brute_force"
    assert len(same.ray_id) == len(same.kind) == 0


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"sweep": "cells"}, "sweep is 'cells'; choose one of: all_structures, grid_cells"),
        ({"steps": 0}, "steps must be a whole number from 1 to 100"),
        ({"truth": "oracle"}, "truth is 'oracle'; choose one of"),
    ],
)
def test_wrong_arguments(change, message):
    with pytest.raises(ValueError, match=message):
        lumitree.compare_structures(BALL, RAYS, **change)


def test_what_the_filter_refuses():
    with pytest.raises(lumitree.LumitreeError, match="ascending order"):
        lumitree.compare_structures(BALL, RAYS, "leaf_sizes", minimum=5, maximum=1)
    with pytest.raises(ValueError, match="tolerance must be from 0 to 1"):
        lumitree.disagreements(BALL, RAYS, tolerance=2)
    with pytest.warns(lumitree.LumitreeWarning, match="Left out: grid"):
        table = lumitree.compare_structures(BALL, RAYS, grid_resolution=(2**20,) * 3, repetitions=1)
    assert "grid" not in table["Structure"]
