# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Radiance: along rays, and by direction around points."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet,
    vtkDataObject,
    vtkDataSet,
    vtkPolyData,
)

from .arrays import in_range, number_in_range, to_vtk
from .choices import LengthUnit, Precision, Structure, choose_length_unit
from .errors import run
from .rayset import rays
from .structures import set_structure
from .surfaces import Mesh, as_surface
from .vtk import vtkLumiRadiance


@dataclass(frozen=True)
class Radiance:
    """Radiance along n rays, or from n places in d directions.

    values : (n,) or (n, d) float64, in `unit`; nan where a ray cannot be traced.
    name : of the array in the data set, ``"Radiance [W/(m^2 sr)]"`` or, of photometric lights,
        ``"Luminance [cd/m^2]"``.
    unit : ``"W/(m^2 sr)"`` or ``"cd/m^2"``.
    dataset : the rays or places with that array, which shares its memory.
    directions, solid_angles : by direction: (d, 3), and (d,) in sr, 4 pi together; else None. The
        sum of values * solid_angles * cosine is about the irradiance.
    """

    values: np.ndarray
    name: str
    unit: str
    dataset: vtkDataSet
    directions: np.ndarray | None = None
    solid_angles: np.ndarray | None = None


def radiance(
    origins: ArrayLike | vtkDataSet,
    directions: ArrayLike | None = None,
    lights: vtkDataObject | Sequence[vtkDataObject] = (),
    occluders: Mesh | None = None,
    *,
    t_min: ArrayLike = 0.0,
    t_max: ArrayLike = np.inf,
    reflectance: float | None = None,
    tolerance: float = 0.01,
    maximum_rays: int = 16384,
    length_unit: LengthUnit | str = "m",
    precision: Precision | str = "automatic",
    structure: Structure | str = "auto",
    threads: int = 0,
    progress: Callable[[float], None] | None = None,
    **build: object,
) -> Radiance:
    """Radiance that arrives at the origin of each ray out of its direction.

    origins, directions, t_min, t_max : as of `Caster.cast`; a data set of rays, such as of
        `camera_rays` (which gives an image), stands in the place of origins and directions.
    lights : of `area_light`, `sky_light` and so on; points, lines and parallel light have no
        radiance and show only by what they make of the surface.
    occluders : what is in the way; see `as_surface`.
    reflectance : the surface reflects that share of direct light by Lambert's law, or, where it has
        it, the share in its cell array ``Reflectance``. None: it is black.
    tolerance, maximum_rays : of the light that is reflected, as of `irradiance`.
    length_unit, precision, structure, threads, build : as of `irradiance`.

    Raises ValueError for wrong shapes, names and types, LumitreeError for what the filter refuses.
    Rays that cannot be traced give nan, and a LumitreeWarning counts them.
    """
    filter_ = _filter(lights, occluders, reflectance, tolerance, maximum_rays, length_unit)
    if isinstance(origins, vtkDataSet):
        if directions is not None:
            raise ValueError("a data set of rays has directions of its own")
        data = origins
    elif directions is None:
        raise ValueError("directions are missing")
    else:
        data = rays(origins, directions, t_min, t_max)
    for name, limit, setter in (
        ("t_min", t_min, filter_.SetTMin),
        ("t_max", t_max, filter_.SetTMax),
    ):
        if np.ndim(limit) == 0:
            setter(float(limit))
        elif data is origins:
            raise ValueError(f"{name} must be a number: a data set of rays has limits of its own")
    filter_.SetInputDataObject(0, data)
    set_structure(filter_, structure, precision=precision, threads=threads, **build)
    run(filter_, progress)
    result = filter_.GetOutputDataObject(0)
    for attributes in (result.GetPointData(), result.GetCellData()):
        array = attributes.GetScalars()
        if array and array.GetName() in ("Radiance [W/(m^2 sr)]", "Luminance [cd/m^2]"):
            break
    unit = array.GetName().partition("[")[2][:-1]
    return Radiance(vtk_to_numpy(array), array.GetName(), unit, result)


def radiance_around(
    points: ArrayLike | vtkDataSet,
    lights: vtkDataObject | Sequence[vtkDataObject],
    occluders: Mesh | None = None,
    *,
    rings: int = 12,
    sectors: int = 24,
    axis: Sequence[float] = (0.0, 0.0, 1.0),
    reference: Sequence[float] = (1.0, 0.0, 0.0),
    reflectance: float | None = None,
    tolerance: float = 0.01,
    maximum_rays: int = 16384,
    length_unit: LengthUnit | str = "m",
    precision: Precision | str = "automatic",
    structure: Structure | str = "auto",
    threads: int = 0,
    progress: Callable[[float], None] | None = None,
    **build: object,
) -> Radiance:
    """Radiance that arrives at places, by direction.

    points : (n, 3), or a data set: where its points have a normal, or belong to polygons, what is
        behind them gives 0.
    rings, sectors : directions are the middles of that many bands of the sphere from `axis` down,
        each cut in sectors that are counted from `reference` counterclockwise.

    The rest is as of `radiance`.
    """
    filter_ = _filter(lights, occluders, reflectance, tolerance, maximum_rays, length_unit)
    if isinstance(points, vtkDataSet):
        data = points
    else:
        places = np.ascontiguousarray(points, dtype=np.float64)
        if places.ndim != 2 or places.shape[1] != 3:
            raise ValueError(f"points must be of shape (n, 3), not {places.shape}")
        data = vtkPolyData()
        held = vtkPoints()
        held.SetData(to_vtk(places))
        data.SetPoints(held)
    filter_.SetInputDataObject(0, data)
    filter_.SetLook(filter_.ByDirection)
    filter_.SetRings(in_range(rings, 1, 180, "rings"))
    filter_.SetSectors(in_range(sectors, 1, 360, "sectors"))
    filter_.SetAxis(*axis)
    filter_.SetReference(*reference)
    set_structure(filter_, structure, precision=precision, threads=threads, **build)
    run(filter_, progress)
    result = filter_.GetOutputDataObject(0)
    array = result.GetPointData().GetScalars()
    fields = result.GetFieldData()
    return Radiance(
        vtk_to_numpy(array).reshape(-1, rings * sectors),
        array.GetName(),
        array.GetName().partition("[")[2][:-1],
        result,
        vtk_to_numpy(fields.GetArray("RadianceDirections")),
        vtk_to_numpy(fields.GetArray("RadianceSolidAngles [sr]")),
    )


def _filter(
    lights: vtkDataObject | Sequence[vtkDataObject],
    occluders: Mesh | None,
    reflectance: float | None,
    tolerance: float,
    maximum_rays: int,
    length_unit: LengthUnit | str,
) -> vtkLumiRadiance:
    filter_ = vtkLumiRadiance()
    for light in [lights] if isinstance(lights, vtkDataObject) else lights:
        if not isinstance(light, (vtkPolyData, vtkCompositeDataSet)):
            raise ValueError(
                f"lights must be data sets, such as of area_light, not {type(light).__name__}"
            )
        filter_.AddLightsData(light)
    if occluders is not None:
        filter_.SetOccludersData(as_surface(occluders, "occluders"))
    if reflectance is not None:
        filter_.ReflectionOn()
        filter_.SetReflectance(number_in_range(reflectance, 0.0, 1.0, "reflectance"))
    filter_.SetRelativeTolerance(number_in_range(tolerance, 0.0, 1.0, "tolerance"))
    filter_.SetMaximumRays(in_range(maximum_rays, 64, 16777216, "maximum_rays"))
    filter_.SetLengthUnit(choose_length_unit(length_unit))
    return filter_
