# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Any implicit function of VTK met by rays: a superquadric, a boolean, a sampled one.

With a file name as argument and Matplotlib at hand, draws what a camera's rays see of them.
"""

import sys
import time

import numpy as np
from vtkmodules.vtkCommonDataModel import (
    vtkCylinder,
    vtkImageData,
    vtkImplicitBoolean,
    vtkImplicitVolume,
    vtkMultiBlockDataSet,
    vtkSphere,
    vtkSuperquadric,
)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonTransforms import vtkTransform

import lumitree

SIZE = (480, 180)

# By intervals: a ring with corners, turned and moved by a transform.
ring = vtkSuperquadric()
ring.ToroidalOn()
ring.SetThickness(0.4)
ring.SetThetaRoundness(0.4)
ring.SetSize(1.0)
place = vtkTransform()
place.RotateX(70)
place.Translate(2.6, 0, 0)
ring.SetTransform(place)

# Exact: a ball with three holes.
drilled = vtkImplicitBoolean()
drilled.SetOperationTypeToDifference()
ball = vtkSphere()
ball.SetRadius(1.0)
drilled.AddFunction(ball)
for axis in np.eye(3):
    drill = vtkCylinder()
    drill.SetRadius(0.45)
    drill.SetAxis(*axis)
    drilled.AddFunction(drill)

# Sampled: a gyroid, known at the points of an image.
axis = np.linspace(-1.2, 1.2, 49)
z, y, x = (6 * c for c in np.meshgrid(axis, axis, axis, indexing="ij"))
values = np.sin(x) * np.cos(y) + np.sin(y) * np.cos(z) + np.sin(z) * np.cos(x)
image = vtkImageData()
image.SetDimensions(49, 49, 49)
image.SetOrigin(1.4, -1.2, -1.2)
image.SetSpacing(0.05, 0.05, 0.05)
image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=True))
gyroid = vtkImplicitVolume()
gyroid.SetVolume(image)
gyroid.SetOutValue(1.0)


def body(function: object, x: float) -> object:
    bounds = (x - 1.2, x + 1.2, -1.2, 1.2, -1.2, 1.2)
    return lumitree.implicit("function", function=function, bounds=bounds)


bodies = {
    "by intervals": body(ring, -2.6),
    "exact": body(drilled, 0.0),
    "sampled": body(gyroid, 2.6),
}
kinds = {"exact": 0, "by intervals": 1, "sampled": 2}
for name, made in bodies.items():
    guarantee = vtk_to_numpy(made.GetFieldData().GetArray("ImplicitGuarantee"))
    assert set(guarantee) == {kinds[name]}

camera = lumitree.camera_rays(eye=(0, -10, 5), target=(0, 0, -0.1), size=SIZE, angle=17)
for name, made in bodies.items():
    start = time.perf_counter()
    hits = lumitree.cast(made, camera, precision="exact", threads=1)
    seconds = time.perf_counter() - start
    # Rays that pass the body's box cost next to nothing.
    each = 1e6 * seconds / hits.hit.sum()
    print(f"{name:12} {hits.hit.sum():6} of {hits.hit.size} rays hit, {each:6.1f} µs a hit")
    assert hits.hit.sum() > 1000
    if name == "exact":
        assert hits.flags is None
    else:
        assert (hits.flags[hits.hit] & 2 != 0).all() == (name == "sampled")

scene = vtkMultiBlockDataSet()
for block, made in enumerate(bodies.values()):
    scene.SetBlock(block, made)
seen = lumitree.cast(scene, camera, precision="exact")
assert set(seen.composite_index[seen.hit]) == {1, 2, 3}

if len(sys.argv) > 1:
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    shade = np.where(seen.hit, 0.15 + 0.85 * np.abs(seen.normal @ (0.4, -0.5, 0.77)), 1.0)
    pyplot.imsave(sys.argv[1], shade.reshape(SIZE[::-1])[::-1], cmap="gray", vmin=0, vmax=1)
