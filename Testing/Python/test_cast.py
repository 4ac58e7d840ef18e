# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shapes, types, limits and queries of `cast`."""

import signal
import threading

import numpy as np
import pytest
from meshes import floor, joined, random_rays, random_triangles

import lumitree

DOWN = (0.0, 0.0, -1.0)
FLOORS = joined(floor(0.0), floor(1.0), floor(3.0))
ABOVE = np.array([(1.0, 2.0, 5.0), (20.0, 0.0, 5.0), (-1.0, 2.0, 2.0)])


def test_closest_has_a_row_per_ray():
    hits = lumitree.cast(FLOORS, ABOVE, DOWN)
    assert hits.t.dtype == np.float64 and hits.t.tolist() == [2.0, np.inf, 1.0]
    assert hits.hit.dtype == bool and hits.hit.tolist() == [True, False, True]
    assert hits.count.tolist() == [1, 0, 1]
    assert hits.cell_id.dtype.kind == "i" and hits.cell_id.tolist() == [5, -1, 3]
    assert hits.composite_index.tolist() == [0, -1, 0]
    assert hits.uv.shape == (3, 2) and hits.normal.shape == (3, 3) and hits.point.shape == (3, 3)
    np.testing.assert_allclose(hits.normal[[0, 2]], [(0, 0, 1)] * 2)
    np.testing.assert_allclose(hits.point[[0, 2]], [(1, 2, 3), (-1, 2, 1)])
    assert np.isnan(hits.uv[1]).all() and np.isnan(hits.normal[1]).all()
    assert np.isnan(hits.point[1]).all()
    assert hits.ray_id is None and hits.offsets is None and hits.cost is None


def test_barycentric_coordinates_give_the_point():
    mesh = random_triangles(200)
    hits = lumitree.cast(mesh, *random_rays(500))
    p0, p1, p2 = (mesh[0][mesh[1][hits.cell_id[hits.hit], i]] for i in range(3))
    u, v = hits.uv[hits.hit].T[:, :, None]
    assert hits.hit.sum() > 50
    np.testing.assert_allclose((1 - u - v) * p0 + u * p1 + v * p2, hits.point[hits.hit], atol=1e-12)


def test_t_is_in_units_of_the_direction():
    hits = lumitree.cast(FLOORS, ABOVE[0], [(0, 0, -1), (0, 0, -0.25), (0, 0, -8)])
    assert hits.t.tolist() == [2.0, 8.0, 0.25]


@pytest.mark.parametrize(
    ("origins", "directions", "count"),
    [
        ((1, 2, 5), DOWN, 1),
        ([(1, 2, 5)], DOWN, 1),
        ((1, 2, 5), np.array([DOWN] * 4), 4),
        ([(1, 2, 5)], np.array([DOWN] * 4), 4),
        (np.array([(1, 2, 5)] * 4), DOWN, 4),
        (np.array([(1, 2, 5)] * 4), [DOWN], 4),
        (np.empty((0, 3)), DOWN, 0),
    ],
)
def test_a_single_one_goes_with_all_of_the_other(origins, directions, count):
    for query in ("closest", "any", "all", "count"):
        hits = lumitree.cast(FLOORS, origins, directions, query=query)
        assert len(hits.hit) == len(hits.count) == count
    assert lumitree.cast(FLOORS, origins, directions).t.tolist() == [2.0] * count


def test_memory_in_another_order_is_understood():
    rows = np.asfortranarray(ABOVE)
    every_second = np.repeat(ABOVE, 2, axis=0)[::2]
    for origins in (rows, every_second):
        assert lumitree.cast(FLOORS, origins, DOWN).t.tolist() == [2.0, np.inf, 1.0]


def test_all_gives_every_hit_in_order():
    hits = lumitree.cast(FLOORS, ABOVE, DOWN, query="all")
    assert hits.offsets.tolist() == [0, 3, 3, 5]
    assert hits.ray_id.tolist() == [0, 0, 0, 2, 2]
    assert hits.t.tolist() == [2.0, 4.0, 5.0, 1.0, 2.0]
    assert hits.cell_id.tolist() == [5, 3, 1, 3, 1]
    assert hits.count.tolist() == [3, 0, 2] and hits.hit.tolist() == [True, False, True]
    assert hits.uv.shape == (5, 2) and hits.normal.shape == (5, 3) and hits.point.shape == (5, 3)


def test_any_and_count_give_no_hits():
    occluded = lumitree.cast(FLOORS, ABOVE, DOWN, query="any")
    assert occluded.hit.tolist() == [True, False, True] and occluded.t is None
    counted = lumitree.cast(FLOORS, ABOVE, DOWN, query=lumitree.Query.COUNT)
    assert counted.count.tolist() == [3, 0, 2] and counted.cell_id is None


def cube(low, high):
    """Twelve triangles that share no points, wound at random."""
    corners = np.array([[(low, high)[i >> k & 1] for k in range(3)] for i in range(8)], float)
    faces = [(0, 2, 6, 4), (1, 5, 7, 3), (0, 4, 5, 1), (2, 3, 7, 6), (0, 1, 3, 2), (4, 6, 7, 5)]
    triangles = [t for a, b, c, d in faces for t in ((a, b, c), (c, a, d))]
    return corners[np.array(triangles)].reshape(-1, 3), np.arange(36).reshape(-1, 3)


def test_crossings_tell_inside_from_outside_in_every_direction():
    cubes = joined(cube(0.0, 2.0), cube(2.0, 4.0))
    lattice = np.stack(np.meshgrid(*[np.arange(-1.0, 5.5, 0.5)] * 3), -1).reshape(-1, 3)
    within = [((low <= lattice) & (lattice < low + 2)).all(axis=1) for low in (0.0, 2.0)]
    for direction in ((0, 0, 1), (1, 0, 0), (-1, -1, -1), (1, -1, 0), (0.3, 0.2, -0.9)):
        hits = lumitree.cast(cubes, lattice, direction, query="crossings")
        assert (hits.inside == (within[0] | within[1])).all(), direction
        assert (hits.inside == (hits.count % 2 == 1)).all() and hits.t is None
        assert (hits.hit == (hits.count > 0)).all()
    assert (lumitree.inside(cubes, lattice) == hits.inside).all()
    assert lumitree.inside(cubes, (1, 1, 1)).tolist() == [True]
    assert hits.statistics["Query"] == "crossings" and hits.statistics["ExactTests"] > 0
    assert hits.statistics["Hits"] == hits.count.sum()


def test_crossings_are_of_exact_alone():
    with pytest.raises(lumitree.LumitreeError, match="'crossings'.*'exact' only, not 'fast'"):
        lumitree.cast(FLOORS, ABOVE, DOWN, query="crossings", precision="fast")
    caster = lumitree.Caster(FLOORS)
    assert caster.cast(ABOVE, DOWN, query="crossings").statistics["Precision"] == "exact"


def test_the_precision_is_the_most_exact_that_the_structure_promises():
    for structure in ("auto", "brute_force", "bvh", "wide_bvh", "grid", "octree", "kd_tree"):
        statistics = lumitree.cast(FLOORS, ABOVE, DOWN, structure=structure).statistics
        assert statistics["Precision"] == "exact"
    chosen = lumitree.cast(FLOORS, ABOVE, DOWN, precision="watertight")
    assert chosen.statistics["Precision"] == "watertight"


def test_ties_are_all_hits_at_the_least_t():
    twice = joined(floor(1.0), floor(1.0, size=3.0), floor(0.0))
    hits = lumitree.cast(twice, [(0.5, 0.5, 5.0), (4.0, 2.0, 5.0)], DOWN, query="ties")
    assert hits.cell_id.tolist() == [0, 1, 2, 3, 0] and hits.offsets.tolist() == [0, 4, 5]
    assert hits.t.tolist() == [4.0] * 5 and hits.ray_id.tolist() == [0, 0, 0, 0, 1]


def test_t_is_the_nearest_double_on_request():
    mesh = (np.array([(-1, -1, 3.0), (1, -1, 3.0), (0, 1, 3.0)]), np.array([(0, 1, 2)]))
    hits = lumitree.cast(mesh, (0, 0, 0), (0.25, 0, 7.0), rounded_t=True)
    assert hits.t[0] == 3 / 7 and hits.statistics["ExactParameters"] == 1
    with pytest.raises(ValueError, match="rounded_t needs the precision 'exact'"):
        lumitree.cast(mesh, (0, 0, 0), (0, 0, 1), rounded_t=True, precision="watertight")


def test_statistics_are_of_all_rays():
    with pytest.warns(lumitree.LumitreeWarning, match="1 of 3 rays"):
        facts = lumitree.cast(FLOORS, ABOVE, [DOWN, (0, 0, 0), DOWN], query="all").statistics
    assert facts["Rays"] == 3 and facts["InvalidRays"] == 1
    assert facts["RaysHit"] == 2 and facts["Hits"] == 5 and facts["ExactTests"] == 0


def test_limits_are_closed_and_may_differ_per_ray():
    ray = ABOVE[[0, 0, 0, 0]]
    scalars = lumitree.cast(FLOORS, ray, DOWN, t_min=2.5, t_max=4.5, query="count")
    assert scalars.count.tolist() == [1] * 4
    per_ray = lumitree.cast(FLOORS, ray, DOWN, t_min=[0, 2, 2.5, 6], t_max=9.0)
    assert per_ray.t.tolist() == [2.0, 2.0, 4.0, np.inf]
    both = lumitree.cast(
        FLOORS, ray, DOWN, np.array([0, 2, 4, 5]), np.array([2, 4, 5, 5], np.float32), "count"
    )
    assert both.count.tolist() == [1, 2, 2, 1]


def test_cost_is_counted_on_request():
    hits = lumitree.cast(random_triangles(300), *random_rays(50), structure="bvh", cost=True)
    assert set(hits.cost) == {
        "nodes_entered",
        "cells_stepped",
        "leaves_visited",
        "primitives_tested",
    }
    assert (hits.cost["nodes_entered"] >= hits.cost["leaves_visited"]).all()
    assert hits.cost["primitives_tested"].max() < 300


def test_threads_do_not_change_a_bit():
    mesh, rays = random_triangles(2000), random_rays(5000)
    for query in ("closest", "all"):
        one, two, four = (
            lumitree.cast(mesh, *rays, query=query, threads=threads) for threads in (1, 2, 4)
        )
        for other in (two, four):
            for name in ("t", "cell_id", "uv", "normal", "point", "count"):
                assert getattr(one, name).tobytes() == getattr(other, name).tobytes(), name


def test_a_caster_is_used_again_and_its_results_stay():
    caster = lumitree.Caster(FLOORS)
    first = caster.cast(ABOVE, DOWN)
    second = caster.cast(ABOVE, (0, 0, 1), query="count")
    assert second.count.tolist() == [0, 0, 1]
    assert first.t.tolist() == [2.0, np.inf, 1.0]


def test_swapped_meshes_are_noticed():
    low, high = (lumitree.surfaces.as_surface(floor(z)) for z in (0.0, 1.0))
    caster = lumitree.Caster(low)
    for mesh, t in ((low, 5.0), (high, 4.0), (low, 5.0), (high, 4.0)):
        caster.mesh = mesh
        assert caster.cast(ABOVE[0], DOWN).t.tolist() == [t]


def test_camera_rays_are_taken_as_they_are():
    camera = lumitree.camera_rays((0, 0, 20), (0, 0, 0), up=(0, 1, 0), size=(40, 30))
    hits = lumitree.cast(FLOORS, camera)
    assert len(hits.t) == 1200 and 0 < hits.hit.sum() < 1200
    assert hits.rays.GetDimensions() == (40, 30, 1)
    assert hits.t.reshape(30, 40)[15, 20] == pytest.approx(17.0, rel=1e-3)


def test_a_near_plane_lets_one_look_into_a_room():
    room = lumitree.scene("cornell_box", resolution=1)
    view = {"eye": (0.5, -1.5, 0.5), "target": (0.5, 0.5, 0.5), "angle": 20.0, "size": (9, 9)}
    assert lumitree.cast(room, lumitree.camera_rays(**view)).t.max() < 1.6
    inside = lumitree.cast(room, lumitree.camera_rays(**view, near=1.51))
    assert inside.hit.all() and inside.point[:, 1].min() > 0.005


def test_line_cells_are_rays():
    from vtkmodules.vtkFiltersSources import vtkLineSource

    line = vtkLineSource()
    line.SetPoint1(1, 2, 2)
    line.SetPoint2(1, 2, -2)
    line.Update()
    hits = lumitree.cast(FLOORS, line.GetOutput(), query="all")
    assert hits.t.tolist() == [0.25, 0.5] and hits.count.tolist() == [2]


def test_progress_is_reported():
    parts = []
    lumitree.cast(random_triangles(1000), *random_rays(20000), progress=parts.append)
    assert parts and parts == sorted(parts) and parts[0] >= 0.0 and parts[-1] == 1.0


def test_what_progress_raises_is_raised():
    def stop(_part):
        raise KeyboardInterrupt

    caster = lumitree.Caster(random_triangles(1000))
    with pytest.raises(KeyboardInterrupt):
        caster.cast(*random_rays(20000), progress=stop)
    assert len(caster.cast(*random_rays(10)).t) == 10


def test_ctrl_c_stops_a_cast_and_not_the_process():
    caster = lumitree.Caster(random_triangles(1000))
    for progress in (None, lambda part: None):
        after = threading.Timer(0.1, signal.raise_signal, [signal.SIGINT])
        after.start()
        with pytest.raises(KeyboardInterrupt):
            while True:
                caster.cast(*random_rays(200000), progress=progress)
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
