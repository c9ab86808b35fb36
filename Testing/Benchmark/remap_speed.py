# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What remapping costs, as a whole filter: cubed spheres turned against each other, on one thread.

Prints a row of Markdown for each number of cells: processor seconds of the first run, of a further
time step (overlaps are kept), and of the first run a target cell. Needs VTK's Python modules and
vtkskdtree:
    remap_speed.py [number of cells...]
"""

import math
import sys
import time

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints, vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkskdtree import vtkSkdTreeRemap

CELLS = [int(float(text)) for text in sys.argv[1:]] or [10**4, 10**5, 10**6]


def cubed_sphere(n, angle):
    """Six faces of n x n quads that share their edges' points, turned about (1, 1, 1)."""
    t = numpy.tan(math.pi / 4 * (2 * numpy.arange(n + 1) / n - 1))
    u, v = (a.ravel() for a in numpy.meshgrid(t, t, indexing="ij"))
    points, cells = [], []
    for face in range(6):
        axis, side = face % 3, 1.0 if face < 3 else -1.0
        x = numpy.empty((len(u), 3))
        x[:, axis], x[:, (axis + 1) % 3], x[:, (axis + 2) % 3] = side, side * u, v
        at = (numpy.arange(n)[:, None] * (n + 1) + numpy.arange(n) + face * len(u)).ravel()
        cells.append(numpy.stack([at, at + n + 1, at + n + 2, at + 1], -1))
        points.append(x / numpy.linalg.norm(x, axis=1, keepdims=True))
    points = numpy.concatenate(points)
    _, first, index = numpy.unique(numpy.round(points * 1e9), axis=0, return_index=True,
        return_inverse=True)
    points, cells = points[first], index.ravel()[numpy.concatenate(cells)]
    k = numpy.ones(3) / math.sqrt(3)
    points = points * math.cos(angle) + numpy.cross(k, points) * math.sin(angle) + numpy.outer(
        points @ k, k) * (1 - math.cos(angle))
    return make_poly_data(points, cells)


def make_poly_data(points, cells):
    data, vtk_points, polygons = vtkPolyData(), vtkPoints(), vtkCellArray()
    vtk_points.SetData(numpy_to_vtk(points, deep=1))
    offsets = numpy.arange(0, cells.size + 1, cells.shape[1])
    polygons.SetData(numpy_to_vtkIdTypeArray(offsets, deep=1),
        numpy_to_vtkIdTypeArray(numpy.ascontiguousarray(cells.ravel(), dtype=numpy.int64), deep=1))
    data.SetPoints(vtk_points)
    data.SetPolys(polygons)
    return data


def with_field(mesh, step):
    copy = vtkPolyData()
    copy.ShallowCopy(mesh)
    field = numpy_to_vtk(numpy.cos(numpy.arange(mesh.GetNumberOfCells()) * 1e-3 + step), deep=1)
    field.SetName("f")
    copy.GetCellData().AddArray(field)
    return copy


def seconds(remap):
    start = time.process_time()
    remap.Update()
    return time.process_time() - start


def main():
    vtkSMPTools.Initialize(1)
    print("| cells each | order | first run, s | a further step, s | a target cell, us |")
    print("| ---: | --- | ---: | ---: | ---: |")
    for cells in CELLS:
        n = round(math.sqrt(cells / 6))
        here, there = cubed_sphere(n, 0.0), cubed_sphere(n, 0.4)
        for title, method in (("first", 3), ("second", 4)):
            remap = vtkSkdTreeRemap()
            remap.SetMethod(method)
            remap.SetInputDataObject(0, there)
            remap.SetInputDataObject(1, with_field(here, 0))
            first = seconds(remap)
            remap.SetInputDataObject(1, with_field(here, 1))
            print("| %d | %s | %.2f | %.2f | %.2f |" %
                (6 * n * n, title, first, seconds(remap), 1e6 * first / (6 * n * n)))


main()
