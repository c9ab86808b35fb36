# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What it costs to find where curves cross a surface, as the surface grows: n random straight pieces
against a sphere of m triangles.

Prints a row of Markdown for each m: processor seconds to build the tree, processor microseconds a
piece with the tree kept, the same over log2 m, the number of crossings, and how many times the time a
piece vtkOBBTree takes, which is asked about 200 pieces of up to a million triangles. One thread;
medians of five. Needs VTK's Python modules and vtkskdtree:
    curve_cost.py [--csv file] [n [m ...]]
"""

import csv
import math
import statistics
import sys
import time

import numpy
import vtkmodules.util.numpy_support as numpy_support
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints, vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersGeneral import vtkOBBTree
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkskdtree import vtkSkdTreeCurveSurfaceIntersection


def sphere(triangles):
    source = vtkSphereSource()
    resolution = max(4, int(math.sqrt(0.5 * triangles)) + 1)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.SetRadius(1)
    source.Update()
    return source.GetOutput()


def segments(count):
    """Ends in a cube around the sphere, a tenth of its size apart."""
    random = numpy.random.default_rng(1)
    start = random.uniform(-1.2, 1.2, (count, 3))
    way = random.normal(size=(count, 3))
    end = start + 0.2 * way / numpy.linalg.norm(way, axis=1)[:, None]
    points = vtkPoints()
    points.SetData(numpy_support.numpy_to_vtk(
        numpy.stack([start, end], axis=1).reshape(-1, 3), deep=True))
    ids = numpy.insert(numpy.arange(2 * count).reshape(-1, 2), 0, 2, axis=1)
    lines = vtkCellArray()
    lines.ImportLegacyFormat(numpy_support.numpy_to_vtkIdTypeArray(ids.ravel(), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    return data


def timed(work):
    start = time.process_time()
    work()
    return time.process_time() - start


def obb_micros(surface, pieces, count=200):
    """What vtkOBBTree takes a piece, its tree kept."""
    tree = vtkOBBTree()
    tree.SetDataSet(surface)
    tree.BuildLocator()
    ends = [(pieces.GetPoint(2 * i), pieces.GetPoint(2 * i + 1)) for i in range(count)]
    points, ids = vtkPoints(), vtkIdList()

    def ask():
        for start, end in ends:
            tree.IntersectWithLine(start, end, points, ids)

    return 1e6 * statistics.median(timed(ask) for _ in range(3)) / count


def measure(count, triangles):
    """(triangles, seconds to build, microseconds a piece, crossings, of vtkOBBTree a piece)."""
    surface = sphere(triangles)
    crossing = vtkSkdTreeCurveSurfaceIntersection()
    crossing.InterpolateDataOff()
    crossing.SetSourceData(surface)
    crossing.SetInputData(segments(8))
    build = timed(crossing.Update)
    pieces = segments(count)
    crossing.SetInputData(pieces)

    def again():
        crossing.Modified()
        crossing.Update()

    again()
    micros = 1e6 * statistics.median(timed(again) for _ in range(5)) / count
    hits = crossing.GetOutputDataObject(0).GetNumberOfPoints()
    others = obb_micros(surface, pieces) if triangles <= 1e6 else None
    return surface.GetNumberOfCells(), build, micros, hits, others


def main(arguments):
    rows = None
    if arguments[:1] == ["--csv"]:
        rows = csv.writer(open(arguments[1], "w", newline=""))
        rows.writerow(["scene", "cells", "work", "unit", "structure", "value"])
        arguments = arguments[2:]
    vtkSMPTools.Initialize(1)
    count = int(arguments[0]) if arguments else 20000
    print("| triangles | build, s | a piece, us | over log2 m | crossings of %d | vtkOBBTree |" % count)
    print("| ---: | ---: | ---: | ---: | ---: | ---: |")
    for size in [float(size) for size in arguments[1:]] or [1e3, 1e4, 1e5, 1e6]:
        m, build, micros, hits, others = measure(count, size)
        print("| %d | %.3g | %.3g | %.3g | %d | %s |" % (m, build, micros, micros / math.log2(m), hits,
            "%.3g x" % (others / micros) if others else "-"), flush=True)
        for name, value in (("skD-tree", micros), ("vtkOBBTree", others)):
            if rows and value:
                rows.writerow(["sphere", m, "pieces across", "ns a piece", name, 1e3 * value])


if __name__ == "__main__":
    main(sys.argv[1:])
