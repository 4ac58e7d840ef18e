# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Helpers for scripts that run inside ParaView (pvpython, pvbatch, its Python shell and macros)."""

from __future__ import annotations

from paraview import simple


def is_camera_rays(proxy) -> bool:
    """Whether a proxy of the pipeline (or None) is the source Camera Rays or the filter Camera Rays of Scene."""
    return proxy is not None and proxy.SMProxy.GetVTKClassName() == "vtkLumiCameraRays"


def rays_from_view(view=None, rays=None, resolution=None):
    """Camera Rays of the camera of a render view: an image of them shows what the view shows.

    view: the active render view by default. rays: Camera Rays to change; by default new ones are made.
    resolution: (width, height) in pixels; by default the view's. The plugin Lumitree has to be loaded.
    Returns the Camera Rays.
    """
    view = view or simple.GetActiveView()
    if view is None or not hasattr(view, "CameraPosition"):
        raise ValueError("rays_from_view needs a render view; the active view is none.")
    if rays is None:
        rays = simple.CameraRays(registrationName="CameraRaysFromView")
    if hasattr(rays, "AutomaticCamera"):
        rays.AutomaticCamera = 0
    rays.Position = list(view.CameraPosition)
    rays.FocalPoint = list(view.CameraFocalPoint)
    rays.ViewUp = list(view.CameraViewUp)
    rays.ViewAngle = view.CameraViewAngle
    rays.ParallelProjection = view.CameraParallelProjection
    rays.ParallelScale = view.CameraParallelScale
    rays.Resolution = list(resolution or view.ViewSize)
    return rays
