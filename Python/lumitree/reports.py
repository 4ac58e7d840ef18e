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
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataObject, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkCompositeDataGeometryFilter, vtkGeometryFilter

from .arrays import from_vtk
from .camera import View, camera_rays
from .comparison import compare_structures
from .errors import run
from .files import write
from .looking import radiance
from .progress import progress_bar
from .radiometry import irradiance
from .raycast import Caster, inside
from .trees import hierarchy

#: Boxes in a picture of a hierarchy: more hide each other.
PICTURE_BOXES = 520


@dataclass
class Report:
    """Computes all there is for one surface; leaves it in a directory, which has to exist."""

    surface: vtkPolyData
    directory: Path
    view: View
    pictures: bool = True
    structure: str = "auto"
    precision: str = "automatic"
    bvh_build: str = "binned_sah"
    kd_build: str = "sah"
    leaf_size: int = 4
    max_depth: int = 64
    grid_density: float = 0.5
    grid_resolution: tuple[int, int, int] | None = None
    threads: int = 0
    structure_file: str | None = None

    def __post_init__(self) -> None:
        self._tree_options = {
            "structure": self.structure,
            "bvh_build": self.bvh_build,
            "kd_build": self.kd_build,
            "leaf_size": self.leaf_size,
            "max_depth": self.max_depth,
            "grid_density": self.grid_density,
            "grid_resolution": self.grid_resolution,
            "threads": self.threads,
        }
        self._caster = Caster(self.surface, precision=self.precision, **self._tree_options)

    def hierarchy(self) -> str:
        """Writes hierarchy.vtm, and hierarchy.png. Returns a line about it."""
        with progress_bar("hierarchy") as progress:
            tree = hierarchy(
                self.surface,
                **self._tree_options,
                structure_file=self.structure_file,
                progress=progress,
            )
            self._tree = tree  # the rays find it built
        write(tree.levels, self.directory / "hierarchy.vtm")
        if self.pictures:
            from .pictures import boxes_picture

            path = self.directory / "hierarchy.png"
            boxes = _upper_boxes(tree.levels)
            boxes_picture(path, self.surface, boxes, "Depth", "Depth in\nthe tree", self.view)
        facts = tree.statistics
        return (
            f"{facts['Structure']}: {facts['Primitives']:,} triangles in {facts['Nodes']:,} nodes, "
            f"{facts['Leaves']:,} of them leaves, {facts['Depth']} deep, "
            f"SAH cost {facts['SahCost']:.4g}, {facts['MemoryBytes'] / 1e6:.3g} MB, "
            f"{facts['Origin']} in {facts['BuildSeconds'] * 1e3:.3g} ms"
        )

    def _camera(self, size: tuple[int, int]) -> vtkImageData:
        view = self.view
        return camera_rays(
            view.eye, view.target, up=view.up, angle=view.angle, near=view.near, size=size
        )

    def compare(self, size: tuple[int, int]) -> list[str]:
        """Casts the rays of a camera of that many pixels at every structure. Returns a line about
        each."""
        with progress_bar("structures") as progress:
            table = compare_structures(
                self.surface,
                self._camera(size),
                precision=self.precision,
                repetitions=1,
                progress=progress,
                **{**self._tree_options, "structure": "auto"},
            )
        return [
            f"{structure:9} {table['TestsPerRay'][i]:9.4g} triangles tested, "
            f"{table['NodesPerRay'][i] + table['CellsPerRay'][i]:7.4g} nodes and cells a ray; "
            f"{table['MemoryBytes'][i] / 1e6:.3g} MB, built in "
            f"{table['BuildSeconds'][i] * 1e3:.3g} ms, {table['RaysPerSecond'][i] / 1e6:.3g} million rays/s"
            for i, structure in enumerate(table["Structure"])
        ]

    def cost(self, size: tuple[int, int]) -> str:
        """Casts the rays of a camera of that many pixels; writes cost.vti, hits.vtp, and cost.png.
        Returns a line about them."""
        camera = self._camera(size)
        with progress_bar("rays") as progress:
            start = time.perf_counter()
            self._caster.cast(camera)
            seconds = time.perf_counter() - start
            result = self._caster.cast(camera, cost=True, progress=progress)
        write(result.rays, self.directory / "cost.vti")
        write(result.hits, self.directory / "hits.vtp")
        mean = {key: float(np.mean(counts)) for key, counts in result.cost.items()}
        if self.pictures:
            from .pictures import image_picture

            array, title = "NodesEntered", "Tree nodes\nentered"
            if mean["cells_stepped"] > mean["nodes_entered"]:
                array, title = "CellsStepped", "Grid cells\nstepped"
            elif mean["nodes_entered"] <= 1:
                array, title = "PrimitivesTested", "Triangles\ntested"
            image_picture(self.directory / "cost.png", result.rays, array, title)
        steps = (
            f"steps through {mean['cells_stepped']:.3g} cells, " if mean["cells_stepped"] else ""
        )
        unsure = result.statistics["ExactTests"]
        decided = "" if self.precision == "fast" else f"; arithmetic left {unsure:,} questions open"
        return (
            f"{len(result.hit):,} rays in {seconds:.3g} s, {np.mean(result.hit):.0%} hit; on "
            f"average a ray enters {mean['nodes_entered']:.3g} nodes, {steps}"
            f"tests {mean['primitives_tested']:.3g} triangles{decided}"
        )

    def sides(self, points: Sequence[tuple[float, float, float]]) -> str:
        """Returns a line about which of the points are inside the surface."""
        flags = inside(self.surface, points, **self._tree_options)
        return "; ".join(
            f"{','.join(f'{x:g}' for x in point)} is {'inside' if flag else 'outside'}"
            for point, flag in zip(points, flags)
        )

    def light(
        self,
        lights: Sequence[vtkDataObject],
        at: str = "cells",
        length_unit: str = "m",
        tolerance: float = 0.01,
    ) -> str:
        """Writes irradiance.vtp, and irradiance.png. Returns a line about it."""
        with progress_bar("irradiance") as progress:
            result = irradiance(
                self.surface,
                lights,
                at=at,
                length_unit=length_unit,
                per_light=len(lights) > 1,
                tolerance=tolerance,
                precision=self.precision,
                **self._tree_options,
                progress=progress,
            )
        write(result.dataset, self.directory / "irradiance.vtp")
        quantity = result.name.split()[0]
        if self.pictures:
            from .pictures import surface_picture

            path = self.directory / "irradiance.png"
            title = f"{quantity}\n[{result.unit}]"
            surface_picture(path, result.dataset, result.name, title, self.view)
        finite = result.values[np.isfinite(result.values)]
        if not finite.size:
            return f"{quantity}: no receiver has a normal"
        extremes = f"{finite.min():.4g} to {finite.max():.4g} {result.unit}"
        line = f"{quantity}: {len(finite):,} receivers, {extremes}"
        if result.rays.any():
            line += f", {int(result.rays.sum()):,} rays"
        if at == "cells":
            metres = from_vtk(result.dataset.GetFieldData(), "MetresPerUnit")[0]
            flux = received(result.dataset, result.name) * metres**2
            line += f"; {flux:.6g} {'lm' if result.unit == 'lx' else 'W'} received in all"
        return line

    def radiance(
        self,
        lights: Sequence[vtkDataObject],
        size: tuple[int, int],
        reflectance: float = 0.5,
        length_unit: str = "m",
        tolerance: float = 0.01,
    ) -> str:
        """Writes radiance.vti, what a camera of that many pixels sees, and radiance.png. Returns a
        line about it."""
        with progress_bar("radiance") as progress:
            result = radiance(
                self._camera(size),
                lights=lights,
                occluders=self.surface,
                reflectance=reflectance,
                length_unit=length_unit,
                tolerance=tolerance,
                precision=self.precision,
                **self._tree_options,
                progress=progress,
            )
        write(result.dataset, self.directory / "radiance.vti")
        quantity = result.name.split()[0]
        if self.pictures:
            from .pictures import image_picture

            title = f"{quantity}\n[{result.unit}]"
            image_picture(self.directory / "radiance.png", result.dataset, result.name, title)
        finite = result.values[np.isfinite(result.values)]
        return (
            f"{quantity}: {len(result.values):,} pixels, {np.count_nonzero(finite):,} of them lit, "
            f"up to {finite.max(initial=0.0):.4g} {result.unit}"
        )


def outer_surface(data: vtkDataObject) -> vtkPolyData:
    """The surface of any data set or composite as one vtkPolyData."""
    if isinstance(data, vtkPolyData):
        return data
    composite = isinstance(data, vtkCompositeDataSet)
    extract = vtkCompositeDataGeometryFilter() if composite else vtkGeometryFilter()
    extract.SetInputDataObject(data)
    run(extract)
    return extract.GetOutput()


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
