# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of the unit sphere for the benchmarks of remapping, as pairs of points and cells."""

import math

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


def unit(x):
    return x / numpy.linalg.norm(x, axis=-1, keepdims=True)


def welded(points, cells):
    """Points that are equal, to rounding, made one; cells are an array."""
    _, first, index = numpy.unique(numpy.round(points * 1e9), axis=0, return_index=True,
        return_inverse=True)
    return points[first], index.ravel()[cells]


def cubed_sphere(n, angle=0.0):
    """Six faces of n x n quadrilaterals at equal angles, turned about (1, 1, 1)."""
    t = numpy.tan(math.pi / 4 * (2 * numpy.arange(n + 1) / n - 1))
    u, v = (a.ravel() for a in numpy.meshgrid(t, t, indexing="ij"))
    points, cells = [], []
    for face in range(6):
        axis, side = face % 3, 1.0 if face < 3 else -1.0
        x = numpy.empty((len(u), 3))
        x[:, axis], x[:, (axis + 1) % 3], x[:, (axis + 2) % 3] = side, side * u, v
        at = (numpy.arange(n)[:, None] * (n + 1) + numpy.arange(n) + face * len(u)).ravel()
        cells.append(numpy.stack([at, at + n + 1, at + n + 2, at + 1], -1))
        points.append(unit(x))
    points, cells = welded(numpy.concatenate(points), numpy.concatenate(cells))
    k = unit(numpy.ones(3))
    return points * math.cos(angle) + numpy.cross(k, points) * math.sin(angle) + numpy.outer(
        points @ k, k) * (1 - math.cos(angle)), cells


def icosahedral_dual(n):
    """10 n^2 + 2 hexagons and pentagons around the points of a divided icosahedron."""
    g = (1 + math.sqrt(5)) / 2
    corners = numpy.array([(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
        (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)])
    faces = ((0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
        (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9),
        (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1))
    tip = math.atan2(1, g)  # corners 0 and 3 turn to the poles
    turn = numpy.array([[math.cos(tip), math.sin(tip), 0], [-math.sin(tip), math.cos(tip), 0],
        [0, 0, 1]])
    corners = (corners @ turn)[:, [2, 0, 1]]
    points, triangles = [], []
    for face in faces:
        place = {}
        for i in range(n + 1):
            for j in range(n + 1 - i):
                place[i, j] = len(points)
                points.append(
                    i * corners[face[0]] + j * corners[face[1]] + (n - i - j) * corners[face[2]])
        for i in range(n):
            for j in range(n - i):
                triangles.append((place[i + 1, j], place[i, j + 1], place[i, j]))
                if i + j + 1 < n:
                    triangles.append((place[i + 1, j + 1], place[i, j + 1], place[i + 1, j]))
    points, triangles = welded(unit(numpy.array(points)), numpy.array(triangles))
    middles = unit(points[triangles].sum(axis=1))
    around = [[] for _ in points]
    for id_, triangle in enumerate(triangles):
        for corner in triangle:
            around[corner].append(id_)
    cells = []
    for x, ids in zip(points, around):
        first = middles[ids[0]] - x
        angles = [math.atan2(x @ numpy.cross(first, middles[i] - x), first @ (middles[i] - x))
            for i in ids]
        cells.append([ids[k] for k in numpy.argsort(angles)])
    return middles, cells


def poly_data(mesh):
    points, cells = mesh
    data, vtk_points, polygons = vtkPolyData(), vtkPoints(), vtkCellArray()
    vtk_points.SetData(numpy_to_vtk(numpy.ascontiguousarray(points), deep=1))
    ids = numpy.concatenate(cells) if isinstance(cells, list) else cells.ravel()
    offsets = numpy.cumsum([0] + [len(cell) for cell in cells])
    polygons.SetData(*(numpy_to_vtkIdTypeArray(numpy.ascontiguousarray(a, numpy.int64), deep=1)
        for a in (offsets, ids)))
    data.SetPoints(vtk_points)
    data.SetPolys(polygons)
    return data


def with_field(mesh, values):
    """A copy of a mesh with values of its cells as the array f."""
    data = vtkPolyData()
    data.ShallowCopy(mesh)
    array = numpy_to_vtk(values, deep=1)
    array.SetName("f")
    data.GetCellData().AddArray(array)
    return data
