# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bodies that rays meet as they are, without a mesh."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImplicitFunction, vtkPolyData

from .arrays import floats, in_range, to_vtk, vector, vectors
from .choices import Shape, choose
from .errors import run
from .vtk import vtkLumiImplicitSurface


def implicit(
    shape: Shape | str = "sphere",
    center: ArrayLike = (0.0, 0.0, 0.0),
    *,
    radius: ArrayLike = 0.5,
    radii: ArrayLike = (0.5, 0.5, 0.5),
    direction: ArrayLike = (0.0, 0.0, 1.0),
    height: float = 1.0,
    capped: bool = True,
    bounds: ArrayLike = (-1.0, 1.0, -1.0, 1.0, -1.0, 1.0),
    coefficients: ArrayLike | None = None,
    function: vtkImplicitFunction | None = None,
    step: float = 0.0,
    preview: int = 16,
) -> vtkPolyData:
    """Spheres, ellipsoids, cylinders, cones, paraboloids, discs, planes, boxes and other quadrics
    without a mesh, as a surface for `cast`, `hierarchy` and `irradiance`.

    shape : ``"sphere"``, ``"ellipsoid"``, ``"cylinder"``, ``"cone"``, ``"paraboloid"``,
        ``"disc"``, and in `bounds` ``"plane"``, ``"box"``, ``"quadric"``, ``"function"``.
    center : (3,), or (n, 3) for one body of the first six shapes at each point.
    radius : a number, or with n points (n,); of a cone at its base, of a paraboloid at `height`.
    radii : semi-axes of an ellipsoid along x, y and z.
    direction : (3,), or with n points (n, 3); the axis, or the normal. Any length but 0.
    height : of a cylinder or cone, with its middle in `center`, or of a paraboloid from there on.
    capped : whether cylinders and cones have their ends.
    bounds : x min, x max, y min, y max, z min, z max.
    coefficients : of a quadric, ten, in the order of vtkQuadric, about `center`.
    function : any vtkImplicitFunction. Spheres, planes, cylinders, cones, quadrics, boxes and
        vtkImplicitBoolean of such are exact, vtkSuperquadric (and booleans with one) goes by
        intervals, all others are sampled along each ray: field array ``ImplicitGuarantee`` 0, 1, 2.
    step : length between samples; 0 for 1/256 of the diagonal of `bounds`.
    preview : steps of the polygons that show a body and that rays do not see; 0 to 200.

    A body with a radius that is not above 0 is never hit. Raises ValueError for arguments of wrong
    shapes and LumitreeError for a boolean of nothing.
    """
    kind = choose(Shape, shape, "shape")
    source = vtkLumiImplicitSurface()
    source.SetShape(kind)
    source.SetRadii(vector(radii, "radii"))
    source.SetHeight(float(height))
    source.SetCapped(bool(capped))
    if not (np.isfinite(step) and step >= 0.0):
        raise ValueError(f"step must be 0 or more, not {step}")
    source.SetStep(float(step))
    source.SetPreviewResolution(in_range(preview, 0, 200, "preview"))
    box = floats(bounds, "bounds")
    if box.shape != (6,):
        raise ValueError(f"bounds must be six numbers, not of shape {box.shape}")
    source.SetBounds([float(x) for x in box])
    if coefficients is not None:
        numbers = floats(coefficients, "coefficients")
        if numbers.shape != (10,):
            raise ValueError(f"coefficients must be ten numbers, not of shape {numbers.shape}")
        source.SetCoefficients([float(x) for x in numbers])
    if function is not None:
        if not isinstance(function, vtkImplicitFunction):
            raise ValueError(
                f"function must be a vtkImplicitFunction, not {type(function).__name__}"
            )
        source.SetImplicitFunction(function)
    place(source, kind, vectors(center, "center"), radius, direction)
    run(source)
    return source.GetOutput()


def place(
    source: vtkLumiImplicitSurface,
    kind: Shape,
    center: np.ndarray,
    radius: ArrayLike,
    direction: ArrayLike,
) -> None:
    """One body, or one at each of several centres, with a radius and a direction each."""
    size, along = floats(radius, "radius"), vectors(direction, "direction")
    if center.ndim == 1:
        if size.ndim != 0 or along.ndim != 1:
            raise ValueError("several radii or directions need several centers")
        source.SetCenter(*(float(x) for x in center))
        source.SetRadius(float(size))
        source.SetDirection(*(float(x) for x in along))
        return
    n = len(center)
    if kind >= Shape.PLANE:
        raise ValueError(f"a {kind.name.lower()} goes by bounds: it cannot be at several centers")
    if size.shape not in ((), (n,)):
        raise ValueError(f"radius must be a number or have shape ({n},), not {size.shape}")
    if along.shape not in ((3,), (n, 3)):
        raise ValueError(f"direction must have shape (3,) or ({n}, 3), not {along.shape}")
    if size.ndim and kind is Shape.ELLIPSOID:
        raise ValueError("an ellipsoid goes by radii, not by several radius")
    points = vtkPoints()
    points.SetData(to_vtk(center))
    data = vtkPolyData()
    data.SetPoints(points)
    if size.ndim:
        data.GetPointData().AddArray(to_vtk(size.astype(np.float64), "Radius"))
        source.SetRadius(1.0)
        source.SetRadiusArray("Radius")
    else:
        source.SetRadius(float(size))
    if along.ndim == 2:
        data.GetPointData().AddArray(to_vtk(along.astype(np.float64), "Direction"))
        source.SetDirectionArray("Direction")
    else:
        source.SetDirection(*(float(x) for x in along))
    source.SetInputData(data)
