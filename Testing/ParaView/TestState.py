# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""A saved state, as XML and as Python, gives the same numbers when it is loaded again."""

import numpy as np
from paraview import smstate
from paraview.simple import *

from pvtesting import IRRADIANCE, cell_array, fetch, load_plugin, point_array

load_plugin()
from paraview.simple import *  # the plugin's proxies


def numbers():
    structure, cast, irradiance = FindSource("Nodes"), FindSource("Cast"), FindSource("Light on it")
    return [
        cell_array(fetch(structure).GetBlock(2), "SurfaceAreaCost").copy(),
        point_array(fetch(cast), "T").copy(),
        point_array(fetch(cast, 1), "PrimitivesTested").copy(),
        cell_array(fetch(irradiance), IRRADIANCE).copy(),
    ]


scene = BuiltinScene(registrationName="Scene", Scene="Teapot", Resolution=4)
camera = CameraRaysofScene(registrationName="Camera", Input=scene, Resolution=[32, 24], Position=[0, -5, 2])
AccelerationStructure(registrationName="Nodes", Input=scene, Structure="BVH", LeafSize=8, BvhBuild="Longest Axis, Median")
RayCast(registrationName="Cast", Input=scene, Rays=camera, CountTraversal=1, TMin=0.5)
lights = [PointLight(Position=[5, 0, 9], Flux=100), DirectionalLight(Direction=[1, 2, -3], NormalIrradiance=0.5)]
screen = Plane(Origin=[-9, -9, 7], Point1=[9, -9, 7], Point2=[-9, 0, 7])
occluders = GroupDatasets(Input=[scene, screen])
Irradiance(
    registrationName="Light on it", Input=scene, Occluders=occluders, Lights=lights, LengthUnit="Centimetre"
)
Show(FindSource("Light on it"))
expected = numbers()
assert all(np.isfinite(array).all() and array.size and array.max() > 0 for array in expected)

SaveState("TestState.pvsm")
script = smstate.get_state()
for load in (lambda: LoadState("TestState.pvsm"), lambda: exec(script, {})):
    ResetSession()
    assert FindSource("Cast") is None
    load()
    for before, after in zip(expected, numbers()):
        assert np.array_equal(before, after)
