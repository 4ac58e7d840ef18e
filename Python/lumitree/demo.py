# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""A tour: what Lumitree does, on scenes of its own. ``python3 -m lumitree.demo [DIR]``"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from .camera import view_of
from .errors import LumitreeError
from .lightspec import parse_light
from .reports import Report, report_cost, report_hierarchy, report_irradiance
from .scenes import scene
from .screen import restart_with_screen, screen_available
from .stages import stage_of

#: A scene, the structures to compare over it, and what to look at.
TOUR = (
    (
        "cornell_box",
        ("auto",),
        "irradiance.png: the lamp's light on floor and walls, and the shadows of the two blocks. "
        "What is received in all is what the lamp emits, 100 W: the room is closed.",
    ),
    (
        "teapot",
        ("bvh", "wide_bvh"),
        "hierarchy.png: the upper boxes of the tree. cost.png: the nodes that the ray of each "
        "pixel enters; edges and the handle are dear, empty space is cheap.",
    ),
    (
        "teapot_in_stadium",
        ("auto",),
        "cost.png: a small object in a big room costs a hierarchy little.",
    ),
)

SIZE = (800, 600)


def main(arguments: list[str] | None = None) -> int:
    """Writes the tour into a directory. Returns an exit code."""
    given = sys.argv[1:] if arguments is None else arguments
    parser = argparse.ArgumentParser(
        prog="python3 -m lumitree.demo", description=__doc__.partition("``")[0]
    )
    parser.add_argument(
        "directory", type=Path, nargs="?", default=Path("out"), help="default: %(default)s"
    )
    options = parser.parse_args(given)
    if not screen_available():
        restart_with_screen("lumitree.demo", given)
        print("lumitree: no pictures, because there is no screen; install xvfb", file=sys.stderr)
    try:
        for name, structures, hint in TOUR:
            for structure in structures:
                folder = name if len(structures) == 1 else f"{name}-{structure}"
                _show(name, structure, options.directory / folder)
            print(f"  look at   {hint}\n")
    except (LumitreeError, OSError) as error:
        print(f"lumitree: {error}", file=sys.stderr)
        return 2
    print(f"All is in {options.directory}/; open the .vtm, .vti and .vtp files in ParaView.")
    return 0


def _show(name: str, structure: str, directory: Path) -> None:
    stage = stage_of(name)
    surface = scene(name, resolution=stage.resolution)
    view = stage.view or view_of(surface.GetBounds())
    directory.mkdir(parents=True, exist_ok=True)
    report = Report(
        directory=directory, view=view, pictures=screen_available(), structure=structure
    )
    print(f"{directory}/: {surface.GetNumberOfCells():,} polygons")
    print("  hierarchy", report_hierarchy(report, surface))
    print("  rays     ", report_cost(report, surface, SIZE))
    print("  light    ", report_irradiance(report, surface, [parse_light(stage.light)]))


if __name__ == "__main__":
    raise SystemExit(main())
