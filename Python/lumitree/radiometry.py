# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Light on a surface, in physical units."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataObject, vtkPolyData

from .choices import LengthUnit, Precision, ReceiverLocation, Structure, choose, choose_length_unit
from .errors import run
from .structures import set_structure
from .surfaces import Mesh, as_surface
from .vtk import vtkLumiIrradiance

#: The main arrays: irradiance of surfaces, and of cells of three dimensions, which have no normal.
QUANTITIES = (
    "Irradiance [W/m^2]",
    "Illuminance [lx]",
    "ScalarIrradiance [W/m^2]",
    "ScalarIlluminance [lx]",
)


@dataclass(frozen=True)
class Irradiance:
    """Irradiance of n receivers.

    values : (n,) float64, in `unit`; nan where a receiver has no normal. Of a composite, its leaves
        one after the other.
    name : of the array in the data set, ``"Irradiance [W/m^2]"`` or, of photometric lights,
        ``"Illuminance [lx]"``; cells of three dimensions have ``"ScalarIrradiance [W/m^2]"``.
    unit : ``"W/m^2"`` or ``"lx"``.
    per_light : of each light by its name, (n,) each; empty unless asked for.
    dataset : the receivers with these arrays, which share its memory.
    """

    values: np.ndarray
    name: str
    unit: str
    dataset: vtkDataObject
    per_light: dict[str, np.ndarray] = field(default_factory=dict)


def irradiance(
    mesh: Mesh,
    lights: vtkDataObject | Sequence[vtkDataObject],
    occluders: Mesh | None = None,
    at: ReceiverLocation | str = "cells",
    length_unit: LengthUnit | str = "m",
    per_light: bool = False,
    *,
    shadows: bool = True,
    precision: Precision | str = "fast",
    structure: Structure | str = "auto",
    threads: int = 0,
    progress: Callable[[float], None] | None = None,
    **build: object,
) -> Irradiance:
    """Light that falls on a mesh directly from the lights, with shadows.

    mesh : what receives, on the side of its normals; see `as_surface`.
    lights : of `point_light`, `directional_light` or a pipeline; composites hold one light a block.
    occluders : what casts shadows; by default the mesh itself.
    at : ``"cells"`` (their centres) or ``"points"``.
    length_unit : what one unit of the coordinates is: ``"m"``, ``"mm"``, ``"cm"``, ``"km"``,
        ``"in"``, ``"ft"``.
    per_light : also an array for each light.
    shadows : without, every receiver sees every light.
    precision, structure, threads, build : as of `Caster`.

    Raises ValueError for wrong names and types, LumitreeError for what the filter refuses, such as
    watts beside lumens. Receivers without a normal are counted in a LumitreeWarning.
    """
    filter_ = vtkLumiIrradiance()
    filter_.SetInputDataObject(0, as_surface(mesh))
    if occluders is not None:
        filter_.SetOccludersData(as_surface(occluders, "occluders"))
    for light in [lights] if isinstance(lights, vtkDataObject) else lights:
        if not isinstance(light, (vtkPolyData, vtkCompositeDataSet)):
            raise ValueError(
                f"lights must be data sets, such as of point_light, not {type(light).__name__}"
            )
        filter_.AddLightsData(light)
    filter_.SetReceiverLocation(choose(ReceiverLocation, at, "at"))
    filter_.SetLengthUnit(choose_length_unit(length_unit))
    filter_.SetPerLightArrays(bool(per_light))
    filter_.SetShadows(bool(shadows))
    set_structure(filter_, structure, precision=precision, threads=threads, **build)
    run(filter_, progress)
    return _result(filter_.GetOutputDataObject(0), choose(ReceiverLocation, at, "at"))


def _result(data: vtkDataObject, at: ReceiverLocation) -> Irradiance:
    kind = vtkDataObject.POINT if at == ReceiverLocation.POINTS else vtkDataObject.CELL
    leaves = [leaf.GetAttributes(kind) for leaf in _leaves(data)]
    arrays = [leaf.GetArray(i) for leaf in leaves for i in range(leaf.GetNumberOfArrays())]
    names = dict.fromkeys(array.GetName() for array in arrays if array)
    name = next((quantity for quantity in QUANTITIES if quantity in names), QUANTITIES[0])

    def joined(wanted: str) -> np.ndarray:
        parts = [vtk_to_numpy(array) for array in arrays if array and array.GetName() == wanted]
        return parts[0] if len(parts) == 1 else np.concatenate([np.empty(0), *parts])

    per_light = {
        other[len(name) + 1 :]: joined(other) for other in names if other.startswith(name + " ")
    }
    return Irradiance(joined(name), name, name[name.index("[") + 1 : -1], data, per_light)


def _leaves(data: vtkDataObject) -> list[vtkDataObject]:
    if not isinstance(data, vtkCompositeDataSet):
        return [data]
    iterator = data.NewIterator()
    leaves = []
    while not iterator.IsDoneWithTraversal():
        leaves.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return leaves
