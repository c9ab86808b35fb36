# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data sets made from what users have, and their bytes for pickle."""

from __future__ import annotations

from typing import Any

import numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSet, vtkPolyData

from .arrays import FLOAT, ID, to_numbers, to_rows, to_vtk

KINDS = "a vtkDataSet, a pair (points, faces), an object with .vertices and .faces or .triangles, or points"


def vtk_points(points: numpy.ndarray) -> vtkPoints:
    if points.dtype.kind != "f":
        points = points.astype(FLOAT)
    made = vtkPoints()
    made.SetData(to_vtk(points))
    return made


def _split(faces: numpy.ndarray) -> tuple[Any, numpy.ndarray]:
    """The offsets and the points of polygons in one row: the number of points of each, then these. In place
    of the offsets one number, if it is that of all."""
    size = int(faces[0])
    if size >= 3 and len(faces) % (size + 1) == 0 and (faces[::size + 1] == size).all():
        return size, faces.reshape(-1, size + 1)[:, 1:].reshape(-1)
    starts, at = [], 0
    counts = faces.tolist()
    while at < len(counts):
        size = counts[at]
        if size < 3 or at + size >= len(counts):
            raise ValueError(f"faces has the shape {faces.shape}: of faces in one row, each is the number of "
                f"its points, 3 or more, and these; faces[{at}] is {size}, and {len(counts) - at - 1} follow")
        starts.append(at)
        at += size + 1
    offsets = numpy.append(starts, len(counts)).astype(ID) - numpy.arange(len(starts) + 1, dtype=ID)
    return offsets, numpy.delete(faces, starts)


def _corners(faces: Any, number: int) -> tuple[Any, numpy.ndarray]:
    """The offsets of faces, or the number of points that each has, and their points."""
    given = to_numbers(faces, "faces")
    if given.dtype.kind == "f" and given.size:
        raise TypeError(f"faces holds {given.dtype}: numbers of points, integers, are needed")
    size: Any = 3
    if given.ndim == 1 and given.size:
        size, given = _split(given)
    elif given.ndim == 2 and given.shape[1] == 4:
        size, given = 4, given.reshape(-1)
    else:
        given = to_rows(given, "faces", 3, ", or (n, 4), or all in one row, each after its number of points")
        given = given.reshape(-1)
    if given.size and not 0 <= given.min() <= given.max() < number:
        raise ValueError(f"faces names points {given.min()} to {given.max()}, but there are {number} points")
    return size, numpy.ascontiguousarray(given, ID)


def surface(points: Any, faces: Any, name: str = "points") -> vtkPolyData:
    """Polygons, or without these one vertex cell per point."""
    points = to_rows(points, name, 3)
    mesh = vtkPolyData()
    mesh.SetPoints(vtk_points(points))
    cells = vtkCellArray()
    if faces is None:
        size, corners = 1, numpy.arange(len(points), dtype=ID)
    else:
        size, corners = _corners(faces, len(points))
    kept = [corners]
    if corners.size and isinstance(size, int):
        cells.SetData(size, to_vtk(corners))
    elif corners.size:
        kept.append(size)
        cells.SetData(to_vtk(size), to_vtk(corners))
    if faces is None:
        mesh.SetVerts(cells)
    else:
        mesh.SetPolys(cells)
    mesh._skd_corners = kept  # vtkCellArray shares their memory, but holds no reference to them
    return mesh


def _is_pair(mesh: Any) -> bool:
    """Of a list of two, the first may be points, or a point."""
    if isinstance(mesh, tuple):
        return len(mesh) == 2
    if not isinstance(mesh, list) or len(mesh) != 2:
        return False
    try:
        return numpy.ndim(mesh[0]) == 2 or numpy.size(mesh[0]) == 0
    except ValueError:  # rows of different lengths
        return False


def mesh_of(mesh: Any, name: str) -> vtkDataSet:
    """The data set that an argument is, produces or contains, or that is made from its arrays."""
    if hasattr(mesh, "GetOutputDataObject"):  # a reader, a source, a filter
        mesh.Update()
        mesh = mesh.GetOutputDataObject(0)
    mesh = getattr(mesh, "VTKObject", mesh)  # vtkmodules.numpy_interface.dataset_adapter
    if isinstance(mesh, vtkDataSet):
        return mesh
    for faces in ("faces", "triangles"):  # of trimesh and similar, of Open3D
        if hasattr(mesh, "vertices") and hasattr(mesh, faces):
            return surface(mesh.vertices, getattr(mesh, faces))
    if _is_pair(mesh):
        return surface(*mesh)
    if hasattr(mesh, "IsA"):
        raise TypeError(f"{name} is a {mesh.GetClassName()}: a vtkDataSet is needed; of blocks take one, "
            "or append them")
    try:
        return surface(mesh, None, name)
    except (TypeError, ValueError) as error:
        raise type(error)(f"{name} is none of {KINDS}: {error}") from None


def _file_kinds() -> dict[str, tuple[Any, Any]]:
    """The writer and the reader of each class of data sets."""
    from vtkmodules import vtkIOXML
    return {f"vtk{kind}": (getattr(vtkIOXML, f"vtkXML{kind}Writer"), getattr(vtkIOXML, f"vtkXML{kind}Reader"))
        for kind in ("PolyData", "UnstructuredGrid", "ImageData", "RectilinearGrid", "StructuredGrid")}


def to_text(mesh: vtkDataSet) -> tuple[str, str]:
    """The class of a data set, and all of it to the last bit, as VTK's XML; nothing of one without points,
    which VTK's readers refuse."""
    for kind, (writer, _) in _file_kinds().items():
        if mesh.IsA(kind) and mesh.GetNumberOfPoints() == 0:
            return kind, ""
        if mesh.IsA(kind):
            writing = writer()
            writing.SetInputData(mesh)
            writing.SetDataModeToBinary()
            writing.SetHeaderTypeToUInt64()
            writing.WriteToOutputStringOn()
            writing.Write()
            return kind, writing.GetOutputString()
    raise TypeError(f"a Tree of a {mesh.GetClassName()} cannot be pickled: make one of a vtkUnstructuredGrid")


def from_text(kind: str, text: str) -> vtkDataSet:
    """What to_text() was called with."""
    reading = _file_kinds()[kind][1]()
    if not text:
        return reading.GetOutput().NewInstance()
    reading.ReadFromInputStringOn()
    reading.SetInputString(text)
    reading.Update()
    return reading.GetOutput()
