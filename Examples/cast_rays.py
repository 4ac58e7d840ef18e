# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rays from numpy: where do they hit, what, and how often?"""

import numpy as np

import lumitree

# A sphere of radius 1, and rays from above its middle and beside it.
sphere = lumitree.scene("sphere", resolution=64)
origins = np.array([(0.05, 0.02, 5.0), (0.3, 0.2, 5.0), (2.0, 0.0, 5.0)])
hits = lumitree.cast(sphere, origins, directions=(0, 0, -1))
print("t          ", hits.t)  # inf: the third ray misses
print("cell       ", hits.cell_id)  # -1: likewise
print("normal     ", hits.normal[0])
assert hits.hit.tolist() == [True, True, False]
assert abs(hits.t[0] - 4.0) < 2e-3

# Many casts at one mesh: the tree over it is built once.
caster = lumitree.Caster(sphere, precision="watertight")
everything = caster.cast(origins, (0, 0, -1), query="all")
for ray in range(len(origins)):
    first, last = everything.offsets[ray : ray + 2]
    print(f"ray {ray} goes in and out at t =", everything.t[first:last])
assert everything.count.tolist() == [2, 2, 0]

# Is the way from one point to another free? t goes from 0 to 1 on the way.
start, end = np.array((0.0, 0.0, 5.0)), np.array([(0.0, 0.0, 2.0), (0.0, 0.0, -2.0)])
blocked = caster.cast(start, end - start, t_max=1.0, query="any").hit
print("blocked    ", blocked)
assert blocked.tolist() == [False, True]
