# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line: a surface in; its hierarchy, the cost of rays and the light on it out."""

from __future__ import annotations

import argparse
import sys
import warnings
from collections.abc import Sequence
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkLogger
from vtkmodules.vtkCommonDataModel import vtkPolyData

from .camera import View
from .choices import (
    LENGTH_SYMBOLS,
    BvhBuild,
    KdBuild,
    Precision,
    ReceiverLocation,
    Scene,
    Structure,
    names,
)
from .errors import LumitreeError, LumitreeWarning
from .files import READERS, read
from .lightspec import FORMS, parse_light, triple
from .reports import Report, outer_surface
from .scenes import scene
from .screen import restart_with_screen, screen_available
from .stages import DIRECTIONS, Stage, in_the_open, stage_of
from .surfacereport import surface_report

#: Formats in which y points up.
Y_UP = (".obj", ".gltf", ".glb")

EXAMPLES = """
examples:
  python3 -m lumitree bunny.ply
      the hierarchy, the cost of rays and sunlight on a scanned surface, in lumitree-out/
  python3 -m lumitree hall.stl --length-unit mm --light point:0,0,2500:900lm --light point:9,9,9:9lm
      two lamps in a hall drawn in millimetres; irradiance.vtp holds lux, also of each lamp alone
  python3 -m lumitree roof.obj --light sun:0.3,0.2,-1:800 --at points --out roof
      sunlight of 800 W/m^2 that travels in the direction (0.3, 0.2, -1), at the points of a roof
  python3 -m lumitree scene:teapot_in_stadium --structure bvh --precision watertight
      a built-in scene, under a binary hierarchy, with no ray slipping between triangles
  python3 -m lumitree scene:cornell_box --radiance --reflectance 0.7
      also what the camera sees of a lit room: radiance.vti and a picture

Open hierarchy.vtm, cost.vti, hits.vtp and irradiance.vtp in ParaView; pictures lie beside them.
"""


def make_parser() -> argparse.ArgumentParser:
    """The parser of the command line."""
    parser = argparse.ArgumentParser(
        prog="python3 -m lumitree",
        description="Builds a hierarchy over a surface and shows it, casts the rays of a camera\n"
        "at it and shows what they cost, and computes the light that lamps and sun throw\n"
        "on it, with shadows.",
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    scenes = ", ".join(names(Scene))
    parser.add_argument(
        "mesh",
        metavar="MESH",
        help=f"a file that VTK reads ({', '.join(READERS)}), or scene:NAME for a built-in scene "
        f"({scenes})",
    )
    parser.add_argument(
        "--out", type=Path, default=Path("lumitree-out"), metavar="DIR", help="default: %(default)s"
    )

    light = parser.add_argument_group("light")
    light.add_argument(
        "--light",
        action="append",
        metavar="LIGHT",
        help=f"one of {'; '.join(FORMS.values())}. FLUX in W or lm (1000lm), IRRADIANCE in W/m2 or lx: "
        "of a sun on a plane facing it, of a sky on the horizontal; RADIANCE in W/m2sr or cd/m2; "
        "directions are those in which light travels; repeat it for more lights (default: a sun of "
        "1000 W/m2 from above, or the scene's own lamp)",
    )
    light.add_argument(
        "--at", choices=names(ReceiverLocation), default="cells", help="default: %(default)s"
    )
    light.add_argument(
        "--tolerance",
        type=float,
        default=0.01,
        metavar="PART",
        help="how far irradiance that rays estimate may be off, relative to it, 0 to 1; what has a "
        "closed form is exact; default: %(default)s",
    )
    light.add_argument(
        "--radiance",
        action="store_true",
        help="also give the radiance (or luminance) that the camera sees, of lights and of the "
        "surface, which reflects --reflectance of the light that falls on it directly",
    )
    light.add_argument(
        "--reflectance",
        type=float,
        default=0.5,
        metavar="PART",
        help="of --radiance, 0 to 1, where the surface has no cell array Reflectance; "
        "default: %(default)s",
    )
    light.add_argument(
        "--length-unit",
        choices=LENGTH_SYMBOLS,
        default="m",
        help="what one unit of the coordinates is; default: %(default)s",
    )

    tree = parser.add_argument_group("rays")
    tree.add_argument(
        "--structure", choices=names(Structure), default="auto", help="default: %(default)s"
    )
    tree.add_argument(
        "--precision", choices=names(Precision), default="automatic", help="default: %(default)s"
    )
    tree.add_argument(
        "--bvh-build", choices=names(BvhBuild), default="binned_sah", help="default: %(default)s"
    )
    tree.add_argument(
        "--compare",
        action="store_true",
        help="also cast the rays at every other structure, and tell what they cost there",
    )
    tree.add_argument(
        "--kd-build", choices=names(KdBuild), default="sah", help="default: %(default)s"
    )
    tree.add_argument(
        "--leaf-size", type=int, default=4, metavar="N", help="of a tree; default: %(default)s"
    )
    tree.add_argument(
        "--max-depth", type=int, default=64, metavar="N", help="of a tree; default: %(default)s"
    )
    tree.add_argument(
        "--grid-density",
        type=float,
        default=0.5,
        metavar="C",
        help="of a grid: cells per primitive; default: %(default)s",
    )
    tree.add_argument(
        "--grid-resolution", metavar="NxMxK", help="of a grid: cells along x, y and z, instead"
    )
    tree.add_argument(
        "--structure-file",
        metavar="FILE",
        help="keeps the structure from one run to the next: loaded where it is of this mesh and "
        "these choices, written where there is none",
    )
    tree.add_argument(
        "--threads", type=int, default=0, metavar="N", help="default: 0, as many as there are"
    )

    tree.add_argument(
        "--inside",
        action="append",
        metavar="x,y,z",
        help="tell whether this point lies inside the surface, which is to be closed; repeat it "
        "for more points",
    )

    camera = parser.add_argument_group("camera")
    camera.add_argument("--eye", metavar="x,y,z", help="where it is (default: so that all is seen)")
    camera.add_argument("--target", metavar="x,y,z", help="what it looks at (default: the middle)")
    camera.add_argument(
        "--up", choices=list(DIRECTIONS), help="default: y for obj, gltf and glb files, otherwise z"
    )
    camera.add_argument(
        "--size", default="640x480", metavar="WxH", help="pixels; default: %(default)s"
    )
    camera.add_argument("--no-pictures", action="store_true", help="write data only, no PNG")

    scene_group = parser.add_argument_group("built-in scenes")
    scene_group.add_argument("--resolution", type=int, metavar="N", help="how fine, from 1 to 1000")
    return parser


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command line. Returns its exit code: 0, or 2 after a message about what is wrong."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    options = make_parser().parse_args(given)
    if not options.no_pictures and not screen_available():
        restart_with_screen("lumitree", given)
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)  # errors are told below, once
    warnings.showwarning = _show_warning
    try:
        _run(options)
    except (LumitreeError, ValueError, OSError) as error:
        print(f"lumitree: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("lumitree: stopped", file=sys.stderr)
        return 130
    return 0


def _run(options: argparse.Namespace) -> None:
    lights = [parse_light(text) for text in options.light or ()]
    points = [triple(text) for text in options.inside or ()]
    size = _size(options.size)
    surface, stage = _load(options)
    up = options.up or ("y" if Path(options.mesh).suffix.lower() in Y_UP else "z")
    view, sun = in_the_open(surface.GetBounds(), up, size[0] / size[1])
    view = stage.view or view
    if options.eye or options.target:
        view = View(
            eye=triple(options.eye) if options.eye else view.eye,
            target=triple(options.target) if options.target else view.target,
            up=view.up,
        )
    pictures = not options.no_pictures
    if pictures and not screen_available():
        print("lumitree: no pictures, because there is no screen; install xvfb", file=sys.stderr)
        pictures = False
    options.out.mkdir(parents=True, exist_ok=True)
    report = Report(
        surface,
        directory=options.out,
        view=view,
        pictures=pictures,
        structure=options.structure,
        precision=options.precision,
        bvh_build=options.bvh_build,
        kd_build=options.kd_build,
        leaf_size=options.leaf_size,
        max_depth=options.max_depth,
        grid_density=options.grid_density,
        grid_resolution=_resolution(options.grid_resolution),
        threads=options.threads,
        structure_file=options.structure_file,
    )
    print(f"surface     {options.mesh}: {surface.GetNumberOfCells():,} cells{_verdict(surface)}")
    print("hierarchy  ", report.hierarchy())
    print("rays       ", report.cost(size))
    if options.compare:
        print("structures", *report.compare(size), sep="\n  ")
    if points:
        print("points     ", report.sides(points))
    lights = lights or [parse_light(stage.light or sun)]
    print("light      ", report.light(lights, options.at, options.length_unit, options.tolerance))
    if options.radiance:
        line = report.radiance(
            lights, size, options.reflectance, options.length_unit, options.tolerance
        )
        print("radiance   ", line)
    written = sorted(file.name for file in options.out.iterdir())
    print(f"written     {options.out}/: {', '.join(written)}")


def _load(options: argparse.Namespace) -> tuple[vtkPolyData, Stage]:
    kind, _, name = options.mesh.partition(":")
    if kind == "scene":
        stage = stage_of(name)
        resolution = stage.resolution if options.resolution is None else options.resolution
        return scene(name, resolution=resolution), stage
    if options.resolution is not None:
        raise ValueError("--resolution is for built-in scenes")
    surface = outer_surface(read(options.mesh))
    if surface.GetNumberOfPolys() + surface.GetNumberOfStrips() == 0:
        raise LumitreeError(f"{options.mesh} holds no surface, only points or lines")
    return surface, Stage()


def _verdict(surface: vtkPolyData) -> str:
    try:
        return f"; {surface_report(surface).facts['Verdict']}"
    except LumitreeError:  # a build without OpenMesh has no verdict
        return ""


def _size(text: str) -> tuple[int, int]:
    width, _, height = text.partition("x")
    if not (width.isdecimal() and height.isdecimal() and int(width) and int(height)):
        raise ValueError(f"--size is {text!r}, not two numbers as in 640x480")
    return int(width), int(height)


def _resolution(text: str | None) -> tuple[int, ...] | None:
    if text is None:
        return None
    cells = text.split("x")
    if len(cells) != 3 or not all(part.isdecimal() for part in cells):
        raise ValueError(f"--grid-resolution is {text!r}, not three numbers as in 32x32x8")
    return tuple(int(part) for part in cells)


def _show_warning(
    message: Warning | str, category: type[Warning], *details: object, **more: object
) -> None:
    head = "lumitree: " if issubclass(category, LumitreeWarning) else f"{category.__name__}: "
    print(f"{head}{message}", file=sys.stderr)
