# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lights, which are data sets: they can be saved, edited and drawn, and `irradiance` takes them."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import datetime, timezone
from os import PathLike, fspath

import numpy as np
from numpy.typing import ArrayLike
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkPolyData

from .arrays import floats, to_vtk, vector
from .choices import LightSystem, choose
from .errors import run
from .surfaces import as_surface
from .vtk import (
    vtkLumiAreaLight,
    vtkLumiDirectionalLight,
    vtkLumiLight,
    vtkLumiPhotometricLight,
    vtkLumiPointLight,
    vtkLumiShapeLight,
    vtkLumiSky,
    vtkLumiSpotLight,
    vtkLumiSun,
)

#: What a lamp of area is given by, as the classes number it.
_EMISSIONS = {"radiance": 0, "exitance": 1, "flux": 2}
_SKIES = {"uniform": 0, "overcast": 1}


def point_light(
    position: ArrayLike,
    flux: float,
    *,
    system: LightSystem | str = "radiometric",
    name: str | None = None,
) -> vtkPolyData:
    """A small lamp that shines alike in all directions: intensity = flux / 4 pi.

    position : three coordinates, in the unit of the mesh.
    flux : all that it emits, at least 0; in W, or in lm with ``system="photometric"``.
    name : of its array when lights are kept apart; by default ``"point"``.

    Raises ValueError for a wrong shape or name, LumitreeError for a flux that is negative or not
    finite.
    """
    source = vtkLumiPointLight()
    source.SetPosition(*vector(position, "position"))
    source.SetFlux(float(flux))
    return _made(source, system, name)


def directional_light(
    direction: ArrayLike,
    normal_irradiance: float,
    *,
    angular_diameter: float = 0.0,
    system: LightSystem | str = "radiometric",
    name: str | None = None,
) -> vtkPolyData:
    """Parallel light from infinitely far, such as the sun's.

    direction : in which the light travels; any length but 0.
    normal_irradiance : on a plane that faces the light, at least 0; in W/m^2, or in lx with
        ``system="photometric"``.
    angular_diameter : of its disk, in degrees; 0.533 is the sun's, 0 has no penumbras.
    name : of its array when lights are kept apart; by default ``"directional"``.

    Raises ValueError for a wrong shape or name, LumitreeError for a value that makes no light.
    """
    source = vtkLumiDirectionalLight()
    source.SetDirection(*vector(direction, "direction"))
    source.SetNormalIrradiance(float(normal_irradiance))
    source.SetAngularDiameter(float(angular_diameter))
    return _made(source, system, name)


def spot_light(
    position: ArrayLike,
    direction: ArrayLike,
    flux: float | None = None,
    *,
    intensity: float | None = None,
    cone: float = 20.0,
    cutoff: float = 30.0,
    exponent: float | None = None,
    system: LightSystem | str = "radiometric",
    name: str | None = None,
) -> vtkPolyData:
    """A small lamp that shines into one direction.

    position : three coordinates, in the unit of the mesh.
    direction : where it shines to; any length but 0.
    flux, intensity : one of them: all that it emits, in W or lm, or its intensity on the axis, in
        W/sr or cd.
    cone, cutoff : angles from the axis, in degrees, where a smooth spot begins to fade and ends.
    exponent : of a cosine lobe, which it is instead when this is given; 1 is a small Lambertian
        surface.
    name : of its array when lights are kept apart; by default ``"spot"`` or ``"lobe"``.

    Raises ValueError for a wrong shape or name or not just one of flux and intensity, LumitreeError
    for values that make no light.
    """
    if (flux is None) == (intensity is None):
        raise ValueError("one of flux and intensity is needed")
    source = vtkLumiSpotLight()
    source.SetPosition(*vector(position, "position"))
    source.SetDirection(*vector(direction, "direction"))
    if exponent is None:
        source.SetConeAngle(float(cone))
        source.SetCutoffAngle(float(cutoff))
    else:
        source.SetFalloff(vtkLumiSpotLight.CosineLobe)
        source.SetExponent(float(exponent))
    source.SetEmissionKind(int(flux is None))
    source.SetEmission(float(intensity if flux is None else flux))
    return _made(source, system, name)


def sphere_light(center: ArrayLike, radius: float, **emission) -> vtkPolyData:
    """A Lambertian sphere. emission : as of `area_light`."""
    source = _shape(vtkLumiShapeLight.Sphere, center)
    source.SetRadius(float(radius))
    return _emitting(source, **emission)


def disk_light(
    center: ArrayLike,
    normal: ArrayLike,
    radius: float,
    *,
    two_sided: bool = False,
    **emission,
) -> vtkPolyData:
    """A Lambertian disk; normal : the side that shines. emission : as of `area_light`."""
    source = _shape(vtkLumiShapeLight.Disk, center)
    source.SetNormal(*vector(normal, "normal"))
    source.SetRadius(float(radius))
    source.SetTwoSided(bool(two_sided))
    return _emitting(source, **emission)


def rectangle_light(
    origin: ArrayLike,
    point1: ArrayLike,
    point2: ArrayLike,
    *,
    two_sided: bool = False,
    **emission,
) -> vtkPolyData:
    """A Lambertian parallelogram of three corners, the first between the others; it shines to the
    side of (point1 - origin) x (point2 - origin). emission : as of `area_light`."""
    source = _shape(vtkLumiShapeLight.Rectangle, origin)
    source.SetPoint1(*vector(point1, "point1"))
    source.SetPoint2(*vector(point2, "point2"))
    source.SetTwoSided(bool(two_sided))
    return _emitting(source, **emission)


def tube_light(begin: ArrayLike, end: ArrayLike, radius: float, **emission) -> vtkPolyData:
    """The outside of a Lambertian cylinder, without its ends. emission : as of `area_light`."""
    source = _shape(vtkLumiShapeLight.Tube, begin)
    source.SetPoint1(*vector(end, "end"))
    source.SetRadius(float(radius))
    return _emitting(source, **emission)


def line_light(
    begin: ArrayLike,
    end: ArrayLike,
    flux: float | None = None,
    *,
    intensity_per_metre: float | None = None,
    isotropic: bool = False,
    system: LightSystem | str = "radiometric",
    name: str | None = None,
) -> vtkPolyData:
    """A straight line that shines, as a thin tube or into all directions alike.

    flux, intensity_per_metre : one of them, in W or lm, or in W/(sr m) or cd/m across the line.
    """
    if (flux is None) == (intensity_per_metre is None):
        raise ValueError("one of flux and intensity_per_metre is needed")
    source = _shape(vtkLumiShapeLight.Line, begin)
    source.SetPoint1(*vector(end, "end"))
    source.SetLineDistribution(int(isotropic))
    source.SetEmissionQuantity(_EMISSIONS["radiance" if flux is None else "flux"])
    source.SetEmission(float(intensity_per_metre if flux is None else flux))
    return _made(source, system, name)


def area_light(surface: object, *, two_sided: bool = False, **emission) -> vtkPolyData:
    """Polygons that shine by Lambert's law, to the side from which their corners turn left.

    surface : whatever `cast` takes as a surface, or any data set.
    two_sided : both sides shine.
    radiance, exitance, flux : one of them: W/(m^2 sr), W/m^2 or W of all polygons together, or
        cd/m^2, lm/m^2 or lm; a number, or the name of a cell array with one for each cell.
    system, name : as of `point_light`.

    Raises ValueError for a wrong name or not just one of the three, LumitreeError for values that
    make no light.
    """
    source = vtkLumiAreaLight()
    source.SetInputDataObject(surface if isinstance(surface, vtkDataSet) else as_surface(surface))
    source.SetTwoSided(bool(two_sided))
    return _emitting(source, **emission)


def sun_light(
    when: datetime,
    latitude: float,
    longitude: float,
    normal_irradiance: float = 1000.0,
    *,
    angular_diameter: float = 0.533,
    north: ArrayLike = (0, 1, 0),
    up: ArrayLike = (0, 0, 1),
    system: LightSystem | str = "radiometric",
    name: str | None = None,
) -> vtkPolyData:
    """The sun at a moment and a place; its field data say where it is (``SunZenith [deg]``,
    ``SunAzimuth [deg]`` from north over east). Below the horizon it gives nothing.

    when : with its time zone; without one it is universal time.
    latitude, longitude : degrees, north and east positive.
    normal_irradiance : on a plane that faces it while it is up, in W/m^2 or lx.
    angular_diameter : degrees; 0: no penumbras.
    """
    moment = when.astimezone(timezone.utc) if when.tzinfo else when
    source = vtkLumiSun()
    source.SetDate(moment.year, moment.month, moment.day)
    seconds = moment.second + moment.microsecond * 1e-6
    source.SetHour(moment.hour + moment.minute / 60 + seconds / 3600)
    source.SetLatitude(float(latitude))
    source.SetLongitude(float(longitude))
    source.SetNormalIrradiance(float(normal_irradiance))
    source.SetAngularDiameter(float(angular_diameter))
    source.SetNorth(*vector(north, "north"))
    source.SetUp(*vector(up, "up"))
    return _made(source, system, name)


def sky_light(
    model: str | int = "uniform",
    *,
    zenith_radiance: float | None = None,
    horizontal_irradiance: float | None = None,
    direct_normal: float | None = None,
    sun_zenith: float = 45.0,
    sun_azimuth: float = 180.0,
    sun: vtkPolyData | None = None,
    ground_radiance: float = 0.0,
    north: ArrayLike = (0, 1, 0),
    up: ArrayLike = (0, 0, 1),
    system: LightSystem | str = "radiometric",
    name: str | None = None,
) -> vtkPolyData:
    """Light of the sky without the sun.

    model : ``"uniform"``, ``"overcast"`` (Moon and Spencer), a type of the CIE general skies from 1
        to 15, or ``"all_weather"`` (Perez), which is made of direct_normal and
        horizontal_irradiance (diffuse), both in W/m^2.
    zenith_radiance, horizontal_irradiance : one of them; W/(m^2 sr) or cd/m^2, W/m^2 or lx.
    sun_zenith, sun_azimuth : degrees from the zenith, and from north over east.
    sun : of `sun_light`, in place of these; the sky is dark while it is below the horizon.
    ground_radiance : of everything below the horizon.

    Raises ValueError for a model that is none or a level that does not fit it, LumitreeError for
    values that make no light.
    """
    source = vtkLumiSky()
    if model == "all_weather":
        if direct_normal is None or horizontal_irradiance is None or zenith_radiance is not None:
            raise ValueError("all_weather needs direct_normal and horizontal_irradiance")
        source.SetModel(vtkLumiSky.AllWeather)
        source.SetDirectNormal(float(direct_normal))
        source.SetDiffuseHorizontal(float(horizontal_irradiance))
    else:
        if (zenith_radiance is None) == (horizontal_irradiance is None):
            raise ValueError("one of zenith_radiance and horizontal_irradiance is needed")
        if isinstance(model, str) and model in _SKIES:
            source.SetModel(_SKIES[model])
        elif not isinstance(model, (str, bool)) and model in range(1, 16):
            source.SetModel(vtkLumiSky.CieGeneral)
            source.SetCieType(int(model))
        else:
            raise ValueError(
                f"model is {model!r}, but must be 'uniform', 'overcast', 'all_weather' or 1 to 15"
            )
        source.SetLevelQuantity(int(zenith_radiance is None))
        level = horizontal_irradiance if zenith_radiance is None else zenith_radiance
        source.SetLevel(float(level))
    source.SetSunZenith(float(sun_zenith))
    source.SetSunAzimuth(float(sun_azimuth))
    if sun is not None:
        if not isinstance(sun, vtkPolyData):
            raise ValueError(f"sun must be of sun_light, not {type(sun).__name__}")
        source.SetInputData(sun)
    source.SetGroundRadiance(float(ground_radiance))
    source.SetNorth(*vector(north, "north"))
    source.SetUp(*vector(up, "up"))
    return _made(source, system, name)


def photometric_light(
    path: str | PathLike[str],
    position: ArrayLike,
    direction: ArrayLike = (0, 0, -1),
    reference: ArrayLike = (1, 0, 0),
    *,
    scale: float = 1.0,
    tilt: float = 0.0,
    name: str | None = None,
) -> vtkPolyData:
    """A luminaire of an IES LM-63 or EULUMDAT file; photometric.

    position : three coordinates, in the unit of the mesh.
    direction, reference : where its axis and its plane C 0 point to.
    scale : factor on all intensities.
    tilt : of the lamp, in degrees, for files with a table of it.

    Its field data have ``LuminousFlux [lm]``, of the interpolant, and ``StatedLuminousFlux [lm]``,
    what the file says. Raises LumitreeError, with line and reason, for a file that is malformed.
    """
    source = vtkLumiPhotometricLight()
    source.SetFileName(fspath(path))
    source.SetPosition(*vector(position, "position"))
    source.SetDirection(*vector(direction, "direction"))
    source.SetReference(*vector(reference, "reference"))
    source.SetScale(float(scale))
    source.SetTilt(float(tilt))
    return _made(source, LightSystem.PHOTOMETRIC, name)


def convertible(light: vtkPolyData, efficacy: float) -> vtkPolyData:
    """A copy of a light that may stand beside lights of the other system: converted by that
    luminous efficacy, in lm/W, above 0 and at most 683.
    """
    if not 0 < efficacy <= 683:
        raise ValueError(f"efficacy is {efficacy}, but must be above 0 and at most 683 lm/W")
    copy = light.NewInstance()
    copy.DeepCopy(light)
    copy.GetFieldData().AddArray(to_vtk(np.array([float(efficacy)]), "LuminousEfficacy [lm/W]"))
    return copy


def luminous_efficacy(nanometres: Sequence[float], values: Sequence[float]) -> float:
    """Luminous efficacy of a spectrum, in lm/W: 683 times its share weighed by V(lambda), CIE 1924.

    nanometres : growing wavelengths. values : any radiant quantity per wavelength, at least 0,
    linear in between. Raises ValueError for what is no spectrum.
    """
    spectrum = np.column_stack([floats(nanometres, "nanometres"), floats(values, "values")])
    result = vtkLumiLight.LuminousEfficacyOfSpectrum(to_vtk(np.ascontiguousarray(spectrum)))
    if np.isnan(result):
        raise ValueError("wavelengths must grow, and values be at least 0 and not all of them 0")
    return result


def _shape(shape: int, origin: ArrayLike) -> vtkLumiShapeLight:
    source = vtkLumiShapeLight()
    source.SetShape(shape)
    source.SetOrigin(*vector(origin, "origin"))
    return source


def _emitting(
    source: vtkLumiAreaLight | vtkLumiShapeLight,
    *,
    radiance: float | str | None = None,
    exitance: float | str | None = None,
    flux: float | str | None = None,
    system: LightSystem | str = "radiometric",
    name: str | None = None,
) -> vtkPolyData:
    given = {"radiance": radiance, "exitance": exitance, "flux": flux}
    given = {quantity: value for quantity, value in given.items() if value is not None}
    if len(given) != 1:
        raise ValueError("one of radiance, exitance and flux is needed")
    ((quantity, value),) = given.items()
    source.SetEmissionQuantity(_EMISSIONS[quantity])
    if isinstance(value, str):
        if not isinstance(source, vtkLumiAreaLight):
            raise ValueError(f"{quantity} must be a number")
        source.SetEmissionArray(value)
    else:
        source.SetEmission(float(value))
    return _made(source, system, name)


def _made(source: vtkLumiLight, system: LightSystem | str, name: str | None) -> vtkPolyData:
    source.SetSystem(choose(LightSystem, system, "system"))
    if name is not None:
        source.SetName(name)
    run(source)
    return source.GetOutput()
