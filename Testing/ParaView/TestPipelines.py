# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pipelines of the plugin's proxies, against numbers known beforehand."""

import math
import tempfile

import numpy as np
from paraview.simple import *

from pvtesting import IRRADIANCE, cell_array, fetch, load_plugin, point_array

load_plugin()
from paraview.simple import *  # the plugin's proxies


def parallel_camera_onto_a_plane():
    plane = Plane(XResolution=4, YResolution=4)
    rays = CameraRays(Position=[0, 0, 2], Resolution=[32, 24], ParallelProjection=1, ParallelScale=0.25)
    cast = RayCast(Input=plane, Rays=rays, CountTraversal=1)
    hits = fetch(cast)
    assert hits.GetNumberOfPoints() == hits.GetNumberOfVerts() == 32 * 24
    assert np.allclose(point_array(hits, "T"), 2, rtol=1e-6)
    assert np.allclose(point_array(hits, "Normals"), [0, 0, 1])
    assert np.array_equal(point_array(hits, "RayId"), np.arange(32 * 24))
    image = fetch(cast, 1)
    assert image.IsA("vtkImageData") and image.GetDimensions() == (32, 24, 1)
    assert np.all(point_array(image, "HitMask") == 1)
    assert np.all(point_array(image, "NodesEntered") >= 1)
    assert np.all(point_array(image, "PrimitivesTested") >= 1)


def perspective_camera_past_a_plane():
    plane = Plane()
    rays = CameraRays(Position=[0, 0, 2], Resolution=[50, 50], ViewAngle=60)
    cast = RayCast(Input=plane, Rays=rays, Query="Any")
    assert fetch(cast).GetNumberOfPoints() == 0
    image = fetch(cast, 1)
    half = 2 * math.tan(math.radians(30))
    middles = (np.arange(50) + 0.5) / 50 * 2 * half - half
    inside = np.abs(middles) < 0.5
    assert np.array_equal(point_array(image, "HitMask").reshape(50, 50), np.outer(inside, inside))


def segments_through_a_box():
    line = Line(Point1=[-2, 0.1, 0.2], Point2=[2, 0.1, 0.2], Resolution=1)
    cast = RayCast(Input=Box(), Rays=line, Query="All")
    assert np.allclose(point_array(fetch(cast), "T"), [0.375, 0.625])
    assert cell_array(fetch(cast, 1), "HitCount").tolist() == [2]


def photometric_files_open_and_save():
    with tempfile.TemporaryDirectory() as directory:
        file = f"{directory}/lamp.ies"
        SaveData(file, PointLight(Flux=1000, System="Photometric"))
        lamp = OpenDataFile(file)
        assert lamp.GetXMLName() == "LumiPhotometricLight"
        flux = fetch(lamp).GetFieldData().GetArray("LuminousFlux [lm]").GetValue(0)
        assert abs(flux - 1000) < 1e-6


def rays_from_a_closed_room():
    scene = BuiltinScene(Scene="Cornell Box", Resolution=4)
    rays = Rays(Mode="Sphere Around Point", Center=[0.5, 0.5, 0.8], NumberOfRays=500)
    cast = RayCast(Input=scene, Rays=rays, PassSurfaceData=1)
    hits = fetch(cast)
    assert hits.GetNumberOfPoints() == 500
    assert set(point_array(hits, "Reflectance").tolist()) <= {0.0, 0.7}


def surface_rays_leave_along_the_normal():
    rays = SurfaceRays(Input=Sphere(Radius=2), SourceLocation="Cells", Distribution="Normal", Offset=0.5)
    data = fetch(rays)
    points = point_array(data, "RayDirection")
    assert data.GetNumberOfPoints() == fetch(Sphere(Radius=2)).GetNumberOfCells()
    assert np.allclose(np.linalg.norm(points, axis=1), 1)


def camera_that_sees_the_scene():
    sphere = Sphere(Center=[5, 6, 7], Radius=2, ThetaResolution=32, PhiResolution=32)
    rays = CameraRaysofScene(Input=sphere, Resolution=[64, 64])
    cast = RayCast(Input=sphere, Rays=rays, Query="Any")
    mask = point_array(fetch(cast, 1), "HitMask").reshape(64, 64)
    assert mask[32, 32] == 1 and 0.2 < mask.mean() < 0.3
    assert not mask[0].any() and not mask[:, 0].any()


def bodies_without_a_mesh():
    rays = [Line(Point1=[x, 0.1, -9], Point2=[x, 0.1, 9], Resolution=1) for x in (0, 5)]
    ball = ImplicitSurface(Shape="Sphere", Radius=0.5)
    points = ImplicitSurfacesatPoints(Input=PointSource(Center=[5, 0, 0]), Shape="Cylinder")
    scene = GroupDatasets(Input=[ball, Sphere(Radius=2), points])
    hits = [fetch(RayCast(Input=scene, Rays=ray, Query="All")) for ray in rays]
    assert point_array(hits[0], "CompositeIndex").tolist() == [2, 1, 1, 2]
    assert point_array(hits[1], "CompositeIndex").tolist() == [3, 3]
    body = ImplicitSurface(Shape="Function", Bounds=[-9, 9, -9, 9, -9, 9])
    for name, count in (("Sphere", 2), ("Plane", 0), ("Cylinder", 0), ("Quadric", 2), ("Box", 2)):
        body.ImplicitFunction = name
        if name == "Plane":
            body.ImplicitFunction.Normal = [0, 0, 1]
            count = 1
        if name == "Cylinder":
            body.ImplicitFunction.Axis = [0, 1, 1]
            count = 2
        if name == "Box":
            body.ImplicitFunction.Position = [-1, -2, -3]
            body.ImplicitFunction.Length = [2, 4, 6]
            body.ImplicitFunction.Rotation = [0, 0, 20]
        found = fetch(RayCast(Input=body, Rays=rays[0], Query="All")).GetNumberOfPoints()
        assert found == count, (name, found)


def structure_of_a_sphere():
    sphere = BuiltinScene(Scene="Sphere", Resolution=8)
    structure = AccelerationStructure(Input=sphere, Structure="BVH", MaximumLevel=3)
    levels = fetch(structure)
    assert levels.GetNumberOfBlocks() == 4
    root = levels.GetBlock(0)
    assert root.GetNumberOfCells() == 12 and set(cell_array(root, "NodeId")) == {0}
    assert set(cell_array(root, "PrimitiveCount")) == {20 * 8 * 8}
    table = fetch(structure, 1)
    assert table.GetNumberOfRows() == 1
    assert table.GetValueByName(0, "Structure").ToString() == "bvh"
    assert table.GetValueByName(0, "Primitives").ToInt() == 20 * 8 * 8
    assert table.GetValueByName(0, "Rays").ToInt() == 0


def visits_of_rays():
    sphere = BuiltinScene(Scene="Sphere", Resolution=8)
    rays = Rays(Mode="Sphere Around Point", NumberOfRays=100)
    structure = AccelerationStructure(Input=sphere, Rays=rays, Structure="BVH")
    assert set(cell_array(fetch(structure).GetBlock(0), "Visits")) == {100}
    assert fetch(structure, 1).GetValueByName(0, "Rays").ToInt() == 100


def irradiance_under_a_point_light():
    plane = Plane(XResolution=8, YResolution=8)
    light = PointLight(Position=[0, 0, 2], Flux=4 * math.pi * 100)
    irradiance = Irradiance(Input=plane, Lights=light, ReceiverLocation="Points")
    data = fetch(irradiance)
    points = np.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    distance = np.linalg.norm(points - [0, 0, 2], axis=1)
    assert np.allclose(point_array(data, IRRADIANCE), 100 * 2 / distance**3, rtol=1e-6)
    irradiance.LengthUnit = "Millimetre"
    assert np.allclose(point_array(fetch(irradiance), IRRADIANCE), 1e6 * 100 * 2 / distance**3, rtol=1e-6)


def two_lights_and_a_screen():
    plane = Plane(XResolution=1, YResolution=1)
    screen = Plane(Origin=[-1, -1, 1], Point1=[1, -1, 1], Point2=[-1, 1, 1])
    sun = DirectionalLight(Direction=[0, 3, -4], NormalIrradiance=1000, LightName="sun")
    lamp = PointLight(Position=[0, 0, 0.5], Flux=math.pi, LightName="lamp")
    irradiance = Irradiance(Input=plane, Lights=[sun, lamp], PerLightArrays=1)
    assert np.allclose(cell_array(fetch(irradiance), IRRADIANCE), 800 + 1)
    irradiance.Occluders = screen
    data = fetch(irradiance)
    assert np.allclose(cell_array(data, IRRADIANCE + " sun"), 0)
    assert np.allclose(cell_array(data, IRRADIANCE + " lamp"), 1)
    irradiance.Shadows = 0
    assert np.allclose(cell_array(fetch(irradiance), IRRADIANCE), 800 + 1)
    irradiance.Lights = lamp
    assert np.allclose(cell_array(fetch(irradiance), IRRADIANCE), 1)


def illuminance_of_lumens():
    lamp = PointLight(Position=[0, 0, 1], Flux=4 * math.pi, System="Photometric")
    data = fetch(Irradiance(Input=Plane(), Lights=lamp))
    assert np.allclose(cell_array(data, "Illuminance [lx]"), 1)


def blocks_shadow_each_other():
    floor = Plane()
    screen = Plane(Origin=[-1, -1, 1], Point1=[1, -1, 1], Point2=[-1, 1, 1])
    sun = DirectionalLight(NormalIrradiance=3)
    data = fetch(Irradiance(Input=GroupDatasets(Input=[floor, screen]), Lights=sun))
    assert np.allclose(cell_array(data.GetBlock(0), IRRADIANCE), 0)
    assert np.allclose(cell_array(data.GetBlock(1), IRRADIANCE), 3)


for test in (
    photometric_files_open_and_save,
    parallel_camera_onto_a_plane,
    perspective_camera_past_a_plane,
    segments_through_a_box,
    rays_from_a_closed_room,
    surface_rays_leave_along_the_normal,
    camera_that_sees_the_scene,
    bodies_without_a_mesh,
    structure_of_a_sphere,
    visits_of_rays,
    irradiance_under_a_point_light,
    two_lights_and_a_screen,
    illuminance_of_lumens,
    blocks_shadow_each_other,
):
    print(test.__name__, flush=True)
    test()
