# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demonstration leaves what it says."""

import subprocess
import sys


def test_demo(in_tmp):
    done = subprocess.run(
        [sys.executable, "-m", "lumitree.demo", "there"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stderr == ""
    folders = sorted(path.name for path in (in_tmp / "there").iterdir())
    assert "cornell_box" in folders and len(folders) >= 3
    for folder in folders:
        for name in ("hierarchy.vtm", "cost.vti", "hits.vtp", "irradiance.vtp"):
            assert (in_tmp / "there" / folder / name).stat().st_size > 500, name
        for name in ("hierarchy.png", "cost.png", "irradiance.png"):
            assert (in_tmp / "there" / folder / name).stat().st_size > 5000, name
    assert "look at" in done.stdout and "there/" in done.stdout
