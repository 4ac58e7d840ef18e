# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Anything that holds a surface, as a VTK data object."""

from __future__ import annotations

import os
from typing import Union

import numpy as np
from numpy.typing import ArrayLike
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.util.vtkConstants import VTK_ID_TYPE
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkCompositeDataSet,
    vtkDataObject,
    vtkDataSet,
    vtkPolyData,
)

from .arrays import floats, to_vtk
from .files import read

#: A data set or a composite of them (PyVista's are both), numpy (points, triangles), or a file.
Mesh = Union[vtkDataSet, vtkCompositeDataSet, tuple[ArrayLike, ArrayLike], str, os.PathLike]


def as_surface(mesh: Mesh, argument: str = "mesh") -> vtkDataObject:
    """The VTK data object of `mesh`.

    A VTK object is returned as it is. Of ``(points, triangles)``, of shapes (n, 3) and (m, 3), it
    is a vtkPolyData on the memory of `points` (float32 and float64 are not converted), with a copy
    of `triangles`.
    A string or a path is read from disk, see `read`.

    Raises ValueError for other types, wrong shapes, and point ids that are out of range.
    """
    if isinstance(mesh, (vtkDataSet, vtkCompositeDataSet)):
        return mesh
    if isinstance(mesh, (str, os.PathLike)):
        return read(mesh)
    if isinstance(mesh, (tuple, list)) and len(mesh) == 2:
        return triangles_to_polydata(*mesh)
    raise ValueError(
        f"{argument} must be a vtkDataSet or a composite of them, a tuple (points, triangles), "
        f"or a file's name, not {type(mesh).__name__}"
    )


def triangles_to_polydata(points: ArrayLike, triangles: ArrayLike) -> vtkPolyData:
    """A vtkPolyData of triangles, on the memory of `points`."""
    coordinates = floats(points, "points")
    if coordinates.ndim != 2 or coordinates.shape[1] != 3:
        raise ValueError(f"points must have shape (n, 3), not {coordinates.shape}")
    ids = np.asarray(triangles)
    if ids.size == 0:
        ids = np.empty((0, 3), np.int64)
    if ids.ndim != 2 or ids.shape[1] != 3:
        raise ValueError(f"triangles must have shape (m, 3), not {ids.shape}")
    if ids.dtype.kind not in "iu":
        raise ValueError(f"triangles must be integers, not {ids.dtype}")
    if ids.size and (ids.min() < 0 or ids.max() >= len(coordinates)):
        raise ValueError(
            f"triangles must hold point ids from 0 to {len(coordinates) - 1}, "
            f"but they go from {ids.min()} to {ids.max()}"
        )
    # A copy: vtkCellArray takes the memory out of the arrays it is given, which then could not keep
    # numpy's memory alive.
    starts = np.arange(0, 3 * len(ids) + 1, 3)
    cells = vtkCellArray()
    cells.SetData(*(numpy_to_vtk(part, True, VTK_ID_TYPE) for part in (starts, ids.ravel())))
    vtk_points = vtkPoints()
    vtk_points.SetData(to_vtk(coordinates))
    result = vtkPolyData()
    result.SetPoints(vtk_points)
    result.SetPolys(cells)
    return result
