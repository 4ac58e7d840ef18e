# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Light to a tolerance: an area light in a closed box, a room with penumbras, and a street canyon under an
overcast sky."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import lumitree
from lumitree.vtk import vtkLumiAreaLight, vtkLumiSky


def quads(*corners):
    """Triangles of quads, four corners each."""
    points = np.array(corners, dtype=float).reshape(-1, 3)
    first = 4 * np.arange(len(points) // 4)[:, None]
    return points, np.concatenate([first + [0, 1, 2], first + [0, 2, 3]])


def area_light(points, triangles, flux):
    """A Lambertian light on a mesh, of that flux in W."""
    source = vtkLumiAreaLight()
    source.SetInputDataObject(lumitree.surfaces.as_surface((points, triangles)))
    source.SetEmissionQuantity(vtkLumiAreaLight.Flux)
    source.SetEmission(flux)
    source.Update()
    return source.GetOutput()


def areas_of(mesh):
    corners = vtk_to_numpy(mesh.GetPoints().GetData())[
        vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 4)
    ]
    return np.linalg.norm(np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]), axis=1) / 2


# The Cornell box under its ceiling light, 0.3 m by 0.3 m, facing down.
lamp = area_light(
    *quads((0.35, 0.35, 0.99), (0.35, 0.65, 0.99), (0.65, 0.65, 0.99), (0.65, 0.35, 0.99)), flux=100.0
)
room = lumitree.scene("cornell_box", resolution=24)
light = lumitree.irradiance(room, lamp, quantities=["penumbra"])
received = float(light.values @ areas_of(room))
print(f"received in all: {received:.2f} W of 100 W, {int(light.rays.sum())} rays")
assert abs(received - 100.0) < 1.0
assert light.quantities["penumbra"].sum() > 100
assert np.all(light.lower <= light.values) and np.all(light.values <= light.upper)

# The floor of an endless street, 0.3 m from one wall of 1 m, 0.7 m from the other.
far = 2000.0
canyon = quads(
    (-0.3, -far, 0), (-0.3, far, 0), (-0.3, far, 1), (-0.3, -far, 1),
    (0.7, -far, 0), (0.7, far, 0), (0.7, far, 1), (0.7, -far, 1),
)  # fmt: skip
sky = vtkLumiSky()
sky.SetModel(vtkLumiSky.CieOvercast)
sky.SetLevelQuantity(vtkLumiSky.ZenithRadiance)
sky.SetLevel(1.0)
sky.Update()
sensor = lumitree.sensor_grid((-0.05, -0.05, 0), (0.05, -0.05, 0), (-0.05, 0.05, 0), spacing=1)
street = lumitree.irradiance(sensor, sky.GetOutput(), occluders=canyon)
sines = np.array([0.3, 0.7]) / np.hypot(1.0, [0.3, 0.7])
angles = np.arctan([0.3, 0.7])
expected = (
    np.pi / 2 * sines.sum() + 8 / 3 * (angles.sum() / 2 + np.sin(2 * angles).sum() / 4)
) / 3
factor = street.statistics["DaylightFactor [%]"]
print(f"street: {street.values[0]:.9f} of {expected:.9f} W/m^2, daylight factor {factor:.1f} %")
assert abs(street.values[0] - expected) < 1e-7
assert street.method[0] == lumitree.EstimateMethod.HORIZON
assert abs(factor - 100 * expected / (7 * np.pi / 9)) < 1e-5
