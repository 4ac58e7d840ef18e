# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Speed against accuracy, measured on a surface."""

from __future__ import annotations

from collections.abc import Callable

from .arrays import in_range
from .errors import run
from .surfaces import Mesh, as_surface
from .vtk import vtkLumiAccuracyChart


def accuracy_chart(
    mesh: Mesh,
    rays: int = 2000,
    *,
    seed: int = 1,
    repeats: int = 2,
    brute_force_limit: int = 2000,
    progress: Callable[[float], None] | None = None,
) -> list[dict[str, str | int | float]]:
    """Measures every structure and precision, the references that this build has, and VTK's static
    cell locator, on five kinds of rays. CGAL is among them once `lumitree.reference` is imported.

    rays : of each kind.
    seed : the same seed gives the same rays.
    repeats : of which the fastest counts.
    brute_force_limit : for surfaces of more triangles brute force is left out. It is asked only so
        many rays that it tests 2e7 triangles, or 100.

    A dict for each back end and kind of rays: ``BackEnd``, ``Setting``, ``Precision``, ``RayKind``
    (``Random``, ``Camera``, ``ThroughVertex``, ``ThroughEdge``, ``TowardVertex``), ``Rays``,
    ``Leaks``, ``Phantoms``, ``OtherPrimitives``, ``FarPrimitives``, ``MedianTError``,
    ``MaxTError``, ``NanosecondsPerRay``.

    Raises ValueError for wrong types and ranges, LumitreeError for what the filter refuses.
    """
    chart = vtkLumiAccuracyChart()
    chart.SetInputDataObject(0, as_surface(mesh))
    chart.SetNumberOfRays(in_range(rays, 1, 10_000_000, "rays"))
    chart.SetSeed(in_range(seed, 0, 2**31 - 1, "seed"))
    chart.SetRepeats(in_range(repeats, 1, 100, "repeats"))
    chart.SetBruteForceLimit(in_range(brute_force_limit, 0, 2**31 - 1, "brute_force_limit"))
    run(chart, progress)
    table = chart.GetOutput()
    columns = [table.GetColumn(i) for i in range(table.GetNumberOfColumns())]
    return [
        {column.GetName(): column.GetValue(i) for column in columns}
        for i in range(table.GetNumberOfRows())
    ]
