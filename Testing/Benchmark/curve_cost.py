# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What it costs to find where curves cross a surface, as the surface grows: n random straight pieces
against a sphere of m triangles.

Prints a row of Markdown for each m: processor seconds to build the tree, processor microseconds a
piece with the tree kept, the same over log2 m, and the number of crossings. One thread; medians of
five. Needs VTK's Python modules and vtkskdtree:
    curve_cost.py [n [m ...]]
"""

import math
import statistics
import sys
import time

import numpy
import vtkmodules.util.numpy_support as numpy_support
from vtkmodules.vtkCommonCore import vtkPoints, vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
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


def measure(count, triangles):
    surface = sphere(triangles)
    crossing = vtkSkdTreeCurveSurfaceIntersection()
    crossing.InterpolateDataOff()
    crossing.SetSourceData(surface)
    crossing.SetInputData(segments(8))
    build = timed(crossing.Update)
    crossing.SetInputData(segments(count))

    def again():
        crossing.Modified()
        crossing.Update()

    again()
    seconds = statistics.median(timed(again) for _ in range(5))
    m = surface.GetNumberOfCells()
    micros = 1e6 * seconds / count
    hits = crossing.GetOutputDataObject(0).GetNumberOfPoints()
    print("| %d | %.3g | %.3g | %.3g | %d |" % (m, build, micros, micros / math.log2(m), hits),
        flush=True)


if __name__ == "__main__":
    vtkSMPTools.Initialize(1)
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 20000
    sizes = [float(size) for size in sys.argv[2:]] or [1e3, 1e4, 1e5, 1e6]
    print("| triangles | build, s | a piece, us | over log2 m | crossings of %d |" % count)
    print("| ---: | ---: | ---: | ---: | ---: |")
    for size in sizes:
        measure(count, size)
