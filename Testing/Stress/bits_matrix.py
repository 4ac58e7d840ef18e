# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Builds the cores and Bits with every compiler at hand and several sets of flags, runs it, and writes
whether all answers have the same bits.

    python3 Testing/Stress/bits_matrix.py [--page Docs/matrix.md] [--build build/matrix]

Exit code 1 when any two answers differ.
"""

from __future__ import annotations

import argparse
import platform
import shutil
import subprocess
import sys
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
COMPILERS = {"g++": "gcc", "clang++": "clang"}
FLAGS = ["-O3", "-O2", "-O3 -march=native", "-O1", "-O0"]
# Slow: four of the conditions.
FEW = {"-O1", "-O0"}
PRECISIONS = ["fast", "watertight", "exact"]


def version(compiler: str) -> str:
    first = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True)
    return first.stdout.splitlines()[0]


def build(compiler: str, flags: str, directory: Path) -> Path:
    """Configures and builds one cell of the matrix; the program."""
    subprocess.run(
        ["cmake", "-S", SOURCE, "-B", directory, "-G", "Ninja", "-Wno-dev"]
        + [f"-DCMAKE_C_COMPILER={COMPILERS[compiler]}", f"-DCMAKE_CXX_COMPILER={compiler}"]
        + ["-DCMAKE_BUILD_TYPE=Matrix", f"-DCMAKE_CXX_FLAGS_MATRIX={flags}"]
        + ["-DLUMITREE_TESTING=ON"]
        + (["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else [])
        + [f"-DLUMITREE_{part}=OFF" for part in ("VTK", "PARAVIEW", "PYTHON", "EMBREE", "CGAL", "OPENMESH")],
        check=True,
        stdout=subprocess.DEVNULL,
    )
    subprocess.run(["cmake", "--build", directory, "--target", "Bits"], check=True)
    return directory / "bin" / "stress" / "Bits"


def run(program: Path, few: bool) -> tuple[dict[str, tuple[str, ...]], list[str]]:
    """Hashes per condition ("instruction set, condition"), and what was skipped."""
    done = subprocess.run([program, *(["few"] if few else [])], capture_output=True, text=True)
    if done.returncode not in (0, 1):
        sys.exit(f"{program}: {done.stderr}")
    hashes, skipped = {}, []
    for line in done.stdout.splitlines():
        condition, _, rest = line.partition(": ")
        if rest.startswith("skipped"):
            skipped.append(line)
        else:
            hashes[condition] = tuple(rest.split()[:3])
    return hashes, skipped


def page(rows: list[tuple[str, str, dict, list]], wanted: dict[bool, tuple[str, ...]]) -> str:
    conditions = [c.partition(", ")[2] for c in rows[0][2]]
    conditions = list(dict.fromkeys(conditions))
    sets = list(dict.fromkeys(c.partition(", ")[0] for row in rows for c in row[2]))
    lines = [
        "# The same bits everywhere",
        "",
        "`./lumitree matrix bits` makes this page. It builds the cores with each compiler and each set of flags below, and traces the same",
        "rays with each instruction set that the kernels are compiled for: closed meshes of floats and doubles at offsets 0, 10⁴, 10⁶ and UTM",
        "coordinates, a room, slivers, a terrain, a cloud; rays through vertices and edges, toward vertices, random, from 10⁶ sizes away; every",
        "structure of our own, every query (ties and crossings among them). A hash takes in primitive, t, u and v of every hit, bit for bit. Where triangles are permuted, their",
        "numbers are mapped back, and the hash is of the set of hits, as the order of equal ones follows the numbers.",
        "",
        f"Machine: {processor()}. {platform.freedesktop_os_release()['PRETTY_NAME']}.",
        "",
        "| conditions of each cell |",
        "| --- |",
    ]
    few = {c.partition(", ")[2] for row in rows if row[1] in FEW for c in row[2]}
    lines += [f"| {c}{' *' if c in few else ''} |" for c in conditions]
    if few:
        lines += ["", "\\* also at " + " and ".join(f"`{f}`" for f in FLAGS if f in FEW) + ", which are slow."]
    lines += ["", "| compiler | flags | " + " | ".join(sets) + " |"]
    lines += ["| --- | --- |" + " --- |" * len(sets)]
    for compiler, flags, hashes, _ in rows:
        cells = []
        for name in sets:
            mine = {c: h for c, h in hashes.items() if c.startswith(name + ", ")}
            bad = [c for c, h in mine.items() if h != wanted["permuted" in c]]
            cells.append("not there" if not mine else f"{len(bad)} differ" if bad else "same")
        lines.append(f"| {compiler} | `{flags}` | " + " | ".join(cells) + " |")
    lines += ["", "Hashes of the answers, and of the sets of hits:", ""]
    lines += ["| precision | answers | sets |", "| --- | --- | --- |"]
    for i, precision in enumerate(PRECISIONS):
        lines.append(f"| {precision} | `{wanted[False][i]}` | `{wanted[True][i]}` |")
    skipped = sorted({s for row in rows for s in row[3]})
    if skipped:
        lines += ["", "Skipped: " + "; ".join(skipped) + "."]
    lines += [
        "",
        "\"Baseline\" is what the compiler may assume without a flag: with `-march=native` the best that the machine has, and the kernels for",
        "lesser sets are then not compiled. `-ffp-contract=off` is always set by the build.",
        "",
    ]
    return "\n".join(lines)


def processor() -> str:
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.partition(": ")[2]
    return platform.machine()


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--page", type=Path, default=SOURCE / "Docs" / "matrix.md")
    parser.add_argument("--build", type=Path, default=SOURCE / "build" / "matrix")
    arguments = parser.parse_args()
    there = [compiler for compiler in COMPILERS if shutil.which(compiler)]
    for compiler in set(COMPILERS) - set(there):
        print(f"{compiler} is not installed; left out")
    rows, wanted, differing = [], {}, []
    for flags in FLAGS:
        for compiler in there:
            print(f"== {compiler} {flags}", flush=True)
            directory = arguments.build / f"{compiler}{flags}".replace(" ", "")
            hashes, skipped = run(build(compiler, flags, directory), flags in FEW)
            rows.append((version(compiler), flags, hashes, skipped))
            for condition, found in hashes.items():
                if found != wanted.setdefault("permuted" in condition, found):
                    differing.append((compiler, flags, condition))
            arguments.page.write_text(page(rows, wanted))
    for cell in differing:
        print("DIFFERS: " + ", ".join(cell))
    print(f"{len(rows)} builds, {sum(len(r[2]) for r in rows)} conditions, {len(differing)} differ")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
