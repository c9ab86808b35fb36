# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Operations on meshes in one call, by the filters: arrays in, arrays out; a data set in, a data set out."""

from __future__ import annotations

import functools
import sys
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Optional, Union, overload

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSet, vtkMultiBlockDataSet, vtkPolyData

from .arrays import ID, to_numbers, to_vtk
from .filters import Filter
from .meshes import mesh_of, surface
from .tree import INFINITY, Tree, _count, _length
from .vtkFiltersSkdTree import (vtkSkdTreeBooleanOperation, vtkSkdTreeCompareSurfaces, vtkSkdTreeRemap,
    vtkSkdTreeSurfaceIntersection, vtkSkdTreeWallThickness)

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from numpy.typing import ArrayLike, NDArray

    from .tree import Floats, Ids

    Pair = tuple[ArrayLike, ArrayLike]


class Surface(NamedTuple):
    """A surface of triangles; itself a pair that all functions and Tree take as a mesh."""
    points: Floats  #: (n, 3)
    faces: Ids  #: (m, 3)


class Parts(NamedTuple):
    """The parts of a solid on both sides of a cut, each the closed surface of what is there."""
    front: Any  #: where the normals of the cut point
    behind: Any


class Distances(NamedTuple):
    """Distances from one surface to another, NaN if one of them is empty."""
    hausdorff: float  #: the largest distance found
    hausdorff_bound: float  #: what the exact Hausdorff distance cannot exceed
    mean: float  #: weighted by area, as are the next ones
    rms: float  #: the root of the mean square
    signed_mean: float  #: negative inside; NaN unless asked for
    median: float
    quantile95: float
    start: Floats  #: (3,) where the largest distance is
    end: Floats  #: (3,) the nearest point of the other surface


class Comparison(NamedTuple):
    """Distances between two surfaces: each way, and of both."""
    both: Distances
    a_to_b: Distances
    b_to_a: Distances

    @property
    def hausdorff(self) -> float:
        """The largest distance found, of both ways."""
        return self.both.hausdorff

    @property
    def mean(self) -> float:
        """The mean distance of both ways, weighted by area."""
        return self.both.mean

    @property
    def rms(self) -> float:
        """The root of the mean square of the distances of both ways."""
        return self.both.rms


class Thickness(NamedTuple):
    """One row per point or face; NaN and -1 where nothing is opposite."""
    thickness: Floats  #: (n,)
    point: Floats  #: (n, 3) what is opposite
    cell: Ids  #: (n,) its face


# Solids


@overload
def union(a: Pair, b: Any, *others: Any) -> Surface: ...
@overload
def union(a: Any, b: Any, *others: Any) -> Any: ...
def union(a: Any, b: Any, *others: Any) -> Any:
    """The surface of what is within any of the meshes, closed surfaces or volume meshes.

    Meshes are what Tree takes, or a Tree. The result is exact but for the rounding of its points, and
    closed. It is of the kind of a: a Surface of triangles (points, faces) for arrays, a vtkPolyData for
    a data set, with the arrays of vtkSkdTreeBooleanOperation, a pyvista.PolyData for a mesh of PyVista."""
    return _combined("Union", a, b, *others)


@overload
def intersection(a: Pair, b: Any, *others: Any) -> Surface: ...
@overload
def intersection(a: Any, b: Any, *others: Any) -> Any: ...
def intersection(a: Any, b: Any, *others: Any) -> Any:
    """The surface of what is within all meshes; see union(). Without others, b may be an open surface:
    the result is then what of a is behind it, where its normals do not point."""
    return _combined("Intersection", a, b, *others)


@overload
def difference(a: Pair, b: Any, *others: Any) -> Surface: ...
@overload
def difference(a: Any, b: Any, *others: Any) -> Any: ...
def difference(a: Any, b: Any, *others: Any) -> Any:
    """The surface of what is within a and none of the other meshes; see union(). Without others, b may
    be an open surface: the result is then what of a is in front of it, where its normals point."""
    return _combined("Difference", a, b, *others)


@overload
def symmetric_difference(a: Pair, b: Any, *others: Any) -> Surface: ...
@overload
def symmetric_difference(a: Any, b: Any, *others: Any) -> Any: ...
def symmetric_difference(a: Any, b: Any, *others: Any) -> Any:
    """The surface of what is within an odd number of the meshes, of two in exactly one; see union()."""
    return _combined("SymmetricDifference", a, b, *others)


def split(mesh: Any, cutter: Any) -> Parts:
    """A solid cut in two: both closed parts, in front of the cutter and behind it. Each may have several
    pieces, or none. The cutter is a plane, a pair (origin, normal), or a mesh: an open surface that cuts
    through, or a closed one, whose outside is in front. A data set's parts have the cell array SkdPartId."""
    cut = _Cut(mesh, cutter)
    parts = cut.run("Split")
    if parts.GetFieldData().GetArray("SkdReportPartVolumes").GetNumberOfValues() > 2:
        # Several sheets, behind which are several parts: here they are one.
        return Parts(*(_returned(cut.run(operation), mesh) for operation in ("Difference", "Intersection")))
    return Parts(*(_returned(_part(parts, number), mesh) for number in (0, 1)))


@overload
def section(mesh: Pair, cutter: Any) -> Surface: ...
@overload
def section(mesh: Any, cutter: Any) -> Any: ...
def section(mesh: Any, cutter: Any) -> Any:
    """The part of a cutter (see split()) that is within a solid, with the cutter's normals: triangles for arrays,
    polygons for a data set (those with holes are triangles), with the arrays of vtkSkdTreeBooleanOperation. Where
    it coincides with the surface of the solid it is not within. intersection_curves() gives the outlines."""
    return _returned(_Cut(mesh, cutter).run("Split", 1), mesh)


# Surfaces


@overload
def intersection_curves(a: Pair, b: Any = ...) -> list[Floats]: ...
@overload
def intersection_curves(a: Any, b: Any = ...) -> Any: ...
def intersection_curves(a: Any, b: Any = None) -> Any:
    """The curves in which two surfaces, which may be open, intersect, or a with itself if b is None; b may
    also be a plane, a pair (origin, normal). For arrays it is a list of arrays of points, (n, 3): of closed
    curves the last point is the first, isolated points have n = 1. For data sets it is a vtkPolyData with
    the arrays of vtkSkdTreeSurfaceIntersection. Within areas in which the surfaces coincide there are none."""
    running = Filter(vtkSkdTreeSurfaceIntersection(), {"Input": "a", "Source": "b"})
    mesh, plane = _mesh(a, "a"), _plane_of(b, "b")
    running.take(mesh, _mesh_in_plane(*plane, mesh) if plane else None if b is None else _mesh(b, "b"))
    found = running.output()
    if not _is_arrays(a):
        return _returned(found, a)
    curves = []
    for cells in (found.GetVerts(), found.GetLines()):
        points = _points(found)
        offsets = vtk_to_numpy(cells.GetOffsetsArray())[1:-1] if cells.GetNumberOfCells() else []
        order = vtk_to_numpy(cells.GetConnectivityArray()) if cells.GetNumberOfCells() else []
        curves += [points[ids] for ids in numpy.split(order, offsets) if len(ids)]
    return curves


@overload
def collide(a: Any, b: Any, transform: Optional[ArrayLike] = ..., pairs: Literal[False] = ...) -> bool: ...
@overload
def collide(a: Any, b: Any, transform: Optional[ArrayLike] = ..., *, pairs: Literal[True]) -> Ids: ...
def collide(a: Any, b: Any, transform: Optional[ArrayLike] = None, pairs: bool = False) -> Any:
    """Tree(a).collide(b, transform, pairs): whether two surfaces have a point in common. To test many b, or many
    positions of one, make a Tree of a once, or pass it here."""
    tree: Any = a if isinstance(a, Tree) else Tree(_mesh(a, "a"))
    return tree.collide(_mesh(b, "b"), transform, pairs)


def compare(a: Any, b: Any, signed: bool = False, tolerance: float = 1e-5) -> Comparison:
    """Distances between two surfaces (or sets of points), both ways: the Hausdorff distance, of all points of
    faces, not of vertices only, within tolerance times the size of both; means and quantiles by area, within
    about 1 %. If signed, signed_mean is of distances that are negative inside the other surface."""
    running = Filter(vtkSkdTreeCompareSurfaces(), {"Input": "a", "Source": "b"})
    running.take(_mesh(a, "a"), _mesh(b, "b"))
    running.filter.SetSignedDistance(bool(signed))
    running.filter.SetTolerance(_length(tolerance, "tolerance"))
    table = running.output(2)
    a_to_b, b_to_a, both = (_distances(table, row) for row in range(3))
    return Comparison(both, a_to_b, b_to_a)


def thickness(mesh: Any, at: str = "points", method: str = "rays", rays: int = 1, cone_angle: float = 60.0,
        maximum: float = INFINITY, reversed: bool = False) -> Any:
    """How thick a body is at each point of its surface, or with at="cells" at the middle of each face: by the
    method "rays" along the inverted normal, or as the median of several rays in a cone, or by the largest
    inscribed "spheres"; of a surface whose normals point inwards if reversed. It is a Thickness for arrays;
    for a data set, a copy of it with the arrays SkdThickness, SkdOppositePoint and SkdOppositeCellId."""
    running = Filter(vtkSkdTreeWallThickness(), {"Input": "mesh"})
    measuring = running.filter
    running.take(_mesh(mesh, "mesh"))
    measuring.SetStart(_choice(at, "at", ("points", "cells")))
    measuring.SetMethod(_choice(method, "method", ("rays", "spheres")))
    measuring.SetNumberOfRays(_within(_count(rays, "rays"), "rays", measuring.GetNumberOfRaysMaxValue()))
    measuring.SetConeAngle(_within(_length(cone_angle, "cone_angle"), "cone_angle", measuring.GetConeAngleMaxValue()))
    measuring.SetReversed(bool(reversed))
    measuring.SetMaximumThickness(min(_length(maximum, "maximum"), measuring.GetMaximumThicknessMaxValue()))
    found = running.output()
    if not _is_arrays(mesh):
        return _returned(found, mesh)
    data = found.GetPointData() if at == "points" else found.GetCellData()
    names = ("SkdThickness", "SkdOppositePoint", "SkdOppositeCellId")
    return Thickness(*(vtk_to_numpy(data.GetArray(name)) for name in names))


# Fields


def remap(source: Any, target: Any, arrays: Union[None, Sequence[str], Mapping[str, ArrayLike]] = None,
        method: str = "automatic", on: str = "automatic") -> Any:
    """Fields of a source mesh on a target mesh that has nothing to do with it. arrays are the names of those of a
    data set, all if None, or {name: values}, with one value or row for each point or each face of the source.
    method is "contained", "interpolation", or, conservative by exact overlaps, "first_order" or "second_order";
    on is "cells" or "points"; as vtkSkdTreeRemap chooses if "automatic". For arrays as target it is
    {name: values}, for a data set a copy of it with these arrays; NaN where there is no answer."""
    running = Filter(vtkSkdTreeRemap(), {"Input": "target", "Source": "source"})
    methods = ("automatic", "contained", "interpolation", "first_order", "second_order")
    running.filter.SetMethod(_choice(method, "method", methods))
    running.filter.SetResultsOn(_choice(on, "on", ("automatic", "cells", "points")))
    given = _with_arrays(_mesh(source, "source"), arrays)
    running.take(_mesh(target, "target"), given)
    found = running.output()
    if not _is_arrays(target):
        return _returned(found, target)
    values = {}
    for name in {**_fields(given.GetPointData()), **_fields(given.GetCellData())}:
        for data in (found.GetPointData(), found.GetCellData()):
            if data.GetArray(name) is not None:
                values[name] = vtk_to_numpy(data.GetArray(name))
    return values


# Implementation


class _Boolean(Filter):
    """The Boolean Operation on two meshes. What it finds is kept for the next operation."""

    def __init__(self, a: Any, a_name: str, b: Optional[vtkDataSet], b_name: str) -> None:
        super().__init__(vtkSkdTreeBooleanOperation(), {"Input": a_name, "Source": b_name})
        self.take(_mesh(a, a_name), b)
        self.filter.SetKeepPolygons(not _is_arrays(a))

    def run(self, operation: str, port: int = 0) -> vtkPolyData:
        getattr(self.filter, "SetOperationTo" + operation)()
        return self.output(port)


class _Cut(_Boolean):
    """The same on a mesh and what cuts it, a mesh or a plane."""

    def __init__(self, mesh: Any, cutter: Any) -> None:
        plane = _plane_of(cutter, "cutter")
        super().__init__(mesh, "mesh", None if plane else _mesh(cutter, "cutter"), "cutter")
        if plane:
            self.filter.CutByPlaneOn()
            self.filter.SetPlaneOrigin(*plane[0])
            self.filter.SetPlaneNormal(*plane[1])


def _combined(operation: str, *given: Any) -> Any:
    """The result of an operation on two or more meshes."""
    names = ["a", "b"] + [f"others[{i}]" for i in range(len(given) - 2)]
    meshes = [_mesh(mesh, name) for mesh, name in zip(given, names)]
    if len(meshes) > 2 and all(map(_has_faces, meshes)):
        combined = _combined_at_once(operation, meshes, names, _is_arrays(given[0]))
        if combined.GetFieldData().GetArray("SkdReportSolids").GetValue(0) == len(meshes):
            return _returned(combined, given[0])
    # A block without faces that have an area is no solid for the filter, but such a Source is an empty one.
    combined = meshes[0]
    for mesh, name in zip(meshes[1:], names[1:]):
        pair = _Boolean(combined, "a", mesh, name)
        pair.filter.SetKeepPolygons(not _is_arrays(given[0]))
        combined = pair.run(operation)
    return _returned(combined, given[0])


def _combined_at_once(operation: str, meshes: list[vtkDataSet], names: list[str], triangles: bool) -> Any:
    """The result of an operation on more than two meshes, as blocks, each of which is a solid."""
    running = Filter(vtkSkdTreeBooleanOperation(), {f"Solid {i}": name for i, name in enumerate(names)})
    blocks = vtkMultiBlockDataSet()
    for i, mesh in enumerate(meshes):
        blocks.SetBlock(i, mesh)
    running.filter.SetInputDataObject(blocks)
    running.filter.SetKeepPolygons(not triangles)
    getattr(running.filter, "SetOperationTo" + operation)()
    return running.output()


def _part(parts: vtkPolyData, number: int) -> vtkPolyData:
    """A part of a split, whose faces and points follow each other, with its volume as the report."""
    part = vtkPolyData()
    volumes = parts.GetFieldData().GetArray("SkdReportPartVolumes")
    if number < volumes.GetNumberOfValues():
        volume = numpy_to_vtk(numpy.array([volumes.GetValue(number)]), deep=True)
        volume.SetName("SkdReportVolume")
        part.GetFieldData().AddArray(volume)
    ids = parts.GetCellData().GetArray("SkdPartId")
    first, last = numpy.searchsorted([] if ids is None else vtk_to_numpy(ids), [number, number + 1])
    if first == last:
        return part
    offsets = vtk_to_numpy(parts.GetPolys().GetOffsetsArray())[first:last + 1]
    corners = vtk_to_numpy(parts.GetPolys().GetConnectivityArray())[offsets[0]:offsets[-1]]
    low, high = int(corners.min()), int(corners.max()) + 1
    cells, points = vtkCellArray(), vtkPoints()
    cells.SetData(*(numpy_to_vtkIdTypeArray((of - of_first).astype(ID), deep=True)
        for of, of_first in ((offsets, offsets[0]), (corners, low))))
    points.SetData(numpy_to_vtk(_points(parts)[low:high], deep=True))
    part.SetPoints(points)
    part.SetPolys(cells)
    for get, start, count in (("GetPointData", low, high - low), ("GetCellData", int(first), int(last - first))):
        data = getattr(part, get)()
        data.CopyAllOn()
        data.CopyAllocate(getattr(parts, get)(), count)
        data.CopyData(getattr(parts, get)(), 0, count, start)
    return part


def _has_faces(mesh: vtkDataSet) -> bool:
    return any(mesh.GetCell(i).GetCellDimension() >= 2 for i in range(mesh.GetNumberOfCells()))


def _mesh(mesh: Any, name: str) -> vtkDataSet:
    """mesh_of(), also of a Tree; errors name the argument."""
    if isinstance(mesh, Tree):
        return mesh.mesh
    try:
        return mesh_of(mesh, name)
    except (TypeError, ValueError) as error:
        if str(error).startswith(name + " "):
            raise
        raise type(error)(f"{name}: {error}") from None


def _given(mesh: Any) -> Any:
    """What the caller has: of a Tree, its mesh."""
    return mesh.mesh if isinstance(mesh, Tree) else mesh


def _is_arrays(mesh: Any) -> bool:
    """Whether an argument is no VTK object, so that results are arrays."""
    mesh = _given(mesh)
    return not hasattr(mesh, "IsA") and not hasattr(mesh, "VTKObject")


def _returned(output: Any, like: Any) -> Any:
    """A data set as what the caller has: arrays, a mesh of PyVista or a data set."""
    if _is_arrays(like):
        return Surface(*_triangles(output))
    if any(kind.__module__.split(".")[0] == "pyvista" for kind in type(_given(like)).__mro__):
        return sys.modules["pyvista"].wrap(output)
    return output


def _points(mesh: vtkPolyData) -> Any:
    return vtk_to_numpy(mesh.GetPoints().GetData()) if mesh.GetNumberOfPoints() else numpy.empty((0, 3))


def _triangles(mesh: vtkPolyData) -> tuple[Any, Any]:
    """The points and faces of a surface of triangles."""
    if mesh.GetNumberOfPolys() == 0:
        return numpy.empty((0, 3)), numpy.empty((0, 3), ID)
    faces = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return _points(mesh), faces.astype(ID, copy=False)


def _plane_of(cutter: Any, name: str) -> Optional[tuple[Any, Any]]:
    """The origin and the unit normal of a plane; None of what is none."""
    if not (isinstance(cutter, (tuple, list)) and len(cutter) == 2
            and all(numpy.size(part) == 3 and numpy.ndim(part) == 1 for part in cutter)):
        return None
    origin, normal = (to_numbers(part, name).astype(float) for part in cutter)
    length = float(numpy.linalg.norm(normal / (abs(normal).max() or 1.0)))
    if not (numpy.isfinite(origin).all() and numpy.isfinite(length) and length > 0.0):
        raise ValueError(f"{name} is a plane (origin, normal) = {cutter!r}: finite numbers are needed, and a normal "
            "that is not 0")
    return origin, normal / abs(normal).max() / length


def _mesh_in_plane(origin: Any, normal: Any, mesh: vtkDataSet) -> vtkPolyData:
    """A triangle in a plane, with twice the room that a mesh needs there."""
    if mesh.GetNumberOfPoints() == 0:
        return vtkPolyData()
    to_middle = numpy.array(mesh.GetCenter()) - origin
    # Offsets along a plane that is normal to an axis are exactly 0 along that axis.
    middle = origin + (to_middle - normal * (normal @ to_middle))
    first = numpy.cross(normal, numpy.eye(3)[abs(normal).argmin()])
    first /= numpy.linalg.norm(first)
    second = numpy.cross(normal, first)
    size = 2.0 * (mesh.GetLength() or 1.0)  # twice the inner radius, which is the diagonal
    corners = [middle + size * (numpy.cos(angle) * first + numpy.sin(angle) * second)
        for angle in 2.0 * numpy.pi / 3.0 * numpy.arange(3)]
    return surface(numpy.array(corners), [[0, 1, 2]])


def _distances(table: Any, row: int) -> Distances:
    """A row of the table of Compare Surfaces."""
    if table.GetNumberOfRows() <= row:
        nothing: list[Any] = [numpy.nan] * 7 + [numpy.full(3, numpy.nan)] * 2
        return Distances(*nothing)
    names = ("HausdorffDistance", "HausdorffUpperBound", "Mean", "RootMeanSquare", "SignedMean", "Median", "Quantile95")
    numbers: list[Any] = [table.GetColumnByName(name).GetValue(row) for name in names]
    places: list[Any] = [numpy.array(table.GetColumnByName(name).GetTuple(row)) for name in ("From", "To")]
    return Distances(*numbers, *places)


def _fields(data: Any) -> dict[str, Any]:
    """The arrays of numbers of point or cell data."""
    arrays = (data.GetArray(i) for i in range(data.GetNumberOfArrays()))
    return {array.GetName(): array for array in arrays if array is not None and array.GetName()}


def _with_arrays(mesh: vtkDataSet, arrays: Any) -> vtkDataSet:
    """A mesh with those of its arrays that are named, or with the given ones."""
    if arrays is None:
        return mesh
    if isinstance(arrays, str):
        raise TypeError(f"arrays is {arrays!r}: a list of names, or {{name: values}}, is needed")
    made = mesh.NewInstance()
    made.CopyStructure(mesh)
    for get in ("GetPointData", "GetCellData"):
        marks = getattr(mesh, get)().GetArray("vtkGhostType")
        if marks is not None:
            getattr(made, get)().AddArray(marks)
    for name in arrays:
        if hasattr(arrays, "keys"):
            _add_values(made, name, arrays[name])
        else:
            _add_named(made, name, mesh)
    made._skd_mesh = mesh  # whose arrays of corners and points are shared
    return made


def _add_named(made: vtkDataSet, name: str, mesh: vtkDataSet) -> None:
    found = False
    for get in ("GetPointData", "GetCellData"):
        array = _fields(getattr(mesh, get)()).get(name)
        if array is not None:
            getattr(made, get)().AddArray(array)
            found = True
    if not found:
        known = [*_fields(mesh.GetPointData()), *_fields(mesh.GetCellData())]
        raise KeyError(f"source has no array of numbers {name!r}, but {known}")


def _add_values(made: vtkDataSet, name: str, values: Any) -> None:
    given = to_numbers(values, f"arrays[{name!r}]")
    sizes = {"points": made.GetNumberOfPoints(), "cells": made.GetNumberOfCells()}
    fitting = [part for part, size in sizes.items() if given.ndim in (1, 2) and len(given) == size]
    if len(fitting) != 1:
        raise ValueError(f"arrays[{name!r}] has the shape {given.shape}: one value or row for each of "
            f"{sizes['points']} points or of {sizes['cells']} cells is needed" + (
            "; whose they are is not clear: pass a data set with the array" if fitting else ""))
    array = to_vtk(given)
    array.SetName(name)
    (made.GetPointData() if fitting == ["points"] else made.GetCellData()).AddArray(array)


def _choice(value: Any, name: str, choices: tuple[str, ...]) -> int:
    if value not in choices:
        raise ValueError(f"{name} is {value!r}, one of {choices} is needed")
    return choices.index(value)


def _within(value: Any, name: str, highest: Any) -> Any:
    if value > highest:
        raise ValueError(f"{name} is {value}, at most {highest} is possible")
    return value
