# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView macro: camera rays of the active view's camera, one per pixel.

Macros > Import new macro... adds it to the toolbar. With Camera Rays active in the pipeline browser, it moves
that camera; else it makes new Camera Rays.
"""

from paraview.simple import GetActiveSource
from lumitree.pv import is_camera_rays, rays_from_view

active = GetActiveSource()
rays_from_view(rays=active if is_camera_rays(active) else None)
