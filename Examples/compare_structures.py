# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Structures side by side: when is a grid right, and when a tree?

Prints the tables, and with a directory as argument and Matplotlib at hand draws two pictures there:
structures-grid-curve.png and structures-stadium.png.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

import lumitree

CAMERA = {"size": (80, 60)}


def work(table: dict) -> np.ndarray:
    """What a ray does in each row: nodes entered, cells stepped, triangles tested."""
    return table["NodesPerRay"] + table["CellsPerRay"] + table["TestsPerRay"]


def show(title: str, table: dict) -> None:
    print(title)
    for i, (structure, parameters) in enumerate(zip(table["Structure"], table["Parameters"])):
        print(
            f"  {structure:9} {parameters:26} {table['NodesPerRay'][i]:8.1f} nodes "
            f"{table['CellsPerRay'][i]:8.1f} cells {table['TestsPerRay'][i]:9.1f} tests a ray, "
            f"{table['RaysPerSecond'][i] / 1e6:7.3f} million rays/s"
        )


# Many things of one size, spread evenly. One cell: no acceleration. Too many: time is lost in empty
# cells. In between it is right.
cloud = lumitree.scene("random_cloud", resolution=30)  # 9000 triangles in the unit cube
at_cloud = lumitree.camera_rays(eye=(3, -2.5, 2), target=(0.5, 0.5, 0.5), **CAMERA)
grids = lumitree.compare_structures(
    cloud, at_cloud, "grid_cells", minimum=0.001, maximum=300, steps=12, repetitions=2
)
show("a cloud, grids from one cell to far too many", grids)
best = int(np.argmin(work(grids)))
assert 0 < best < len(work(grids)) - 1
assert work(grids)[0] > 10 * work(grids)[best]

# A teapot in a stadium: the teapot fills one cell of the grid, and every ray at it tests most of it.
stadium = lumitree.scene("teapot_in_stadium", resolution=16)
at_teapot = lumitree.camera_rays(eye=(0.35, -0.7, 0.4), target=(0.0, 0.0, 0.08), **CAMERA)
structures = lumitree.compare_structures(stadium, at_teapot, repetitions=2)
show("a teapot in a stadium, seen from near", structures)
tests = dict(zip(structures["Structure"], structures["TestsPerRay"]))
factor = tests["grid"] / max(tests["bvh"], tests["kd_tree"])
print(f"the grid tests {factor:.0f} times as many triangles as the worse of BVH and KD-tree")
assert factor > 20


def draw(directory: Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(7.2, 4.2), dpi=100)
    cells = grids["GridCells"]
    axes.loglog(cells, grids["CellsPerRay"], "o-", label="cells stepped through")
    axes.loglog(cells, grids["TestsPerRay"], "s-", label="triangles tested")
    axes.loglog(cells, work(grids), "k--", label="both, and nodes")
    axes.axvline(cells[best], color="0.7", zorder=0)
    axes.annotate("right", (cells[best], work(grids)[0]), ha="center")
    axes.annotate("one cell", (cells[0], 3), ha="left")
    axes.annotate("too many", (cells[-1], 3), ha="right")
    axes.set(xlabel="cells of the grid, for 9000 triangles", ylabel="on average a ray")
    axes.legend()
    figure.tight_layout()
    figure.savefig(directory / "structures-grid-curve.png")

    figure, axes = pyplot.subplots(figsize=(7.2, 3.6), dpi=100)
    names = structures["Structure"]
    axes.barh(names, structures["TestsPerRay"], color="#4477aa", label="triangles tested")
    axes.set_xscale("log")
    axes.invert_yaxis()
    for name, count in zip(names, structures["TestsPerRay"]):
        axes.annotate(f" {count:.3g}", (count, name), va="center")
    axes.set_title(f"Teapot in a stadium: the grid tests {factor:.0f} times as much as BVH and KD-tree")
    axes.set_xlabel("triangles that a ray at the teapot tests")
    axes.margins(x=0.15)
    figure.tight_layout()
    figure.savefig(directory / "structures-stadium.png")


if len(sys.argv) > 1:
    draw(Path(sys.argv[1]))
