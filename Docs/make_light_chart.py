# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Measures error against time of direct light, ours and that of Radiance and Mitsuba where they are installed,
and writes the tables and the picture of light-benchmarks.md; `./lumitree chart light` runs it.

python3 Docs/make_light_chart.py PROGRAM

PROGRAM is the benchmark LightChart, which makes the scenes and measures ours. Radiance is looked for on the
path and in the Python package pyradiance; that package and mitsuba in this Python and in the `python3` of the path
(a virtual environment will do). What is absent is said. Mitsuba's fast variant needs LLVM 16 or newer, the
variable DRJIT_LIBLLVM_PATH names it; without, its scalar variant is left out, as it would be no match.
"""

from __future__ import annotations

import csv
import json
import math
import os
import re
import shutil
import statistics
import subprocess
import sys
import time
from collections import defaultdict
from pathlib import Path

import light_radiance
import matplotlib
import numpy as np
from make_accuracy import processor
from vtkmodules.numpy_interface.dataset_adapter import numpyTovtkDataArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import lumitree

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  after the choice of back end

HERE = Path(__file__).resolve().parent
PAGE = HERE / "light-benchmarks.md"
TARGETS = (0.01, 0.001)
TARGET = TARGETS[0]
EXACT = 1e-6  # where exact methods are drawn


def pythons() -> list[str]:
    return list(dict.fromkeys(filter(None, [sys.executable, shutil.which("python3")])))


def run_ours(program: str, directory: Path) -> list[dict]:
    subprocess.run([program, str(directory)], check=True)
    with (directory / "ours.csv").open() as file:
        return [
            {
                "Program": "ours",
                "Scene": row["Scene"],
                "Method": row["Method"],
                "Setting": f"tolerance {float(row['Tolerance']):g}",
                "Seconds": float(row["Seconds"]),
                "Error": float(row["Error"]),
            }
            for row in csv.DictReader(file)
        ]


def sensors_of(directory: Path, key: str) -> vtkPolyData:
    positions = np.fromfile(directory / f"{key}.sensors").reshape(-1, 3)
    points, cells, data = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpyTovtkDataArray(positions))
    for i in range(len(positions)):
        cells.InsertNextCell(1, [i])
    data.SetPoints(points)
    data.SetVerts(cells)
    normals = numpyTovtkDataArray(np.tile([0.0, 0.0, 1.0], (len(positions), 1)), "Normals")
    data.GetPointData().SetNormals(normals)
    return data


def run_filter(directory: Path, scenes: list[dict]) -> list[dict]:
    """vtkLumiIrradiance with all that it does beside: building the structure, arrays, statistics."""
    rows = []
    for scene in scenes:
        key = scene["key"]
        exact = np.fromfile(directory / f"{key}.exact")
        corners = np.fromfile(directory / f"{key}.triangles").reshape(-1, 3)
        occluders = (corners, np.arange(len(corners)).reshape(-1, 3))
        if "polygon" in scene:
            a, b, _, d = scene["polygon"]
            light = lumitree.rectangle_light(a, b, d, radiance=scene["radiance"])
        elif scene["sky"][0] == 0:
            light = lumitree.sky_light(zenith_radiance=1.0)
        else:
            continue
        sensors = sensors_of(directory, key)
        for tolerance in (0.05,):
            seconds, error = [], 0.0
            for _ in range(5):
                start = time.process_time()
                result = lumitree.irradiance(
                    sensors, light, occluders, at="points", tolerance=tolerance, threads=1
                )
                seconds.append(time.process_time() - start)
                error = float(np.sqrt(np.mean((result.values - exact) ** 2)) / exact.mean())
            rows.append(
                {
                    "Program": "ours",
                    "Scene": key,
                    "Method": "vtkLumiIrradiance from Python",
                    "Setting": f"tolerance {tolerance:g}",
                    "Seconds": statistics.median(seconds),
                    "Error": error,
                }
            )
    return rows


def run_mitsuba(directory: Path) -> tuple[str, list[dict]]:
    """Its version, or why there is none, and rows."""
    for python in pythons():
        if (
            subprocess.run(
                [python, "-c", "import mitsuba"], capture_output=True, check=False
            ).returncode
            != 0
        ):
            continue
        command = [python, str(HERE / "light_mitsuba.py"), str(directory), "llvm_ad_rgb"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        lines = done.stdout.splitlines()
        if done.returncode != 0 or not lines:
            return "Mitsuba failed, mostly for want of LLVM 16 or newer (DRJIT_LIBLLVM_PATH)", []
        rows = []
        for line in lines[1:]:
            scene, method, samples, seconds, error, mean = line.split(";")
            row = {
                "Program": "Mitsuba",
                "Scene": scene,
                "Method": method,
                "Setting": f"{samples} samples",
            }
            rows.append(
                {**row, "Seconds": float(seconds), "Error": float(error), "Mean": float(mean)}
            )
        return lines[0][2:], rows
    return "", []


def seconds_to(
    points: list[tuple[float, float]], target: float = TARGET
) -> tuple[float, bool] | None:
    """When the error of a method falls to the target, between its measurements or, where the last two
    still fall, beyond them (True); None where it does not."""
    front, best = [], math.inf
    for seconds, error in sorted(points):
        if error < best:
            front.append((math.log(seconds), math.log(max(error, 1e-12))))
            best = error
    goal = math.log(target)
    if front[0][1] <= goal:
        return math.exp(front[0][0]), False
    for (t0, e0), (t1, e1) in zip(front, front[1:]):
        if e1 <= goal:
            return math.exp(t0 + (t1 - t0) * (goal - e0) / (e1 - e0)), False
    if len(front) < 2 or len(front) < len(points):
        return None
    (t0, e0), (t1, e1) = front[-2:]
    slope = (e1 - e0) / (t1 - t0)
    return (math.exp(t1 + (goal - e1) / slope), True) if slope < -0.3 else None


def grouped(rows: list[dict], scene: str) -> dict[tuple[str, str], list[tuple[float, float]]]:
    result = defaultdict(list)
    for row in rows:
        if row["Scene"] == scene:
            result[row["Program"], row["Method"]].append((row["Seconds"], row["Error"]))
    return result


def written(time_to: tuple[float, bool] | None, points: list[tuple[float, float]]) -> str:
    if time_to is None:
        return f"not reached ({100 * min(e for _, e in points):.2g} % at best)"
    return f"{time_to[0]:.3g}" + ("*" if time_to[1] else "")


CONTENDERS = {
    "ours": lambda program, method: program == "ours" and not method.startswith("vtk"),
    "ours, the whole filter": lambda program, method: (
        program == "ours" and method.startswith("vtk")
    ),
    "Radiance": lambda program, method: program == "Radiance",
    "Mitsuba, path integrator, default sampler": lambda program, method: (
        method == "path, independent"
    ),
    "Mitsuba, path integrator, best sampler": lambda program, method: method.startswith("path,"),
    "Mitsuba, shadow rays by hand": lambda program, method: method.startswith(
        ("emitter,", "cosine,")
    ),
}


def best_of(methods: dict, chosen, target: float) -> tuple[float, bool] | None:
    times = [
        t for key, points in methods.items() if chosen(*key) and (t := seconds_to(points, target))
    ]
    return min(times) if times else None


def summary(rows: list[dict], scenes: list[dict], target: float) -> str:
    """Of each contender its best method; behind it how many times as long as ours it takes."""
    lines = [
        f"| seconds to {100 * target:g} % | " + " | ".join(scene["name"] for scene in scenes) + " |"
    ]
    lines += ["|" + " --- |" * (1 + len(scenes))]
    for name, chosen in CONTENDERS.items():
        cells = []
        for scene in scenes:
            methods = grouped(rows, scene["key"])
            ours = best_of(methods, CONTENDERS["ours"], target)
            best = best_of(methods, chosen, target)
            if not any(chosen(*key) for key in methods):
                cells.append("–")
            elif best is None:
                cells.append("not reached")
            else:
                times = "" if name == "ours" or ours is None else f" ({best[0] / ours[0]:.2g} x)"
                cells.append(f"{best[0]:.3g}{'*' if best[1] else ''}{times}")
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def table(rows: list[dict], scenes: list[dict]) -> str:
    lines = []
    for scene in scenes:
        lines += [f"### {scene['name']}", ""]
        lines += [
            "| method | seconds to 1 % | measured: setting, seconds, nRMSE [%] |",
            "| --- | --- | --- |",
        ]
        for (program, method), points in grouped(rows, scene["key"]).items():
            own = [
                r
                for r in rows
                if (r["Scene"], r["Program"], r["Method"]) == (scene["key"], program, method)
            ]
            values = "; ".join(
                f"{r['Setting']}: {r['Seconds']:.3g}, {100 * r['Error']:.2g}" for r in own
            )
            lines.append(
                f"| {program}: {method} | {written(seconds_to(points), points)} | {values} |"
            )
        lines.append("")
    return "\n".join(lines).rstrip()


def draw(rows: list[dict], scenes: list[dict], path: Path) -> None:
    colours = {"ours": "#1b7837", "Radiance": "#b2182b", "Mitsuba": "#2166ac"}
    styles = ["-", "--", ":", "-.", (0, (1, 3)), (0, (5, 1))]
    figure, axes = pyplot.subplots(2, 2, figsize=(13, 9.5))
    for axis, scene in zip(axes.flat, scenes):
        drawn = defaultdict(int)
        for (program, method), points in grouped(rows, scene["key"]).items():
            times, errors = zip(*sorted(points))
            style = styles[drawn[program] % len(styles)]
            drawn[program] += 1
            axis.plot(
                times, np.maximum(errors, EXACT), ls=style, marker="o", ms=3, lw=1.2, color=colours[program],
                label=f"{program}: {method}",
            )  # fmt: skip
        axis.axhline(TARGET, color="#808080", lw=0.8)
        axis.set_xscale("log")
        axis.set_yscale("log")
        axis.set_title(scene["name"], fontsize=10)
        axis.set_xlabel("seconds, one thread")
        axis.set_ylabel("nRMSE")
        axis.grid(alpha=0.3)
        axis.legend(fontsize=6.5)
    figure.tight_layout()
    figure.savefig(path, dpi=90)
    pyplot.close(figure)


def replace(text: str, name: str, content: str) -> str:
    pattern = re.compile(rf"(<!-- chart {name} -->\n).*?(<!-- end -->)", re.DOTALL)
    assert pattern.search(text), f"{PAGE} has no mark for {name}"
    return pattern.sub(lambda m: f"{m[1]}\n{content}\n\n{m[2]}", text)


def main() -> None:
    directory = HERE.parent / "out" / "light"
    directory.mkdir(parents=True, exist_ok=True)
    rows = run_ours(sys.argv[1], directory)
    scenes = json.loads((directory / "scenes.json").read_text())
    rows += run_filter(directory, scenes)
    radiance, more = light_radiance.measure(directory, scenes, pythons())
    rows += [{"Program": "Radiance", **row} for row in more]
    mitsuba, more = run_mitsuba(directory)
    rows += more
    peers = [
        radiance or "Radiance is absent: neither rtrace nor the Python package pyradiance was found"
    ]
    peers += [mitsuba or "Mitsuba is absent: no Python has the package mitsuba"]
    print("; ".join(peers))
    with (directory / "light.csv").open("w", newline="") as file:
        writer = csv.DictWriter(
            file, ["Scene", "Program", "Method", "Setting", "Seconds", "Error", "Mean"]
        )
        writer.writeheader()
        writer.writerows(rows)
    draw(rows, scenes, HERE / "images" / "light-benchmarks.png")
    facts = (
        f"Machine: {processor()}, load {os.getloadavg()[0]:.1f}, one thread, processor time, medians of three runs, interleaved "
        f"where they are ours. {'; '.join(peers)}."
    )  # fmt: skip
    text = PAGE.read_text(encoding="utf-8")
    tables = "\n\n".join(summary(rows, scenes, target) for target in TARGETS)
    for name, content in (("facts", facts), ("summary", tables), ("table", table(rows, scenes))):
        text = replace(text, name, content)
    PAGE.write_text(text, encoding="utf-8")
    print(tables)


if __name__ == "__main__":
    main()
