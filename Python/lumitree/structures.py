# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which structure is built over a surface, and how: the same options for every function."""

from __future__ import annotations

import os
from collections.abc import Sequence

import numpy as np

from .arrays import in_range
from .choices import BvhBuild, KdBuild, Precision, Structure, StructureFileUse, choose
from .vtk import vtkLumiStructureAlgorithm


def set_structure(
    filter_: vtkLumiStructureAlgorithm,
    structure: Structure | str = "auto",
    *,
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
    """Tells a filter what to build. The options are described at `Caster`.

    Raises ValueError for wrong names, types and ranges.
    """
    filter_.SetStructure(choose(Structure, structure, "structure"))
    filter_.SetPrecision(choose(Precision, precision, "precision"))
    filter_.SetBvhBuild(choose(BvhBuild, bvh_build, "bvh_build"))
    filter_.SetKdBuild(choose(KdBuild, kd_build, "kd_build"))
    filter_.SetLeafSize(in_range(leaf_size, 1, 1024, "leaf_size"))
    filter_.SetMaxDepth(in_range(max_depth, 1, 64, "max_depth"))
    filter_.SetGridDensity(_density(grid_density))
    filter_.SetGridResolution(_resolution(grid_resolution))
    filter_.SetMailboxing(bool(mailboxing))
    filter_.SetNumberOfThreads(in_range(threads, 0, 4096, "threads"))
    filter_.SetRefit(bool(refit))
    filter_.SetRefitLimit(_limit(refit_limit))
    filter_.SetStructureFile(os.fspath(structure_file) if structure_file is not None else "")
    filter_.SetStructureFileUse(
        choose(StructureFileUse, structure_file_use, "structure_file_use")
    )


def _limit(value: float) -> float:
    number = isinstance(value, (int, float, np.integer, np.floating))
    if isinstance(value, bool) or not number or not 1 <= value <= 1e300:
        raise ValueError(f"refit_limit must be a number from 1 on, not {value!r}")
    return float(value)


def _density(value: float) -> float:
    number = isinstance(value, (int, float, np.integer, np.floating))
    if isinstance(value, bool) or not number or not 0 < value <= 1000:
        raise ValueError(f"grid_density must be above 0 and at most 1000, not {value!r}")
    return float(value)


def _resolution(value: Sequence[int] | None) -> tuple[int, int, int]:
    if value is None:
        return 0, 0, 0
    if isinstance(value, str) or np.shape(value) != (3,):
        raise ValueError(f"grid_resolution must be three whole numbers, not {value!r}")
    x, y, z = (in_range(cells, 1, 2**20, "grid_resolution") for cells in value)
    return x, y, z
