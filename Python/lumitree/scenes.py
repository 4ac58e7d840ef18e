# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The built-in scenes."""

from __future__ import annotations

from vtkmodules.vtkCommonDataModel import vtkPolyData

from .arrays import in_range
from .choices import Scene, choose
from .errors import run
from .vtk import vtkLumiScene


def scene(name: Scene | str, *, resolution: int = 10, seed: int = 1) -> vtkPolyData:
    """A generated scene: polygons in metres, z up, facing the side that light meets.

    name : ``"cornell_box"``, ``"teapot"``, ``"city"``, ``"teapot_in_stadium"``, ``"random_cloud"``,
        ``"sphere"``, ``"torus"`` or ``"terrain"``.
    resolution : how fine it is, or how much there is of it; 1 to 1000. With R the resolution, the
        box has R x R quads a face, the teapot R x R a patch, the city R x R towers, the cloud 10
        R^2 triangles.
    seed : what city, cloud and terrain draw their random numbers from.

    Cell data: ``Part`` and ``Reflectance``. Raises ValueError for a name or number that is none of
    these.
    """
    source = vtkLumiScene()
    source.SetScene(choose(Scene, name, "name"))
    source.SetResolution(in_range(resolution, 1, 1000, "resolution"))
    source.SetSeed(in_range(seed, -(2**31), 2**31 - 1, "seed"))
    run(source)
    return source.GetOutput()
