# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lights as they are written on a command line: ``point:0,0,2:1000``, ``sun:0,0,-1:800W/m2``."""

from __future__ import annotations

import re

from vtkmodules.vtkCommonDataModel import vtkPolyData

from .lights import directional_light, point_light

#: Units, and the system of each; without a unit the first is meant.
UNITS = {
    "point": {"W": "radiometric", "lm": "photometric"},
    "sun": {"W/m2": "radiometric", "W/m^2": "radiometric", "lx": "photometric"},
}

_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")


def triple(text: str) -> tuple[float, float, float]:
    """Three numbers between commas. Raises ValueError for anything else."""
    parts = text.split(",")
    if len(parts) != 3 or not all(_NUMBER.fullmatch(part.strip()) for part in parts):
        raise ValueError(f"{text!r} is not three numbers as in 0,0,2")
    return tuple(float(part) for part in parts)


def parse_light(text: str) -> vtkPolyData:
    """The light that ``KIND:x,y,z:VALUE[UNIT]`` means: a ``point`` at a place with a flux in W or
    lm, or a ``sun`` that shines in a direction with a normal irradiance in W/m2 or lx. Raises
    ValueError, naming what is wrong.
    """
    parts = text.split(":")
    if len(parts) != 3 or parts[0] not in UNITS:
        raise ValueError(f"light {text!r} is neither point:x,y,z:flux nor sun:dx,dy,dz:irradiance")
    kind, place, amount = parts
    number = _NUMBER.match(amount)
    unit = amount[number.end() :] if number else ""
    system = UNITS[kind].get(unit) if unit else "radiometric"
    if not number or system is None:
        known = ", ".join(UNITS[kind])
        raise ValueError(
            f"light {text!r}: {amount!r} is not a number with or without a unit ({known})"
        )
    make = point_light if kind == "point" else directional_light
    return make(triple(place), float(number.group()), system=system)
