# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What does each pixel of a picture cost? A camera's rays are an image, and so are its results."""

import sys

import numpy as np

import lumitree

teapot = lumitree.scene("teapot", resolution=16)
camera = lumitree.camera_rays(eye=(3, -9, 6), target=(0.2, 0, 1.4), size=(320, 240))

# The same rays, the same hits, two ways to split a tree: the cost is what differs.
mean = {}
for build in ("longest_axis_median", "binned_sah"):
    result = lumitree.cast(teapot, camera, structure="bvh", bvh_build=build, cost=True)
    mean[build] = result.cost["nodes_entered"].mean()
    print(f"{build:19} {mean[build]:6.2f} nodes a ray, {result.hit.mean():.0%} of the rays hit")
assert mean["binned_sah"] < mean["longest_axis_median"]

# As an array of rows of pixels, row 0 at the bottom; and as a file for ParaView.
picture = result.cost["nodes_entered"].reshape(240, 320)
print("the dearest pixel (row, column):", np.unravel_index(picture.argmax(), picture.shape))
path = sys.argv[1] if len(sys.argv) > 1 else "cost.vti"
lumitree.write(result.rays, path)
assert result.rays.GetDimensions() == (320, 240, 1)
