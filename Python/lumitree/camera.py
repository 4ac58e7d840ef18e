# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where to look from, and the rays of a camera as an image."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from vtkmodules.vtkCommonDataModel import vtkImageData

from .arrays import from_vtk, in_range, to_vtk, vector
from .errors import run
from .vtk import vtkLumiCameraRays


@dataclass(frozen=True)
class View:
    """Where a picture is taken from: the arguments of `camera_rays`."""

    eye: tuple[float, float, float]
    target: tuple[float, float, float]
    up: tuple[float, float, float] = (0.0, 0.0, 1.0)
    angle: float = 30.0  #: vertical, in degrees
    near: float = 0.0  #: what is less far than this, along the axis, is not seen


def view_of(
    bounds: ArrayLike,
    direction: ArrayLike = (0.5, -1.0, 0.5),
    *,
    up: ArrayLike = (0.0, 0.0, 1.0),
    angle: float = 30.0,
    aspect: float = 1.2,
) -> View:
    """The view from the side of `direction` that the box `bounds` (x, y and z as low, high) just
    fills.

    up, angle : as of `camera_rays`; up must not lie along the direction.
    aspect : width of the picture by its height.
    """
    low, high = np.asarray(bounds, float).reshape(3, 2).T
    middle = (low + high) / 2
    back = np.asarray(direction, float) / np.linalg.norm(direction)
    right = np.cross(up, back)
    right /= np.linalg.norm(right)
    signs = np.array(np.meshgrid(*[(-1, 1)] * 3)).reshape(3, 8).T
    corners = signs * (high - low) / 2 @ np.array([right, np.cross(back, right), back]).T
    slope = np.tan(np.radians(angle / 2))
    needed = (
        np.maximum(np.abs(corners[:, 0]) / aspect, np.abs(corners[:, 1])) / slope + corners[:, 2]
    )
    distance = 1.05 * float(needed.max()) or 1.0
    return View(tuple(middle + distance * back), tuple(middle), tuple(up), angle)


def camera_rays(
    eye: ArrayLike,
    target: ArrayLike,
    *,
    up: ArrayLike = (0.0, 0.0, 1.0),
    angle: float = 30.0,
    near: float = 0.0,
    size: tuple[int, int] = (640, 480),
) -> vtkImageData:
    """Rays through the pixels of a camera: a vtkImageData with ``RayOrigin`` and ``RayDirection``,
    so that all that is computed per ray is an image at once. `cast` takes it in the place of
    origins and directions.

    eye, target, up : where the camera is, what is in the middle of the picture, and which way is
        up.
    angle : vertical angle of view in degrees, between 0 and 180.
    near : rays start (``RayTMin``) at the plane that is this far along the axis, so that one can
        look into a closed room.
    size : pixels, (width, height); row 0 is at the bottom.

    Raises ValueError for wrong shapes, LumitreeError for a camera that cannot be (eye = target, up
    along the view).
    """
    width, height = size
    source = vtkLumiCameraRays()
    source.SetPosition(*vector(eye, "eye"))
    source.SetFocalPoint(*vector(target, "target"))
    source.SetViewUp(*vector(up, "up"))
    source.SetViewAngle(float(angle))
    source.SetResolution(in_range(width, 1, 2**20, "width"), in_range(height, 1, 2**20, "height"))
    run(source)
    image = source.GetOutput()
    if near > 0.0:
        axis = np.subtract(target, eye) / np.linalg.norm(np.subtract(target, eye))
        depth = from_vtk(image.GetPointData(), "RayDirection") @ axis
        image.GetPointData().AddArray(to_vtk(near / depth, "RayTMin"))
    return image
