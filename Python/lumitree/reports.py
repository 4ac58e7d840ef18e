# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the command line and the demonstration leave on disk: data to open in ParaView, and
pictures."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataObject, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkCompositeDataGeometryFilter, vtkGeometryFilter

from .camera import View, camera_rays
from .choices import choose_length_unit
from .errors import run
from .files import write
from .progress import progress_bar
from .radiometry import irradiance
from .raycast import Caster
from .trees import hierarchy

METRES = (1.0, 1e-3, 1e-2, 1e3, 0.0254, 0.3048)  #: per unit, by LengthUnit

#: Boxes in a picture of a hierarchy: more hide each other.
PICTURE_BOXES = 520


@dataclass(frozen=True)
class Report:
    """Where results go, and how they are computed and shown."""

    directory: Path
    view: View
    pictures: bool = True
    structure: str = "auto"
    precision: str = "fast"
    bvh_build: str = "binned_sah"
    leaf_size: int = 4
    threads: int = 0

    @property
    def tree_options(self) -> dict[str, str | int]:
        """The arguments that `hierarchy` and `Caster` share."""
        return {
            "structure": self.structure,
            "bvh_build": self.bvh_build,
            "leaf_size": self.leaf_size,
            "threads": self.threads,
        }


def outer_surface(data: vtkDataObject) -> vtkPolyData:
    """The surface of any data set or composite as one vtkPolyData."""
    if isinstance(data, vtkPolyData):
        return data
    composite = isinstance(data, vtkCompositeDataSet)
    extract = vtkCompositeDataGeometryFilter() if composite else vtkGeometryFilter()
    extract.SetInputDataObject(data)
    run(extract)
    return extract.GetOutput()


def report_hierarchy(report: Report, surface: vtkPolyData) -> str:
    """Writes hierarchy.vtm, and hierarchy.png. Returns a line about it."""
    with progress_bar("hierarchy") as progress:
        tree = hierarchy(surface, **report.tree_options, progress=progress)
    write(tree.levels, report.directory / "hierarchy.vtm")
    if report.pictures:
        from .pictures import boxes_picture

        boxes = _upper_boxes(tree.levels)
        title = "Depth in\nthe tree"
        boxes_picture(
            report.directory / "hierarchy.png", surface, boxes, "Depth", title, report.view
        )
    facts = tree.statistics
    return (
        f"{facts['Structure']}: {facts['Primitives']:,} triangles in {facts['Nodes']:,} nodes, "
        f"{facts['Leaves']:,} of them leaves, {facts['Depth']} deep, "
        f"SAH cost {facts['SahCost']:.4g}, {facts['MemoryBytes'] / 1e6:.3g} MB, "
        f"built in {facts['BuildSeconds'] * 1e3:.3g} ms"
    )


def report_cost(report: Report, surface: vtkPolyData, size: tuple[int, int]) -> str:
    """Casts the rays of a camera; writes cost.vti, hits.vtp, and cost.png. Returns a line about
    them."""
    view = report.view
    camera = camera_rays(
        view.eye, view.target, up=view.up, angle=view.angle, near=view.near, size=size
    )
    caster = Caster(surface, precision=report.precision, **report.tree_options)
    with progress_bar("rays") as progress:
        start = time.perf_counter()
        result = caster.cast(camera, cost=True, progress=progress)
        seconds = time.perf_counter() - start
    write(result.rays, report.directory / "cost.vti")
    write(result.hits, report.directory / "hits.vtp")
    mean = {key: float(np.mean(counts)) for key, counts in result.cost.items()}
    if report.pictures:
        from .pictures import image_picture

        array, title = "NodesEntered", "Tree nodes\nentered"
        if mean["cells_stepped"] > mean["nodes_entered"]:
            array, title = "CellsStepped", "Grid cells\nstepped"
        elif mean["nodes_entered"] <= 1:
            array, title = "PrimitivesTested", "Triangles\ntested"
        image_picture(report.directory / "cost.png", result.rays, array, title)
    return (
        f"{len(result.hit):,} rays, {np.mean(result.hit):.0%} hit; on average a ray enters "
        f"{mean['nodes_entered']:.3g} nodes, steps through {mean['cells_stepped']:.3g} cells "
        f"and tests {mean['primitives_tested']:.3g} triangles; {seconds:.3g} s with counting"
    )


def report_irradiance(
    report: Report,
    surface: vtkPolyData,
    lights: Sequence[vtkDataObject],
    at: str = "cells",
    length_unit: str = "m",
) -> str:
    """Writes irradiance.vtp, and irradiance.png. Returns a line about it."""
    with progress_bar("irradiance") as progress:
        result = irradiance(
            surface,
            lights,
            at=at,
            length_unit=length_unit,
            per_light=len(lights) > 1,
            precision=report.precision,
            structure=report.structure,
            threads=report.threads,
            progress=progress,
        )
    write(result.dataset, report.directory / "irradiance.vtp")
    quantity = result.name.split()[0]
    if report.pictures:
        from .pictures import surface_picture

        title = f"{quantity}\n[{result.unit}]"
        surface_picture(
            report.directory / "irradiance.png", result.dataset, result.name, title, report.view
        )
    finite = result.values[np.isfinite(result.values)]
    if not finite.size:
        return f"{quantity}: no receiver has a normal"
    extremes = f"{finite.min():.4g} to {finite.max():.4g} {result.unit}"
    line = f"{quantity}: {len(finite):,} receivers, {extremes}"
    if at == "cells":
        metres = METRES[choose_length_unit(length_unit)]
        flux = received(result.dataset, result.name) * metres**2
        line += f"; {flux:.6g} {'lm' if result.unit == 'lx' else 'W'} received in all"
    return line


def received(surface: vtkPolyData, name: str) -> float:
    """The integral of a cell array over the surface, in its unit times the square of the
    coordinates'."""
    triangles = vtkTriangleFilter()
    triangles.SetInputData(surface)
    triangles.PassVertsOff()
    triangles.PassLinesOff()
    run(triangles)
    cut = triangles.GetOutput()
    if cut.GetNumberOfCells() == 0:
        return 0.0
    points = vtk_to_numpy(cut.GetPoints().GetData()).astype(float)
    a, b, c = (
        points[ids] for ids in vtk_to_numpy(cut.GetPolys().GetConnectivityArray()).reshape(-1, 3).T
    )
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    return float(np.nansum(vtk_to_numpy(cut.GetCellData().GetArray(name)) * areas))


def _upper_boxes(levels: vtkCompositeDataSet) -> vtkPolyData:
    """The levels from the root down, as far as they do not hide each other."""
    append = vtkAppendPolyData()
    boxes = 0
    for i in range(levels.GetNumberOfBlocks()):
        level = levels.GetBlock(i)
        boxes += len(np.unique(vtk_to_numpy(level.GetCellData().GetArray("NodeId"))))
        if i > 0 and boxes > PICTURE_BOXES:
            break
        append.AddInputData(level)
    run(append)
    return append.GetOutput()
