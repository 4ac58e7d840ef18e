# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""How to look at a surface, and how to light it, when nothing else is said."""

from __future__ import annotations

from dataclasses import dataclass

from numpy.typing import ArrayLike

from .camera import View, view_of
from .choices import Scene, choose

#: By the axis that points up: up, the side that a surface is seen from, and where sunlight goes.
DIRECTIONS = {
    "y": ((0.0, 1.0, 0.0), (0.5, 0.5, 1.0), (0.4, -1.0, -0.6)),
    "z": ((0.0, 0.0, 1.0), (0.5, -1.0, 0.5), (0.4, 0.6, -1.0)),
}


@dataclass(frozen=True)
class Stage:
    """Resolution, view and light (as on the command line) of a scene. None: as in the open."""

    resolution: int = 10
    view: View | None = None
    light: str | None = None


STAGES = {
    Scene.CORNELL_BOX: Stage(
        resolution=80,
        view=View(eye=(0.5, -1.6, 0.5), target=(0.5, 0.5, 0.5), angle=34.4, near=1.61),
        light="point:0.55,0.25,0.65:100W",
    ),
    Scene.TEAPOT: Stage(resolution=24),
    Scene.CITY: Stage(resolution=8),
    Scene.TEAPOT_IN_STADIUM: Stage(
        resolution=24,
        view=View(eye=(0.35, -0.7, 0.4), target=(0.0, 0.0, 0.08)),
        light="point:-10,-20,20:2e6W",
    ),
    Scene.RANDOM_CLOUD: Stage(resolution=30),
    Scene.SPHERE: Stage(resolution=32),
    Scene.TORUS: Stage(resolution=32),
    Scene.TERRAIN: Stage(resolution=256, light="sun:0.8,0.4,-0.35:1000W/m2"),
}


def stage_of(name: str) -> Stage:
    """The stage of a built-in scene. Raises ValueError for a name that is none."""
    return STAGES[choose(Scene, name, "scene")]


def in_the_open(bounds: ArrayLike, up: str = "z", aspect: float = 4 / 3) -> tuple[View, str]:
    """A view of all that is in the bounds, and a sun.

    up : the axis that points up, ``"y"`` or ``"z"``.
    aspect : width of the picture by its height.
    """
    upwards, side, sunwards = DIRECTIONS[up]
    light = f"sun:{','.join(str(x) for x in sunwards)}:1000W/m2"
    return view_of(bounds, side, up=upwards, aspect=aspect), light
