# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The choices a caller makes by name.

The values are those of the data model and of the wrapped classes; the names are theirs in snake
case (``"wide_bvh"``). Every function that takes a choice accepts the name or the member.
"""

from __future__ import annotations

from enum import IntEnum
from typing import TypeVar


class Structure(IntEnum):
    """How a surface is organised for rays."""

    AUTO = 0
    BRUTE_FORCE = 1
    BVH = 2
    WIDE_BVH = 3
    GRID = 4
    OCTREE = 5
    KD_TREE = 6
    BSP_TREE = 7
    EMBREE = 8
    CGAL = 9
    CGAL_EPICK = 10
    CGAL_CARTESIAN = 11


class Precision(IntEnum):
    """What is promised about the primitives hit and their order."""

    FAST = 0
    WATERTIGHT = 1
    EXACT = 2
    AUTOMATIC = 3


class BvhBuild(IntEnum):
    """How a bounding volume hierarchy is split."""

    LONGEST_AXIS_MEDIAN = 0
    BINNED_SAH = 1
    SWEEP_SAH = 2
    SPATIAL_SPLITS = 3
    MORTON = 4


class KdBuild(IntEnum):
    """How a KD-tree is split."""

    SPATIAL_MEDIAN = 0
    SAH = 1


class StructureFileUse(IntEnum):
    """What is done with a file that keeps a structure."""

    LOAD_OR_BUILD = 0
    LOAD = 1
    SAVE = 2


class Query(IntEnum):
    """The question asked of each ray."""

    CLOSEST = 0
    ANY = 1
    ALL = 2
    COUNT = 3
    CROSSINGS = 4
    TIES = 5


class Sweep(IntEnum):
    """What changes from row to row of a comparison."""

    ALL_STRUCTURES = 0
    GRID_CELLS = 1
    LEAF_SIZES = 2


class LengthUnit(IntEnum):
    """What one unit of the coordinates is."""

    METRE = 0
    MILLIMETRE = 1
    CENTIMETRE = 2
    KILOMETRE = 3
    INCH = 4
    FOOT = 5


class ReceiverLocation(IntEnum):
    """Where irradiance is computed."""

    POINTS = 0
    CELLS = 1


class LightSystem(IntEnum):
    """Watts, or lumens."""

    RADIOMETRIC = 0
    PHOTOMETRIC = 1


class Shape(IntEnum):
    """A body of second degree."""

    SPHERE = 0
    ELLIPSOID = 1
    CYLINDER = 2
    CONE = 3
    PARABOLOID = 4
    DISC = 5
    PLANE = 6
    BOX = 7
    QUADRIC = 8
    FUNCTION = 9


class Scene(IntEnum):
    """A built-in scene."""

    CORNELL_BOX = 0
    TEAPOT = 1
    CITY = 2
    TEAPOT_IN_STADIUM = 3
    RANDOM_CLOUD = 4
    SPHERE = 5
    TORUS = 6
    TERRAIN = 7


#: The usual symbols of the length units.
LENGTH_SYMBOLS = {
    "m": LengthUnit.METRE,
    "mm": LengthUnit.MILLIMETRE,
    "cm": LengthUnit.CENTIMETRE,
    "km": LengthUnit.KILOMETRE,
    "in": LengthUnit.INCH,
    "ft": LengthUnit.FOOT,
}

Choice = TypeVar("Choice", bound=IntEnum)


def names(kind: type[Choice]) -> list[str]:
    """The names of a choice, in the order of their values."""
    return [member.name.lower() for member in kind]


def choose(kind: type[Choice], value: Choice | str, argument: str) -> Choice:
    """The member that `value` names. Raises ValueError, with the names there are, for any other."""
    if isinstance(value, kind):
        return value
    if isinstance(value, str):
        for member in kind:
            if member.name.lower() == value:
                return member
    raise ValueError(f"{argument} is {value!r}; choose one of: {', '.join(names(kind))}")


def choose_length_unit(value: LengthUnit | str) -> LengthUnit:
    """As `choose`, and a unit may be named by its symbol (``"mm"``)."""
    if isinstance(value, str) and value in LENGTH_SYMBOLS:
        return LENGTH_SYMBOLS[value]
    if not isinstance(value, (LengthUnit, str)) or value not in (*names(LengthUnit), *LengthUnit):
        known = [f"{symbol} ({unit.name.lower()})" for symbol, unit in LENGTH_SYMBOLS.items()]
        raise ValueError(f"length_unit is {value!r}; choose one of: {', '.join(known)}")
    return choose(LengthUnit, value, "length_unit")
