# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether pictures can be rendered here, and a virtual screen where they cannot."""

from __future__ import annotations

import ctypes
import os
import shutil
import sys

from vtkmodules.vtkCommonCore import vtkVersion


def screen_available() -> bool:
    """Whether VTK can render. On Linux, VTK before 9.4 ends the process if it has no X server."""
    version = vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion()
    if not sys.platform.startswith("linux") or version >= (9, 4):
        return True
    if not os.environ.get("DISPLAY"):
        return False
    try:
        x11 = ctypes.CDLL("libX11.so.6")
    except OSError:
        return False
    x11.XOpenDisplay.restype = ctypes.c_void_p
    display = x11.XOpenDisplay(None)
    if not display:
        return False
    x11.XCloseDisplay(ctypes.c_void_p(display))
    return True


def restart_with_screen(module: str, arguments: list[str]) -> None:
    """Replaces this process by the same command under xvfb-run. Returns if there is no xvfb-run, or
    if this process has been replaced already."""
    xvfb = shutil.which("xvfb-run")
    if xvfb is None or "LUMITREE_VIRTUAL_SCREEN" in os.environ:
        return
    environment = {**os.environ, "LUMITREE_VIRTUAL_SCREEN": "1"}
    command = [xvfb, "-a", sys.executable, "-m", module, *arguments]
    os.execvpe(xvfb, command, environment)
