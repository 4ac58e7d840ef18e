# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
import os
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))


def pytest_report_header() -> str:
    import lumitree

    return f"lumitree from {os.path.dirname(lumitree.__file__)}"


@pytest.fixture
def in_tmp(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A directory of its own to work in."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture(params=["brute_force", "bvh", "wide_bvh", "grid", "octree", "kd_tree", "bsp_tree"])
def structure(request: pytest.FixtureRequest) -> str:
    """Each structure of our own; skipped where this build lacks it."""
    import lumitree

    try:
        lumitree.cast(
            ([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]),
            *[(0, 0, 1)] * 2,
            structure=request.param,
        )
    except lumitree.LumitreeError as error:
        assert f"'{request.param}' is not available here" in str(error), error
        pytest.skip(str(error))
    return request.param
