# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the Python on each page of Docs/filters in ParaView and saves what the view shows: the page's picture.

PV_PLUGIN_PATH=<where the plugin Lumitree is> xvfb-run -a pvbatch Docs/make_pictures.py [DIRECTORY]

The pictures go to DIRECTORY, by default Docs/images.
"""

from __future__ import annotations

import sys
from pathlib import Path

from paraview import simple
from run_page import run_page

HERE = Path(__file__).resolve().parent
SIZE = (720, 480)


def make_picture(page: Path, directory: Path) -> Path:
    """Runs one page in a session of its own; returns its picture."""
    simple.ResetSession()
    view = simple.CreateView("RenderView", ViewSize=SIZE, OrientationAxesVisibility=0)
    simple.SetActiveView(view)
    run_page(page)
    picture = directory / f"filter-{page.stem}.png"
    simple.SaveScreenshot(
        str(picture), simple.GetActiveView(), ImageResolution=SIZE, OverrideColorPalette="WhiteBackground"
    )
    return picture


if __name__ == "__main__":
    target = Path(sys.argv[1] if len(sys.argv) > 1 else HERE / "images")
    target.mkdir(parents=True, exist_ok=True)
    for path in sorted((HERE / "filters").glob("*.md")):
        print(make_picture(path, target), flush=True)
