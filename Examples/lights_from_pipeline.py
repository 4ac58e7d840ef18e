# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lights and surfaces in a VTK pipeline: the classes beneath the functions, like any other."""

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkPlaneSource

from lumitree.vtk import vtkLumiDirectionalLight, vtkLumiIrradiance, vtkLumiPointLight

floor = vtkPlaneSource()  # 1 m x 1 m in the plane z = 0, facing up
floor.SetResolution(10, 10)

lamp = vtkLumiPointLight()
lamp.SetName("lamp")
lamp.SetPosition(0, 0, 2)
lamp.SetFlux(1000.0)  # W

sun = vtkLumiDirectionalLight()
sun.SetName("sun")
sun.SetDirection(0, 0, -1)
sun.SetNormalIrradiance(800.0)  # W/m^2

light = vtkLumiIrradiance()
light.SetInputConnection(floor.GetOutputPort())
light.AddLightsConnection(lamp.GetOutputPort())
light.AddLightsConnection(sun.GetOutputPort())
light.SetReceiverLocation(vtkLumiIrradiance.Points)
light.PerLightArraysOn()
light.Update()

data = light.GetOutputDataObject(0).GetPointData()
for i in range(data.GetNumberOfArrays()):
    if "Irradiance" in data.GetArrayName(i):
        print(f"{data.GetArrayName(i):26} at most {vtk_to_numpy(data.GetArray(i)).max():.2f}")
total = vtk_to_numpy(data.GetArray("Irradiance [W/m^2]"))
of_sun = vtk_to_numpy(data.GetArray("Irradiance [W/m^2] sun"))
assert of_sun.min() == of_sun.max() == 800.0

# Moving a light computes again, and builds nothing again.
lamp.SetPosition(0, 0, 1)
light.Update()
data = light.GetOutputDataObject(0).GetPointData()
assert vtk_to_numpy(data.GetArray("Irradiance [W/m^2]")).max() > total.max()
