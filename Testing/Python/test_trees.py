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


def test_mailboxing_tests_less_and_hits_the_same():
    rays = lumitree.rays(*random_rays(300))
    casts = [
        lumitree.cast(MESH, rays, query="all", structure="grid", mailboxing=on, cost=True)
        for on in (False, True)
    ]
    np.testing.assert_array_equal(casts[1].t, casts[0].t)
    tested = [cast.cost["primitives_tested"].sum() for cast in casts]
    assert tested[1] < tested[0]


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


def test_saved_structures(tmp_path):
    path = tmp_path / "mesh.lumitree"
    rays = random_rays(100)
    fresh = lumitree.cast(MESH, *rays, precision="exact")
    facts = lumitree.save_structure(MESH, path, "kd_tree")
    assert facts["Origin"] == "built" and path.stat().st_size > 100
    caster = lumitree.Caster(
        MESH, precision="exact", structure_file=path, structure_file_use="load"
    )
    again = caster.cast(*rays)
    assert (again.statistics["Origin"], again.statistics["Structure"]) == ("loaded", "kd_tree")
    np.testing.assert_array_equal(again.t, fresh.t)
    np.testing.assert_array_equal(again.cell_id, fresh.cell_id)
    tree = lumitree.hierarchy(MESH, "kd_tree", structure_file=path)
    assert tree.statistics["Origin"] == "loaded"

    moved = (MESH[0] + np.float32(0.125), MESH[1])
    caster.mesh = moved
    with pytest.raises(lumitree.LumitreeError, match="another surface"):
        caster.cast(*rays)
    path.write_bytes(b"x" * 200)
    with pytest.raises(lumitree.LumitreeError, match="no saved structure"):
        lumitree.save_structure(MESH, path)
    with pytest.raises(lumitree.LumitreeError, match="cannot be saved"):
        lumitree.save_structure(MESH, tmp_path / "other", "embree")
    with pytest.raises(ValueError, match="structure_file_use"):
        lumitree.hierarchy(MESH, structure_file=path, structure_file_use="keep")


def test_moving_meshes_are_refitted():
    points, triangles = MESH
    rays = random_rays(100)
    caster = lumitree.Caster((points, triangles), structure="wide_bvh", precision="exact")
    assert caster.cast(*rays).statistics["Origin"] == "built"
    for frame in range(1, 4):
        moved = points + np.float32(0.05 * frame) * np.sin(points[:, ::-1])
        caster.mesh = (moved, triangles)
        hits = caster.cast(*rays)
        assert hits.statistics["Origin"] == "refitted"
        wanted = lumitree.cast(
            (moved, triangles), *rays, structure="brute_force", precision="exact"
        )
        np.testing.assert_array_equal(hits.t, wanted.t)
        np.testing.assert_array_equal(hits.cell_id, wanted.cell_id)
    with pytest.raises(ValueError, match="refit_limit"):
        lumitree.Caster(MESH, refit_limit=0.5)
