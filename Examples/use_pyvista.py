# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""PyVista's meshes are VTK data sets: they go in as they are, and results go back on them."""

import numpy as np

try:
    import pyvista
except ImportError:
    raise SystemExit("skipped: PyVista is not installed") from None

import lumitree

ground = pyvista.Plane(i_size=10, j_size=10, i_resolution=50, j_resolution=50)
tower = pyvista.Cube(center=(0, 0, 1), x_length=1, y_length=1, z_length=2)
site = pyvista.MultiBlock({"ground": ground, "tower": tower})

# A ray from above: which block, which cell?
hits = lumitree.cast(site, origins=(0.1, 0.1, 5.0), directions=(0, 0, -1))
print(f"the ray meets block {hits.composite_index[0]} at z = {hits.point[0, 2]:.2f}")
assert abs(hits.point[0, 2] - 2.0) < 1e-6

# The tower's shadow on the ground.
sun = lumitree.directional_light(direction=(1, 0, -1), normal_irradiance=1000.0)
light = lumitree.irradiance(ground, sun, occluders=site)
ground.cell_data[light.name] = light.values
shaded = np.count_nonzero(light.values == 0.0) / ground.n_cells
print(f"{shaded:.1%} of the ground lies in shadow")
assert 0.01 < shaded < 0.1
