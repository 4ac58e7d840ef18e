# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Light on a surface, in physical units."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from enum import IntEnum

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataObject, vtkPolyData

from .arrays import in_range, number_in_range
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

#: What turns each further quantity on, and how its array is named from that of the irradiance.
_SETTERS = {
    "back": "SetTwoSided",
    "scalar": "SetScalarIrradiance",
    "vector": "SetLightVector",
    "cylindrical": "SetCylindricalIrradiance",
    "hemispherical": "SetHemisphericalIrradiance",
    "shadow": "SetShadowMasks",
    "penumbra": "SetShadowMasks",
}
_NAMES = {
    "back": "Back{base} [{unit}]",
    "scalar": "Scalar{base} [{unit}]",
    "vector": "LightVector [{unit}]",
    "cylindrical": "Cylindrical{base} [{unit}]",
    "hemispherical": "Hemispherical{base} [{unit}]",
    "shadow": "ShadowMask",
    "penumbra": "PenumbraMask",
}


class EstimateMethod(IntEnum):
    """How a value was found; of several lights the last of these."""

    NONE = 0
    CLOSED_FORM = 1
    SIGHTLINE = 2
    CLIPPING = 3
    HORIZON = 4
    BOUNDS = 5
    SAMPLING = 6


@dataclass(frozen=True)
class Irradiance:
    """Irradiance of n receivers.

    values : (n,) float64, in `unit`; nan where a receiver has no normal. Of a composite, its leaves
        one after the other.
    name : of the array in the data set, ``"Irradiance [W/m^2]"`` or, of photometric lights,
        ``"Illuminance [lx]"``; cells of three dimensions have ``"ScalarIrradiance [W/m^2]"``.
    unit : ``"W/m^2"`` or ``"lx"``.
    per_light : of each light by its name, (n,) each; empty unless asked for.
    lower, upper : (n,) each, what the value lies between: the value itself where it is exact, an
        interval where rays were cast.
    method : (n,) uint8, see `EstimateMethod`.
    rays : (n,) int32, rays cast for each receiver.
    quantities : of each quantity asked for, by the name of `irradiance`; (n,), the vector (n, 3).
    statistics : of all receivers by name: ``IrradianceMinimum [W/m^2]``, ``IrradianceMean [W/m^2]``,
        ``IrradianceMaximum [W/m^2]``, ``Uniformity``; under skies ``DaylightFactor [%]``.
    dataset : the receivers with these arrays, which share its memory.
    """

    values: np.ndarray
    name: str
    unit: str
    dataset: vtkDataObject
    per_light: dict[str, np.ndarray] = field(default_factory=dict)
    lower: np.ndarray | None = None
    upper: np.ndarray | None = None
    method: np.ndarray | None = None
    rays: np.ndarray | None = None
    quantities: dict[str, np.ndarray] = field(default_factory=dict)
    statistics: dict[str, float] = field(default_factory=dict)


def irradiance(
    mesh: Mesh,
    lights: vtkDataObject | Sequence[vtkDataObject],
    occluders: Mesh | None = None,
    at: ReceiverLocation | str = "cells",
    length_unit: LengthUnit | str = "m",
    per_light: bool = False,
    *,
    tolerance: float = 0.01,
    absolute_tolerance: float = 0.0,
    maximum_rays: int = 16384,
    quantities: Sequence[str] = (),
    shadows: bool = True,
    precision: Precision | str = "automatic",
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
    tolerance, absolute_tolerance : how far a value that rays estimate may be off: relative to it,
        and in W/m2 or lx; the larger of both holds. What has a closed form is exact.
    maximum_rays : from a receiver to a light.
    quantities : further ones, of ``"back"`` (irradiance of the other side), ``"scalar"``,
        ``"vector"``, ``"cylindrical"``, ``"hemispherical"``, ``"shadow"``, ``"penumbra"``.
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
    filter_.SetRelativeTolerance(number_in_range(tolerance, 0.0, 1.0, "tolerance"))
    filter_.SetAbsoluteTolerance(
        number_in_range(absolute_tolerance, 0.0, 1e300, "absolute_tolerance")
    )
    filter_.SetMaximumRays(in_range(maximum_rays, 64, 16777216, "maximum_rays"))
    filter_.SetEstimateArrays(True)
    for quantity in quantities:
        if quantity not in _SETTERS:
            raise ValueError(f"quantities must be of {', '.join(_SETTERS)}, not {quantity!r}")
        getattr(filter_, _SETTERS[quantity])(True)
    set_structure(filter_, structure, precision=precision, threads=threads, **build)
    run(filter_, progress)
    return _result(
        filter_.GetOutputDataObject(0), choose(ReceiverLocation, at, "at"), quantities
    )


def _result(data: vtkDataObject, at: ReceiverLocation, quantities: Sequence[str]) -> Irradiance:
    kind = vtkDataObject.POINT if at == ReceiverLocation.POINTS else vtkDataObject.CELL
    leaves = [leaf.GetAttributes(kind) for leaf in _leaves(data)]
    arrays = [leaf.GetArray(i) for leaf in leaves for i in range(leaf.GetNumberOfArrays())]
    names = dict.fromkeys(array.GetName() for array in arrays if array)
    name = next((quantity for quantity in QUANTITIES if quantity in names), QUANTITIES[0])
    head, _, unit = name[:-1].partition(" [")
    base = head.removeprefix("Scalar")

    def joined(wanted: str) -> np.ndarray:
        parts = [vtk_to_numpy(array) for array in arrays if array and array.GetName() == wanted]
        return parts[0] if len(parts) == 1 else np.concatenate([np.empty(0), *parts])

    per_light = {
        other[len(name) + 1 :]: joined(other) for other in names if other.startswith(name + " ")
    }
    fields = data.GetFieldData()
    numbers = [fields.GetArray(i) for i in range(fields.GetNumberOfArrays())]
    return Irradiance(
        joined(name),
        name,
        unit,
        data,
        per_light,
        joined(f"{head}Lower [{unit}]"),
        joined(f"{head}Upper [{unit}]"),
        joined("EstimateMethod"),
        joined("RayCount"),
        {key: joined(_NAMES[key].format(base=base, unit=unit)) for key in quantities},
        {
            array.GetName(): array.GetValue(0)
            for array in numbers
            if array and array.GetNumberOfTuples() == 1 and array.GetName() in _statistics(head, unit)
        },
    )


def _statistics(head: str, unit: str) -> set[str]:
    outdoor = head.removeprefix("Scalar")
    return {
        f"{head}Minimum [{unit}]",
        f"{head}Mean [{unit}]",
        f"{head}Maximum [{unit}]",
        f"Outdoor{outdoor} [{unit}]",
        "Uniformity",
        "DaylightFactor [%]",
    }


def _leaves(data: vtkDataObject) -> list[vtkDataObject]:
    if not isinstance(data, vtkCompositeDataSet):
        return [data]
    iterator = data.NewIterator()
    leaves = []
    while not iterator.IsDoneWithTraversal():
        leaves.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return leaves
