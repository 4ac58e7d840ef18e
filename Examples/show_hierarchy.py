# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tree over a surface: a block of boxes per level, and its numbers."""

import sys

import lumitree

teapot = lumitree.scene("teapot", resolution=16)
camera = lumitree.camera_rays(eye=(3, -9, 6), target=(0.2, 0, 1.4), size=(160, 120))

for build in ("longest_axis_median", "binned_sah"):
    tree = lumitree.hierarchy(teapot, "bvh", bvh_build=build, rays=camera)
    facts = tree.statistics
    print(
        f"{build:19} {facts['Nodes']:6} nodes, {facts['Depth']} deep, "
        f"SAH cost {facts['SahCost']:.2f}, built in {1e3 * facts['BuildSeconds']:.2f} ms"
    )

# Every ray that meets the root's box enters the root; deeper down they spread.
root = tree.levels.GetBlock(0)
visits = root.GetCellData().GetArray("Visits").GetValue(0)
print(f"{visits} of {160 * 120} rays enter the root")
assert 0 < visits <= 160 * 120
assert facts["Primitives"] >= teapot.GetNumberOfCells()

lumitree.write(tree.levels, sys.argv[1] if len(sys.argv) > 1 else "hierarchy.vtm")
