# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Structures side by side, and rays on which two of them differ."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkPolyData

from .arrays import columns, first_row, from_vtk, in_range
from .choices import Precision, Query, Structure, Sweep, choose
from .errors import run
from .structures import set_structure
from .surfaces import Mesh, as_surface
from .vtk import vtkLumiRayDisagreement, vtkLumiStructureComparison

#: The kinds of disagreement, by their values.
KINDS = ("missed", "phantom", "other_primitive", "far", "tie")


def compare_structures(
    mesh: Mesh,
    rays: vtkDataSet,
    sweep: Sweep | str = "all_structures",
    minimum: float = 0.01,
    maximum: float = 100.0,
    steps: int = 9,
    *,
    query: Query | str = "closest",
    brute_force: bool = False,
    references: bool = False,
    truth: Structure | str | None = None,
    repetitions: int = 3,
    progress: Callable[[float], None] | None = None,
    **build: object,
) -> dict[str, np.ndarray | list[str]]:
    """What structures over one mesh cost, for the same rays.

    rays : a data set of rays, such as of `camera_rays`.
    sweep : what changes from row to row: ``"all_structures"``; ``"grid_cells"``, a grid of one cell
        and then of `minimum` to `maximum` cells per primitive; or ``"leaf_sizes"`` from `minimum`
        to `maximum` of the tree named by ``structure``.
    brute_force, references : whether those (Embree, CGAL) are among all structures.
    truth : a structure whose exact answers the rows are compared with, or None.
    repetitions : how often the rays are cast for the time; the quickest counts.
    build : further options of `Caster`: structure, precision, threads, leaf_size and so on.

    Returns the columns of the table by their names: ``Structure``, ``Parameters`` (lists of
    strings), ``BuildSeconds``, ``MemoryBytes``, ``NodesPerRay``, ``TestsPerRay``,
    ``RaysPerSecond`` and more. What cannot be built is left out, with a LumitreeWarning.

    Raises ValueError for wrong names and types, LumitreeError for what the filter refuses.
    """
    comparison = vtkLumiStructureComparison()
    comparison.SetInputDataObject(0, as_surface(mesh))
    comparison.SetRaysData(rays)
    set_structure(comparison, **build)
    comparison.SetQuery(choose(Query, query, "query"))
    comparison.SetSweep(choose(Sweep, sweep, "sweep"))
    comparison.SetSweepMinimum(float(minimum))
    comparison.SetSweepMaximum(float(maximum))
    comparison.SetSweepSteps(in_range(steps, 1, 100, "steps"))
    comparison.SetIncludeBruteForce(bool(brute_force))
    comparison.SetIncludeReferences(bool(references))
    comparison.SetCountDisagreements(truth is not None)
    if truth is not None:
        comparison.SetReferenceStructure(choose(Structure, truth, "truth"))
    comparison.SetRepetitions(in_range(repetitions, 1, 100, "repetitions"))
    run(comparison, progress)
    return columns(comparison.GetOutputDataObject(0))


@dataclass(frozen=True)
class Disagreements:
    """Rays on which two back ends differ.

    counts : a dict with the columns of the table Counts: ``Rays``, ``Agree``, ``Missed``,
        ``Phantom``, ``OtherPrimitive``, ``Far``, ``Tie`` and who was asked.
    lines : a line for each of these rays, with both answers.
    """

    counts: dict[str, str | int | float]
    lines: vtkPolyData

    @property
    def ray_id(self) -> np.ndarray:
        """(k,) int64: the rays."""
        return from_vtk(self.lines.GetCellData(), "RayId")

    @property
    def kind(self) -> np.ndarray:
        """(k,) int32: places in `KINDS`."""
        return from_vtk(self.lines.GetCellData(), "Kind")


def disagreements(
    mesh: Mesh,
    rays: vtkDataSet,
    structure: Structure | str = "auto",
    precision: Precision | str = "fast",
    other_structure: Structure | str = "brute_force",
    other_precision: Precision | str = "exact",
    *,
    query: Query | str = "closest",
    tolerance: float = 1e-6,
    progress: Callable[[float], None] | None = None,
    **build: object,
) -> Disagreements:
    """The rays on which two back ends differ, each a structure with a precision.

    rays : a data set of rays, such as of `camera_rays`.
    tolerance : how far two t may be apart and still be the same, as a part of the larger; 0 to 1.
    build : further options of `Caster`, for both.

    Raises ValueError for wrong names and types, LumitreeError for what the filter refuses.
    """
    if not 0 <= tolerance <= 1:
        raise ValueError(f"tolerance must be from 0 to 1, not {tolerance!r}")
    asked = vtkLumiRayDisagreement()
    asked.SetInputDataObject(0, as_surface(mesh))
    asked.SetRaysData(rays)
    set_structure(asked, structure, precision=precision, **build)
    asked.SetOtherStructure(choose(Structure, other_structure, "other_structure"))
    asked.SetOtherPrecision(choose(Precision, other_precision, "other_precision"))
    asked.SetQuery(choose(Query, query, "query"))
    asked.SetTolerance(float(tolerance))
    run(asked, progress)
    lines, table = (asked.GetOutputDataObject(port) for port in (0, 1))
    return Disagreements(first_row(table), lines)
