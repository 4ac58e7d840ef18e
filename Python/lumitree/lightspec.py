# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lights as they are written on a command line: ``point:0,0,2:1000``, ``sun:0,0,-1:800W/m2``."""

from __future__ import annotations

import re
from collections.abc import Callable

from vtkmodules.vtkCommonDataModel import vtkPolyData

from .lights import (
    area_light,
    directional_light,
    photometric_light,
    point_light,
    rectangle_light,
    sky_light,
    sphere_light,
    spot_light,
    tube_light,
)

_FLUX = {"W": "radiometric", "lm": "photometric"}
_IRRADIANCE = {"W/m2": "radiometric", "W/m^2": "radiometric", "lx": "photometric"}
_RADIANCE = {"W/m2sr": "radiometric", "W/(m^2 sr)": "radiometric", "cd/m2": "photometric"}

#: How each kind is written; in brackets what may be left out.
FORMS = {
    "point": "point:x,y,z:FLUX",
    "spot": "spot:x,y,z:dx,dy,dz:FLUX[:cone,cutoff]",
    "sun": "sun:dx,dy,dz:IRRADIANCE[:diameter]",
    "sphere": "sphere:x,y,z:radius:RADIANCE",
    "rectangle": "rectangle:x,y,z:x,y,z:x,y,z:RADIANCE",
    "tube": "tube:x,y,z:x,y,z:radius:RADIANCE",
    "mesh": "mesh:FILE:RADIANCE",
    "sky": "sky:uniform|overcast|1...15:IRRADIANCE",
    "ies": "ies:FILE:x,y,z[:dx,dy,dz]",
}

_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")


def numbers(text: str, count: int, example: str) -> tuple[float, ...]:
    """So many numbers between commas. Raises ValueError for anything else."""
    parts = text.split(",")
    if len(parts) != count or not all(_NUMBER.fullmatch(part.strip()) for part in parts):
        raise ValueError(f"{text!r} is not {count} numbers as in {example}")
    return tuple(float(part) for part in parts)


def triple(text: str) -> tuple[float, float, float]:
    """Three numbers between commas. Raises ValueError for anything else."""
    parts = text.split(",")
    if len(parts) != 3 or not all(_NUMBER.fullmatch(part.strip()) for part in parts):
        raise ValueError(f"{text!r} is not three numbers as in 0,0,2")
    return tuple(float(part) for part in parts)


def parse_light(text: str) -> vtkPolyData:
    """The light that a line of `FORMS` means. An amount is a number with or without one of its
    units: W or lm; W/m2 or lx; W/m2sr or cd/m2. Without a unit the first is meant. Raises
    ValueError, naming what is wrong.
    """
    kind, *parts = text.split(":")
    make = _MAKERS.get(kind)
    wanted = {} if make is None else _fields(FORMS[kind])
    if make is None or len(parts) not in wanted:
        forms = FORMS.values() if make is None else [FORMS[kind]]
        raise ValueError(f"light {text!r} is not written as {' or '.join(forms)}")
    return make(text, parts)


def _fields(form: str) -> set[int]:
    full = form.replace("[", "").count(":")
    return {full, full - form.count("[")}


def _amount(text: str, amount: str, units: dict[str, str]) -> tuple[float, str]:
    """A number, and the system of the unit behind it."""
    number = _NUMBER.match(amount)
    unit = amount[number.end() :] if number else ""
    system = units.get(unit) if unit else "radiometric"
    if not number or system is None:
        raise ValueError(
            f"light {text!r}: {amount!r} is not a number with or without a unit ({', '.join(units)})"
        )
    return float(number.group()), system


def _point(text: str, parts: list[str]) -> vtkPolyData:
    flux, system = _amount(text, parts[1], _FLUX)
    return point_light(triple(parts[0]), flux, system=system)


def _spot(text: str, parts: list[str]) -> vtkPolyData:
    flux, system = _amount(text, parts[2], _FLUX)
    cone, cutoff = numbers(parts[3], 2, "20,30") if len(parts) > 3 else (20.0, 30.0)
    return spot_light(
        triple(parts[0]), triple(parts[1]), flux, cone=cone, cutoff=cutoff, system=system
    )


def _sun(text: str, parts: list[str]) -> vtkPolyData:
    irradiance, system = _amount(text, parts[1], _IRRADIANCE)
    diameter = numbers(parts[2], 1, "0.533")[0] if len(parts) > 2 else 0.0
    return directional_light(
        triple(parts[0]), irradiance, angular_diameter=diameter, system=system
    )


def _sphere(text: str, parts: list[str]) -> vtkPolyData:
    radiance, system = _amount(text, parts[2], _RADIANCE)
    radius = numbers(parts[1], 1, "0.5")[0]
    return sphere_light(triple(parts[0]), radius, radiance=radiance, system=system)


def _rectangle(text: str, parts: list[str]) -> vtkPolyData:
    radiance, system = _amount(text, parts[3], _RADIANCE)
    return rectangle_light(*map(triple, parts[:3]), radiance=radiance, system=system)


def _tube(text: str, parts: list[str]) -> vtkPolyData:
    radiance, system = _amount(text, parts[3], _RADIANCE)
    radius = numbers(parts[2], 1, "0.5")[0]
    return tube_light(triple(parts[0]), triple(parts[1]), radius, radiance=radiance, system=system)


def _mesh(text: str, parts: list[str]) -> vtkPolyData:
    radiance, system = _amount(text, parts[1], _RADIANCE)
    return area_light(parts[0], radiance=radiance, system=system)


def _sky(text: str, parts: list[str]) -> vtkPolyData:
    irradiance, system = _amount(text, parts[1], _IRRADIANCE)
    model = int(parts[0]) if parts[0].isdecimal() else parts[0]
    return sky_light(model, horizontal_irradiance=irradiance, system=system)


def _ies(_text: str, parts: list[str]) -> vtkPolyData:
    direction = triple(parts[2]) if len(parts) > 2 else (0.0, 0.0, -1.0)
    reference = (1.0, 0.0, 0.0) if direction[1] or direction[2] else (0.0, 1.0, 0.0)
    return photometric_light(parts[0], triple(parts[1]), direction, reference)


_MAKERS: dict[str, Callable[[str, list[str]], vtkPolyData]] = {
    "point": _point,
    "spot": _spot,
    "sun": _sun,
    "sphere": _sphere,
    "rectangle": _rectangle,
    "tube": _tube,
    "mesh": _mesh,
    "sky": _sky,
    "ies": _ies,
}
