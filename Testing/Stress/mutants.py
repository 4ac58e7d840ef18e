# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Breaks a copy of the core on purpose, one way after the other, and runs the core's tests: each way must
fail at least one. Writes what failed first as a table.

    python3 Testing/Stress/mutants.py [--page Docs/mutants.md] [--build build/mutants] [--only WORD]

Exit code 1 when a mutant survives, or no longer fits the sources.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path
from typing import NamedTuple

SOURCE = Path(__file__).resolve().parents[2]

# In the order in which they are run, the quick and the sharp ones first.
TESTS = "FilterBound Triangles Boxes Stress ExactPredicates ExactStages TriangleBoxOverlap Cells KdTree Numbers".split()


class Mutant(NamedTuple):
    what: str
    file: str
    old: str
    new: str


MUTANTS = [
    Mutant("No pad in the boxes' slab test in double", "Accel/Kernel/RayBox.h",
           "relativePad = 0x1p-40", "relativePad = 0x1p-80"),
    Mutant("A NaN slab rules the box out", "Accel/Kernel/RayBox.h",
           "enter = tNear > enter ? tNear : enter;", "enter = enter > tNear ? enter : tNear;"),
    Mutant("No pad in the eight-wide tree's slab test", "Accel/Structures/WideRay-inl.h",
           "slabPad = 0x1p-21f", "slabPad = 0.0f"),
    Mutant("No interval around the eight-wide tree's origin", "Accel/Structures/WideRay-inl.h",
           "absolute(o) * Double4::all(0x1p-22) + Double4::all(0x1p-120)", "Double4::all(0.0)"),
    Mutant("The eight-wide tree's boxes are not rounded outward", "Accel/Structures/BvhFrame.h",
           "v - (std::fabs(v) * 0x1p-23 + 0x1p-120)", "v"),
    Mutant("Boxes behind half of the way to the best hit are passed over", "Accel/Structures/WideBvhWalk.cxx",
           "this->stack.enter[this->stack.height] <= this->stop",
           "this->stack.enter[this->stack.height] <= 0.5f * this->stop"),
    Mutant("The bound of edge functions halved", "Accel/Kernel/EdgeFilter.h",
           "edgeBound = 16 * 0x1p-53", "edgeBound = 8 * 0x1p-53"),
    Mutant("The bound of edge functions a hundredth", "Accel/Kernel/EdgeFilter.h",
           "edgeBound = 16 * 0x1p-53", "edgeBound = 0.16 * 0x1p-53"),
    Mutant("Nothing added to the bound for underflow", "Accel/Kernel/EdgeFilter.h",
           "boundFloor(0x1p-1020 * (1.0 + oneNorm))", "boundFloor(0.0)"),
    Mutant("Undecided triangles are hits: the exact sign is dropped", "Accel/Kernel/Precisions.h",
           "if (!exact::lineMeetsTriangle(state.ray, vertices))", "if (false)"),
    Mutant("Undecided triangles are misses", "Accel/Kernel/Precisions.h",
           "if (!exact::lineMeetsTriangle(state.ray, vertices))", "if (true)"),
    Mutant("Watertight takes what is undecided for a miss", "Accel/Kernel/Precisions.h",
           "return !surelyMissed(x.edges) && std::isfinite(x.t) && x.tHigh",
           "return surelyHit(x.edges) && std::isfinite(x.t) && x.tHigh"),
    Mutant("Of equal t the highest primitive wins", "Accel/Kernel/Precisions.h",
           "order == 0 && a.primitive < b.primitive", "order == 0 && a.primitive > b.primitive"),
    Mutant("t is compared as computed, never exactly", "Accel/Kernel/Precisions.h",
           "const int order = compare(state, a, b);",
           "const int order = a.t < b.t ? -1 : (a.t > b.t ? 1 : 0);"),
    Mutant("tMin is compared with the computed t", "Accel/Kernel/Precisions.h",
           "return exact::compareCrossing(state.ray, vertices, limit) >= 0;", "return x.t >= limit;"),
    Mutant("The interval of t without its rounding", "Accel/Kernel/Crossing.h",
           "0x1p-49 * std::max(std::fabs(low), std::fabs(high)) + 0x1p-1020", "0.0"),
    Mutant("The search ends at the middle of the interval of t", "Accel/Kernel/Precisions.h",
           "static double stopAt(const Candidate& c) { return c.tHigh; }",
           "static double stopAt(const Candidate& c) { return 0.999 * c.t; }"),
    Mutant("A wide interval of t is not settled exactly", "Accel/Kernel/Finish.cxx",
           "tHigh - tLow > 0x1p-26 * std::fabs(t)", "tHigh - tLow > 1e3 * std::fabs(t)"),
    Mutant("The tail of what does not fit the lattice is dropped", "Accel/Exact/Lattice.h",
           "exact &= truncate(from[k] * this->scale_, to[k]) * this->unit_ == from[k];",
           "truncate(from[k] * this->scale_, to[k]);"),
    Mutant("The host's rounding mode stays", "Accel/FloatEnvironment.h",
           "std::fesetround(FE_TONEAREST);", ""),
    Mutant("The host's flushing of subnormals stays", "Accel/FloatEnvironment.h",
           "_mm_setcsr(_mm_getcsr() & ~0x8040u);", ""),
    Mutant("Contraction is allowed", "cmake/LumitreeCompiler.cmake",
           ":-ffp-contract=off>", ":-ffp-contract=fast>"),
    Mutant("The first leaf with a hit ends the walk of a KD-tree", "Accel/Structures/KdTreeWalk.h",
           "tStop = visitor.leaf({ node.first, node.count, current.tEnter });",
           "const double before = tStop;\n"
           "tStop = visitor.leaf({ node.first, node.count, current.tEnter });\n"
           "if (tStop < before)\n{\nreturn;\n}"),
    Mutant("A ray in a split plane visits one side", "Accel/Structures/KdTreeWalk.h",
           "tHigh < current.tExit ? tHigh : current.tExit", "current.tExit < tHigh ? current.tExit : tHigh"),
    Mutant("Clipped triangles are not rounded outward", "Accel/Structures/KdTreeClip.cxx",
           "most * 0x1p-49 + 0x1p-1060", "0.0"),
    Mutant("The grid goes to one cell at a time, past those at its corners", "Accel/Structures/GridSweep.h",
           "first[k] = k == this->fresh_ ? this->axes_[k].last : this->axes_[k].first;",
           "first[k] = this->axes_[k].last;"),
    Mutant("Triangles that touch a cell within rounding are left out", "Accel/Structures/TriangleBoxOverlap.cxx",
           "relativeError = 0x1p-49", "relativeError = -0x1p-20"),
]  # fmt: skip


def run(command: list, directory: Path, log: Path, limit: int) -> bool:
    with log.open("ab") as out:
        try:
            done = subprocess.run(command, cwd=directory, stdout=out, stderr=out, timeout=limit)
        except subprocess.TimeoutExpired:
            return False
    return done.returncode == 0


def first_failure(binary: Path, log: Path) -> str | None:
    """The first test that fails, or None."""
    try:
        done = subprocess.run(
            [binary, "--gtest_fail_fast"], capture_output=True, text=True, errors="replace", timeout=300
        )
    except subprocess.TimeoutExpired:
        return f"{binary.name} (no end)"
    with log.open("a") as out:
        out.write(done.stdout[-4000:] + done.stderr[-4000:])
    if done.returncode == 0:
        return None
    failed = re.search(r"\[  FAILED  \] (\S+)", done.stdout)
    return failed.group(1).rstrip(",") if failed else f"{binary.name} (ended by {done.returncode})"


def contraction_failure(directory: Path, log: Path) -> str | None:
    ran = run(["ctest", "-R", "StyleFloatingPointFlags"], directory, log, 60)
    return None if ran else "StyleFloatingPointFlags"


class Copy:
    """A copy of the tree with a build of the core and its tests."""

    def __init__(self, directory: Path) -> None:
        self.source = directory / "source"
        self.build = directory / "build"
        self.log = directory / "log.txt"
        shutil.rmtree(self.source, ignore_errors=True)
        ignored = shutil.ignore_patterns(".git", "build", "out", "*.png", "__pycache__")
        shutil.copytree(SOURCE, self.source, ignore=ignored)
        self.log.write_text("")
        parts = [f"-DLUMITREE_{p}=OFF" for p in ("VTK", "PARAVIEW", "PYTHON", "EMBREE", "CGAL")]
        configured = run(
            ["cmake", "-S", self.source, "-B", self.build, "-G", "Ninja", "-Wno-dev"]
            + ["-DCMAKE_BUILD_TYPE=Mutants", "-DCMAKE_CXX_FLAGS_MUTANTS=-O1 -DNDEBUG"]
            + ["-DLUMITREE_TESTING=ON", *parts],
            directory, self.log, 600,
        )  # fmt: skip
        if not configured or not self.make():
            sys.exit(f"the unchanged core does not build; see {self.log}")

    def make(self) -> bool:
        targets = [f"LumitreeTest{t}" for t in TESTS]
        return run(["ninja", *targets], self.build, self.log, 3600)

    def failure(self) -> str | None:
        if not self.make():
            return "does not compile"
        failed = contraction_failure(self.build, self.log)
        for test in TESTS if failed is None else []:
            failed = first_failure(self.build / "bin" / f"LumitreeTest{test}", self.log)
            if failed:
                break
        return failed

    def kill(self, mutant: Mutant) -> str | None:
        """What notices the mutant, or None."""
        path = self.source / mutant.file
        original = path.read_text()
        with self.log.open("a") as out:
            out.write(f"\n=== {mutant.what}\n")
        path.write_text(original.replace(mutant.old, mutant.new))
        try:
            return self.failure()
        finally:
            path.write_text(original)


def page(rows: list[tuple[Mutant, str | None]]) -> str:
    lines = [
        "# Mutants",
        "",
        "`./lumitree mutants` makes this page. It breaks a copy of the core, one way after the other, builds it with GCC at -O1 and runs",
        "the quicker tests of the core (without CGAL and Embree). A mutant that no test notices would mean that what it breaks is not tested.",
        "`<` for `<=` in a slab test is not among them: entry and exit are padded apart, so that it changes no answer while the pads are there.",
        "",
        f"{sum(1 for r in rows if r[1])} of {len(rows)} are noticed.",
        "",
        "| what is broken | file | first test that fails |",
        "| --- | --- | --- |",
    ]
    for mutant, failed in rows:
        lines.append(f"| {mutant.what} | `{mutant.file}` | {failed or '**none**'} |")
    return "\n".join(lines) + "\n"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--page", type=Path, default=SOURCE / "Docs" / "mutants.md")
    parser.add_argument("--build", type=Path, default=SOURCE / "build" / "mutants")
    parser.add_argument("--only", default="", help="mutants whose description has this word")
    arguments = parser.parse_args()
    chosen = [m for m in MUTANTS if arguments.only in m.what]
    for mutant in chosen:
        if (SOURCE / mutant.file).read_text().count(mutant.old) != 1:
            sys.exit(f"'{mutant.what}' does not fit {mutant.file} any more")
    arguments.build.mkdir(parents=True, exist_ok=True)
    os.environ.setdefault("CCACHE_NOHASHDIR", "1")
    copy = Copy(arguments.build)
    failed = copy.failure()
    if failed:
        sys.exit(f"the unchanged core fails {failed}; see {copy.log}")
    rows = []
    for mutant in chosen:
        start = time.monotonic()
        rows.append((mutant, copy.kill(mutant)))
        if not arguments.only:
            arguments.page.write_text(page(rows))
        print(f"{rows[-1][1] or 'SURVIVES'}: {mutant.what} ({time.monotonic() - start:.0f} s)", flush=True)
    return 1 if any(r[1] is None for r in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
