# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the pictures of the examples about light, from the variables that they leave. Needs a screen
(xvfb-run).

xvfb-run -a python3 Docs/make_example_pictures.py
"""

from __future__ import annotations

import os
import runpy
import tempfile
from datetime import datetime, timezone
from pathlib import Path

import lumitree
from lumitree.camera import View
from lumitree.pictures import surface_picture
from lumitree.stages import stage_of

HERE = Path(__file__).resolve().parent


def picture_of(name: str) -> Path:
    return HERE / "images" / f"example-{name}.png"


def variables_of(name: str) -> dict[str, object]:
    """Runs an example in a directory that is thrown away."""
    before = Path.cwd()
    with tempfile.TemporaryDirectory() as directory:
        os.chdir(directory)
        try:
            return runpy.run_path(str(HERE.parent / "Examples" / f"{name}.py"))
        finally:
            os.chdir(before)


def office() -> None:
    light = variables_of("office_luminaires")["light"]
    above = View((3, 2.4, 9.5), (3, 2.4, 0.75), (0, 1, 0), 40.0)
    surface_picture(picture_of("office"), light.dataset, light.name, "Illuminance\n[lx]", above)


def street() -> None:
    """The street's floor, 1 m wide and 1 m of its length."""
    names = variables_of("daylight_and_area_light")
    floor = lumitree.sensor_grid((-0.3, 0, 0), (0.7, 0, 0), (-0.3, 1, 0), spacing=0.02)
    light = lumitree.irradiance(floor, names["sky"].GetOutput(), names["canyon"])
    above = View((0.2, 0.5, 2), (0.2, 0.5, 0), (0, 1, 0), 35.0)
    surface_picture(picture_of("street"), light.dataset, light.name, "Irradiance\n[W/m^2]", above)


def panels() -> None:
    """The rows on a December morning."""
    names = variables_of("solar_panel_rows")
    when = datetime(2024, 12, 21, 9, 30, tzinfo=timezone.utc)
    sun = lumitree.sun_light(when, 47.0, 8.0, 800.0, angular_diameter=0.0)
    light = lumitree.irradiance(names["both"], [names["sky"].GetOutput(), sun])
    view = View((-20, -26, 17), (0, 2, 0.5), (0, 0, 1), 30.0)
    surface_picture(picture_of("panels"), light.dataset, light.name, "Irradiance\n[W/m^2]", view)


def room() -> None:
    light = variables_of("irradiance_of_a_room")["light"]
    view = stage_of("cornell_box").view
    surface_picture(picture_of("room"), light.dataset, light.name, "Irradiance\n[W/m^2]", view)


def shadow() -> None:
    light = variables_of("shadow_outlines")["light"]
    above = View((0, 0, 4), (0, 0, 0), (0, 1, 0), 30.0)
    surface_picture(picture_of("shadow"), light.dataset, light.name, "Irradiance\n[W/m^2]", above)


if __name__ == "__main__":
    for make in (office, street, panels, room, shadow):
        make()
