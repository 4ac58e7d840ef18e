# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pages of the filters: their tables say what the proxies say, their Python runs and draws something."""

import os
import sys
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

from pvtesting import PROXIES, load_plugin

DOCS = Path(os.environ["LUMITREE_SOURCE_DIR"]) / "Docs"
sys.path.insert(0, str(DOCS))
load_plugin()
from make_pictures import make_picture
from property_tables import PAGES, with_tables


def is_drawn(picture):
    """Whether a picture shows more than a background."""
    reader = vtkPNGReader()
    reader.SetFileName(str(picture))
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return np.any(pixels != pixels[0], axis=1).mean() > 0.02


pages = {path: path.read_text(encoding="utf-8") for path in sorted(PAGES.glob("*.md"))}
# The same as another proxy, but for an input.
VARIANTS = {"LumiCameraRaysOfScene": "Camera Rays of Scene", "LumiSkyOfSun": "Sky of Sun"}
for names in PROXIES.values():
    for name in names:
        described = VARIANTS.get(name, f"<!-- properties of {name} -->")
        assert any(described in text for text in pages.values()), f"no page of {name}"
for path, text in pages.items():
    print(path.name, flush=True)
    assert with_tables(text) == text, f"{path}: run Docs/property_tables.py"
    picture = make_picture(path, Path.cwd())
    assert is_drawn(picture), picture
    assert f"../images/{picture.name}" in text and (DOCS / "images" / picture.name).exists()
