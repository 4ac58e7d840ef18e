# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a first Apply looks as it did: irradiance and the hierarchy of one scene, against baselines.

Renderers differ by a shade or a pixel along edges; pictures are compared blurred, block by block.
LUMITREE_UPDATE_BASELINES=1 in the environment writes new baselines.
"""

import os

import numpy as np
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

from pvtesting import load_plugin

load_plugin()
from paraview.simple import *  # the plugin's proxies

BASELINES = os.path.join(os.environ["LUMITREE_SOURCE_DIR"], "Testing", "ParaView", "Baselines")
WIDTH, HEIGHT, BLOCK = 240, 180, 12
TOLERANCE = 0.04  # of full brightness, the worst block


def blocks(path):
    """The mean colours of square blocks of a picture."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    picture = reader.GetOutput()
    assert picture.GetDimensions() == (WIDTH, HEIGHT, 1), picture.GetDimensions()
    pixels = vtk_to_numpy(picture.GetPointData().GetScalars()).reshape(HEIGHT, WIDTH, -1)[..., :3] / 255
    return pixels.reshape(HEIGHT // BLOCK, BLOCK, WIDTH // BLOCK, BLOCK, 3).mean(axis=(1, 3))


def compare(name, *shown):
    view = CreateView("RenderView", ViewSize=[WIDTH, HEIGHT], OrientationAxesVisibility=0)
    for proxy in shown:
        Show(proxy, view)
    view.CameraPosition, view.CameraViewUp = [4, -9, 7], [0, 0, 1]
    ResetCamera(view)
    baseline = os.path.join(BASELINES, name)
    path = baseline if os.environ.get("LUMITREE_UPDATE_BASELINES") else name
    SaveScreenshot(path, view, ImageResolution=[WIDTH, HEIGHT], OverrideColorPalette="WhiteBackground")
    difference = np.abs(blocks(path) - blocks(baseline)).max()
    print(f"{name}: worst block differs by {difference:.3f}")
    assert difference < TOLERANCE, name


scene = BuiltinScene(Scene="Teapot", Resolution=6)
lamp = PointLight(Position=[4, -4, 6], Flux=1000)
compare("irradiance.png", Irradiance(Input=scene, Lights=lamp))
# One level: where boxes of two levels share an edge, which block is drawn on top depends on its address.
compare("hierarchy.png", AccelerationStructure(Input=scene, Structure="BVH", MinimumLevel=5, MaximumLevel=5))
