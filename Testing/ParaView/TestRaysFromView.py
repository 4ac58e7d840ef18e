# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Camera rays of the current view hit where the view shows something, by function and by macro."""

import os

import numpy as np
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

from lumitree.pv import rays_from_view
from pvtesting import fetch, load_plugin, point_array

load_plugin()
from paraview.simple import *  # the plugin's proxies

MACRO = os.path.join(os.environ["LUMITREE_SOURCE_DIR"], "ParaView", "Macros", "rays_from_current_view.py")

scene = BuiltinScene(Scene="Teapot", Resolution=6)
view = GetActiveViewOrCreate("RenderView")
view.ViewSize = [120, 90]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [0, 0, 0]
display = Show(scene, view)
ColorBy(display, None)
display.DiffuseColor = display.AmbientColor = [1, 1, 1]
display.Ambient = 1
ResetCamera(view)
view.CameraPosition = [4, -9, 7]
view.CameraViewUp = [0.2, 0, 1]


def drawn():
    """Where the view shows the scene."""
    picture = view.CaptureWindow(1)
    pixels = vtk_to_numpy(picture.GetPointData().GetScalars())
    width, height, _ = picture.GetDimensions()
    return pixels.reshape(height, width, -1).max(axis=2) > 127


def hit(rays):
    """Where camera rays hit the scene."""
    image = fetch(RayCast(Input=scene, Rays=rays, Query="Any"), 1)
    width, height, _ = image.GetDimensions()
    return point_array(image, "HitMask").reshape(height, width) > 0


for parallel in (0, 1):
    view.CameraParallelProjection = parallel
    Render(view)
    seen = drawn()
    rays = rays_from_view(view)
    assert rays.Resolution[:] == [120, 90]
    assert 0.1 < seen.mean() < 0.9
    assert (seen != hit(rays)).mean() < 0.01, "rays and rasteriser should differ along outlines only"

# The macro moves the Camera Rays that are active, and makes new ones when something else is.
SetActiveSource(rays)
view.CameraPosition = [9, 4, 7]
exec(open(MACRO).read(), {})
assert rays.Position[:] == [9, 4, 7]
SetActiveSource(scene)
exec(open(MACRO).read(), {})
assert GetActiveSource().SMProxy.GetVTKClassName() == "vtkLumiCameraRays" and GetActiveSource() != rays
assert GetActiveSource().Position[:] == [9, 4, 7]
