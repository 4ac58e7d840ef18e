# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a surface is, in Python."""

import numpy as np
import pytest

import lumitree

POINTS = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], float)
TETRAHEDRON = np.array([(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])


@pytest.fixture(autouse=True)
def needs_openmesh():
    try:
        lumitree.surface_report((POINTS, TETRAHEDRON))
    except lumitree.LumitreeError as error:
        assert "OpenMesh" in str(error)
        pytest.skip(str(error))


def test_facts():
    facts = lumitree.surface_report((POINTS, TETRAHEDRON)).facts
    assert facts["Closed"] == facts["Manifold"] == facts["WatertightApplies"] == 1
    assert facts["Volume"] == pytest.approx(1 / 6)
    assert "closed, manifold, wound alike" in facts["Verdict"]


def test_defects_and_edges():
    turned = TETRAHEDRON.copy()
    turned[2] = turned[2, ::-1]
    report = lumitree.surface_report((POINTS, turned))
    assert report.defect.tolist() == [0, 0, 5, 0]
    assert report.cell_id.tolist() == [0, 1, 2, 3]
    assert report.edges.GetNumberOfCells() == 3


def test_wrong_mesh():
    with pytest.raises(ValueError, match="mesh must be"):
        lumitree.surface_report(3)
