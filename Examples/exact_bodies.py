# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bodies without a mesh: balls, a can and a mesh in one scene, a drilled block and a ring."""

import numpy as np
from vtkmodules.vtkCommonDataModel import (
    vtkBox,
    vtkCylinder,
    vtkImplicitBoolean,
    vtkMultiBlockDataSet,
    vtkSuperquadric,
)

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

# A block with a hole along y: a difference of functions, exact as its operands are.
block, drill = vtkBox(), vtkCylinder()
block.SetBounds(-1, 1, -1, 1, -1, 1)
drill.SetRadius(0.5)
drilled = vtkImplicitBoolean()
drilled.SetOperationTypeToDifference()
drilled.AddFunction(block)
drilled.AddFunction(drill)
body = lumitree.implicit("function", function=drilled, bounds=(-2, 2, -2, 2, -2, 2))
through = lumitree.cast(body, (-3, 0, 0), (1, 0, 0), query="all", precision="exact")
print("the drilled block is met at t =", *through.t)
assert through.t.tolist() == [2.0, 2.5, 3.5, 4.0]
places = [(0, 0, 0), (0.75, 0, 0), (0.75, 0.9, 0.9), (1.5, 0, 0)]
assert lumitree.inside(body, places).tolist() == [False, True, True, False]

# A ring has no such form: intervals isolate its hits, and would mark what they could not.
ring = vtkSuperquadric()
ring.ToroidalOn()
ring.SetThickness(1.0 / 3.0)
ring.SetSize(1.0)
torus = lumitree.implicit("function", function=ring, bounds=(-2, 2, -2, 2, -2, 2))
across = lumitree.cast(torus, (-2, 0, 0), (1, 0, 0), query="all", precision="exact")
assert np.allclose(across.t, [1.0, 1.5, 2.5, 3.0], atol=1e-12) and not across.flags.any()
