# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""CGAL from plain Python: the same answers as the exact precision."""

import numpy as np
import pytest

import lumitree

try:
    import lumitree.reference  # noqa: F401
except ImportError as reason:
    pytest.skip(str(reason), allow_module_level=True)


def test_cgal_agrees_with_exact():
    mesh = lumitree.scene("teapot", resolution=3)
    rng = np.random.default_rng(4)
    origins = rng.uniform(-4, 4, (300, 3))
    directions = rng.uniform(-1, 1, (300, 3)) + (0, 0, 1) - origins  # towards its middle
    truth = lumitree.cast(mesh, origins, directions, structure="cgal", precision="exact")
    ours = lumitree.cast(mesh, origins, directions, precision="exact")
    assert np.array_equal(truth.cell_id, ours.cell_id)
    assert np.allclose(truth.t, ours.t, rtol=1e-7)
    assert (truth.cell_id >= 0).sum() > 50


def test_cgal_is_exact_only():
    mesh = lumitree.scene("teapot", resolution=2)
    with pytest.raises(lumitree.LumitreeError):
        lumitree.cast(mesh, (0, 0, 5), (0, 0, -1), structure="cgal", precision="fast")


@pytest.mark.parametrize("structure", ["cgal_epick", "cgal_cartesian"])
def test_other_kernels_of_cgal_are_fast_only(structure):
    mesh = lumitree.scene("teapot", resolution=3)
    hit = lumitree.cast(mesh, (0.3, 0.2, 9), (0, 0, -1), structure=structure, precision="fast")
    ours = lumitree.cast(mesh, (0.3, 0.2, 9), (0, 0, -1), precision="exact")
    assert np.array_equal(hit.cell_id, ours.cell_id)
    with pytest.raises(lumitree.LumitreeError):
        lumitree.cast(mesh, (0, 0, 5), (0, 0, -1), structure=structure, precision="exact")
