# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Solid angles, intensities by direction, and grids of sensors."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkTable

from .arrays import in_range, number_in_range, to_vtk
from .choices import LengthUnit, LightSystem, choose, choose_length_unit
from .errors import run
from .surfaces import Mesh, as_surface
from .vtk import vtkLumiRadiantIntensity, vtkLumiSensorGrid, vtkLumiSolidAngle

#: What the value of an emitter is.
EMISSIONS = {"flux": 0, "exitance": 1, "radiance": 2}


def solid_angle(
    points: np.ndarray,
    surface: Mesh,
    occluders: Mesh | None = None,
    *,
    visible: bool = False,
    tolerance: float = 0.01,
    threads: int = 0,
    progress: Callable[[float], None] | None = None,
) -> np.ndarray:
    """The solid angle in sr of a surface as seen from points; (n,) float64.

    points : (n, 3).
    surface : its triangles count by their winding: positive where their back is seen, so that it is
        4 pi inside a closed surface and 0 outside; see `as_surface`.
    visible : instead, the directions in which the surface is seen at all, from either side.
    occluders : what hides it, itself included; by default the surface.
    tolerance : relative; of the visible part, where rays are cast.

    Raises ValueError for wrong shapes and types, LumitreeError for what the filter refuses.
    """
    places = np.ascontiguousarray(points, dtype=np.float64)
    if places.ndim != 2 or places.shape[1] != 3:
        raise ValueError(f"points must be of shape (n, 3), not {places.shape}")
    data = vtkPolyData()
    held = vtkPoints()
    held.SetData(to_vtk(places))
    data.SetPoints(held)
    filter_ = vtkLumiSolidAngle()
    filter_.SetInputData(data)
    filter_.SetSurfaceData(as_surface(surface))
    if occluders is not None:
        filter_.SetOccludersData(as_surface(occluders, "occluders"))
    filter_.SetVisiblePart(bool(visible))
    filter_.SetRelativeTolerance(number_in_range(tolerance, 0.0, 1.0, "tolerance"))
    filter_.SetNumberOfThreads(in_range(threads, 0, 4096, "threads"))
    run(filter_, progress)
    name = "VisibleSolidAngle [sr]" if visible else "SolidAngle [sr]"
    return vtk_to_numpy(filter_.GetOutputDataObject(0).GetPointData().GetArray(name))


@dataclass(frozen=True)
class Intensity:
    """Intensity over the sphere of directions.

    values : (gammas, planes) float64, in `unit`.
    c, gamma : the angles of the columns and the rows, degrees.
    unit : ``"W/sr"`` or ``"cd"``.
    emitted_flux : before anything is hidden; in W or lm.
    integrated_flux : of the linear interpolant of the values.
    far_field_distance : five times the extent of a surface; nan of a light.
    solid : the photometric solid.
    """

    values: np.ndarray
    c: np.ndarray
    gamma: np.ndarray
    unit: str
    emitted_flux: float
    integrated_flux: float
    far_field_distance: float
    solid: vtkPolyData


def radiant_intensity(
    emitter: Mesh,
    value: float = 1.0,
    emission: str = "flux",
    occluders: Mesh | None = None,
    *,
    system: LightSystem | str = "radiometric",
    two_sided: bool = False,
    axis: Sequence[float] = (0.0, 0.0, -1.0),
    reference: Sequence[float] = (1.0, 0.0, 0.0),
    planes: int = 24,
    steps: int = 36,
    length_unit: LengthUnit | str = "m",
    file: str | Path | None = None,
    threads: int = 0,
    progress: Callable[[float], None] | None = None,
) -> Intensity:
    """The far-field intensity of a surface that shines by Lambert's law, or of a light.

    emitter : a surface, shining on the side of its winding, see `as_surface`; or a light, such as of
        `point_light`.
    value, emission : what the surface emits: ``"flux"`` [W or lm], ``"exitance"`` [W/m2 or lm/m2] or
        ``"radiance"`` [W/(m2 sr) or cd/m2].
    occluders : what hides it, itself included; by default the surface.
    axis, reference : directions of gamma = 0 and of C = 0.
    planes, steps : C planes in 360 degrees, steps of gamma in 180.
    file : also written as a photometric file, EULUMDAT for ``.ldt``, else IES LM-63.

    Raises ValueError for wrong names, types and ranges, LumitreeError for what the filter refuses.
    """
    if emission not in EMISSIONS:
        raise ValueError(f"emission must be one of {', '.join(EMISSIONS)}, not {emission!r}")
    filter_ = vtkLumiRadiantIntensity()
    light = isinstance(emitter, vtkPolyData) and emitter.GetFieldData().HasArray("LightType")
    filter_.SetInputDataObject(0, emitter if light else as_surface(emitter))
    if occluders is not None:
        filter_.SetOccludersData(as_surface(occluders, "occluders"))
    filter_.SetEmission(EMISSIONS[emission])
    filter_.SetValue(number_in_range(value, 0.0, 1e300, "value"))
    filter_.SetSystem(choose(LightSystem, system, "system"))
    filter_.SetTwoSided(bool(two_sided))
    filter_.SetAxis(*axis)
    filter_.SetReference(*reference)
    filter_.SetPlanes(in_range(planes, 1, 720, "planes"))
    filter_.SetSteps(in_range(steps, 2, 720, "steps"))
    filter_.SetLengthUnit(choose_length_unit(length_unit))
    filter_.SetNumberOfThreads(in_range(threads, 0, 4096, "threads"))
    run(filter_, progress)
    if file is not None and not filter_.WritePhotometricFile(str(file)):
        raise OSError(f"{file} cannot be written")
    solid: vtkPolyData = filter_.GetOutputDataObject(0)
    table: vtkTable = filter_.GetOutputDataObject(1)
    columns = [vtk_to_numpy(table.GetColumn(i)) for i in range(table.GetNumberOfColumns())]
    fields = solid.GetFieldData()
    numbers = {
        fields.GetArrayName(i).partition(" ")[0]: fields.GetArray(i).GetValue(0)
        for i in range(fields.GetNumberOfArrays())
        if fields.GetArray(i)
    }
    unit = solid.GetPointData().GetScalars().GetName().partition("[")[2][:-1]
    return Intensity(
        values=np.stack(columns[1:], axis=1),
        c=np.array([360.0 * i / planes for i in range(planes)]),
        gamma=columns[0],
        unit=unit,
        emitted_flux=numbers["EmittedFlux"],
        integrated_flux=numbers["IntegratedFlux"],
        far_field_distance=numbers.get("FarFieldDistance", float("nan")),
        solid=solid,
    )


def sensor_grid(
    origin: Sequence[float],
    point1: Sequence[float],
    point2: Sequence[float],
    *,
    margin: float = 0.0,
    spacing: float = 0.0,
    flip: bool = False,
    length_unit: LengthUnit | str = "m",
) -> vtkPolyData:
    """Light sensors on a parallelogram, spaced by EN 12464-1: a quad for each, for `irradiance`.

    origin, point1, point2 : a corner and the ends of the two sides from there; sensors face along
        the first side cross the second, with `flip` to the other side.
    margin : width of a band along the sides without sensors.
    spacing : largest size of a cell; 0: 0.2 * 5^(log10 d) metres.

    Raises LumitreeError for corners that span no area and margins that leave no room.
    """
    source = vtkLumiSensorGrid()
    source.SetOrigin(*origin)
    source.SetPoint1(*point1)
    source.SetPoint2(*point2)
    source.SetMargin(number_in_range(margin, 0.0, 1e300, "margin"))
    source.SetSpacing(number_in_range(spacing, 0.0, 1e300, "spacing"))
    source.SetFlip(bool(flip))
    source.SetLengthUnit(choose_length_unit(length_unit))
    run(source)
    return source.GetOutput()
