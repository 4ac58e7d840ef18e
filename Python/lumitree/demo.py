# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""A tour: what Lumitree does, on scenes of its own. ``python3 -m lumitree.demo [DIR]``"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from .errors import LumitreeError
from .lightspec import parse_light
from .reports import Report
from .scenes import scene
from .screen import restart_with_screen, screen_available
from .stages import in_the_open, stage_of

#: A scene; a directory for each way to build a tree over it; what to look at.
TOUR = (
    (
        "cornell_box",
        {"cornell_box": {}},
        "cornell_box/irradiance.png: a lamp's light in a room, and the shadows of two blocks. All "
        "that the lamp emits, 100 W, is received, as the room is closed and its mesh is fine.",
    ),
    (
        "teapot",
        {
            "teapot-median": {"structure": "bvh", "bvh_build": "longest_axis_median"},
            "teapot-sah": {"structure": "bvh", "bvh_build": "binned_sah"},
        },
        "teapot-*/cost.png: the nodes that the ray of each pixel enters, in a tree that is split "
        "in the middle and in one split where it costs least; hierarchy.png: their boxes.",
    ),
    (
        "teapot_in_stadium",
        {"teapot_in_stadium": {}},
        "teapot_in_stadium/cost.png: a small thing in a hall 300 times its size costs a hierarchy "
        "little; a uniform grid would put all of it into one cell.",
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
    directory = parser.parse_args(given).directory
    if not screen_available():
        restart_with_screen("lumitree.demo", given)
        print("lumitree: no pictures, because there is no screen; install xvfb", file=sys.stderr)
    try:
        for name, builds, hint in TOUR:
            for folder, options in builds.items():
                _show(name, directory / folder, options)
            print(f"  look at   {hint}\n")
    except (LumitreeError, OSError) as error:
        print(f"lumitree: {error}", file=sys.stderr)
        return 2
    print(f"All is in {directory}/; open the .vtm, .vti and .vtp files in ParaView.")
    return 0


def _show(name: str, directory: Path, options: dict[str, str]) -> None:
    stage = stage_of(name)
    surface = scene(name, resolution=stage.resolution)
    view, sun = in_the_open(surface.GetBounds(), aspect=SIZE[0] / SIZE[1])
    directory.mkdir(parents=True, exist_ok=True)
    report = Report(surface, directory, stage.view or view, pictures=screen_available(), **options)
    print(f"{directory}/: {surface.GetNumberOfCells():,} polygons")
    print("  hierarchy", report.hierarchy())
    print("  rays     ", report.cost(SIZE))
    if (
        name != "teapot_in_stadium"
    ):  # its hall is a single cell a wall, too few receivers to look at
        print("  light    ", report.light([parse_light(stage.light or sun)]))


if __name__ == "__main__":
    raise SystemExit(main())
