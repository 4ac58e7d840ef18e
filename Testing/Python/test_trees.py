# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The hierarchy as data."""

import numpy as np
import pytest
from meshes import random_rays, random_triangles
from vtkmodules.util.numpy_support import vtk_to_numpy

import lumitree

MESH = random_triangles(500)


def test_statistics(structure):
    facts = lumitree.hierarchy(MESH, structure).statistics
    assert facts["Structure"] == structure
    assert facts["Primitives"] == 500 and facts["Nodes"] >= facts["Leaves"] >= 1
    assert facts["References"] >= 500 and facts["Rays"] == 0
    assert isinstance(facts["SahCost"], float) and isinstance(facts["Depth"], int)


def test_a_block_per_level():
    tree = lumitree.hierarchy(MESH, "bvh", max_level=5)
    assert tree.levels.GetNumberOfBlocks() == 6
    nodes = 0
    for depth in range(6):
        level = tree.levels.GetBlock(depth)
        name = tree.levels.GetMetaData(depth).Get(tree.levels.NAME())
        data = level.GetCellData()
        assert name == f"Level {depth}" and level.GetNumberOfLines() == level.GetNumberOfCells()
        assert set(vtk_to_numpy(data.GetArray("Depth"))) == {depth}
        nodes += len(set(vtk_to_numpy(data.GetArray("NodeId"))))
    assert nodes <= 2**6 - 1
    root = tree.levels.GetBlock(0)
    np.testing.assert_allclose(
        np.reshape(root.GetBounds(), (3, 2)),
        np.transpose([MESH[0].min(axis=0), MESH[0].max(axis=0)]),
        atol=1e-5,
    )


def test_faces_and_leaves_on_request():
    tree = lumitree.hierarchy(MESH, "bvh", leaves=True, as_faces=True)
    last = tree.levels.GetNumberOfBlocks() - 1
    assert tree.levels.GetMetaData(last).Get(tree.levels.NAME()) == "Leaves"
    leaves = tree.levels.GetBlock(last)
    assert leaves.GetNumberOfPolys() == 6 * tree.statistics["Leaves"]


def test_visits_of_rays():
    rays = lumitree.rays(*random_rays(200))
    tree = lumitree.hierarchy(MESH, "bvh", rays)
    assert tree.statistics["Rays"] == 200
    cost = lumitree.cast(MESH, rays, structure="bvh", cost=True).cost
    assert tree.statistics["RayNodesEntered"] == cost["nodes_entered"].sum()
    assert tree.statistics["RayPrimitivesTested"] == cost["primitives_tested"].sum()
    visits = tree.levels.GetBlock(0).GetCellData().GetArray("Visits")
    assert visits.GetValue(0) == np.count_nonzero(cost["nodes_entered"])


def test_wrong_arguments():
    with pytest.raises(ValueError, match="structure is 'tree'"):
        lumitree.hierarchy(MESH, "tree")
    with pytest.raises(ValueError, match="max_level must be a whole number from 0 to 64"):
        lumitree.hierarchy(MESH, max_level=65)
