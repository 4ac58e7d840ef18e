# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a filter shows when nothing but its inputs is chosen: representation, colouring, what stays hidden."""

from paraview.simple import *

from pvtesting import IRRADIANCE, load_plugin

load_plugin()
from paraview.simple import *  # the plugin's proxies


def shown(proxy, port=0):
    """The representation and what colours it, as Apply would choose them."""
    display = Show(OutputPort(proxy, port), GetActiveViewOrCreate("RenderView"))
    return display.Representation, list(display.ColorArrayName)


def preferred_view(proxy, port):
    for view in proxy.SMProxy.GetHints().FindNestedElementByName("View"), None:
        if view is not None and view.GetAttribute("port") == str(port):
            return view.GetAttribute("type")
    return None


scene = BuiltinScene(Scene="Teapot", Resolution=4)
plain = shown(scene)
assert plain[0] == "Surface", plain

# The hierarchy is lines coloured by cost, not an opaque root box; with rays by their visits.
structure = AccelerationStructure(Input=scene)
assert shown(structure) == ("Wireframe", ["CELLS", "SurfaceAreaCost"]), shown(structure)
assert preferred_view(structure, 1) == "None"
structure = AccelerationStructure(Input=scene, Rays=Rays(NumberOfRays=10, Mode="Random"))
assert shown(structure) == ("Wireframe", ["CELLS", "Visits"]), shown(structure)

# Irradiance colours by itself, whatever coloured its input.
lamp = PointLight(Position=[0, 0, 10], Flux=1000)
assert shown(Irradiance(Input=scene, Lights=lamp)) == ("Surface", ["CELLS", IRRADIANCE])
for location, attribute in (("Cells", "CELLS"), ("Points", "POINTS")):
    elevation = Elevation(Input=scene)
    assert shown(elevation)[1] == ["POINTS", "Elevation"]
    representation = shown(Irradiance(Input=elevation, Lights=lamp, ReceiverLocation=location))
    assert representation == ("Surface", [attribute, IRRADIANCE]), representation

# Hits are a cloud of points coloured by T; the rays, an image without a place in the scene, stay hidden.
camera = CameraRaysofScene(Input=scene, Resolution=[40, 30])
cast = RayCast(Input=scene, Rays=camera)
assert shown(cast) == ("Surface", ["POINTS", "T"]), shown(cast)
assert preferred_view(cast, 1) == "None" and preferred_view(camera, 0) == "None"
assert preferred_view(CameraRays(), 0) == "None"

for light in (PointLight(), DirectionalLight(), Rays(), SurfaceRays(Input=scene)):
    assert shown(light)[0] == "Surface"
Render()
