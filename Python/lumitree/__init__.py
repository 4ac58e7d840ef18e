# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lumitree: rays and light for VTK and ParaView, from numpy and to numpy.

=========================== ========================================================`cast`, `Caster`, `Hits`    rays against a mesh: nearest hits, all hits, counts, occlusion
`inside`                    whether points lie inside a closed mesh
`camera_rays`, `rays`       sets of rays as VTK data sets
`hierarchy`                 the tree over a mesh, as boxes and statistics
`save_structure`            keeps it in a file, for ``structure_file=``
`compare_structures`        structures side by side, for the same rays
`disagreements`             the rays on which two back ends differ
`surface_report`            whether a mesh is closed, manifold, wound alike, and where it is not
`accuracy_chart`            speed against accuracy of every structure on a mesh
`irradiance`                light on a mesh, with shadows and units, to a tolerance
`radiance`                  along rays, with what surfaces reflect; `radiance_around` points
`radiant_intensity`         what a surface or a light sends in each direction
`solid_angle`               of a surface, or of its visible part, from points
`sensor_grid`               sensors on a plane, by EN 12464-1
`point_light`, ...          lights: `spot_light`, `photometric_light` (IES, EULUMDAT), `area_light`,
                            `sphere_light`, `disk_light`, `rectangle_light`, `tube_light`,
                            `line_light`, `directional_light`, `sun_light`, `sky_light`
`luminous_efficacy`         lm/W of a spectrum; `convertible` lets a light stand beside others
`scene`, `read`, `write`    built-in scenes, files
`implicit`                  spheres, cylinders and other quadrics without a mesh
`lumitree.vtk`              the VTK classes beneath
=========================== ========================================================
Meshes are data sets of VTK or PyVista, composites of them, ``(points, triangles)`` of numpy, or
files' names. What VTK reports as an error is raised as `LumitreeError`; a wrong argument is a
`ValueError`. ``python3 -m lumitree --help`` tells of the command line.
"""

from .accuracy import accuracy_chart
from .camera import camera_rays
from .choices import (
    BvhBuild,
    KdBuild,
    LengthUnit,
    LightSystem,
    Precision,
    Query,
    ReceiverLocation,
    Scene,
    Shape,
    Structure,
    StructureFileUse,
    Sweep,
)
from .comparison import Disagreements, compare_structures, disagreements
from .errors import LumitreeError, LumitreeWarning
from .files import read, write
from .implicit import implicit
from .intensity import Intensity, radiant_intensity, sensor_grid, solid_angle
from .lights import (
    area_light,
    convertible,
    directional_light,
    disk_light,
    line_light,
    luminous_efficacy,
    photometric_light,
    point_light,
    rectangle_light,
    sky_light,
    sphere_light,
    spot_light,
    sun_light,
    tube_light,
)
from .looking import Radiance, radiance, radiance_around
from .radiometry import EstimateMethod, Irradiance, irradiance
from .raycast import Caster, Hits, cast, inside
from .rayset import rays
from .scenes import scene
from .surfacereport import SurfaceReport, surface_report
from .trees import Hierarchy, hierarchy, save_structure

__all__ = [
    "BvhBuild",
    "Caster",
    "Disagreements",
    "EstimateMethod",
    "Hierarchy",
    "Hits",
    "Intensity",
    "Irradiance",
    "KdBuild",
    "LengthUnit",
    "LightSystem",
    "LumitreeError",
    "LumitreeWarning",
    "Precision",
    "Query",
    "Radiance",
    "ReceiverLocation",
    "Scene",
    "Shape",
    "Structure",
    "StructureFileUse",
    "SurfaceReport",
    "Sweep",
    "accuracy_chart",
    "area_light",
    "camera_rays",
    "cast",
    "compare_structures",
    "convertible",
    "directional_light",
    "disagreements",
    "disk_light",
    "hierarchy",
    "implicit",
    "inside",
    "irradiance",
    "line_light",
    "luminous_efficacy",
    "photometric_light",
    "point_light",
    "radiance",
    "radiance_around",
    "radiant_intensity",
    "rays",
    "read",
    "rectangle_light",
    "save_structure",
    "scene",
    "sensor_grid",
    "sky_light",
    "solid_angle",
    "sphere_light",
    "spot_light",
    "sun_light",
    "surface_report",
    "tube_light",
    "write",
]
