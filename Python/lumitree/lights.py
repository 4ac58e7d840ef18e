# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lights, which are data sets: they can be saved, edited and drawn, and `irradiance` takes them."""

from __future__ import annotations

from numpy.typing import ArrayLike
from vtkmodules.vtkCommonDataModel import vtkPolyData

from .arrays import vector
from .choices import LightSystem, choose
from .errors import run
from .vtk import vtkLumiDirectionalLight, vtkLumiPointLight


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
    system: LightSystem | str = "radiometric",
    name: str | None = None,
) -> vtkPolyData:
    """Parallel light from infinitely far, such as the sun's.

    direction : in which the light travels; any length but 0.
    normal_irradiance : on a plane that faces the light, at least 0; in W/m^2, or in lx with
        ``system="photometric"``.
    name : of its array when lights are kept apart; by default ``"directional"``.

    Raises ValueError for a wrong shape or name, LumitreeError for a value that makes no light.
    """
    source = vtkLumiDirectionalLight()
    source.SetDirection(*vector(direction, "direction"))
    source.SetNormalIrradiance(float(normal_irradiance))
    return _made(source, system, name)


def _made(
    source: vtkLumiPointLight | vtkLumiDirectionalLight, system: LightSystem | str, name: str | None
) -> vtkPolyData:
    source.SetSystem(choose(LightSystem, system, "system"))
    if name is not None:
        source.SetName(name)
    run(source)
    return source.GetOutput()
