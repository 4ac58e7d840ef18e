# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bodies without a mesh: balls, a can and a mesh in one scene, met exactly."""

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet

import lumitree

# Rays past a ball: one touches it, one misses it by the last digit of a double.
ball = lumitree.implicit("sphere", (0, 0, 0), radius=0.1)
beside = np.nextafter(0.1, 1.0)
hits = lumitree.cast(ball, [(-1, 0.1, 0), (-1, beside, 0)], (1, 0, 0), precision="exact")
print("touches at t =", hits.t[0], "- passes by:", not hits.hit[1])
assert hits.t.tolist() == [1.0, np.inf]

# A thousand balls, a can and a mesh are one scene: a ray through it meets what it meets.
rng = np.random.default_rng(1)
balls = lumitree.implicit("sphere", rng.uniform(-4, 4, (1000, 3)), radius=0.2)
can = lumitree.implicit("cylinder", (0, 0, 0), radius=1.5, height=3.0)
scene = vtkMultiBlockDataSet()
for block, part in enumerate((lumitree.scene("sphere", resolution=20), balls, can)):
    scene.SetBlock(block, part)
all_hits = lumitree.cast(scene, (-6, 0.1, 0.2), (1, 0, 0), query="all", precision="exact")
for t, leaf in zip(all_hits.t, all_hits.composite_index):
    print(f"t = {t:.6f}  {['', 'mesh', 'ball', 'can'][leaf]}")
assert (np.diff(all_hits.t) >= 0).all()
assert (all_hits.composite_index == 3).sum() == 2  # into the can and out of it
assert (all_hits.composite_index == 2).sum() % 2 == 0  # likewise every ball
