# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Measures speed against accuracy of every back end on several meshes and writes the tables of accuracy.md
and its pictures; `./lumitree chart` runs it.

python3 Docs/make_accuracy.py [RAYS OF EACH KIND]

What is between the marks ``<!-- chart … -->`` and ``<!-- end -->`` on the page is replaced.
"""

from __future__ import annotations

import csv
import platform
import re
import sys
from collections import defaultdict
from pathlib import Path

import matplotlib
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import lumitree

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  after the choice of back end

HERE = Path(__file__).resolve().parent
PAGE = HERE / "accuracy.md"
ORDINARY = ("Random", "Camera")
DEGENERATE = ("ThroughVertex", "ThroughEdge", "TowardVertex")
UTM = (500000.0, 4649776.0, 100.0)
COLOURS = {"exact": "#1b7837", "watertight": "#2166ac", "fast": "#92c5de"}


def mesh(name: str, resolution: int, offset: tuple, grid: float, dtype) -> tuple:
    """A scene 100 times as large, on a grid so that floats hold it, moved; as points and triangles."""
    data = lumitree.scene(name, resolution=resolution)
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float) * 100
    if grid:
        points = np.round(points / grid) * grid
    cells = data.GetPolys()
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    ids = vtk_to_numpy(cells.GetConnectivityArray())
    triangles = [
        (ids[begin], ids[i], ids[i + 1])
        for begin, end in zip(offsets[:-1], offsets[1:])
        for i in range(begin + 1, end - 1)
    ]
    return (points + offset).astype(dtype), np.array(triangles)


def meshes() -> dict[str, tuple]:
    return {
        "sphere, floats": mesh("sphere", 64, (0, 0, 0), 2**-10, np.float32),
        "torus, floats at 1e6": mesh("torus", 100, (1e6, 1e6, 1e6), 2**-4, np.float32),
        "torus, doubles at UTM coordinates": mesh("torus", 100, UTM, 0, np.float64),
        "terrain, floats": mesh("terrain", 128, (0, 0, 0), 2**-10, np.float32),
    }


def label(row: dict) -> str:
    words = [row["BackEnd"], row["Setting"], row["Precision"] if "cgal" not in row["BackEnd"] else ""]
    text = " ".join(word for word in words if word)
    return text.replace("embree robust fast", "Embree robust").replace("embree not robust fast", "Embree")


def pooled(rows: list[dict], kinds: tuple) -> dict[str, dict]:
    """Per back end over all meshes: geometric mean of the times, failures per million, errors of t."""
    groups = defaultdict(list)
    for row in rows:
        if row["RayKind"] in kinds:
            groups[label(row)].append(row)
    result = {}
    for name, group in groups.items():
        rays = sum(row["Rays"] for row in group)

        def per_million(column, group=group, rays=rays):
            return 1e6 * sum(row[column] for row in group) / rays

        result[name] = {
            "ns": float(np.exp(np.mean([np.log(row["NanosecondsPerRay"]) for row in group]))),
            "leaks": per_million("Leaks"),
            "phantoms": per_million("Phantoms"),
            "others": per_million("OtherPrimitives"),
            "far": per_million("FarPrimitives"),
            "median": float(np.median([row["MedianTError"] for row in group])),
            "max": max(row["MaxTError"] for row in group),
            "precision": group[0]["Precision"] if "cgal" not in name and "Embree" not in name else "",
        }
    return result


def table(rows: list[dict]) -> str:
    lines = []
    for title, kinds in (("Random and camera rays", ORDINARY), ("Rays at vertices and edges", DEGENERATE)):
        lines += [f"{title}, all meshes together; failures per million rays.", ""]
        lines += ["| back end | ns per ray | leaks | phantoms | other triangle | of these far | median error of t | largest |"]
        lines += ["| --- | --- | --- | --- | --- | --- | --- | --- |"]
        for name, r in sorted(pooled(rows, kinds).items(), key=lambda item: item[1]["ns"]):
            lines.append(
                f"| {name} | {r['ns']:,.0f} | {r['leaks']:,.0f} | {r['phantoms']:,.0f} | {r['others']:,.0f} "
                f"| {r['far']:,.0f} | {r['median']:.0e} | {r['max']:.0e} |"
            )
        lines.append("")
    return "\n".join(lines).rstrip()


def pareto(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Those that no other is faster than and at least as accurate as."""
    front, best = [], np.inf
    for time, wrong in sorted(points):
        if wrong < best:
            front.append((time, wrong))
            best = wrong
    return front


def draw_chart(rows: list[dict], path: Path) -> None:
    figure, axes = pyplot.subplots(1, 2, figsize=(14, 6.5), sharey=True)
    for axis, (title, kinds) in zip(
        axes, (("random and camera rays", ORDINARY), ("rays at vertices and edges", DEGENERATE))
    ):
        results = pooled(rows, kinds)
        places = {n: (r["ns"], r["leaks"] + r["phantoms"] + r["others"]) for n, r in results.items()}
        front = pareto(list(places.values()))
        axis.step(*zip(*front), where="post", color="#b2182b", lw=1, zorder=1, label="no other is better in both")
        crowd = defaultdict(int)
        for name, (time, wrong) in sorted(places.items(), key=lambda item: item[1]):
            axis.scatter(time, wrong, color=COLOURS.get(results[name]["precision"], "#762a83"), zorder=2, s=28)
            cell = (round(3 * np.log10(time)), round(np.log10(wrong + 0.1)))
            lift = 6 + 9 * crowd[cell]
            crowd[cell] += 1
            axis.annotate(name, (time, wrong), xytext=(4, lift), textcoords="offset points", fontsize=6.5)
        axis.set_xscale("log")
        axis.set_yscale("symlog", linthresh=1)
        axis.set_ylim(-0.2, 3e7)
        axis.set_xlabel("nanoseconds per ray, one thread")
        axis.set_title(title)
        axis.grid(alpha=0.3)
    axes[0].set_ylabel("wrong rays per million: leaks, phantoms, other triangles")
    axes[0].legend(loc="upper right")
    figure.tight_layout()
    figure.savefig(path, dpi=90)
    pyplot.close(figure)


def first_failure(wrong: np.ndarray) -> int | None:
    return int(np.argmax(wrong)) if wrong.any() else None


def draw_failures(path: Path) -> None:
    """Rays of which a back end is wrong. Above, along the ray: the triangles around the point that it should
    hit, the right one green, the one named red. Below, from the side: where it goes."""
    figure, (axes, sides) = pyplot.subplots(2, 3, figsize=(12, 8.6))
    leaks, others = (lambda f, t: (f < 0) & (t >= 0)), (lambda f, t: (f >= 0) & (f != t))
    floats, doubles = mesh("sphere", 24, (0, 0, 0), 2**-10, np.float32), mesh("sphere", 24, UTM, 0, float)
    shown = (
        ("a leak at a vertex", "embree", floats, (0, 0, 0), False, leaks),
        ("a leak at an edge (full mantissas)", "fast", doubles, UTM, True, leaks),
        ("another triangle at the same point", "fast", floats, (0, 0, 0), False, others),
    )
    for axis, side, (title, back_end, surface, middle, at_edge, is_wrong) in zip(axes, sides, shown):
        points, triangles = surface
        rng = np.random.default_rng(3)
        origins = np.round(rng.uniform(-20, 20, (30000, 3)) * 1024) / 1024 + middle
        corners = points[triangles[rng.integers(len(triangles), size=len(origins))]].astype(float)
        directions = corners[:, 0] - origins
        if at_edge:
            directions += corners[:, 1] - origins
        truth = lumitree.cast(surface, origins, directions, precision="exact")
        if back_end == "embree":
            options = {"structure": "embree", "precision": "fast"}
        else:
            options = {"structure": "wide_bvh", "precision": "fast"}
        try:
            found = lumitree.cast(surface, origins, directions, **options)
        except lumitree.LumitreeError:
            axis.set_axis_off()
            side.set_axis_off()
            continue
        i = first_failure(is_wrong(found.cell_id, truth.cell_id))
        count = int(is_wrong(found.cell_id, truth.cell_id).sum())
        axis.set_title(f"{title}\n{options['structure']}, {count} of {len(origins)} rays", fontsize=9)
        axis.set_aspect("equal")
        axis.set_xticks([])
        axis.set_yticks([])
        if i is None:
            axis.text(0.5, 0.5, "none", ha="center", transform=axis.transAxes)
            side.set_axis_off()
            continue
        draw_around(axis, surface, origins[i], directions[i], truth.cell_id[i], found.cell_id[i])
        draw_from_side(side, surface, origins[i], directions[i], truth.t[i], found.t[i])
    figure.tight_layout()
    figure.savefig(path, dpi=90)
    pyplot.close(figure)


def draw_around(axis, surface: tuple, origin, direction, right: int, named: int) -> None:
    points, triangles = surface
    along = direction / np.linalg.norm(direction)
    side = np.cross(along, [0.3, 0.5, 0.8])
    side /= np.linalg.norm(side)
    basis = np.stack([side, np.cross(along, side)])
    shared = np.isin(triangles, triangles[right]).any(axis=1)
    ahead = (points[triangles].mean(axis=1) - origin) @ along > 0
    for t in np.flatnonzero(shared & ahead):
        flat = (points[triangles[t]] - origin) @ basis.T
        colour = "#a6dba0" if t == right else "#f4a582" if t == named else "#f0f0f0"
        axis.fill(*flat.T, facecolor=colour, edgecolor="#404040", lw=0.8)
    axis.plot(0, 0, "o", color="#b2182b", ms=5)


def draw_from_side(axis, surface: tuple, origin, direction, right: float, found: float) -> None:
    """The surface cut along the ray, the ray until it ends, the point it should end at."""
    points, triangles = surface
    length = np.linalg.norm(direction)
    along = direction / length
    side = np.cross(along, [0.3, 0.5, 0.8])
    side /= np.linalg.norm(side)
    frame = np.stack([along, side, np.cross(along, side)])
    corners = (points[triangles] - origin) @ frame.T
    for a, b in ((0, 1), (1, 2), (2, 0)):
        # One end of an edge on each side of the cut: where the cut crosses it.
        p, q = corners[:, a], corners[:, b]
        crossed = p[:, 2] * q[:, 2] < 0
        share = (p[crossed, 2] / (p[crossed, 2] - q[crossed, 2]))[:, None]
        cut = p[crossed] + share * (q[crossed] - p[crossed])
        axis.plot(cut[:, 0], cut[:, 1], ".", color="#808080", ms=2)
    leaks = not np.isfinite(found)
    end = 2 * right if leaks else found
    axis.annotate("", xy=(end * length, 0), xytext=(0, 0), arrowprops={"arrowstyle": "->", "color": "#b2182b"})
    axis.plot([0, end * length], [0, 0], color="#b2182b", lw=0.8)
    axis.plot(0, 0, "k.", ms=6)
    axis.plot(right * length, 0, "o", mfc="none", mec="#1b7837", ms=9, mew=1.6)
    axis.set_title("goes on, and hits nothing" if leaks else "ends at the same point", fontsize=9)
    axis.set_aspect("equal")
    axis.set_xticks([])
    axis.set_yticks([])


def replace(text: str, name: str, content: str) -> str:
    pattern = re.compile(rf"(<!-- chart {name} -->\n).*?(<!-- end -->)", re.DOTALL)
    assert pattern.search(text), f"{PAGE} has no mark for {name}"
    return pattern.sub(lambda m: f"{m[1]}\n{content}\n\n{m[2]}", text)


def processor() -> str:
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.partition(": ")[2]
    return platform.machine()


def main() -> None:
    rays = int(sys.argv[1]) if len(sys.argv) > 1 else 20000
    try:
        import lumitree.reference  # noqa: F401  CGAL
    except ImportError as reason:
        print(reason)
    rows = []
    sizes = []
    for name, surface in meshes().items():
        print(name, flush=True)
        sizes.append(f"{name} ({len(surface[1]):,} triangles)")
        for row in lumitree.accuracy_chart(surface, rays, repeats=2, brute_force_limit=2**31 - 1):
            rows.append({"Mesh": name, **row})
    out = HERE.parent / "out"
    out.mkdir(exist_ok=True)
    with (out / "accuracy.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)
    draw_chart(rows, HERE / "images" / "accuracy.png")
    draw_failures(HERE / "images" / "accuracy-failures.png")
    facts = (
        f"Machine: {processor()}, one thread, processor time, the better of two. {rays:,} rays of each kind on each mesh "
        f"(brute force: {min(row['Rays'] for row in rows)} at least): "
        + "; ".join(sizes) + "."
    )  # fmt: skip
    text = PAGE.read_text(encoding="utf-8")
    text = replace(text, "facts", facts)
    text = replace(text, "table", table(rows))
    PAGE.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
