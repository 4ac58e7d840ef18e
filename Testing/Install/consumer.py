# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Imports the installed package and runs one filter; argument: the prefix it must come from."""

import sys

import lumitree
import lumitree.vtk
from vtkmodules.vtkFiltersSources import vtkSphereSource

prefix = sys.argv[1]
for module in (lumitree, lumitree.vtk):
    assert module.__file__.startswith(prefix), module.__file__

rays = lumitree.vtk.vtkLumiCameraRays()
rays.Update()
cast = lumitree.vtk.vtkLumiRayCast()
sphere = vtkSphereSource()
cast.SetInputConnection(0, sphere.GetOutputPort())
cast.SetInputConnection(1, rays.GetOutputPort())
cast.Update()
counted = cast.GetOutputDataObject(1).GetNumberOfPoints()
assert counted == rays.GetOutput().GetNumberOfPoints() > 0, counted
print("cast", counted, "rays from", prefix)
