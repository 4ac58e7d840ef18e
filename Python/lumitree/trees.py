# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The hierarchy over a surface, as boxes to look at and numbers to compare."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, field

from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkMultiBlockDataSet

from .arrays import first_row, in_range
from .choices import Structure, StructureFileUse
from .errors import run
from .structures import set_structure
from .surfaces import Mesh, as_surface
from .vtk import vtkLumiAccelerationStructure


@dataclass(frozen=True)
class Hierarchy:
    """A tree over a surface.

    levels : a block per depth, ``Level 0`` to the deepest, of boxes with cell arrays such as
        ``Depth``, ``PrimitiveCount``, ``SurfaceAreaCost`` and, with rays, ``Visits``.
    statistics : a dict with the columns of the table Statistics: ``Structure``, ``Nodes``,
        ``Depth``, ``SahCost``, ``MemoryBytes``, ``BuildSeconds`` and more.

    The tree lives as long as this object: rays that are cast meanwhile at the same mesh, with the
    same options, find it built.
    """

    levels: vtkMultiBlockDataSet
    statistics: dict[str, str | int | float]
    _tree: vtkLumiAccelerationStructure = field(repr=False)


def hierarchy(
    mesh: Mesh,
    structure: Structure | str = "auto",
    rays: vtkDataSet | None = None,
    *,
    max_level: int = 10,
    leaves: bool = False,
    as_faces: bool = False,
    occupancy: bool = False,
    overlap: bool = False,
    progress: Callable[[float], None] | None = None,
    **build: object,
) -> Hierarchy:
    """Builds a structure over a mesh, and shows it.

    mesh, structure : as of `Caster`.
    build : further options of `Caster`: bvh_build, leaf_size, threads and so on.
    rays : a data set of rays, such as of `camera_rays`; each node then tells how many of them
        entered it.
    max_level : the deepest level that is drawn, 0 to 64; statistics are of the whole tree.
    leaves : whether a last block ``Leaves`` holds all leaves again.
    as_faces : draw a node as six faces instead of twelve lines.
    occupancy : of a grid, whether a last block ``Occupancy`` holds its cells as an image.
    overlap : whether statistics tell ``EndPointOverlap``; takes about as long as building.

    Raises ValueError for wrong names and types, LumitreeError for what the filter refuses.
    """
    tree = vtkLumiAccelerationStructure()
    tree.SetInputDataObject(0, as_surface(mesh))
    set_structure(tree, structure, **build)
    tree.SetMaximumLevel(in_range(max_level, 0, 64, "max_level"))
    tree.SetShowLeaves(bool(leaves))
    tree.SetShowOccupancy(bool(occupancy))
    tree.SetMeasureOverlap(bool(overlap))
    tree.SetRepresentation(tree.Cells if as_faces else tree.Outlines)
    if rays is not None:
        tree.SetRaysData(rays)
    run(tree, progress)
    levels, statistics = (tree.GetOutputDataObject(port) for port in (0, 1))
    return Hierarchy(levels, first_row(statistics), tree)


def save_structure(
    mesh: Mesh,
    path: str | os.PathLike[str],
    structure: Structure | str = "auto",
    *,
    progress: Callable[[float], None] | None = None,
    **build: object,
) -> dict[str, str | int | float]:
    """Builds a structure over a mesh and saves it, over one saved there before.

    path : where; functions and classes that build structures load it with ``structure_file=path``,
        and need no time to build it then.
    mesh, structure, build : as of `hierarchy`.

    Returns its statistics. Raises LumitreeError where the file cannot be written or is something
    else than a saved structure, and for structures that are never saved (embree, cgal).
    """
    use = {"structure_file": path, "structure_file_use": StructureFileUse.SAVE}
    return hierarchy(mesh, structure, max_level=0, progress=progress, **build, **use).statistics
