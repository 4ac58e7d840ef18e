# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Between numpy and VTK, without copies where the memory allows it."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkCommonDataModel import vtkFieldData, vtkTable


def floats(value: ArrayLike, argument: str) -> np.ndarray:
    """`value` as an array of float32 or float64.

    An array of one of the two is returned as it is; other numbers become float64. Raises ValueError
    for what is not numbers.
    """
    array = np.asarray(value)
    if array.dtype in (np.float32, np.float64):
        return array
    if array.dtype.kind not in "iufb":
        raise ValueError(f"{argument} must be numbers, not {array.dtype}")
    return array.astype(np.float64)


def vectors(value: ArrayLike, argument: str) -> np.ndarray:
    """`value` as an array of shape (n, 3) or (3,). Raises ValueError for other shapes."""
    array = floats(value, argument)
    if array.ndim not in (1, 2) or array.shape[-1] != 3:
        raise ValueError(f"{argument} must have shape (n, 3) or (3,), not {array.shape}")
    return array


def vector(value: ArrayLike, argument: str) -> tuple[float, float, float]:
    """Three finite numbers. Raises ValueError for anything else."""
    array = floats(value, argument)
    if array.shape != (3,) or not np.isfinite(array).all():
        raise ValueError(f"{argument} must be three finite numbers, not {value!r}")
    return tuple(float(x) for x in array)


def in_range(value: int, low: int, high: int, argument: str) -> int:
    """`value`, if it is a whole number from `low` to `high`. Raises ValueError if it is not."""
    if (
        isinstance(value, bool)
        or not isinstance(value, (int, np.integer))
        or not low <= value <= high
    ):
        raise ValueError(f"{argument} must be a whole number from {low} to {high}, not {value!r}")
    return int(value)


def number_in_range(value: float, low: float, high: float, argument: str) -> float:
    """`value`, if it is a number from `low` to `high`. Raises ValueError if it is not."""
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = float("nan")
    if not low <= number <= high:
        raise ValueError(f"{argument} must be a number from {low:g} to {high:g}, not {value!r}")
    return number


def to_vtk(array: np.ndarray, name: str = "") -> vtkDataArray:
    """A VTK array on the memory of `array`, which it keeps alive. A copy only if it is not
    contiguous."""
    result = numpy_to_vtk(np.ascontiguousarray(array))
    if name:
        result.SetName(name)
    return result


def from_vtk(data: vtkFieldData, name: str) -> np.ndarray:
    """The named array as numpy, on VTK's memory, which it keeps alive. Raises KeyError if it is not
    there."""
    array = data.GetArray(name)
    if array is None:
        raise KeyError(name)
    return vtk_to_numpy(array)


def first_row(table: vtkTable) -> dict[str, str | int | float]:
    """The first row of a table: plain values by the columns' names."""
    row = {}
    for column in range(table.GetNumberOfColumns()):
        value = table.GetValue(0, column)
        if value.IsString():
            plain = value.ToString()
        elif value.IsDouble() or value.IsFloat():
            plain = value.ToDouble()
        else:
            plain = value.ToLongLong()
        row[table.GetColumnName(column)] = plain
    return row


def columns(table: vtkTable) -> dict[str, np.ndarray | list[str]]:
    """The columns of a table by their names: numpy arrays, and lists of strings."""
    found: dict[str, np.ndarray | list[str]] = {}
    for i in range(table.GetNumberOfColumns()):
        column = table.GetColumn(i)
        found[column.GetName()] = (
            vtk_to_numpy(column).copy()
            if isinstance(column, vtkDataArray)
            else [column.GetValue(row) for row in range(column.GetNumberOfValues())]
        )
    return found
