# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Client and server: pvserver loads the plugin, computes, and the client sees the numbers."""

import os
import socket
import subprocess

import numpy as np
from paraview import simple

from pvtesting import IRRADIANCE, cell_array, fetch, load_plugin


def free_port():
    with socket.socket() as any_free:
        any_free.bind(("127.0.0.1", 0))
        return any_free.getsockname()[1]


def compute_on_the_server():
    lamp = simple.PointLight(Position=[0, 0, 2], Flux=16 * np.pi)
    irradiance = simple.Irradiance(Input=simple.Plane(), Lights=lamp)
    assert irradiance.SMProxy.GetClientSideObject() is None, "the filter should be on the server"
    assert np.allclose(cell_array(fetch(irradiance), IRRADIANCE), 1)


port = free_port()
command = [os.environ["LUMITREE_PVSERVER"], f"--server-port={port}"]
server = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
try:
    assert any("Accepting connection" in line for line in server.stdout), "pvserver ended before it listened"
    simple.Connect("127.0.0.1", port)
    load_plugin(remote=True)
    load_plugin(remote=False)
    compute_on_the_server()
finally:
    server.kill()
# Without the destructors: they would complain that the server is gone.
os._exit(0)
