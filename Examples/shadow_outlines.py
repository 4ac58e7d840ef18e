# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The outlines of a shadow and of its penumbra, and their areas: a plate in the sun, with the sun's disk."""

from datetime import datetime, timezone

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkThreshold
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource

import lumitree

# A plate of 1 m x 1 m, 20 m over the ground; noon at the equator on an equinox: the sun is in the zenith.
HEIGHT, CELL = 20.0, 0.02
sun = lumitree.sun_light(datetime(2024, 3, 20, 12, 7, 30, tzinfo=timezone.utc), 0.0, 0.0, 1000.0)
down = np.array(sun.GetFieldData().GetArray("LightDirection").GetTuple(0))
shift = HEIGHT * down[:2] / -down[2]
plate = (
    np.array([(-0.5, -0.5, HEIGHT), (0.5, -0.5, HEIGHT), (0.5, 0.5, HEIGHT), (-0.5, 0.5, HEIGHT)]),
    np.array([(0, 1, 2), (0, 2, 3)]),
)
ground = vtkPlaneSource()
ground.SetOrigin(shift[0] - 0.8, shift[1] - 0.8, 0)
ground.SetPoint1(shift[0] + 0.8, shift[1] - 0.8, 0)
ground.SetPoint2(shift[0] - 0.8, shift[1] + 0.8, 0)
ground.SetResolution(round(1.6 / CELL), round(1.6 / CELL))
ground.Update()
light = lumitree.irradiance(ground.GetOutput(), sun, plate, quantities=["shadow", "penumbra"])
assert light.rays.sum() == 0  # the plate is cut out of the sun's disk; no ray is cast


def outline_of(mask):
    """The boundary of the cells where a mask is set."""
    cut = vtkThreshold()
    cut.SetInputData(light.dataset)
    cut.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, mask)
    cut.SetUpperThreshold(0.5)
    cut.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputConnection(cut.GetOutputPort())
    edges = vtkFeatureEdges()
    edges.SetInputConnection(surface.GetOutputPort())
    edges.BoundaryEdgesOn()
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    return edges.GetOutput()


# The disk blurs each edge over the width h * 2 tan(alpha): full shadow within, penumbra around.
blur = HEIGHT * 2 * np.tan(np.radians(0.533 / 2))
umbra = light.quantities["shadow"].sum() * CELL**2
penumbra = light.quantities["penumbra"].sum() * CELL**2
print(f"shadow {umbra:.3f} m^2 of {(1 - blur) ** 2:.3f}, penumbra {penumbra:.3f} m^2 of {4 * blur:.3f}")
assert abs(umbra - (1 - blur) ** 2) < 0.05
assert abs(penumbra - 4 * blur) < 0.08  # its corners are round
for mask, reach in (("ShadowMask", 0.5 - blur / 2), ("PenumbraMask", 0.5 + blur / 2)):
    points = vtk_to_numpy(outline_of(mask).GetPoints().GetData())[:, :2] - shift
    print(f"{mask}: outline of {len(points)} points, to {np.abs(points).max():.2f} m from the middle")
    assert abs(np.abs(points).max() - reach) < 1.5 * CELL
