# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rays against a surface, from numpy and to numpy."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSet, vtkPolyData

from .arrays import first_row, from_vtk
from .choices import BvhBuild, KdBuild, Precision, Query, Structure, StructureFileUse, choose
from .errors import run
from .rayset import rays
from .structures import set_structure
from .surfaces import Mesh, as_surface
from .vtk import vtkLumiRayCast

#: What a walk costs, as counted with ``cost=True``.
COST_ARRAYS = {
    "nodes_entered": "NodesEntered",
    "cells_stepped": "CellsStepped",
    "leaves_visited": "LeavesVisited",
    "primitives_tested": "PrimitivesTested",
}


@dataclass(frozen=True)
class Hits:
    """What rays met. With n rays, arrays have a row per ray (k = n) for ``closest``, and a row per
    hit, sorted by ray and then by t, for ``all`` and ``ties`` (k = m hits). What a query does not
    give is None.

    ================= ======== ======= ===== ===================================================
    attribute         shape    type    miss  given by
    ================= ======== ======= ===== ===================================================
    `hit`             (n,)     bool    False every query
    `count`           (n,)     int64   0     every query; of ``closest`` and ``any`` 0 or 1
    `inside`          (n,)     bool    False ``crossings``: whether `count` is odd
    `t`               (k,)     float64 inf   ``closest``, ``all``, ``ties``; in |direction|
    `cell_id`         (k,)     int64   -1    the same; local to its leaf data set
    `composite_index` (k,)     int32   -1    the same; flat index of the leaf (0: not composite)
    `uv`              (k, 2)   float64 nan   the same; barycentric, (1 - u - v) p0 + u p1 + v p2
    `normal`          (k, 3)   float64 nan   the same; unit length, by the triangle's winding
    `point`           (k, 3)   float   nan   the same; float64 if the rays or the mesh are
    `flags`           (k,)     int32   0     the same, of implicits that are no quadrics
    `ray_id`          (m,)     int64         ``all``, ``ties``: the ray of each hit
    `offsets`         (n + 1,) int64         the same: ray i has hits offsets[i]:offsets[i + 1]
    `cost`            (n,)     int32         ``cost=True``: a dict, see `COST_ARRAYS`
    ================= ======== ======= ===== ===================================================

    `flags` add up what is not certain about a hit: 1, whether an implicit is met there or nearly;
    2, seen between two samples; 4, the order of the ray's hits. None where no surface is such.

    `statistics` are facts about all the rays, by the names of the table Statistics of
    vtkLumiRayCast: ``Rays``, ``Hits``, ``ExactTests`` (questions that floating point left open) and
    more.

    `rays` and `hits` are the same as VTK data sets: the rays with their results as arrays, and a
    point for every hit. `surface` is the mesh; with ``cost=True`` its cells have ``RayTests``,
    ``RayHits`` and ``LeafReferences``: how often each was tested and hit, and how many leaves hold
    it. Arrays share memory with them.
    """

    hit: np.ndarray
    count: np.ndarray
    rays: vtkDataSet
    hits: vtkPolyData
    surface: vtkDataObject
    statistics: dict[str, str | int | float]
    inside: np.ndarray | None = None
    t: np.ndarray | None = None
    cell_id: np.ndarray | None = None
    composite_index: np.ndarray | None = None
    ray_id: np.ndarray | None = None
    offsets: np.ndarray | None = None
    cost: dict[str, np.ndarray] | None = None

    @cached_property
    def uv(self) -> np.ndarray | None:
        """Barycentric coordinates; made on first use, as are `normal` and `point`."""
        return self._rows(self.hits.GetPointData().GetArray("UV"))

    @cached_property
    def normal(self) -> np.ndarray | None:
        """Unit normals of the triangles."""
        return self._rows(self.hits.GetPointData().GetArray("Normals"))

    @cached_property
    def point(self) -> np.ndarray | None:
        """Where the mesh was hit."""
        return self._rows(self.hits.GetPoints().GetData())

    @cached_property
    def flags(self) -> np.ndarray | None:
        """What is not certain about hits, of surfaces with implicits; else None."""
        of_hits = self.hits.GetPointData().GetArray("HitFlags")
        if self.t is None or of_hits is None:
            return None
        rows = vtk_to_numpy(of_hits)
        if len(rows) == len(self.t):
            return rows
        result = np.zeros(len(self.t), rows.dtype)
        result[self.hit] = rows
        return result

    def _rows(self, of_hits: vtkDataArray) -> np.ndarray | None:
        if self.t is None:
            return None
        rows = vtk_to_numpy(of_hits)
        if len(rows) == len(self.t):
            return rows
        result = np.full((len(self.t), rows.shape[1]), np.nan, rows.dtype)
        result[self.hit] = rows
        return result


class Caster:
    """Casts rays at one mesh, again and again: what is built over the mesh is built once.

    mesh : a vtkDataSet or a composite of them, ``(points, triangles)``, or a file's name, see
        `as_surface`. Points in numpy are shared: do not change them while this is in use.
    structure : ``"auto"``, ``"brute_force"``, ``"bvh"``, ``"wide_bvh"``, ``"grid"``, ``"octree"``,
        ``"kd_tree"``, ``"bsp_tree"``, ``"embree"``, ``"cgal"``, ``"cgal_epick"`` or
        ``"cgal_cartesian"``. One that this build lacks is an
        error.
    precision : ``"fast"`` (may leak at edges), ``"watertight"``, ``"exact"``, or ``"automatic"``:
        the most exact that the structure promises, ``"exact"`` of all but the references.
    bvh_build : ``"binned_sah"``, ``"longest_axis_median"``, ``"sweep_sah"``, ``"spatial_splits"`` or
        ``"morton"``.
    kd_build : ``"sah"`` or ``"spatial_median"``.
    leaf_size : a tree's nodes with more primitives than this are split; 1 to 1024.
    max_depth : a tree's nodes as deep as this are leaves; 1 to 64.
    grid_density : a grid's cells per primitive; above 0, at most 1000.
    grid_resolution : a grid's cells along x, y and z, instead; each 1 to 2^20.
    mailboxing : let rays remember the primitives they were tested against of late, in a grid, an
        octree, a KD- or a BSP-tree. Hits are the same, tests are fewer.
    threads : 0 means VTK_SMP_MAX_THREADS when that is set, else as many as this process may use.
        Results do not depend on it.
    refit : fit a bounding volume hierarchy to points that moved, when the mesh is set to another
        one of the same cells or its points are told to be modified, in place of building it again.
        Hits are the same; ``statistics["Origin"]`` tells which it was.
    refit_limit : build again where rays are expected to cost so many times what they did when the
        tree was built; at least 1.
    structure_file : a file that keeps the structure from one run to the next. One that is damaged
        or no saved structure is an error, and never overwritten.
    structure_file_use : ``"load_or_build"`` (loaded where it is of this mesh and these options,
        else built, and saved where there is no file), ``"load"`` (whatever the options; of another
        mesh an error) or ``"save"``.

    Raises ValueError for wrong names, types and shapes. Over several MPI ranks, with a global VTK
    controller, the mesh is the union of the ranks' meshes, and every rank has to cast.
    """

    def __init__(
        self,
        mesh: Mesh,
        *,
        structure: Structure | str = "auto",
        precision: Precision | str = "automatic",
        bvh_build: BvhBuild | str = "binned_sah",
        kd_build: KdBuild | str = "sah",
        leaf_size: int = 4,
        max_depth: int = 64,
        grid_density: float = 0.5,
        grid_resolution: Sequence[int] | None = None,
        mailboxing: bool = False,
        threads: int = 0,
        refit: bool = True,
        refit_limit: float = 2.0,
        structure_file: str | os.PathLike[str] | None = None,
        structure_file_use: StructureFileUse | str = "load_or_build",
    ) -> None:
        self._filter = vtkLumiRayCast()
        set_structure(
            self._filter,
            structure,
            precision=precision,
            bvh_build=bvh_build,
            kd_build=kd_build,
            leaf_size=leaf_size,
            max_depth=max_depth,
            grid_density=grid_density,
            grid_resolution=grid_resolution,
            mailboxing=mailboxing,
            threads=threads,
            refit=refit,
            refit_limit=refit_limit,
            structure_file=structure_file,
            structure_file_use=structure_file_use,
        )
        self.mesh = mesh

    @property
    def mesh(self) -> vtkDataObject:
        """The mesh that rays are cast at, as a VTK object. It may be set to another one."""
        return self._mesh

    @mesh.setter
    def mesh(self, mesh: Mesh) -> None:
        self._mesh = as_surface(mesh)
        self._filter.SetInputDataObject(0, self._mesh)

    def cast(
        self,
        origins: ArrayLike | vtkDataSet,
        directions: ArrayLike | None = None,
        t_min: ArrayLike = 0.0,
        t_max: ArrayLike = np.inf,
        query: Query | str = "closest",
        *,
        cost: bool = False,
        rounded_t: bool = False,
        progress: Callable[[float], None] | None = None,
    ) -> Hits:
        """Casts rays.

        origins, directions : (n, 3) or (3,); a single one goes with all of the other. float32 and
            float64 are used as they are. Directions have any length but 0 and are not normalised: a
            hit is at origin + t * direction. Or `origins` alone, a vtkDataSet of rays, such as of
            `camera_rays`.
        t_min, t_max : closed limits of t; a number, or (n,) for a limit per ray. In a data set of
            rays, ``RayTMin`` and ``RayTMax`` come first.
        query : ``"closest"``, ``"any"`` (is anything hit), ``"all"`` (every hit), ``"count"`` (how
            many), ``"ties"`` (every hit at the least t) or ``"crossings"``: how often the ray
            passes through the surface, once also at edges and vertices; odd from inside a closed
            surface.
        cost : also count what each ray's walk costs. Slower.
        rounded_t : t is the double nearest to the exact one; of the precision exact.
        progress : called with the part that is done, from 0 to 1.

        Raises ValueError for wrong shapes, types and names; LumitreeError for what the filter
        refuses. Rays that cannot be traced (a coordinate not finite, direction 0, t_min > t_max)
        hit nothing, and a LumitreeWarning counts them.
        """
        if isinstance(origins, vtkDataSet):
            if directions is not None:
                raise ValueError("origins is a data set of rays, so directions must be left out")
            ray_set = origins
            limits = float(t_min), float(t_max)
        elif directions is None:
            raise ValueError(
                "directions are missing (only a vtkDataSet of rays has them in itself)"
            )
        else:
            ray_set = rays(origins, directions, t_min, t_max)
            limits = tuple(
                float(limit) if np.ndim(limit) == 0 else default
                for limit, default in ((t_min, 0.0), (t_max, np.inf))
            )
        if not limits[0] <= limits[1]:
            raise ValueError(
                f"t_min must not be above t_max, but they are {limits[0]} and {limits[1]}"
            )
        question = choose(Query, query, "query")
        self._filter.SetRaysData(ray_set)
        self._filter.SetTMin(limits[0])
        self._filter.SetTMax(limits[1])
        self._filter.SetQuery(question)
        self._filter.SetCountTraversal(bool(cost))
        self._filter.SetRoundedParameter(bool(rounded_t))
        if rounded_t and self._filter.GetPrecision() not in (Precision.EXACT, Precision.AUTOMATIC):
            raise ValueError("rounded_t needs the precision 'exact'")
        run(self._filter, progress)
        return _hits(self._filter, question, cost)


def cast(
    mesh: Mesh,
    origins: ArrayLike | vtkDataSet,
    directions: ArrayLike | None = None,
    t_min: ArrayLike = 0.0,
    t_max: ArrayLike = np.inf,
    query: Query | str = "closest",
    precision: Precision | str = "automatic",
    structure: Structure | str = "auto",
    threads: int = 0,
    *,
    cost: bool = False,
    rounded_t: bool = False,
    progress: Callable[[float], None] | None = None,
    **build: object,
) -> Hits:
    """Casts rays at a mesh, once. Arguments and errors are those of `Caster` (`build` are
    bvh_build, leaf_size and so on) and `Caster.cast`; use a `Caster` to cast several times at one
    mesh.

    >>> hits = lumitree.cast("bunny.ply", origins=(0, 0, 5), directions=[(0, 0, -1), (0, 1, 0)])
    >>> hits.t, hits.cell_id
    """
    caster = Caster(mesh, structure=structure, precision=precision, threads=threads, **build)
    return caster.cast(
        origins, directions, t_min, t_max, query, cost=cost, rounded_t=rounded_t, progress=progress
    )


def inside(
    mesh: Mesh,
    points: ArrayLike,
    structure: Structure | str = "auto",
    threads: int = 0,
    *,
    progress: Callable[[float], None] | None = None,
    **build: object,
) -> np.ndarray:
    """Whether points lie inside a closed mesh: a bool for each, decided exactly.

    points : (n, 3) or (3,).

    The mesh is to be closed (see `surface_report`); its triangles need not share points, and may be
    wound as they like. Bodies of `implicit` may stand in for it or beside it, if they are closed and
    not sampled. Of several closed meshes, or one that overlaps itself, a point is inside
    when an odd number of them holds it. A point on the surface is where the point moved up along x
    (then y, then z) by next to nothing is. Points with a coordinate that is not finite are outside,
    and a LumitreeWarning counts them. Other arguments and errors are those of `cast`.

    >>> lumitree.inside("bunny.ply", [(0, 0, 0), (9, 9, 9)])
    """
    caster = Caster(mesh, structure=structure, precision="exact", threads=threads, **build)
    return caster.cast(points, (0.0, 0.0, 1.0), query="crossings", progress=progress).inside


def _hits(filter_: vtkLumiRayCast, query: Query, cost: bool) -> Hits:
    # Shallow copies, because the filter empties its outputs when it runs again.
    hits = filter_.GetOutputDataObject(0).NewInstance()
    hits.ShallowCopy(filter_.GetOutputDataObject(0))
    ray_set = filter_.GetOutputDataObject(1).NewInstance()
    ray_set.ShallowCopy(filter_.GetOutputDataObject(1))

    surface = filter_.GetOutputDataObject(2).NewInstance()
    surface.ShallowCopy(filter_.GetOutputDataObject(2))

    per_ray, per_hit = ray_set.GetPointData(), hits.GetPointData()
    if not per_ray.HasArray("HitMask"):
        per_ray = ray_set.GetCellData()
    result = {}
    if query in (Query.CLOSEST, Query.ALL, Query.TIES):
        source = per_ray if query == Query.CLOSEST else per_hit
        result["t"] = from_vtk(source, "T")
        result["cell_id"] = from_vtk(source, "CellId")
        result["composite_index"] = from_vtk(source, "CompositeIndex")
    if query == Query.CROSSINGS:
        result["inside"] = from_vtk(per_ray, "Inside").view(bool)
    if query in (Query.ALL, Query.TIES):
        result["ray_id"] = from_vtk(per_hit, "RayId")
        result["offsets"] = np.append(from_vtk(per_ray, "HitOffset"), hits.GetNumberOfPoints())
    if cost:
        result["cost"] = {key: from_vtk(per_ray, name) for key, name in COST_ARRAYS.items()}
    hit, count = from_vtk(per_ray, "HitMask").view(bool), from_vtk(per_ray, "HitCount")
    statistics = first_row(filter_.GetOutputDataObject(3))
    return Hits(hit, count, ray_set, hits, surface, statistics, **result)
