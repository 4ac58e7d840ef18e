# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
import os
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

#: Structures of every build; the reference back ends are tested elsewhere.
OWN_STRUCTURES = ["brute_force", "bvh", "wide_bvh", "grid", "octree", "kd_tree", "bsp_tree"]


def pytest_report_header() -> str:
    import lumitree

    return f"lumitree from {os.path.dirname(lumitree.__file__)}"


@pytest.fixture
def in_tmp(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A directory of its own to work in."""
    monkeypatch.chdir(tmp_path)
    return tmp_path
