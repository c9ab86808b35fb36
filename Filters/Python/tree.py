# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""numpy in, numpy out: what the skD-tree answers about a mesh, for arrays of queries."""

from __future__ import annotations

import os
import re
import warnings
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Optional, overload

import numpy
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdTypeArray, vtkPoints, vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSet, vtkPolyData

from .arrays import FLOAT, ID, Locator, check_outputs, output, to_numbers, to_rows, to_vtk
from .vtkFiltersSkdTree import vtkSkdTreeClosestPoint, vtkSkdTreePointInOut, vtkSkdTreeProbe

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Ids = NDArray[numpy.int64]
    Floats = NDArray[numpy.float64]

INFINITY = float("inf")
FARTHEST = vtkSkdTreeClosestPoint().GetMaximumDistanceMaxValue()  # that the filter takes


def _queries_of(lists: Any) -> Ids:
    """The number of the query that each value of the lists belongs to."""
    return numpy.repeat(numpy.arange(len(lists.offsets) - 1), numpy.diff(lists.offsets))


class Closest(NamedTuple):
    """A row for each query; NaN and -1 where nothing is near enough."""
    point: Floats  #: (n, 3) the nearest point on the mesh
    distance: Floats  #: (n,)
    cell: Ids  #: (n,) the cell that it is on, of several the lowest


class Nearest(NamedTuple):
    """A row for each query, nearest first; NaN and -1 where there are fewer."""
    distance: Floats  #: (n, k)
    cell: Ids  #: (n, k)


class Cells(NamedTuple):
    """A row for each query; -1 and NaN where no cell is. m is the number of points of the mesh's
    largest cell; of a smaller one point_ids end with -1, and weights with 0."""
    cell: Ids  #: (n,)
    pcoords: Floats  #: (n, 3) parametric coordinates
    point_ids: Ids  #: (n, m) the cell's points
    weights: Floats  #: (n, m) by which values at these are summed up


class RayHits(NamedTuple):
    """A row for each ray, its first hit; -1 and NaN of a ray that hits nothing."""
    cell: Ids  #: (n,)
    distance: Floats  #: (n,) from the origin, in the units of the coordinates
    point: Floats  #: (n, 3)


class RayHitLists(NamedTuple):
    """All hits of all rays: those of ray i are rows offsets[i] to offsets[i + 1] of the others."""
    offsets: Ids  #: (n + 1,)
    cell: Ids  #: (m,)
    distance: Floats  #: (m,) from the origin, ascending for each ray
    point: Floats  #: (m, 3)
    query = property(_queries_of, doc="(m,) the ray of each hit")


class SegmentHits(NamedTuple):
    """A row for each segment, its first hit; -1 and NaN of a segment that hits nothing."""
    cell: Ids  #: (n,)
    parameter: Floats  #: (n,) 0 at the start, 1 at the end
    point: Floats  #: (n, 3)


class SegmentHitLists(NamedTuple):
    """All hits of all segments: those of segment i are rows offsets[i] to offsets[i + 1]."""
    offsets: Ids  #: (n + 1,)
    cell: Ids  #: (m,)
    parameter: Floats  #: (m,) 0 at the start, 1 at the end, ascending for each segment
    point: Floats  #: (m, 3)
    query = property(_queries_of, doc="(m,) the segment of each hit")


class CellLists(NamedTuple):
    """Lists of cells: those of query i are cell[offsets[i]:offsets[i + 1]]."""
    offsets: Ids  #: (n + 1,)
    cell: Ids  #: (m,)
    query = property(_queries_of, doc="(m,) the query that each cell is an answer to")


class NearLists(NamedTuple):
    """Lists of cells and their distances: those of query i are rows offsets[i] to offsets[i + 1]."""
    offsets: Ids  #: (n + 1,)
    cell: Ids  #: (m,) ascending for each query
    distance: Floats  #: (m,)
    query = property(_queries_of, doc="(m,) the query that each cell is an answer to")


def _use_all_processors() -> None:
    """Where VTK's loops run on one processor, and nobody said that they should."""
    if vtkSMPTools.GetBackend() == "Sequential" and "VTK_SMP_BACKEND_IN_USE" not in os.environ:
        vtkSMPTools.SetBackend("STDThread")


def _vtk_points(points: numpy.ndarray) -> vtkPoints:
    if points.dtype.kind != "f":
        points = points.astype(FLOAT)
    made = vtkPoints()
    made.SetData(to_vtk(points))
    return made


def _surface(points: Any, triangles: Any) -> vtkPolyData:
    """Of (n, 3) points and (m, 3) numbers of these; of (m, 1) it is points, each a cell."""
    points = to_rows(points, "points", 3)
    if triangles is None:
        corners = numpy.arange(len(points), dtype=ID).reshape(-1, 1)
    else:
        corners = to_rows(triangles, "triangles", 3)
        if corners.dtype.kind == "f" and corners.size:
            raise TypeError(f"triangles holds {corners.dtype}: numbers of points, integers, are needed")
        if corners.size and not 0 <= corners.min() <= corners.max() < len(points):
            raise ValueError(f"triangles names points {corners.min()} to {corners.max()}, but points "
                f"has {len(points)} rows")
        corners = numpy.ascontiguousarray(corners, ID)
    mesh = vtkPolyData()
    mesh.SetPoints(_vtk_points(points))
    cells = vtkCellArray()
    if corners.size:
        cells.SetData(corners.shape[1], to_vtk(corners.reshape(-1)))
    mesh.SetVerts(cells) if triangles is None else mesh.SetPolys(cells)
    mesh._skd_corners = corners  # VTK's cells have its memory, but do not keep it
    return mesh


def _mesh_of(mesh: Any) -> vtkDataSet:
    """The data set that something is, has inside, or has arrays of."""
    if hasattr(mesh, "GetOutputDataObject"):  # a reader, a source, a filter
        mesh.Update()
        mesh = mesh.GetOutputDataObject(0)
    mesh = getattr(mesh, "VTKObject", mesh)  # vtkmodules.numpy_interface.dataset_adapter
    if isinstance(mesh, vtkDataSet):
        return mesh
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):  # trimesh and its like
        return _surface(mesh.vertices, mesh.faces)
    if isinstance(mesh, tuple) and len(mesh) == 2:
        return _surface(*mesh)
    if hasattr(mesh, "IsA"):
        raise TypeError(f"mesh is a {mesh.GetClassName()}: a vtkDataSet is needed; of blocks take one, "
            "or append them")
    try:
        return _surface(mesh, None)
    except (TypeError, ValueError) as error:
        raise type(error)("mesh is neither a vtkDataSet, nor a tuple (points, triangles), nor points: "
            + str(error)) from None


class Tree:
    """What a mesh is asked, by its skD-tree, for whole arrays of queries at once.

    mesh may be

    - any vtkDataSet (PyVista's meshes are such), or a reader, source or filter that makes one;
    - a tuple (points, triangles) of arrays of the shapes (n, 3) and (m, 3), or an object that has
      such as .vertices and .faces (trimesh's);
    - points alone, an array of the shape (n, 3): cell i is then point i.

    Arrays of float64 and float32 points are not copied, nor are int64 triangles, nor is a data set:
    call update() after changing them.

    Queries are arrays (or lists) of numbers, a row each. Float64 that lies row by row is read where
    it is. Answers are named tuples of arrays, in the order of the queries, with ids of cells and
    points as VTK has them. Queries that are not finite find nothing. All processors work on them;
    answers do not depend on how many. Where a method has `out`, an earlier answer of the same shapes
    handed in is overwritten and returned, which spares the memory of a new one.

    A query of the wrong shape raises ValueError, one of the wrong type TypeError; both say what was
    given and what is needed. Warnings of VTK (a surface that is not closed, say) are Python's.

    The tree is built by the first query, in O(N log N). signed_distance(), contains() and
    winding_number() build trees of the mesh's boundary when first called, and interpolate() another.
    """

    mesh: vtkDataSet  #: the mesh that is asked
    locator: Locator  #: its locator, for settings and for queries one by one

    def __init__(self, mesh: Any) -> None:
        _use_all_processors()
        self.mesh = _mesh_of(mesh)
        self._messages: list[tuple[bool, str]] = []
        self._filters: dict[Any, Any] = {}
        self.locator = self._heard(Locator())
        self.locator.SetDataSet(self.mesh)

    def __len__(self) -> int:
        """The number of cells of the mesh."""
        return self.mesh.GetNumberOfCells()

    def __repr__(self) -> str:
        return f"Tree({self.mesh.GetClassName()} of {len(self)} cells)"

    def update(self) -> None:
        """Tells that coordinates or cells were changed in place: the next query builds anew."""
        points = getattr(self.mesh, "GetPoints", lambda: None)()
        if points is not None:
            points.Modified()
        self.mesh.Modified()

    # Nearest cells

    def closest(self, points: ArrayLike, maximum: float = INFINITY,
            out: Optional[Closest] = None) -> Closest:
        """The nearest point of the mesh to each of points, within the distance maximum."""
        at = to_vtk(to_rows(points, "points", 3))
        return self._ask(Closest, out, lambda point, distance, cell: (
            self.locator.FindClosestPoints(at, cell, point, distance, _length(maximum, "maximum"))))

    def k_nearest(self, points: ArrayLike, k: int, maximum: float = INFINITY,
            out: Optional[Nearest] = None) -> Nearest:
        """The k nearest cells to each of points, within the distance maximum; ties to the lowest."""
        at = to_vtk(to_rows(points, "points", 3))
        if k < 1:
            raise ValueError(f"k is {k}, at least 1 is needed")
        found = self._ask(Nearest, out, lambda distance, cell: (
            self.locator.FindClosestNCells(at, k, cell, distance, _length(maximum, "maximum"))))
        return found if found.cell.ndim == 2 else Nearest(*(a.reshape(-1, k) for a in found))

    def within(self, points: ArrayLike, radius: ArrayLike) -> NearLists:
        """All cells at a distance of at most radius, a number or one for each of points."""
        at = to_rows(points, "points", 3)
        radii = to_numbers(radius, "radius")
        if radii.shape not in ((), (1, ), (len(at), )):
            raise ValueError(f"radius has the shape {radii.shape}, () or ({len(at)},) is needed")
        spheres = numpy.empty((len(at), 4))
        spheres[:, :3] = at
        spheres[:, 3] = radii
        return self._ask(NearLists, None, lambda offsets, cell, distance: (
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
        """The first cell that each ray hits, or all of them: from origins along directions (a row
        for each, or one for all; of any length but 0), up to the distance maximum.

        A cell is hit once; a ray through an edge hits all cells that have it."""
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
            return self._ask(RayHitLists, _none(out), lambda offsets, cell, distance, point: (
                self.locator.FindAllRayHits(start, along, offsets, cell, distance, point, limit)))
        return self._ask(RayHits, out, lambda cell, distance, point: (
            self.locator.IntersectWithRays(start, along, cell, distance, point, limit)))

    @overload
    def segments(self, starts: ArrayLike, ends: Optional[ArrayLike] = ...,
        all_hits: Literal[False] = ..., out: Optional[SegmentHits] = ...) -> SegmentHits: ...

    @overload
    def segments(self, starts: ArrayLike, ends: Optional[ArrayLike] = ..., *,
        all_hits: Literal[True]) -> SegmentHitLists: ...

    def segments(self, starts: ArrayLike, ends: Optional[ArrayLike] = None,
            all_hits: bool = False, out: Optional[SegmentHits] = None) -> Any:
        """The first cell that each segment hits, or all of them: from starts to ends, a row for
        each. Without ends, starts has both, in the shape (n, 2, 3) or (n, 6): it is not copied."""
        if ends is not None:
            start, end = to_rows(starts, "starts", 3), to_rows(ends, "ends", 3)
            if len(start) != len(end):
                raise ValueError(f"starts has {len(start)} rows, but ends has {len(end)}")
            both = numpy.hstack([start, end])
        else:
            both = to_numbers(starts, "starts")
            both = both.reshape(-1, 6) if both.shape[1:] == (2, 3) else both
            both = to_rows(both, "starts", 6, " without ends, or (n, 2, 3)")
        lines = to_vtk(both)
        if all_hits:
            return self._ask(SegmentHitLists, _none(out), lambda offsets, cell, parameter, point: (
                self.locator.FindAllHits(lines, offsets, cell, parameter, point)))
        return self._ask(SegmentHits, out, lambda cell, parameter, point: (
            self.locator.IntersectWithLines(lines, cell, parameter, point)))

    # Cells at places

    def find_cells(self, points: ArrayLike, tolerance: float = 0.0,
            out: Optional[Cells] = None) -> Cells:
        """The cell that each of points is in, or else the nearest at a distance of at most
        tolerance, where in it, and the weights of its points there: of an array v of the mesh's
        points, (v[found.point_ids] * found.weights).sum(1) is interpolated."""
        at = to_vtk(to_rows(points, "points", 3))
        reach2 = _length(tolerance, "tolerance")**2
        found = self._ask(Cells, out, lambda cell, pcoords, point_ids, weights: (
            self.locator.FindCellsAndWeights(at, cell, pcoords, point_ids, weights, reach2)))
        rows = (len(found.cell), -1 if len(found.cell) else 1)  # where all cells are points, too
        return Cells(*found[:2], *(array.reshape(rows) for array in found[2:]))

    def interpolate(self, name: str, points: ArrayLike, outside: bool = False) -> NDArray[Any]:
        """An array of the mesh at points: point data interpolated in the cell that holds each, else
        cell data taken; or outside of all cells those of the nearest, if outside is true. NaN, or 0
        of integers, where there is no answer. KeyError of a name that the mesh does not have."""
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
        """The cells whose bounds overlap each box: boxes has the shape (n, 2, 3), the lowest and the
        highest corner, or (n, 6), xmin, xmax, ymin, ymax, zmin, zmax as VTK has them (not copied)."""
        given = to_numbers(boxes, "boxes")
        if given.shape[1:] == (2, 3):
            given = given.transpose(0, 2, 1).reshape(-1, 6)
        bounds = to_vtk(to_rows(given, "boxes", 6, ", or (n, 2, 3)"))
        return self._ask(CellLists, None, lambda offsets, cell: (
            self.locator.FindCellsWithinBoxes(bounds, offsets, cell)))

    def pairs(self, other: Any) -> CellLists:
        """For each cell of this mesh the cells of another Tree, or of anything that a Tree is made
        of, whose bounds overlap its own."""
        if not isinstance(other, Tree):
            other = Tree(other)
        return self._ask(CellLists, None, lambda offsets, cell: (
            self.locator.FindPairs(other.locator, offsets, cell)))

    # Inside or outside

    def signed_distance(self, points: ArrayLike, maximum: float = INFINITY) -> Closest:
        """closest() on the boundary of the mesh (the outer faces of volume cells, else its surface
        cells), with distances that are negative inside. Inside is decided exactly, however the
        surface is oriented; of a surface that is not closed, with a warning, by a vote."""
        limit = min(_length(maximum, "maximum"), FARTHEST)
        return Closest(*self._filter(vtkSkdTreeClosestPoint, points,
            ["SkdClosestPoint", "SkdDistance", "SkdClosestCellId"], SignedDistance=True,
            MaximumDistance=limit))

    def contains(self, points: ArrayLike) -> NDArray[numpy.bool_]:
        """Whether each of points is inside the boundary of the mesh: exactly, however the surface is
        oriented, and of a surface that is not closed, with a warning, by its winding number."""
        inside, = self._filter(vtkSkdTreePointInOut, points, ["SkdInside"])
        return inside.view(numpy.bool_)

    def winding_number(self, points: ArrayLike, tolerance: float = 0.25) -> Floats:
        """The generalised winding number around each of points of the boundary of the mesh as it is
        oriented: 1 inside a closed one whose normals point outward, 0 outside, and between where it
        is open. Off by at most tolerance, mostly by a hundredth of it; 0 sums up all triangles."""
        number, = self._filter(vtkSkdTreePointInOut, points, ["SkdWindingNumber"],
            Method=vtkSkdTreePointInOut.WINDING_NUMBER, WindingTolerance=_length(tolerance, "tolerance"))
        return number

    # How they are asked

    def _heard(self, source: Any) -> Any:
        """An object of VTK whose warnings and errors are kept for _raise()."""
        messages = self._messages

        @calldata_type(VTK_STRING)
        def hear(_caller: Any, event: str, text: str) -> None:
            messages.append((event == "ErrorEvent", re.sub(r"^.*?\(0x\w+\): ", "", text, flags=re.S).strip()))

        source.AddObserver("WarningEvent", hear)
        source.AddObserver("ErrorEvent", hear)
        if hasattr(source, "GetExecutive"):
            source.GetExecutive().AddObserver("ErrorEvent", hear)
        return source

    def _raise(self) -> None:
        """Says what VTK said."""
        messages = list(self._messages)
        self._messages.clear()
        for is_error, text in messages:
            if is_error:
                raise RuntimeError(text)
            warnings.warn(text, RuntimeWarning, stacklevel=4)

    def _ask(self, kind: Any, out: Any, batch: Any) -> Any:
        """batch(arrays), the arrays being those of the fields of a kind of answer."""
        if out is None:
            arrays = [vtkIdTypeArray() if name in _IDS else vtkDoubleArray() for name in kind._fields]
        else:
            if len(out) != len(kind._fields):
                raise ValueError(f"out has {len(out)} arrays, a {kind.__name__} has {kind._fields}")
            for name, array in zip(kind._fields, out):
                if not isinstance(array, numpy.ndarray) or array.dtype != (ID if name in _IDS else FLOAT):
                    raise TypeError(f"out.{name} is no array of {ID if name in _IDS else FLOAT}")
            arrays = [output(array, f"out.{name}") for name, array in zip(kind._fields, out)]
        batch(*arrays)
        self._raise()
        if out is None:
            return kind(*map(vtk_to_numpy, arrays))
        check_outputs([(f"out.{name}", array, written)
            for name, array, written in zip(kind._fields, out, arrays)])
        return kind(*out)

    def _filter(self, kind: Any, points: ArrayLike, names: list[str],
            source: Optional[vtkDataSet] = None, **properties: Any) -> list[Any]:
        """Point arrays of what a filter makes of points; it is kept, for its trees."""
        asked = vtkPolyData()
        asked.SetPoints(_vtk_points(to_rows(points, "points", 3)))
        key = (kind, properties.get("Method"))
        if key not in self._filters:
            self._filters[key] = self._heard(kind())
        made = self._filters[key]
        made.SetSourceData(self.mesh if source is None else source)
        for name, value in properties.items():
            getattr(made, "Set" + name)(value)
        made.SetInputData(asked)
        made.Update()
        output = made.GetOutputDataObject(0)
        answers = [vtk_to_numpy(output.GetPointData().GetArray(name)) for name in names]
        output.Initialize()  # the answers live on without it
        made.SetInputData(vtkPolyData())
        self._raise()
        return answers


_IDS = {"cell", "offsets", "point_ids"}


def _length(value: Any, name: str) -> float:
    """A number that is not negative."""
    try:
        length = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} is {value!r}, a number is needed") from None
    if not length >= 0.0:
        raise ValueError(f"{name} is {length}, it must not be negative")
    return length


def _none(out: Any) -> None:
    if out is not None:
        raise ValueError("out cannot be given with all_hits: how many there will be is not known")
