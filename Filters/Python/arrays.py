# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Conversion between numpy arrays and VTK arrays, with shared memory where possible."""

from __future__ import annotations

import inspect
from typing import Any, Optional

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkIdTypeArray

from .vtkFiltersSkdTree import vtkSkdTreeCellLocator

ID = numpy.dtype(f"i{vtkIdTypeArray().GetDataTypeSize()}")
FLOAT = numpy.dtype(numpy.float64)


def to_numbers(value: Any, name: str) -> numpy.ndarray:
    """A contiguous array of a type that VTK supports: the given one if possible, else a copy. Raises
    TypeError unless it holds numbers."""
    array = value if isinstance(value, numpy.ndarray) else numpy.asarray(value)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name} holds {array.dtype} ({type(value).__name__}): "
            "numbers are needed, best of float64")
    if array.dtype.kind == "f" and array.dtype.itemsize not in (4, 8):
        array = array.astype(FLOAT)
    if not array.dtype.isnative:
        array = array.astype(array.dtype.newbyteorder("="))
    return numpy.ascontiguousarray(array)


def to_rows(value: Any, name: str, columns: int, hint: str = "") -> numpy.ndarray:
    """to_numbers() with the shape (n, columns); raises ValueError for any other. [] has no rows."""
    array = to_numbers(value, name)
    if array.shape == (0, ):
        array = array.reshape(0, columns)
    if array.ndim != 2 or array.shape[1] != columns:
        if array.shape == (columns, ):
            hint = f": for a single one write [{name}]"
        raise ValueError(f"{name} has the shape {array.shape}, (n, {columns}) is needed{hint}")
    return array


def to_vtk(array: numpy.ndarray) -> Any:
    """A VTK array that shares the memory of an array and keeps it alive."""
    if array.dtype == ID:
        return numpy_to_vtkIdTypeArray(array)
    return numpy_to_vtk(array)


def output(array: numpy.ndarray, name: str) -> Any:
    """A VTK array for results that shares the memory of an array."""
    if array.dtype not in (ID, FLOAT):
        raise TypeError(f"{name} holds {array.dtype}: ids are {ID}, all else is {FLOAT}")
    if not (array.flags.c_contiguous and array.flags.writeable):
        raise ValueError(f"{name} is {'not contiguous' if array.flags.writeable else 'read-only'}: "
            "no answer can be written to it")
    return to_vtk(array)


def check_outputs(arrays: list[tuple[str, Optional[numpy.ndarray], Any]]) -> None:
    """Raises ValueError if a result (name, array, VTK array) has another shape than its array. VTK has
    then allocated other memory, or filled only a part."""
    for name, array, written in arrays:
        rows, columns = written.GetNumberOfTuples(), written.GetNumberOfComponents()
        shape = (rows, ) if columns == 1 else (rows, columns)
        if array is not None and array.shape not in (shape, (rows, columns)):
            raise ValueError(f"{name} has the shape {array.shape}, {shape} is needed")


class Locator(vtkSkdTreeCellLocator):
    """vtkSkdTreeCellLocator with numpy arrays in place of VTK arrays, as queries and as outputs of
    batches: FindClosestPoints(points, ids, None, distances), for example, fills the arrays ids (of
    the type of vtkIdType, usually int64) and distances (float64). An output whose shape is not that of
    the result raises a ValueError with the required shape. For lists, whose lengths are not known in
    advance, pass vtkIdTypeArray and vtkDoubleArray, or None: the method returns the length."""


def _batch(name: str, queries: int) -> Any:
    """The named method for numpy arrays; its first `queries` arguments are queries."""
    wrapped = getattr(vtkSkdTreeCellLocator, name)

    def method(self: Locator, *arguments: Any) -> int:
        converted, outputs = [], []
        for number, argument in enumerate(arguments):
            if isinstance(argument, numpy.ndarray):
                label = f"{name}: argument {number + 1}"
                if number < queries:
                    argument = to_vtk(to_numbers(argument, label))
                else:
                    array, argument = argument, output(argument, label)
                    outputs.append((label, array, argument))
            converted.append(argument)
        found = wrapped(self, *converted)
        if found >= 0:
            check_outputs(outputs)
        return found

    method.__name__ = name
    method.__qualname__ = f"Locator.{name}"
    method.__doc__ = inspect.getdoc(wrapped)
    return method


for _name, _queries in {"FindClosestPoints": 1, "FindClosestNCells": 1, "FindCells": 1,
        "FindCellsAndWeights": 1, "IntersectWithLines": 1, "FindAllHits": 1, "IntersectWithSegments": 2,
        "FindAllSegmentHits": 2, "IntersectWithRays": 2, "FindAllRayHits": 2, "FindCellsWithinBoxes": 1, "FindCellsWithinSpheres": 1,
        "FindPairs": 0}.items():
    setattr(Locator, _name, _batch(_name, _queries))
