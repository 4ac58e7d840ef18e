# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the ParaView tests share: loading the plugin that was built, and arrays of proxies as numpy arrays."""

import os

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

PLUGIN = os.path.join(os.environ["LUMITREE_PLUGIN_DIR"], "Lumitree", "Lumitree.so")
PROXIES = {
    "sources": [
        "LumiScene",
        "LumiCameraRays",
        "LumiImplicitSurface",
        "LumiRays",
        "LumiSensorGrid",
        "LumiPointLight",
        "LumiDirectionalLight",
        "LumiSpotLight",
        "LumiShapeLight",
        "LumiSun",
        "LumiSky",
        "LumiPhotometricLight",
    ],
    "filters": [
        "LumiAccelerationStructure",
        "LumiAccuracyChart",
        "LumiAreaLight",
        "LumiCameraRaysOfScene",
        "LumiImplicitSurfaceAtPoints",
        "LumiIrradiance",
        "LumiRadiance",
        "LumiRadiantIntensity",
        "LumiRayCast",
        "LumiRayDisagreement",
        "LumiStructureComparison",
        "LumiSkyOfSun",
        "LumiSolidAngle",
        "LumiSurfaceRays",
        "LumiSurfaceReport",
    ],
}
IRRADIANCE = "Irradiance [W/m^2]"


def load_plugin(remote=False):
    """Loads the plugin of the build tree, unless ParaView did; fails if its proxies are not known afterwards."""
    if remote or not _known("sources", "LumiScene"):
        simple.LoadPlugin(PLUGIN, remote=remote, ns=simple.__dict__)
    for group, names in PROXIES.items():
        for name in names:
            assert _known(group, name), f"no proxy ({group}, {name})"


def _known(group, name):
    return servermanager.ProxyManager().SMProxyManager.HasDefinition(group, name)


def fetch(proxy, port=0):
    """The data of an output port, from all ranks, on this process."""
    proxy.UpdatePipeline()
    return servermanager.Fetch(proxy, idx=port)


def point_array(data, name):
    """A point array as numpy array."""
    return _array(data.GetPointData(), name)


def cell_array(data, name):
    """A cell array as numpy array."""
    return _array(data.GetCellData(), name)


def _array(attributes, name):
    names = [attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays())]
    assert name in names, f"no array {name!r} among {names}"
    return vtk_to_numpy(attributes.GetArray(name))
