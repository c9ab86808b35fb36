# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Spatial queries on a mesh for numpy arrays: Tree, and the named tuples that it returns."""

from __future__ import annotations

import operator
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Optional, overload

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4

from .arrays import FLOAT, ID, Locator, check_outputs, output, to_numbers, to_rows, to_vtk
from .filters import Filter, Messages, use_all_processors
from .meshes import from_text, mesh_of, to_text, vtk_points
from .vtkFiltersSkdTree import (vtkSkdTreeClosestPoint, vtkSkdTreePointInOut, vtkSkdTreeProbe,
    vtkSkdTreeRays, vtkSkdTreeSurfaceIntersection)

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Ids = NDArray[numpy.int64]
    Floats = NDArray[numpy.float64]

INFINITY = float("inf")
FARTHEST = vtkSkdTreeClosestPoint().GetMaximumDistanceMaxValue()  # that the filter takes


def _queries_of(lists: Any) -> Ids:
    """The index of the query to which each row of the lists belongs."""
    return numpy.repeat(numpy.arange(len(lists.offsets) - 1), numpy.diff(lists.offsets))


class Closest(NamedTuple):
    """One row per query; NaN and -1 if nothing is within the maximum distance."""
    point: Floats  #: (n, 3) the nearest point on the mesh
    distance: Floats  #: (n,)
    cell: Ids  #: (n,) the cell of that point, the lowest id if there are several


class Nearest(NamedTuple):
    """One row per query, nearest first; NaN and -1 where there are fewer than k."""
    distance: Floats  #: (n, k)
    cell: Ids  #: (n, k)


class Cells(NamedTuple):
    """One row per query; -1 and NaN if no cell contains the point. m is the number of points of the
    largest cell of the mesh; for smaller cells, point_ids is filled up with -1 and weights with 0."""
    cell: Ids  #: (n,)
    pcoords: Floats  #: (n, 3) parametric coordinates
    point_ids: Ids  #: (n, m) the cell's points
    weights: Floats  #: (n, m) interpolation weights of these


class RayHits(NamedTuple):
    """The first hit of each ray; -1 and NaN for rays without a hit."""
    cell: Ids  #: (n,)
    distance: Floats  #: (n,) from the origin, in the units of the coordinates
    point: Floats  #: (n, 3)


class RayHitLists(NamedTuple):
    """All hits: those of ray i are rows offsets[i]:offsets[i + 1] of the other arrays."""
    offsets: Ids  #: (n + 1,)
    cell: Ids  #: (m,)
    distance: Floats  #: (m,) from the origin, ascending for each ray
    point: Floats  #: (m, 3)

    @property
    def query(self) -> Ids:
        """(m,) the ray of each hit"""
        return _queries_of(self)


class SegmentHits(NamedTuple):
    """The first hit of each segment; -1 and NaN for segments without a hit."""
    cell: Ids  #: (n,)
    parameter: Floats  #: (n,) 0 at the start, 1 at the end
    point: Floats  #: (n, 3)


class SegmentHitLists(NamedTuple):
    """All hits: those of segment i are rows offsets[i]:offsets[i + 1] of the other arrays."""
    offsets: Ids  #: (n + 1,)
    cell: Ids  #: (m,)
    parameter: Floats  #: (m,) 0 at the start, 1 at the end, ascending for each segment
    point: Floats  #: (m, 3)

    @property
    def query(self) -> Ids:
        """(m,) the segment of each hit"""
        return _queries_of(self)


class CellLists(NamedTuple):
    """A list of cells per query: cell[offsets[i]:offsets[i + 1]] for query i."""
    offsets: Ids  #: (n + 1,)
    cell: Ids  #: (m,)

    @property
    def query(self) -> Ids:
        """(m,) the query of each cell"""
        return _queries_of(self)


class NearLists(NamedTuple):
    """A list of cells and distances per query: rows offsets[i]:offsets[i + 1] for query i."""
    offsets: Ids  #: (n + 1,)
    cell: Ids  #: (m,) ascending for each query
    distance: Floats  #: (m,)

    @property
    def query(self) -> Ids:
        """(m,) the query of each cell"""
        return _queries_of(self)


class Tree:
    """Spatial queries on a mesh, by its skD-tree, for numpy arrays of points, rays or boxes.

    mesh may be

    - a vtkDataSet (PyVista's meshes are data sets), or a VTK reader, source or filter;
    - a pair (points, faces), a tuple or a list, of arrays: points with the shape (n, 3), faces with the
      shape (m, 3), triangles, or (m, 4), quadrilaterals, or all faces in one row, each after its number
      of points (as PyVista has them);
    - an object that has such arrays as .vertices and .faces (like trimesh's meshes) or .triangles
      (like Open3D's);
    - an array of points with the shape (n, 3): cell i is then point i.

    Data sets, points of type float64 or float32 and faces of type int64 with the shape (m, 3) or (m, 4)
    are not copied; call update() after changing them.

    Queries are arrays (or lists) of numbers, one row per query; contiguous arrays are not copied.
    Results are named tuples of arrays in the order of the queries, with the ids of cells and points
    in the VTK data set. Queries that are not finite find nothing. Queries run on all processors;
    results do not depend on their number. Where a method has a parameter out, it writes to the arrays
    of this earlier result, which must have the same shapes, instead of allocating new ones.

    Queries of wrong shape raise ValueError, queries of wrong type TypeError. Warnings of VTK, for
    example about a surface that is not closed, become Python warnings, errors RuntimeError.

    Trees can be pickled and copied: with the mesh and the settings of the locator; the tree is built
    again when it is needed. Only copy.copy() shares the mesh.

    The first query builds the tree, in O(N log N). signed_distance(), contains(), winding_number() and
    interpolate() build trees of their own on first use.
    """

    mesh: vtkDataSet  #: the mesh
    locator: Locator  #: its locator, for settings and single queries

    def __init__(self, mesh: Any) -> None:
        use_all_processors()
        self.mesh = mesh_of(mesh, "mesh")
        self._messages = Messages(("the points", "the mesh"), {"Source": "the mesh"})
        self._filters: dict[Any, Any] = {}
        self.locator = self._messages.hear(Locator())
        self.locator.SetDataSet(self.mesh)

    def __len__(self) -> int:
        """The number of cells of the mesh."""
        return self.mesh.GetNumberOfCells()

    def __repr__(self) -> str:
        return f"Tree({self.mesh.GetClassName()} of {len(self)} cells)"

    def __getstate__(self) -> dict[str, Any]:
        state = {name: getattr(self.locator, "Get" + name)() for name in _SETTINGS}
        motion = self.locator.GetTransform()
        if motion is not None:
            state["Transform"] = [motion.GetElement(i, j) for i in range(4) for j in range(4)]
        return {"mesh": to_text(self.mesh), "settings": state}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__init__(from_text(*state["mesh"]))  # type: ignore[misc]
        self._set(dict(state["settings"]))

    def __copy__(self) -> Tree:
        copied = Tree(self.mesh)
        copied.locator.ShallowCopy(self.locator)
        return copied

    def _set(self, settings: dict[str, Any]) -> None:
        """Settings of the locator, by name."""
        transform = settings.pop("Transform", None)
        for name, value in settings.items():
            getattr(self.locator, "Set" + name)(value)
        if transform is not None:
            motion = vtkMatrix4x4()
            motion.DeepCopy(transform)
            self.locator.SetTransform(motion)

    def update(self) -> None:
        """Must be called after points or cells were changed in place: the next query rebuilds the tree."""
        points = getattr(self.mesh, "GetPoints", lambda: None)()
        if points is not None:
            points.Modified()
        self.mesh.Modified()

    # Nearest cells

    def closest(self, points: ArrayLike, maximum: float = INFINITY,
            out: Optional[Closest] = None) -> Closest:
        """The nearest point of the mesh to each point, at a distance of at most maximum."""
        at = to_vtk(to_rows(points, "points", 3))
        return self._run(Closest, out, lambda point, distance, cell: (
            self.locator.FindClosestPoints(at, cell, point, distance, _length(maximum, "maximum"))))

    def k_nearest(self, points: ArrayLike, k: int, maximum: float = INFINITY,
            out: Optional[Nearest] = None) -> Nearest:
        """The k nearest cells to each point, at a distance of at most maximum; ties by id."""
        at = to_vtk(to_rows(points, "points", 3))
        k = _count(k, "k")
        found = self._run(Nearest, out, lambda distance, cell: (
            self.locator.FindClosestNCells(at, k, cell, distance, _length(maximum, "maximum"))))
        return found if found.cell.ndim == 2 else Nearest(*(a.reshape(-1, k) for a in found))

    def within(self, points: ArrayLike, radius: ArrayLike) -> NearLists:
        """All cells at a distance of at most radius (one number, or one per point) of each point."""
        at = to_rows(points, "points", 3)
        radii = to_numbers(radius, "radius")
        if radii.shape not in ((), (1, ), (len(at), )):
            raise ValueError(f"radius has the shape {radii.shape}, () or ({len(at)},) is needed")
        if not (radii >= 0).all():
            raise ValueError(f"radius is {radii.min()}, it must not be negative")
        spheres = numpy.empty((len(at), 4))
        spheres[:, :3] = at
        spheres[:, 3] = radii
        return self._run(NearLists, None, lambda offsets, cell, distance: (
            self.locator.FindCellsWithinSpheres(to_vtk(spheres), offsets, cell, distance)))

    # Lines

    @overload
    def rays(self, origins: ArrayLike, directions: ArrayLike, maximum: float = ...,
        all_hits: Literal[False] = ..., out: Optional[RayHits] = ...) -> RayHits: ...

    @overload
    def rays(self, origins: ArrayLike, directions: ArrayLike, maximum: float = ..., *,
        all_hits: Literal[True]) -> RayHitLists: ...

    def rays(self, origins: ArrayLike, directions: ArrayLike, maximum: float = INFINITY,
            all_hits: bool = False, out: Optional[RayHits] = None) -> Any:
        """The first hit of each ray, or all hits, at a distance of at most maximum from its origin.
        directions has one row per ray, or is one direction for all; their lengths do not matter.

        A ray hits each cell at most once. Several cells at one place, as at a shared edge, are one hit
        of the first of them: places closer than 1e-9 of the diagonal of the mesh's bounds are one, as
        in vtkSkdTreeRays. locator.FindAllRayHits() has a hit for each cell."""
        start = to_rows(origins, "origins", 3)
        along = to_numbers(directions, "directions")
        if along.shape == (3, ):
            along = numpy.ascontiguousarray(numpy.broadcast_to(along, (len(start), 3)))
        along = to_rows(along, "directions", 3)
        if len(along) != len(start):
            raise ValueError(f"origins has {len(start)} rows, but directions has {len(along)}")
        limit = _length(maximum, "maximum")
        start, along = to_vtk(start), to_vtk(along)
        if all_hits:
            found = self._run(RayHitLists, _none(out), lambda offsets, cell, distance, point: (
                self.locator.FindAllRayHits(start, along, offsets, cell, distance, point, limit)))
            return _merged(found, found.distance, self._tolerance(vtk_to_numpy(start)))
        return self._run(RayHits, out, lambda cell, distance, point: (
            self.locator.IntersectWithRays(start, along, cell, distance, point, limit)))

    @overload
    def segments(self, starts: ArrayLike, ends: Optional[ArrayLike] = ...,
        all_hits: Literal[False] = ..., out: Optional[SegmentHits] = ...) -> SegmentHits: ...

    @overload
    def segments(self, starts: ArrayLike, ends: Optional[ArrayLike] = ..., *,
        all_hits: Literal[True]) -> SegmentHitLists: ...

    def segments(self, starts: ArrayLike, ends: Optional[ArrayLike] = None,
            all_hits: bool = False, out: Optional[SegmentHits] = None) -> Any:
        """The first hit of each segment from starts to ends, or all hits, of which those at one place
        are one as in rays(). Without ends, starts holds both, with the shape (n, 2, 3) or (n, 6)."""
        if ends is None:
            both = _lines(starts)
            start, end = both[:, :3], both[:, 3:]
            queries: tuple[Any, ...] = (to_vtk(both), )
            find_all, find_first = self.locator.FindAllHits, self.locator.IntersectWithLines
        else:
            start, end = to_rows(starts, "starts", 3), to_rows(ends, "ends", 3)
            if len(start) != len(end):
                raise ValueError(f"starts has {len(start)} rows, but ends has {len(end)}")
            queries = (to_vtk(start), to_vtk(end))
            find_all = self.locator.FindAllSegmentHits
            find_first = self.locator.IntersectWithSegments
        if all_hits:
            found = self._run(SegmentHitLists, _none(out), lambda offsets, cell, parameter, point: (
                find_all(*queries, offsets, cell, parameter, point)))
            length = numpy.linalg.norm(end.astype(FLOAT) - start, axis=1)
            return _merged(found, found.parameter * length[found.query], self._tolerance(start))
        return self._run(SegmentHits, out, lambda cell, parameter, point: (
            find_first(*queries, cell, parameter, point)))

    # Cells at places

    def find_cells(self, points: ArrayLike, tolerance: float = 0.0,
            out: Optional[Cells] = None) -> Cells:
        """The cell that contains each point, or the nearest one at a distance of at most tolerance,
        with parametric coordinates and interpolation weights: for values v at the points of the mesh,
        the interpolated ones are (v[found.point_ids] * found.weights).sum(1)."""
        at = to_vtk(to_rows(points, "points", 3))
        reach2 = _length(tolerance, "tolerance")**2
        found = self._run(Cells, out, lambda cell, pcoords, point_ids, weights: (
            self.locator.FindCellsAndWeights(at, cell, pcoords, point_ids, weights, reach2)))
        rows = (len(found.cell), -1 if len(found.cell) else 1)  # where all cells are points, too
        return Cells(*found[:2], *(array.reshape(rows) for array in found[2:]))

    def interpolate(self, name: str, points: ArrayLike, outside: bool = False) -> NDArray[Any]:
        """The values of an array of the mesh at points: interpolated point data, or else cell data. A
        point outside all cells gets NaN, or 0 in integer arrays, unless outside is true: then it gets
        the values at the nearest point of the mesh. Raises KeyError if there is no such array."""
        if not isinstance(name, str):
            raise TypeError(f"name is {name!r}: the name of an array, a str, is needed")
        source = self.mesh.NewInstance()
        source.CopyStructure(self.mesh)
        for get in ("GetPointData", "GetCellData"):
            array = getattr(self.mesh, get)().GetArray(name)
            if array is not None:
                getattr(source, get)().AddArray(array)
                for ghosts in ("GetPointData", "GetCellData"):
                    marks = getattr(self.mesh, ghosts)().GetArray("vtkGhostType")
                    if marks is not None:
                        getattr(source, ghosts)().AddArray(marks)
                values, = self._filter(vtkSkdTreeProbe, points, [name], source=source,
                    OutsidePoints=vtkSkdTreeProbe.NEAREST_CELL if outside else vtkSkdTreeProbe.LEAVE)
                return values
        known = [data.GetArrayName(i) for data in (self.mesh.GetPointData(), self.mesh.GetCellData())
            for i in range(data.GetNumberOfArrays())]
        raise KeyError(f"the mesh has no array of numbers {name!r}, but {known}")

    def in_boxes(self, boxes: ArrayLike) -> CellLists:
        """The cells whose bounds overlap each box. boxes has the shape (n, 2, 3), lowest and highest
        corners, or (n, 6), bounds as in VTK: xmin, xmax, ymin, ymax, zmin, zmax (not copied)."""
        given = to_numbers(boxes, "boxes")
        if given.shape[1:] == (2, 3):
            given = given.transpose(0, 2, 1).reshape(-1, 6)
        bounds = to_vtk(to_rows(given, "boxes", 6, ", or (n, 2, 3)"))
        return self._run(CellLists, None, lambda offsets, cell: (
            self.locator.FindCellsWithinBoxes(bounds, offsets, cell)))

    def pairs(self, other: Any) -> CellLists:
        """For each cell of this mesh, the cells of another one (a Tree, or a mesh as for Tree) whose
        bounds overlap its own."""
        if not isinstance(other, Tree):
            other = Tree(mesh_of(other, "other"))
        return self._run(CellLists, None, lambda offsets, cell: (
            self.locator.FindPairs(other.locator, offsets, cell)))

    @overload
    def collide(self, other: Any, transform: Optional[ArrayLike] = ...,
        pairs: Literal[False] = ...) -> bool: ...

    @overload
    def collide(self, other: Any, transform: Optional[ArrayLike] = ..., *, pairs: Literal[True]) -> Ids: ...

    def collide(self, other: Any, transform: Optional[ArrayLike] = None, pairs: bool = False) -> Any:
        """Whether the surfaces of this mesh and another one (a Tree, or a mesh as for Tree) have a point in
        common, by exact tests of their triangles; or, with pairs, the cells that have, as rows (cell,
        cell of the other one), ascending. The other one is moved first by a rigid transform, of the shape
        (4, 4). One body within the other does not collide: see contains()."""
        if "collide" not in self._filters:
            self._filters["collide"] = Filter(
                vtkSkdTreeSurfaceIntersection(), {"Input": "the mesh", "Source": "other"})
        running = self._filters["collide"]
        running.take(self.mesh, other.mesh if isinstance(other, Tree) else mesh_of(other, "other"))
        running.filter.SetTransform(_matrix(transform, "transform"))
        running.filter.SetPairs(running.filter.ALL_PAIRS if pairs else running.filter.WHETHER_ANY)
        table = running.output(2)
        if not pairs:
            return table.GetNumberOfRows() > 0
        columns = [table.GetColumnByName(name) for name in ("SkdFirstCellId", "SkdSecondCellId")]
        if None in columns:
            return numpy.empty((0, 2), ID)
        return numpy.stack([vtk_to_numpy(column) for column in columns], 1)

    # Inside or outside

    def signed_distance(self, points: ArrayLike, maximum: float = INFINITY) -> Closest:
        """The nearest point on the boundary of the mesh (the outer faces of its volume cells, or else
        its surface cells), with a distance that is negative inside. The sign is exact for closed
        surfaces of any orientation. For others there is a warning, and gaps are closed first, as in
        contains()."""
        limit = min(_length(maximum, "maximum"), FARTHEST)
        return Closest(*self._filter(vtkSkdTreeClosestPoint, points,
            ["SkdClosestPoint", "SkdDistance", "SkdClosestCellId"], SignedDistance=True,
            MaximumDistance=limit))

    def contains(self, points: ArrayLike) -> NDArray[numpy.bool_]:
        """Whether each point is inside the boundary of the mesh. This is exact for closed surfaces of
        any orientation. For others there is a warning: small gaps are closed first; where they are
        large, the winding number decides. Points near gaps may be classified wrongly."""
        inside, = self._filter(vtkSkdTreePointInOut, points, ["SkdInside"])
        return inside.view(numpy.bool_)

    def winding_number(self, points: ArrayLike, tolerance: float = 0.25) -> Floats:
        """The generalized winding number of the boundary of the mesh at each point: 1 inside a closed
        surface with outward normals, 0 outside, and values in between near gaps. The error is at most
        tolerance, typically a hundredth of it; tolerance 0 sums over all triangles."""
        number, = self._filter(vtkSkdTreePointInOut, points, ["SkdWindingNumber"],
            Method=vtkSkdTreePointInOut.WINDING_NUMBER, WindingTolerance=_length(tolerance, "tolerance"))
        return number

    # Implementation

    def _run(self, kind: Any, out: Any, batch: Any) -> Any:
        """Calls batch with one VTK array per field of a kind of result, and returns the result."""
        if out is None:
            arrays = [vtkIdTypeArray() if name in _IDS else vtkDoubleArray() for name in kind._fields]
        else:
            if not isinstance(out, (tuple, list)):
                raise TypeError(f"out is {type(out).__name__}: an earlier result is needed, a {kind.__name__}")
            if len(out) != len(kind._fields):
                raise ValueError(f"out has {len(out)} arrays, a {kind.__name__} has {kind._fields}")
            for name, array in zip(kind._fields, out):
                if not isinstance(array, numpy.ndarray) or array.dtype != (ID if name in _IDS else FLOAT):
                    raise TypeError(f"out.{name} is no array of {ID if name in _IDS else FLOAT}")
            arrays = [output(array, f"out.{name}") for name, array in zip(kind._fields, out)]
        batch(*arrays)
        self._messages.raise_them()
        if out is None:
            return kind(*map(vtk_to_numpy, arrays))
        check_outputs([(f"out.{name}", array, written)
            for name, array, written in zip(kind._fields, out, arrays)])
        return kind(*out)

    def _tolerance(self, starts: numpy.ndarray) -> float:
        """Hits within this distance are one, as for vtkSkdTreeRays: its own, and that of rounding."""
        bounds = numpy.array(self.mesh.GetBounds()).reshape(3, 2)
        if not (bounds[:, 0] <= bounds[:, 1]).all():
            return 0.0
        known = starts[numpy.isfinite(starts)]
        largest = max(abs(bounds).max(), abs(known).max() if known.size else 0.0)
        return float(max(vtkSkdTreeRays().GetTolerance() * numpy.linalg.norm(bounds[:, 1] - bounds[:, 0]),
            8 * numpy.finfo(FLOAT).eps * largest))

    def _filter(self, kind: Any, points: ArrayLike, names: list[str],
            source: Optional[vtkDataSet] = None, **properties: Any) -> list[Any]:
        """Point arrays of the output of a filter for points. Filters are kept, with their trees."""
        queries = vtkPolyData()
        queries.SetPoints(vtk_points(to_rows(points, "points", 3)))
        key = (kind, properties.get("Method"))
        if key not in self._filters:
            self._filters[key] = self._messages.hear(kind())
        made = self._filters[key]
        made.SetSourceData(self.mesh if source is None else source)
        for name, value in properties.items():
            getattr(made, "Set" + name)(value)
        made.SetInputData(queries)
        made.Update()
        output = made.GetOutputDataObject(0)
        answers = [vtk_to_numpy(output.GetPointData().GetArray(name)) for name in names]
        output.Initialize()  # releases all other arrays
        made.SetInputData(vtkPolyData())
        self._messages.raise_them()
        return answers


_IDS = {"cell", "offsets", "point_ids"}
_SETTINGS = ("Epsilon", "LazyBuild", "SplitRule", "SkipGhostCells", "NumberOfCellsPerNode",
    "CacheCellBounds", "UseExistingSearchStructure")


def _merged(found: Any, places: numpy.ndarray, tolerance: float) -> Any:
    """Lists of hits, sorted along each line, with one hit for those within a tolerance of its first."""
    first = numpy.zeros(len(places), bool)
    begins = found.offsets[:-1][numpy.diff(found.offsets) > 0]
    first[begins] = True
    first[1:] |= numpy.diff(places) > tolerance
    while True:  # a row of close hits may be longer than the tolerance
        start = numpy.maximum.accumulate(numpy.where(first, numpy.arange(len(places)), 0))
        beyond = places - places[start] > tolerance
        if not beyond.any():
            break
        at = numpy.nonzero(beyond)[0]
        first[at[numpy.unique(start[at], return_index=True)[1]]] = True
    if first.all():
        return found
    offsets = numpy.concatenate([[0], numpy.cumsum(first)]).astype(ID)[found.offsets]
    return type(found)(offsets, *(values[first] for values in found[1:]))


def _lines(ends: Any) -> numpy.ndarray:
    """Both ends of lines, of the shape (n, 2, 3) or (n, 6), with the shape (n, 6)."""
    both = to_numbers(ends, "starts")
    both = both.reshape(-1, 6) if both.shape[1:] == (2, 3) else both
    return to_rows(both, "starts", 6, " without ends, or (n, 2, 3)")


def _length(value: Any, name: str) -> float:
    """A number that is not negative and not NaN."""
    try:
        length = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} is {value!r}, a number is needed") from None
    if not length >= 0.0:
        raise ValueError(f"{name} is {length}, it must not be negative")
    return length


def _matrix(values: Any, name: str) -> Optional[vtkMatrix4x4]:
    """A matrix of VTK, or None."""
    if values is None:
        return None
    given = to_rows(values, name, 4)
    if len(given) != 4:
        raise ValueError(f"{name} has the shape {given.shape}, (4, 4) is needed")
    matrix = vtkMatrix4x4()
    matrix.DeepCopy(given.reshape(-1).tolist())
    return matrix


def _count(value: Any, name: str) -> int:
    """A number from 1 on that VTK can count to."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} is {value!r}, an integer is needed") from None
    if not 1 <= number < 2**31:
        raise ValueError(f"{name} is {number}, at least 1 is needed" + (", and less than 2**31" if number > 1 else ""))
    return number


def _none(out: Any) -> None:
    if out is not None:
        raise ValueError("out cannot be given with all_hits: how many there will be is not known")
