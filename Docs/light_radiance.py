# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Irradiance of the benchmark's scenes by Radiance's rtrace, one process; see `make_light_chart.py`.

Seconds are processor time (user and system) of rtrace, the median of three runs, or one of more than 0.5 s, less that of a run for one
sensor: neither start nor loading the octree counts.
"""

from __future__ import annotations

import os
import shutil
import statistics
import subprocess
from pathlib import Path

import numpy as np

SKY = """\
zen(c) : 1 + ({a})*exp(({b})/c);
ind(x) : {base} + ({c})*exp(({d})*x) + ({e})*cos(x)^2;
cosine = Dx*({sx}) + Dy*({sy}) + Dz*({sz});
chi = acos(if(cosine-1, 1, if(-1-cosine, -1, cosine)));
skybr = zen(if(Dz-1e-6, Dz, 1e-6)) * ind(chi) / (zen(1) * ind(acos({sz})));
"""


def program(name: str, pythons: list[str]) -> str | None:
    """A program of Radiance on the path, or in the package pyradiance of one of these Pythons."""
    if found := shutil.which(name):
        return found
    ask = (
        "import importlib.util as u; print(u.find_spec('pyradiance').submodule_search_locations[0])"
    )
    for python in pythons:
        answer = subprocess.run([python, "-c", ask], capture_output=True, text=True, check=False)
        path = Path(answer.stdout.strip() or "/nowhere") / "bin" / name
        if answer.returncode == 0 and path.exists():
            return str(path)
    return None


def write_polygon(file, modifier: str, name: str, corners: np.ndarray) -> None:
    numbers = " ".join(f"{x:.17g}" for x in corners.ravel())
    file.write(f"{modifier} polygon {name} 0 0 {corners.size} {numbers}\n")


def write_light(file, scene: dict, parts: int, directory: Path) -> None:
    if "polygon" in scene:
        file.write("void light lamp 0 0 3" + f" {scene['radiance']:g}" * 3 + "\n")
        a, b, _, d = np.array(scene["polygon"])
        for i in range(parts):
            for j in range(parts):
                corner = a + i / parts * (b - a) + j / parts * (d - a)
                u, v = (b - a) / parts, (d - a) / parts
                write_polygon(
                    file,
                    "lamp",
                    f"l{i}.{j}",
                    np.array([corner, corner + u, corner + u + v, corner + v]),
                )
        return
    sun = np.array(scene["sun"]) / np.linalg.norm(scene["sun"])
    numbers = dict(zip(("a", "b", "c", "d", "e", "base"), scene["sky"])) | dict(
        zip(("sx", "sy", "sz"), sun)
    )
    (directory / "sky.cal").write_text(SKY.format(**numbers))
    file.write(f"void brightfunc bright 2 skybr {directory}/sky.cal 0 0\n")
    file.write("bright glow shine 0 0 4 1 1 1 0\nshine source sky 0 0 4 0 0 1 180\n")


def octree(oconv: str, scene: dict, parts: int, directory: Path) -> Path:
    base = directory / scene["key"]
    triangles = np.fromfile(f"{base}.triangles").reshape(-1, 3, 3)
    description = Path(f"{base}.{parts}.rad")
    with description.open("w") as file:
        file.write("void plastic black 0 0 5 0 0 0 0 0\n")
        for i, triangle in enumerate(triangles):
            write_polygon(file, "black", f"t{i}", triangle)
        write_light(file, scene, parts, directory)
    result = Path(f"{base}.{parts}.oct")
    with result.open("wb") as file:
        subprocess.run(
            [oconv, "-f", str(description)], stdout=file, stderr=subprocess.DEVNULL, check=True
        )
    return result


def trace(
    rtrace: str, settings: list[str], tree: Path, sensors: np.ndarray
) -> tuple[np.ndarray, float]:
    rays = np.hstack([sensors, np.tile([0.0, 0.0, 1.0], (len(sensors), 1))])
    rays_file, answers = tree.with_suffix(".rays"), tree.with_suffix(".answers")
    rays.tofile(rays_file)
    with rays_file.open("rb") as source, answers.open("wb") as sink:
        command = [rtrace, "-I", "-h", "-w", "-n", "1", "-fdd", *settings, str(tree)]
        process = subprocess.Popen(command, stdin=source, stdout=sink)
        _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        raise RuntimeError(f"{' '.join(command)} failed")
    return np.fromfile(answers).reshape(-1, 3)[:, 0], usage.ru_utime + usage.ru_stime


def settings_of(scene: dict) -> list[tuple[int, str]]:
    """How finely the light is cut by hand, and the options."""
    if "polygon" in scene:
        # Radiance takes at most 64 samples of one source, so a light is cut to have more.
        whole = [
            (1, f"-dt 0 -dc 1 -dj {j} -ds {s}") for j in (0, 0.7) for s in (0.5, 0.2, 0.1, 0.05)
        ]
        cut = [(2, ".05"), (2, ".025"), (4, ".02"), (4, ".0125")]
        return [(1, ""), *whole, *((n, f"-dt 0 -dc 1 -dj 0 -ds {s}") for n, s in cut)]
    free = [f"-ab 1 -aa 0 -as 0 -ad {n}" for n in (64, 256, 1024)]
    return [
        (1, s + " -lw 1e-7")
        for s in [*free, "-ab 1 -aa 0 -ad 512 -as 512", "-ab 1 -aa .1 -ar 300 -ad 1024 -as 512"]
    ]


def measure(directory: Path, scenes: list[dict], pythons: list[str]) -> tuple[str, list[dict]]:
    """Its version ('' where it is absent), and rows."""
    rtrace, oconv = program("rtrace", pythons), program("oconv", pythons)
    if rtrace is None or oconv is None:
        return "", []
    library = Path(rtrace).resolve().parent.parent / "lib"
    os.environ["RAYPATH"] = os.pathsep.join(
        filter(None, [os.environ.get("RAYPATH"), ".", str(library)])
    )
    version = subprocess.run(
        [rtrace, "-version"], capture_output=True, text=True, check=False
    ).stdout.strip()
    rows = []
    for scene in scenes:
        sensors = np.fromfile(f"{directory / scene['key']}.sensors").reshape(-1, 3)
        exact = np.fromfile(f"{directory / scene['key']}.exact")
        trees = {}
        for parts, options in settings_of(scene):
            if parts not in trees:
                tree = octree(oconv, scene, parts, directory)
                start = min(trace(rtrace, options.split(), tree, sensors[:1])[1] for _ in range(3))
                trees[parts] = tree, start
            tree, start = trees[parts]
            seconds = []
            while len(seconds) < 3 and sum(seconds) < 0.5:
                values, elapsed = trace(rtrace, options.split(), tree, sensors)
                seconds.append(max(1e-4, elapsed - start))
            error = np.sqrt(np.mean((values - exact) ** 2)) / exact.mean()
            name = options or "defaults"
            rows.append(
                {
                    "Scene": scene["key"],
                    "Method": "light cut by hand"
                    if parts > 1
                    else "cache"
                    if "-aa ." in options
                    else "no cache"
                    if "-ab" in options
                    else "one light",
                    "Setting": f"{name}, {parts * parts} parts" if parts > 1 else name,
                    "Seconds": statistics.median(seconds),
                    "Error": error,
                    "Mean": values.mean() / exact.mean(),
                }
            )
    return version, rows
