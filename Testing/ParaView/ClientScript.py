# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs inside the ParaView client: every proxy gets a properties panel, and Apply shows what it should."""

import os
import sys
import traceback

sys.path.insert(0, os.path.join(os.environ["LUMITREE_SOURCE_DIR"], "Testing", "ParaView"))


def run():
    from paraview import simple

    from pvtesting import IRRADIANCE, load_plugin

    load_plugin()
    view = simple.GetActiveViewOrCreate("RenderView")

    def show(proxy):
        """Makes the proxy the active one, which builds its panel, and shows it."""
        simple.SetActiveSource(proxy)
        display = simple.Show(proxy, view)
        simple.Render(view)
        return display.Representation, list(display.ColorArrayName)

    scene = simple.BuiltinScene(Scene="Teapot", Resolution=4)
    lamp, sun = simple.PointLight(Position=[4, -4, 6], Flux=500), simple.DirectionalLight()
    rays = simple.CameraRaysofScene(Input=scene, Resolution=[40, 30])
    shown = [show(proxy) for proxy in (scene, lamp, sun, rays, simple.CameraRays(), simple.SurfaceRays(Input=scene))]
    for mode in ("Parallel Grid", "Sphere Around Point", "Random"):
        shown.append(show(simple.Rays(Mode=mode)))
    assert show(simple.AccelerationStructure(Input=scene)) == ("Wireframe", ["CELLS", "SurfaceAreaCost"])
    assert show(simple.RayCast(Input=scene, Rays=rays)) == ("Surface", ["POINTS", "T"])
    assert show(simple.Irradiance(Input=scene, Lights=[lamp, sun])) == ("Surface", ["CELLS", IRRADIANCE])


try:
    run()
    message, status = "client script: passed\n", 0
except BaseException:
    message, status = traceback.format_exc(), 1
# The client shows sys.stdout in a window of its own; and a script cannot ask it to quit.
os.write(1, message.encode())
os._exit(status)
