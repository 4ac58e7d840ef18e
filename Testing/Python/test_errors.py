# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Wrong input is told clearly, by an exception, and nothing is printed."""

import numpy as np
import pytest
from meshes import floor
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkTable

import lumitree

DOWN = (0.0, 0.0, -1.0)
ABOVE = np.array([(1.0, 2.0, 5.0), (3.0, 2.0, 5.0)])


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (
            {"origins": np.zeros((2, 2))},
            r"origins must have shape \(n, 3\) or \(3,\), not \(2, 2\)",
        ),
        ({"directions": np.zeros((1, 2, 3))}, "directions must have shape"),
        ({"directions": np.ones((3, 3))}, "there are 2 origins, but 3 directions"),
        ({"directions": None}, "directions are missing"),
        ({"origins": [("a", "b", "c")]}, "origins must be numbers"),
        ({"t_min": [0.0, 0.0, 0.0]}, r"t_min must be a number or have shape \(2,\), not \(3,\)"),
        ({"t_max": np.zeros((2, 1))}, "t_max must be a number or have shape"),
        ({"t_min": 2.0, "t_max": 1.0}, "t_min must not be above t_max"),
        ({"t_min": np.nan}, "t_min must not be above t_max"),
        ({"query": "first"}, "query is 'first'; choose one of: closest, any, all, count"),
        ({"precision": "best"}, "precision is 'best'; choose one of: fast, watertight, exact"),
        ({"structure": "tree"}, "structure is 'tree'; choose one of: auto, brute_force, bvh"),
        ({"structure": 2}, "structure is 2; choose one of"),
        ({"bvh_build": "sah"}, "choose one of: longest_axis_median, binned_sah"),
        ({"kd_build": "median"}, "choose one of: spatial_median, sah"),
        ({"max_depth": 65}, "max_depth must be a whole number from 1 to 64, not 65"),
        ({"grid_density": 0}, "grid_density must be above 0 and at most 1000, not 0"),
        ({"grid_density": float("nan")}, "grid_density must be above 0"),
        ({"grid_resolution": (2, 2)}, "grid_resolution must be three whole numbers"),
        ({"grid_resolution": (2, 2, 0)}, "grid_resolution must be a whole number from 1"),
        ({"leaf_size": 0}, "leaf_size must be a whole number from 1 to 1024, not 0"),
        ({"threads": -1}, "threads must be a whole number from 0"),
        ({"threads": 1.5}, "threads must be a whole number"),
        ({"mesh": 3}, "mesh must be a vtkDataSet or a composite"),
        ({"mesh": vtkTable()}, "not vtkTable"),
        ({"mesh": (np.zeros((3, 2)), [(0, 1, 2)])}, r"points must have shape \(n, 3\)"),
        ({"mesh": (np.zeros((4, 3)), [(0, 1, 2, 3)])}, r"triangles must have shape \(m, 3\)"),
        ({"mesh": (np.zeros((3, 3)), [(0.0, 1.0, 2.0)])}, "triangles must be integers"),
        (
            {"mesh": (np.zeros((3, 3)), [(0, 1, 3)])},
            "point ids from 0 to 2, but they go from 0 to 3",
        ),
        ({"mesh": (np.zeros((3, 3)), [(0, 1, -1)])}, "they go from -1 to 1"),
    ],
)
def test_wrong_arguments(change, message):
    arguments = {"mesh": floor(), "origins": ABOVE, "directions": DOWN, **change}
    with pytest.raises(ValueError, match=message):
        lumitree.cast(**arguments)


def test_errors_of_the_filter_are_raised_and_not_printed(capfd):
    rays = vtkPolyData()  # without directions
    rays.SetPoints(lumitree.rays(ABOVE, DOWN).GetPoints())
    caster = lumitree.Caster(floor())
    with pytest.raises(lumitree.LumitreeError, match="RayDirection") as caught:
        caster.cast(rays)
    assert "0x" not in str(caught.value) and ".cxx" not in str(caught.value)
    assert capfd.readouterr() == ("", "")
    assert caster.cast(ABOVE, DOWN).hit.all()  # and it goes on


def test_rays_that_cannot_be_traced_are_counted_in_a_warning(capfd):
    origins = np.array([(1, 2, 5), (np.nan, 2, 5), (1, np.inf, 5), (1, 2, 5)], float)
    directions = np.array([DOWN, DOWN, DOWN, (0, 0, 0)])
    with pytest.warns(lumitree.LumitreeWarning, match="3") as told:
        hits = lumitree.cast(floor(), origins, directions)
    assert len(told) == 1
    assert hits.hit.tolist() == [True, False, False, False]
    assert capfd.readouterr() == ("", "")
    with pytest.warns(lumitree.LumitreeWarning, match="1"):
        crossed = lumitree.cast(floor(), ABOVE, DOWN, t_min=[0, 7], t_max=6)
    assert crossed.hit.tolist() == [True, False]


@pytest.mark.parametrize("query", ["closest", "any", "all", "count"])
def test_nothing_is_hit_of_an_empty_mesh(query):
    for mesh in ((np.empty((0, 3)), np.empty((0, 3), int)), (ABOVE, []), vtkPolyData()):
        hits = lumitree.cast(mesh, ABOVE, DOWN, query=query)
        assert hits.hit.tolist() == [False, False] and hits.count.tolist() == [0, 0]
        if query == "closest":
            assert np.isposinf(hits.t).all() and hits.cell_id.tolist() == [-1, -1]
            assert np.isnan(hits.point).all()
        if query == "all":
            assert len(hits.t) == 0 and hits.offsets.tolist() == [0, 0, 0]


def test_triangles_that_are_none_are_never_hit():
    points, triangles = floor()
    bad = np.concatenate([points, [(np.nan, 0, 1), (0, 0, 1), (1, 0, 1)]])
    more = np.concatenate([triangles, [(4, 5, 6), (5, 5, 6)]])
    assert lumitree.cast((bad, more), ABOVE, DOWN).t.tolist() == [5.0, 5.0]


def test_names_are_those_of_the_wrapped_classes():
    from lumitree import choices
    from lumitree.vtk import (
        vtkLumiImplicitSurface,
        vtkLumiIrradiance,
        vtkLumiPointLight,
        vtkLumiRayCast,
        vtkLumiScene,
    )

    for kind, wrapped in (
        (choices.Structure, vtkLumiRayCast),
        (choices.Precision, vtkLumiRayCast),
        (choices.BvhBuild, vtkLumiRayCast),
        (choices.Query, vtkLumiRayCast),
        (choices.Structure, vtkLumiIrradiance),
        (choices.LengthUnit, vtkLumiIrradiance),
        (choices.ReceiverLocation, vtkLumiIrradiance),
        (choices.LightSystem, vtkLumiPointLight),
        (choices.Scene, vtkLumiScene),
        (choices.Shape, vtkLumiImplicitSurface),
    ):
        for member in kind:
            camel = "".join(part.capitalize() for part in member.name.split("_"))
            assert getattr(wrapped, camel) == member, camel
