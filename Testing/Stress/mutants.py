# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Breaks a copy of the core on purpose, one way after the other (mutations.py), and runs the core's tests:
each way must fail at least one. Writes what failed first as a table.

    python3 Testing/Stress/mutants.py [--page Docs/mutants.md] [--build build/mutants] [--only WORD]
                                      [--trust] [--quick] [--check]

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

from mutations import MUTANTS, Mutant

SOURCE = Path(__file__).resolve().parents[2]
STYLE = "StyleFloatingPointFlags"

# All of the core's tests, the quick ones first; those that a mutant names run before them.
TESTS = (
    "Triangles Boxes SkipSets Surface Choices Hierarchy Grid Cells Stress FilterBound KdTree Octree "
    "TriangleBoxOverlap ExactPredicates ExactStages AgainstBruteForce Catalogue Quadrics Queries Save Watertight Builders Numbers"
).split()
QUICK = 12


def run(command: list, directory: Path, log: Path, limit: int) -> bool:
    with log.open("ab") as out:
        try:
            done = subprocess.run(command, cwd=directory, stdout=out, stderr=out, timeout=limit)
        except subprocess.TimeoutExpired:
            return False
    return done.returncode == 0


class Copy:
    """A copy of the tree with a build of the core and its tests."""

    def __init__(self, directory: Path) -> None:
        self.source = directory / "source"
        self.build = directory / "build"
        self.log = directory / "log.txt"
        shutil.rmtree(self.source, ignore_errors=True)
        ignored = shutil.ignore_patterns(".git", "build", "out", "*.png", "__pycache__")
        shutil.copytree(SOURCE, self.source, ignore=ignored)
        # A run that was interrupted leaves objects of a mutant, newer than the file.
        for edit in (edit for mutant in MUTANTS for edit in mutant.edits):
            (self.source / edit.file).touch()
        self.log.write_text("")
        parts = [f"-DLUMITREE_{p}=OFF" for p in ("VTK", "PARAVIEW", "PYTHON", "EMBREE", "CGAL", "OPENMESH")]
        launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
        configured = run(
            ["cmake", "-S", self.source, "-B", self.build, "-G", "Ninja", "-Wno-dev"]
            + ["-DCMAKE_BUILD_TYPE=Mutants", "-DCMAKE_CXX_FLAGS_MUTANTS=-O1 -DNDEBUG"]
            + ["-DLUMITREE_TESTING=ON", "-DLUMITREE_WERROR=OFF", *launcher, *parts],
            self.source, self.log, 600,
        )  # fmt: skip
        if not configured or not self.make([]):
            sys.exit(f"the unchanged core does not build; see {self.log}")

    def make(self, tests: list[str]) -> bool:
        targets = [f"LumitreeTest{t}" for t in tests] or ["LumitreeAccel"]
        return run(["ninja", *targets], self.build, self.log, 3600)

    def first_failure(self, test: str) -> str | None:
        """The first case of a test that fails, or None."""
        if test == STYLE:
            run(["cmake", self.build], self.build, self.log, 600)
            return None if run(["ctest", "-R", STYLE], self.build, self.log, 60) else STYLE
        binary = self.build / "bin" / f"LumitreeTest{test}"
        try:
            done = subprocess.run(
                [binary, "--gtest_fail_fast"], capture_output=True, text=True, errors="replace", timeout=900
            )
        except subprocess.TimeoutExpired:
            return f"{test}: no end"
        with self.log.open("a") as out:
            out.write(done.stdout[-4000:] + done.stderr[-4000:])
        if done.returncode == 0:
            return None
        failed = re.search(r"\[  FAILED  \] ([\w./]+)", done.stdout)
        running = re.findall(r"\[ RUN      \] ([\w./]+)", done.stdout)
        if failed:
            return failed.group(1)
        return f"{running[-1] if running else test}: ended by {done.returncode}"

    def failure(self, likely: list[str], among: list[str]) -> str | None:
        """What fails first: of the likely tests, which alone are built at first, or of the others."""
        for tests in (likely, [t for t in among if t not in likely]):
            if tests != [STYLE] and not self.make([t for t in tests if t != STYLE]):
                return "does not compile"
            for test in tests:
                failed = self.first_failure(test)
                if failed:
                    return failed
        return None

    def kill(self, mutant: Mutant, among: list[str]) -> str | None:
        """What notices the mutant, or None."""
        with self.log.open("a") as out:
            out.write(f"\n=== {mutant.what}\n")
        originals: dict[Path, str] = {}
        try:
            for edit in mutant.edits:
                path = self.source / edit.file
                text = path.read_text()
                originals.setdefault(path, text)
                path.write_text(text.replace(edit.old, edit.new))
            return self.failure(mutant.tests.split(), among)
        finally:
            for path, text in originals.items():
                path.write_text(text)


PAGE = """# Mutants

`./lumitree mutants` makes this page. It breaks a copy of the core, one way after the other (`Testing/Stress/mutations.py`), builds it with GCC
at -O1 and runs the core's tests (without CGAL and Embree), the likeliest first, until one fails. A mutant that no test notices would mean that
what it breaks is not tested.

Not among them is what changes no answer: `<` for `<=` between entry and exit of a padded slab (the pads keep them apart; with the pads gone it
is a mutant below), what only costs time (an order of children, a box that is met too often), and a pad of the eight-wide tree that another one
covers: those of boxes and of origins make good for each other ([exactness](exactness.md), *Boxes in float*), both together are a mutant.

"""


def page(rows: list[tuple[Mutant, str | None]]) -> str:
    lines = [
        f"{sum(1 for r in rows if r[1])} of {len(rows)} are noticed.",
        "",
        "| what is broken | file | first test that fails |",
        "| --- | --- | --- |",
    ]
    for mutant, failed in rows:
        files = ", ".join(dict.fromkeys(f"`{e.file.removeprefix('Accel/')}`" for e in mutant.edits))
        lines.append(f"| {mutant.what} | {files} | {failed or '**none**'} |")
    return PAGE + "\n".join(lines) + "\n"


def misfits(mutants: list[Mutant]) -> list[str]:
    """Mutants whose edits the sources no longer have, or have twice."""
    found = []
    for mutant in mutants:
        for edit in mutant.edits:
            path = SOURCE / edit.file
            if not path.exists() or path.read_text().count(edit.old) != 1:
                found.append(f"'{mutant.what}' does not fit {edit.file} any more")
        unknown = set(mutant.tests.split()) - set(TESTS) - {STYLE}
        found += [f"'{mutant.what}' names the test {t}, which there is not" for t in unknown]
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--page", type=Path, default=SOURCE / "Docs" / "mutants.md")
    parser.add_argument("--build", type=Path, default=SOURCE / "build" / "mutants")
    parser.add_argument("--only", default="", help="mutants whose description has this word")
    parser.add_argument("--trust", action="store_true", help="do not run the tests on the unchanged core first")
    parser.add_argument("--quick", action="store_true", help="only the likely tests and the quick ones")
    parser.add_argument("--check", action="store_true", help="only whether all mutants fit the sources")
    arguments = parser.parse_args()
    chosen = [m for m in MUTANTS if arguments.only in m.what]
    if wrong := misfits(chosen):
        sys.exit("\n".join(wrong))
    if arguments.check:
        return 0
    arguments.build.mkdir(parents=True, exist_ok=True)
    os.environ.setdefault("CCACHE_NOHASHDIR", "1")
    copy = Copy(arguments.build)
    failed = None if arguments.trust else copy.failure([STYLE], TESTS)
    if failed:
        sys.exit(f"the unchanged core fails {failed}; see {copy.log}")
    rows = []
    for mutant in chosen:
        start = time.monotonic()
        rows.append((mutant, copy.kill(mutant, TESTS[:QUICK] if arguments.quick else TESTS)))
        if not arguments.only:
            arguments.page.write_text(page(rows))
        print(f"{rows[-1][1] or 'SURVIVES'}: {mutant.what} ({time.monotonic() - start:.0f} s)", flush=True)
    return 1 if any(r[1] is None for r in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
