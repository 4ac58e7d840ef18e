# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""How to look at a built-in scene, and how to light it, when nothing else is said."""

from __future__ import annotations

from dataclasses import dataclass

from .camera import View
from .choices import Scene, choose


@dataclass(frozen=True)
class Stage:
    """Resolution, view and light of a scene."""

    resolution: int = 10
    view: View | None = None  #: None: all of it
    light: str = "sun:0.4,0.6,-1:1000W/m2"  #: as on the command line


STAGES = {
    Scene.CORNELL_BOX: Stage(
        resolution=40,
        view=View(eye=(0.5, -1.6, 0.5), target=(0.5, 0.5, 0.5), angle=36.0, near=1.61),
        light="point:0.5,0.5,0.9:100W",
    ),
    Scene.TEAPOT: Stage(resolution=24),
    Scene.CITY: Stage(resolution=8),
    Scene.TEAPOT_IN_STADIUM: Stage(
        resolution=24,
        view=View(eye=(0.35, -0.7, 0.4), target=(0.0, 0.0, 0.08)),
        light="point:10,-20,20:200000W",
    ),
    Scene.RANDOM_CLOUD: Stage(resolution=30),
    Scene.SPHERE: Stage(resolution=32),
    Scene.TORUS: Stage(resolution=32),
    Scene.TERRAIN: Stage(resolution=256, light="sun:0.8,0.4,-0.35:1000W/m2"),
}


def stage_of(name: str | None) -> Stage:
    """The stage of a built-in scene; of None, that of any other surface. Raises ValueError for
    other names."""
    return Stage() if name is None else STAGES[choose(Scene, name, "scene")]
