# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Starts the ParaView client, which runs ClientScript.py and says what became of it."""

import os
import subprocess
import tempfile

script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "ClientScript.py")
with tempfile.TemporaryDirectory() as home:
    # Settings of its own: no recent state, no welcome window, no plugins remembered.
    environment = dict(os.environ, XDG_CONFIG_HOME=home, HOME=home, XDG_RUNTIME_DIR=home)
    run = subprocess.run(
        [os.environ["LUMITREE_PARAVIEW_CLIENT"], "--dr", f"--script={script}"],
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        timeout=240,
    )
print(run.stdout)
assert run.returncode == 0 and "client script: passed" in run.stdout
