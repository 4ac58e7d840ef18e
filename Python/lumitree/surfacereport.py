# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether a surface is closed, manifold and wound alike, and where it is not."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData

from .arrays import first_row, from_vtk
from .errors import run
from .surfaces import Mesh, as_surface
from .vtk import vtkLumiSurfaceReport


@dataclass(frozen=True)
class SurfaceReport:
    """What a surface is.

    facts : a dict with the columns of the table Report: ``Verdict`` in words, ``Closed``,
        ``Manifold``, ``ConsistentlyOriented``, ``WatertightApplies``, ``InsideOutsideApplies``
        (0 or 1), counts, ``Area`` and ``Volume``.
    surface : the triangles, with what is wrong with each.
    edges : boundary loops, non-manifold and inconsistent edges.
    """

    facts: dict[str, str | int | float]
    surface: vtkPolyData
    edges: vtkPolyData

    @property
    def defect(self) -> np.ndarray:
        """(m,) int32, for each triangle: 0 nothing, 1 not finite, 2 no area, 3 duplicate, 4 refused
        by half-edges, 5 flipped."""
        return from_vtk(self.surface.GetCellData(), "Defect")

    @property
    def cell_id(self) -> np.ndarray:
        """(m,) int64, for each triangle: the cell it came from."""
        return from_vtk(self.surface.GetCellData(), "CellId")


def surface_report(
    mesh: Mesh,
    merge_coincident_points: bool = True,
    *,
    progress: Callable[[float], None] | None = None,
) -> SurfaceReport:
    """Examines a mesh, cut into triangles as rays see it.

    merge_coincident_points : whether points of the same coordinates are one point, as they are for
        rays. Without, an unwelded mesh (of an STL file) falls apart.

    Raises ValueError for wrong types, LumitreeError for what the filter refuses and where this
    build has no OpenMesh.
    """
    report = vtkLumiSurfaceReport()
    report.SetInputDataObject(0, as_surface(mesh))
    report.SetMergeCoincidentPoints(bool(merge_coincident_points))
    run(report, progress)
    surface, edges, table = (report.GetOutputDataObject(port) for port in (0, 1, 2))
    return SurfaceReport(first_row(table), surface, edges)
