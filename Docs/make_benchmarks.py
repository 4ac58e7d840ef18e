# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the benchmarks of rays and writes the tables of benchmarks.md and their pictures; `./lumitree bench` runs it.

python3 Docs/make_benchmarks.py [--programs DIRECTORY] [--surface FILE.obj] [--out DIRECTORY] [--no-page]
                                [--quick] [PART...]

Parts: rays, structures, filter, growth; all by default. Between the marks ``<!-- PART -->`` and ``<!-- end -->``
the page (and README.md, which has a part of filter) is replaced, unless --no-page is given; tables and raw numbers also go to the output directory
(out/bench). With --surface the first scene, and the third that is made of it, are those of the file.
"""

from __future__ import annotations

import argparse
import csv
import json
import math
import os
import re
import subprocess
from collections import defaultdict
from pathlib import Path
from statistics import median

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  after the choice of back end

HERE = Path(__file__).resolve().parent
PAGE = HERE / "benchmarks.md"
README = HERE.parent / "README.md"
KINDS = ("camera", "incoherent", "occlusion")
STRUCTURES = ("bvh", "grid", "octree", "kd_tree", "bsp_tree")


def table(head: list[str], rows: list[list[str]]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def processor() -> str:
    names = re.findall(r"^model name\s*:\s*(.*)$", Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    features = Path("/proc/cpuinfo").read_text()
    widest = "AVX-512" if "avx512f" in features else "AVX2" if "avx2" in features else "no AVX2"
    return f"{names[0] if names else 'unknown processor'} with {widest}"


def load() -> str:
    return f"{os.getloadavg()[0]:.0f}"


class Bench:
    """The programs, the output directory and the page."""

    def __init__(self, arguments: argparse.Namespace) -> None:
        self.programs = arguments.programs
        self.out = arguments.out
        self.surface = arguments.surface
        self.page = not arguments.no_page
        self.quick = arguments.quick

    def run(self, program: str, *flags: str, surface: bool = True) -> str:
        file = [f"--surface={self.surface}"] if surface and self.surface else []
        command = [str(self.programs / program), *file, *flags]
        return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout

    def google(self, part: str, pattern: str) -> tuple[list[dict], dict]:
        """What Rays measured, and its context."""
        file = self.out / f"{part}.json"
        self.run(
            "Rays",
            f"--benchmark_filter={pattern}",
            f"--benchmark_repetitions={2 if self.quick else 5}",
            f"--benchmark_out={file}",
            "--benchmark_out_format=json",
        )
        read = json.loads(file.read_text())
        runs = [run for run in read["benchmarks"] if run["run_type"] == "iteration"]
        return runs, read["context"]

    def write(self, part: str, text: str, page: Path = PAGE) -> None:
        """To the output directory, and between the marks of a page."""
        (self.out / f"{page.stem}-{part}.md").write_text(text)
        print(text, flush=True)
        if self.page:
            marked = re.compile(rf"(<!-- {part} -->\n).*?(<!-- end -->)", re.DOTALL)
            page.write_text(marked.sub(lambda m: f"{m[1]}\n{text.strip()}\n\n{m[2]}", page.read_text()))

    def warning(self) -> str:
        return " **A quick run, beside other work: provisional.**" if self.quick else ""

    def draw(self, name: str, figure) -> None:
        places = [self.out / f"{name}.png"]
        if self.page:
            places.append(HERE / "images" / f"{name}.png")
        for place in places:
            figure.savefig(place, dpi=110, bbox_inches="tight", metadata={"Software": None})
        pyplot.close(figure)


def place(cell: tuple[str, str]) -> tuple:
    """Where a scene and a kind of rays stand in a table; runs come in random order."""
    scene, kind = cell
    return (scene == "stadium", scene.endswith(" x 16"), scene == "city", scene, (*KINDS, "build").index(kind))


def cells(runs: list[dict]) -> tuple[dict, dict]:
    """Nanoseconds per ray, by (scene, kind) and contender, medians; which part of the rays hit."""
    times = defaultdict(lambda: defaultdict(list))
    shares = {}
    for run in runs:
        scene, kind, contender = run["name"].split("/")[:3]
        if kind in KINDS:
            times[scene, kind][contender].append(1e6 * run["cpu_time"] / run["rays"])
            if contender == "wide_bvh exact":
                shares[scene, kind] = run["hit_share"]
    return {c: {n: median(t) for n, t in times[c].items()} for c in sorted(times, key=place)}, shares


def best(of: dict, start: str, is_sorted: bool) -> tuple[float, str]:
    """The quickest interface of Embree, and its name."""
    found = [(t, n) for n, t in of.items() if n.startswith(start) and ("sorted" in n) == is_sorted]
    return min(found, default=(math.nan, ""))


def number(value: float) -> str:
    return "–" if math.isnan(value) else f"{value:,.0f}"


def rays_table(times: dict, shares: dict) -> str:
    rows = []
    reached = defaultdict(int)
    for (scene, kind), of in times.items():
        fast, robust = best(of, "Embree fast", False), best(of, "Embree robust", False)
        fast_sorted, robust_sorted = best(of, "Embree fast", True), best(of, "Embree robust", True)
        ours = [of[f"wide_bvh {p}"] for p in ("fast", "watertight", "exact")]
        ratios = [fast[0] / ours[0], fast_sorted[0] / ours[0], robust[0] / ours[2], robust_sorted[0] / ours[2]]
        for i, ratio in enumerate(ratios):
            reached[i] += ratio >= (0.75 if i == 2 and kind == "camera" else 1.0)

        def shown(found: tuple[float, str]) -> str:
            how = found[1].split(", ", 1)[-1].replace("sorted, ", "").replace(", sorted", "")
            return "–" if not found[1] else f"{found[0]:.0f} ({how})"

        rows.append(
            [f"{scene}, {kind}", f"{100 * shares[scene, kind]:.1f}", *(number(t) for t in ours)]
            + [shown(fast), shown(fast_sorted), shown(robust), shown(robust_sorted)]
            + ["–" if math.isnan(r) else f"{r:.2f}" for r in ratios]
            + [number(of.get(n, math.nan)) for n in ("vtkStaticCellLocator", "CGAL EPECK", "CGAL doubles")]
        )
    head = ["[ns per ray]", "hit [%]", "fast", "watertight", "exact", "Embree fast", "sorted", "Embree robust", "sorted"]
    head += ["fast is × Embree", "sorted", "exact is × Embree robust", "sorted", "locator", "CGAL EPECK", "CGAL doubles"]
    said = (
        f"Of {len(times)} cells `fast` is at least as fast as Embree's best interface on {reached[0]}, as its best on sorted rays on "
        f"{reached[1]}; `exact` reaches Embree robust (0.75 of it on camera rays) on {reached[2]}, sorted on {reached[3]}."
    )
    return table(head, rows) + "\n\n" + said


def build_table(runs: list[dict], context: dict) -> str:
    times = defaultdict(lambda: defaultdict(list))
    memory = {}
    for run in runs:
        scene, kind, contender = run["name"].split("/")[:3]
        if kind == "build":
            times[contender][scene].append(run["real_time"])
            memory[contender, scene] = run["bytes_per_triangle"]
    scenes = sorted(next(iter(times.values())), key=lambda scene: place((scene, "build")))
    rows = []
    for contender, of in sorted(times.items(), reverse=True):
        weights = [memory[contender, s] for s in scenes]
        rows.append(
            [contender]
            + [f"{median(of[s]):.1f}" for s in scenes]
            + ["–" if not w else f"{w:.0f}" for w in weights]
        )
    head = ["build [ms]", *(f"{s}, {int(context[s]):,}" for s in scenes)] + [f"{s} [bytes per triangle]" for s in scenes]
    return table(head, rows)


def rays_picture(bench: Bench, times: dict) -> None:
    figure, axes = pyplot.subplots(1, 3, figsize=(13, 4.2), sharey=True)
    scenes = list(dict.fromkeys(scene for scene, _ in times))
    for axis, kind in zip(axes, KINDS):
        names = ("wide_bvh fast", "wide_bvh exact", "Embree fast", "Embree robust", "vtkStaticCellLocator", "CGAL EPECK")
        colours = ("#92c5de", "#1b7837", "#fdb863", "#e66101", "#999999", "#5e3c99")
        for i, (name, colour) in enumerate(zip(names, colours)):
            values = []
            for scene in scenes:
                of = times[scene, kind]
                values.append(of.get(name, math.nan) if not name.startswith("Embree") else best(of, name, False)[0])
            axis.bar([s + (i - 2.5) * 0.14 for s in range(len(scenes))], values, 0.14, color=colour, label=name)
        axis.set_yscale("log")
        axis.set_xticks(range(len(scenes)), scenes)
        axis.set_title(kind)
        axis.grid(axis="y", alpha=0.3)
    axes[0].set_ylabel("ns per ray")
    axes[2].legend(fontsize=7, loc="upper right")
    bench.draw("benchmarks-rays", figure)


def rays(bench: Bench) -> None:
    runs, context = bench.google("rays", "-(" + "|".join(f"/{s} exact" for s in STRUCTURES) + ")")
    times, shares = cells(runs)
    with (bench.out / "rays.csv").open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["scene", "rays", "contender", "ns per ray"])
        writer.writerows([*cell, name, f"{t:.2f}"] for cell, of in times.items() for name, t in of.items())
    facts = (
        f"Machine: {processor()}, one thread, load {load()} at the end; Embree {context.get('embree', '')}; processor time, medians of "
        f"{2 if bench.quick else 5} repetitions in random order.{bench.warning()}"
    )
    bench.write("rays", f"{facts}\n\n{rays_table(times, shares)}\n\n{build_table(runs, context)}\n")
    rays_picture(bench, times)


def structures(bench: Bench) -> None:
    names = "|".join((*STRUCTURES, "wide_bvh"))
    runs, _ = bench.google("structures", rf"^[^/x]*/.*/({names}) exact")
    times, _ = cells(runs)
    order = ["wide_bvh", *STRUCTURES]
    rows = []
    for (scene, kind), of in times.items():
        wide = of["wide_bvh exact"]
        shown = [of.get(f"{s} exact", math.nan) for s in order]
        rows.append([f"{scene}, {kind}"] + ["–" if math.isnan(t) else f"{t:,.0f} ({t / wide:.1f} ×)" for t in shown])
    facts = f"Machine: {processor()}, load {load()} at the end.{bench.warning()}\n\n"
    bench.write("structures", facts + table(["exact, [ns per ray]", *order], rows) + "\n")


def filter_cost(bench: Bench) -> None:
    facts = f"Machine: {processor()}, load {load()} at the beginning.{bench.warning()}\n\n"
    flags = ("1000000", "2", "20000") if bench.quick else ()
    measured = bench.run("RayCastVersusLocator", *flags)
    bench.write("filter", facts + measured)
    rows = [
        [name, f"{float(build) + float(calls):,.2f}", f"{float(own) + float(rest):,.2f}", times, without]
        for name, _, _, build, calls, own, rest, _, times, without in (
            [cell.strip() for cell in line.strip("| ").split(" | ")]
            for line in measured.splitlines()
            if line.count(" | ") == 9 and re.search(r"\d", line)
        )
    ]
    head = ["a million rays", "`vtkStaticCellLocator` [s]", "`vtkLumiRayCast` [s]", "times as fast", "without builds"]
    bench.write("filter", table(head, rows) + "\n\n" + bench.warning().strip(), README)


def exponent(points: list[tuple[float, float]]) -> float:
    """The slope of log time over log n, by least squares."""
    logs = [(math.log(n), math.log(t)) for n, t in points]
    x, y = (sum(p[k] for p in logs) / len(logs) for k in (0, 1))
    return sum((a - x) * (b - y) for a, b in logs) / sum((a - x) ** 2 for a, _ in logs)


def growth(bench: Bench) -> None:
    what = defaultdict(list)
    lines = bench.run("Growth", *(("2e6", "1e7") if bench.quick else ()), surface=False).splitlines()
    (bench.out / "growth.csv").write_text("\n".join(["what,n,seconds", *lines, ""]))
    for line in lines:
        name, n, seconds = line.split(",")
        what[name].append((float(n), float(seconds)))

    figure, axes = pyplot.subplots(1, 2, figsize=(11, 4.2))
    shown = (("build", 0, "build"), ("camera", 0, "a million camera rays"))
    shown += (("incoherent", 0, "a million incoherent rays"), ("rays", 1, "incoherent rays"))
    exponents = []
    for name, axis, title in shown:
        # Where n is small, time is that of what does not grow.
        slope = exponent(what[name][len(what[name]) // 2 - 1 :])
        exponents.append([title, "triangles" if axis == 0 else "rays", f"{slope:.2f}"])
        n, seconds = zip(*what[name])
        axes[axis].loglog(n, seconds, "o-", label=f"{title}: n^{slope:.2f}")
    for axis, label in zip(axes, ("triangles", "rays")):
        axis.set_xlabel(label)
        axis.set_ylabel("s")
        axis.grid(alpha=0.3)
        axis.legend()
    bench.draw("benchmarks-growth", figure)

    triangles = [
        [f"{n:,.0f}", f"{1e3 * t:,.1f}", f"{1e3 * camera:,.0f}", f"{1e3 * incoherent:,.0f}"]
        for (n, t), (_, camera), (_, incoherent) in zip(what["build"], what["camera"], what["incoherent"])
    ]
    rays_rows = [[f"{n:,.0f}", f"{t:,.4g}", f"{1e9 * t / n:,.0f}"] for n, t in what["rays"]]
    threads = [
        [f"{n:.0f}", f"{1e3 * t:,.0f}", f"{what['threads build'][0][1] / t:.2f}", f"{1e3 * r:,.0f}"]
        + [f"{what['threads rays'][0][1] / r:.2f}"]
        for (n, t), (_, r) in zip(what["threads build"], what["threads rays"])
    ]
    parts = [
        f"Machine: {processor()}, load {load()} at the end.{bench.warning()}",
        table(["time of", "grows with", "exponent, upper half of the sizes"], exponents),
        table(["triangles", "build [ms]", "camera rays [ns]", "incoherent rays [ns]"], triangles),
        table(["rays, streamed", "[s]", "[ns per ray]"], rays_rows),
        table(["threads", "build [ms]", "times as fast", "a million rays [ms]", "times as fast"], threads),
    ]
    bench.write("growth", "\n\n".join(parts) + "\n")


PARTS = {"rays": rays, "structures": structures, "filter": filter_cost, "growth": growth}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", type=Path, default=HERE.parent / "build/release/bin/benchmarks")
    parser.add_argument("--out", type=Path, default=HERE.parent / "out/bench")
    parser.add_argument("--surface", help="a Wavefront file")
    parser.add_argument("--no-page", action="store_true", help="leave benchmarks.md and its pictures as they are")
    parser.add_argument("--quick", action="store_true", help="fewer repetitions, rays and triangles")
    parser.add_argument("parts", nargs="*", metavar="PART", help=", ".join(PARTS))
    arguments = parser.parse_args()
    unknown = set(arguments.parts) - set(PARTS)
    if unknown:
        parser.error(f"no part {', '.join(sorted(unknown))}; there are {', '.join(PARTS)}")
    arguments.out.mkdir(parents=True, exist_ok=True)
    bench = Bench(arguments)
    for part in arguments.parts or PARTS:
        PARTS[part](bench)


if __name__ == "__main__":
    main()
