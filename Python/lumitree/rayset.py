# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sets of rays."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

from .arrays import floats, to_vtk, vectors


def rays(
    origins: ArrayLike, directions: ArrayLike, t_min: ArrayLike = 0.0, t_max: ArrayLike = np.inf
) -> vtkPolyData:
    """Rays as a data set: a point each, with ``RayDirection``, and ``RayTMin``, ``RayTMax`` if they
    differ.

    origins, directions : (n, 3) or (3,); a single one goes with all of the other. float32 and
        float64 stay what they are, and are shared if there are as many as rays; other numbers
        become float64. Directions have any length but 0.
    t_min, t_max : a number, or (n,); in units of |direction|. Scalars are not stored: the caster
        has them.

    Raises ValueError for shapes that do not fit.
    """
    start = vectors(origins, "origins")
    direction = vectors(directions, "directions")
    count = {len(array) for array in (start, direction) if array.ndim == 2} - {1}
    if len(count) > 1:
        raise ValueError(f"there are {start.shape[0]} origins, but {direction.shape[0]} directions")
    n = count.pop() if count else 1
    points = vtkPoints()
    points.SetData(to_vtk(np.broadcast_to(start, (n, 3))))
    result = vtkPolyData()
    result.SetPoints(points)
    result.GetPointData().AddArray(to_vtk(np.broadcast_to(direction, (n, 3)), "RayDirection"))
    for argument, name, value in (("t_min", "RayTMin", t_min), ("t_max", "RayTMax", t_max)):
        limit = floats(value, argument)
        if limit.ndim == 0:
            continue
        if limit.shape != (n,):
            raise ValueError(f"{argument} must be a number or have shape ({n},), not {limit.shape}")
        result.GetPointData().AddArray(to_vtk(limit, name))
    return result
