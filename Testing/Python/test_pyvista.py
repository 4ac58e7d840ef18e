# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""PyVista's objects, where PyVista is installed."""

import numpy as np
import pytest

import lumitree

pyvista = pytest.importorskip("pyvista")

DOWN = (0.0, 0.0, -1.0)


def test_meshes_and_blocks():
    sphere = pyvista.Sphere(radius=2.0)
    blocks = pyvista.MultiBlock([sphere, pyvista.Plane(i_size=9, j_size=9)])
    assert lumitree.cast(sphere, (0.1, 0.2, 5), DOWN).t[0] == pytest.approx(3.0, abs=0.05)
    assert lumitree.cast(blocks, (0.1, 0.2, 5), DOWN, query="count").count.tolist() == [3]


def test_arrays_of_pyvista():
    grid = pyvista.Plane(i_size=9, j_size=9, i_resolution=3, j_resolution=3)
    above = grid.translate((0, 0, 2)).points
    hits = lumitree.cast(grid, above, np.array(DOWN, above.dtype))
    assert hits.t.tolist() == [2.0] * 16
    assert hits.point.dtype == above.dtype == np.float32


def test_results_go_back_on_the_mesh():
    sphere = pyvista.Sphere(radius=2.0)
    light = lumitree.irradiance(sphere, lumitree.directional_light(DOWN, 100.0), at="points")
    sphere.point_data[light.name] = light.values
    assert np.nanmax(sphere[light.name]) == pytest.approx(100.0, rel=0.02)
    assert isinstance(pyvista.wrap(light.dataset), pyvista.PolyData)
