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
        names = {path.name: path.stat().st_size for path in (in_tmp / "there" / folder).iterdir()}
        for name in ("hierarchy.vtm", "cost.vti", "hits.vtp"):
            assert names[name] > 500, name
        for name in ("hierarchy.png", "cost.png"):
            assert names[name] > 5000, name
    for name in ("irradiance.vtp", "irradiance.png"):
        assert (in_tmp / "there" / "cornell_box" / name).stat().st_size > 5000, name
    assert "look at" in done.stdout and "there/" in done.stdout
