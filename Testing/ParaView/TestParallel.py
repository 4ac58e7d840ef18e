# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run on one rank and on two: the same hits and the same irradiance.

The floor is in two halves, each on a rank of its own where there are two, and a wall stands on the half of
rank 0: its shadow falls on the half of rank 1. The run on one rank leaves its numbers for the other to compare.
"""

import sys

import numpy as np
from paraview.simple import *

from pvtesting import IRRADIANCE, cell_array, fetch, load_plugin, point_array

load_plugin()
from paraview.simple import *  # the plugin's proxies

RANKS = int(sys.argv[1])
LIGHT = np.array([-1.0, 0.0, 2.0])
CELLS = 24  # of a half, along x; twice as many along y

HALVES = f"""
import numpy as np
from vtkmodules.vtkCommonCore import vtkIdTypeArray
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController

def plane(first, *corners):
    source = vtkPlaneSource()
    source.SetOrigin(corners[0]); source.SetPoint1(corners[1]); source.SetPoint2(corners[2])
    source.SetResolution({CELLS}, 2 * {CELLS})
    source.Update()
    ids = vtkIdTypeArray()
    ids.SetName("GlobalCell")
    for i in range(source.GetOutput().GetNumberOfCells()):
        ids.InsertNextValue(first + i)
    source.GetOutput().GetCellData().AddArray(ids)
    return source.GetOutput()

controller = vtkMultiProcessController.GetGlobalController()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
append = vtkAppendPolyData()
if WITH_FLOOR and rank == 0:
    append.AddInputData(plane(0, (-2, -2, 0), (0, -2, 0), (-2, 2, 0)))
if WITH_FLOOR and rank == ranks - 1:
    append.AddInputData(plane(10000, (0, -2, 0), (2, -2, 0), (0, 2, 0)))
if WITH_WALL and rank == 0:
    append.AddInputData(plane(20000, (-0.5, -1, 0), (-0.5, 1, 0), (-0.5, -1, 1.5)))
if append.GetNumberOfInputConnections(0):
    append.Update()
    self.GetOutput().ShallowCopy(append.GetOutput())
"""


def pieces(floor, wall):
    script = f"WITH_FLOOR, WITH_WALL = {floor}, {wall}\n" + HALVES
    source = ProgrammableSource(OutputDataSetType="vtkPolyData", Script=script)
    source.UpdatePipeline()
    return source


def ordered(keys, *arrays):
    order = np.lexsort(np.atleast_2d(np.asarray(keys).T))
    return [array[order] for array in arrays]


def irradiance_of_the_floor():
    lamp = PointLight(Position=LIGHT.tolist(), Flux=4 * np.pi)
    irradiance = Irradiance(Input=pieces(True, False), Occluders=pieces(True, True), Lights=lamp)
    data = fetch(irradiance)
    centers = fetch(CellCenters(Input=irradiance))
    points = np.array([centers.GetPoint(i) for i in range(centers.GetNumberOfPoints())])
    return ordered(cell_array(data, "GlobalCell"), points, cell_array(data, IRRADIANCE))


def closed_form(points):
    ray = points - LIGHT
    distance = np.linalg.norm(ray, axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        at_wall = LIGHT + ray * (0.5 / ray[:, :1])
    shadow = (points[:, 0] > -0.5) & (np.abs(at_wall[:, 1]) < 1) & (at_wall[:, 2] < 1.5)
    return np.where(shadow, 0, LIGHT[2] / distance**3)


def hits_from_above():
    rays = Rays(Origin=[-1.9, -1.9, 5], Point1=[-1.9, 1.9, 5], Point2=[1.9, -1.9, 5], Resolution=[37, 41])
    cast = RayCast(Input=pieces(True, True), Rays=rays, PassSurfaceData=1)
    hits = fetch(cast)
    points = np.array([hits.GetPoint(i) for i in range(hits.GetNumberOfPoints())])
    if RANKS > 1:
        assert set(point_array(hits, "ProcessId")) == {0, 1}
    misses = point_array(fetch(cast, 1), "HitMask") == 0
    assert not misses.any(), f"{misses.sum()} rays hit nothing"
    return ordered(np.round(points, 6), points, point_array(hits, "T"), point_array(hits, "GlobalCell"))


def nodes_of_the_structure():
    structure = AccelerationStructure(Input=pieces(True, True), Structure="BVH")
    table = fetch(structure, 1)
    return np.array([table.GetValueByName(0, name).ToInt() for name in ("Nodes", "Primitives")])


points, values = irradiance_of_the_floor()
assert len(points) == 2 * CELLS * 2 * CELLS
assert np.allclose(values, closed_form(points), rtol=1e-6)
right = points[:, 0] > 0
assert (values[right] == 0).any() and (values[right] > 0).any()

hit_points, hit_t, hit_cells = hits_from_above()
assert len(hit_points) == 37 * 41 and np.allclose(hit_t, 5)

results = [points, values, hit_points, hit_t, hit_cells, nodes_of_the_structure()]
if RANKS == 1:
    np.savez("TestParallel.npz", *results)
else:
    alone = np.load("TestParallel.npz")
    for name, array in zip(alone.files, results):
        assert np.array_equal(alone[name], array), f"{name} differs between one rank and {RANKS}"
