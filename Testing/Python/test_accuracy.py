# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Speed against accuracy, in Python."""

import pytest

import lumitree


def test_promises_are_kept_and_everything_is_there():
    rows = lumitree.accuracy_chart(lumitree.scene("sphere", resolution=4), 60, repeats=1)
    kinds = ["Random", "Camera", "ThroughVertex", "ThroughEdge", "TowardVertex"]
    assert sorted({row["RayKind"] for row in rows}) == sorted(kinds)
    assert {"brute_force", "bvh", "wide_bvh", "vtkStaticCellLocator"} <= {r["BackEnd"] for r in rows}
    for row in rows:
        assert row["Rays"] == 60 and row["NanosecondsPerRay"] > 0
        if row["Precision"] == "exact":
            assert row["Leaks"] == row["Phantoms"] == row["OtherPrimitives"] == 0
            assert row["MaxTError"] <= 2**-23
        if row["Precision"] == "watertight":
            assert row["Leaks"] == 0


def test_bad_input():
    mesh = lumitree.scene("sphere", resolution=2)
    for wrong in ({"rays": 0}, {"repeats": 0}, {"seed": -1}, {"brute_force_limit": -1}):
        with pytest.raises(ValueError, match=next(iter(wrong))):
            lumitree.accuracy_chart(mesh, **wrong)
