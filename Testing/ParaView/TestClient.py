# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Starts the ParaView client, with the plugin, to run ClientScript.py and then to click through ClientMenus.xml."""

import os
import subprocess
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))


def client(*options):
    with tempfile.TemporaryDirectory() as home:
        # A home of its own: no settings, no plugins remembered.
        environment = dict(os.environ, HOME=home, XDG_CONFIG_HOME=home, XDG_RUNTIME_DIR=home)
        environment["PV_PLUGIN_PATH"] = os.environ["LUMITREE_PLUGIN_DIR"]
        command = [os.environ["LUMITREE_PARAVIEW_CLIENT"], "--disable-registry", *options]
        run = subprocess.run(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=140)
    output = run.stdout.decode(errors="replace")
    print(output, flush=True)
    assert run.returncode == 0, f"{' '.join(command)}: {run.returncode}"
    return output


assert "client script: passed" in client(f"--script={HERE}/ClientScript.py")
assert "critical" not in client(f"--test-script={HERE}/ClientMenus.xml", "--exit")
