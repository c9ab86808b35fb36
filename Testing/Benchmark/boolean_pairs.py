# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Boolean operations of real solids: all pairs of the closed surfaces of a folder.

Each surface is combined with itself: as it is, moved along an axis by a quarter of its length, moved
by irrational distances, and turned. Then each is combined with each other, which is scaled to its
size, centred on it and moved by irrational distances. A table has, for each pair: triangles, the
largest error of volume(A or B) + volume(A and B) = volume(A) + volume(B) and of the like for the
differences, relative to volume(A) + volume(B); bad edges, those that triangles do not pass as often in one
direction as in the other; what the filter warns of; processor seconds of all five operations. Volumes
and edges are found here by numpy, not by the filter, but for the volumes of surfaces that cover
places twice or inside out: these are what the filter makes of them, and "covers" is by how much that
differs from the signed volume. Pairs that are not right are marked: the error is above 1e-13, or
there are bad edges.

Run by pvpython with the package vtkskdtree:
    boolean_pairs.py [--most TRIANGLES] [--self] folder or file ...
"""

import argparse
import itertools
import math
import os
import re
import subprocess
import tempfile
import time

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkskdtree import vtkSkdTreeBooleanOperation

INLINE = os.path.join(os.path.dirname(__file__), "..", "..", "Plugin", "inline_xml.py")


class Solid:
    """Points, and triangles as rows of their numbers."""

    def __init__(self, name, points, triangles):
        self.name = name
        self.points = points
        self.triangles = triangles

    @staticmethod
    def of(name, polydata):
        points = vtk_to_numpy(polydata.GetPoints().GetData()).astype(float)
        triangles = vtk_to_numpy(polydata.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        different, numbers = numpy.unique(points, axis=0, return_inverse=True)
        return Solid(name, different, numbers.ravel()[triangles])

    def polydata(self):
        points = vtkPoints()
        points.SetData(numpy_to_vtk(self.points, deep=True))
        cells = vtkCellArray()
        offsets = numpy.arange(0, 3 * len(self.triangles) + 1, 3)
        cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
            numpy_to_vtkIdTypeArray(self.triangles.ravel().astype(numpy.int64), deep=True))
        polydata = vtkPolyData()
        polydata.SetPoints(points)
        polydata.SetPolys(cells)
        return polydata

    def moved(self, matrix, offset):
        return Solid(self.name, self.points @ numpy.asarray(matrix).T + offset, self.triangles)

    def length(self):
        return numpy.linalg.norm(numpy.ptp(self.points, axis=0))

    def middle(self):
        return 0.5 * (self.points.min(axis=0) + self.points.max(axis=0))

    def volume(self):
        a, b, c = (self.points[self.triangles[:, i]] - self.points[:1] for i in range(3))
        return math.fsum(numpy.einsum("ij,ij->i", a, numpy.cross(b, c))) / 6

    def bad_edges(self):
        if len(self.triangles) == 0:
            return 0
        a = self.triangles.astype(numpy.int64)
        b = numpy.roll(a, -1, axis=1)
        keys = (numpy.minimum(a, b) * len(self.points) + numpy.maximum(a, b)).ravel()
        _, at = numpy.unique(keys, return_inverse=True)
        return numpy.count_nonzero(numpy.bincount(at.ravel(), weights=numpy.sign(b - a).ravel()))


def read(file):
    """The triangulated surface, or None."""
    with tempfile.TemporaryDirectory() as folder:
        made = os.path.join(folder, os.path.basename(file))
        if re.search(r"\.vt[pu]$", file) and subprocess.run(["python3", INLINE, file, made],
                stderr=subprocess.DEVNULL).returncode == 0:
            reader = simple.OpenDataFile(made)
        else:
            reader = simple.OpenDataFile(file)
        if reader is None:
            return None
        surface = simple.Triangulate(Input=simple.ExtractSurface(Input=simple.MergeBlocks(Input=reader)))
        polydata = servermanager.Fetch(surface)
    if polydata is None or polydata.GetNumberOfPolys() == 0:
        return None
    return Solid.of(os.path.basename(file), polydata)


def combine(first, second, operation):
    """Result, messages, processor seconds, volumes of both by the filter."""
    filter = vtkSkdTreeBooleanOperation()
    filter.SetInputData(first)
    filter.SetSourceData(second)
    filter.SetOperation(operation)
    said = []

    def listen(caller, event, text):
        said.append(text.split("): ", 1)[-1])

    listen.CallDataType = "string0"
    filter.AddObserver("WarningEvent", listen)
    filter.AddObserver("ErrorEvent", listen)
    start = time.process_time()
    filter.Update()
    seconds = time.process_time() - start
    output = filter.GetOutputDataObject(0)
    report = [output.GetFieldData().GetArray("SkdReport%sVolume" % which) for which in ("Input", "Source")]
    volumes = [array.GetTuple1(0) if array else math.nan for array in report]
    if output.GetNumberOfPolys() == 0:
        result = Solid("", numpy.zeros((1, 3)), numpy.zeros((0, 3), dtype=int))
    else:
        result = Solid("", vtk_to_numpy(output.GetPoints().GetData()),
            vtk_to_numpy(output.GetPolys().GetConnectivityArray()).reshape(-1, 3))
    return result, said, seconds, volumes


def measure(first, second, how):
    """A row of the table; returns whether all is right."""
    data = first.polydata(), second.polydata()
    results = [combine(*data, operation) for operation in range(5)]
    v = [result[0].volume() for result in results]
    signed = abs(first.volume()), abs(second.volume())
    covers = max(abs(told / volume - 1) for told, volume in zip(results[0][3], signed))
    a, b = results[0][3] if covers > 1e-12 else signed
    error = max(map(abs, (v[0] + v[1] - a - b, v[2] + v[1] - a, v[3] + v[1] - b, v[4] - v[2] - v[3]))) / (a + b)
    bad = max(result[0].bad_edges() for result in results)
    texts = sorted({text[:40] for result in results for text in result[1]})
    is_right = error <= 1e-13 and bad == 0
    print("| %s | %s | %s | %d | %.3g | %.1e | %.1e | %d | %s | %.3g | %s |" %
        (first.name, second.name, how, len(first.triangles) + len(second.triangles), v[1] / (a + b), covers,
            error, bad, ", ".join(texts), sum(result[2] for result in results), "" if is_right else "WRONG"),
        flush=True)
    return is_right


def turned():
    """Rows of an orthogonal matrix."""
    axis = numpy.array([1, math.sqrt(2), math.sqrt(3)]) / math.sqrt(6)
    cross = numpy.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return numpy.eye(3) + math.sin(1) * cross + (1 - math.cos(1)) * cross @ cross


IRRATIONAL = numpy.array([0.1 * math.sqrt(2), 0.05 * math.sqrt(3), 0.02 * math.sqrt(5)])


def pairs_of_one(solid):
    size, middle = solid.length(), solid.middle()
    one = numpy.eye(3)
    yield solid, solid, "identical"
    yield solid, solid.moved(one, [numpy.ptp(solid.points[:, 0]) / 4, 0, 0]), "along an axis"
    yield solid, solid.moved(one, size * IRRATIONAL), "irrational"
    yield solid, solid.moved(turned(), middle - turned() @ middle), "turned"


def pairs_of_two(first, second):
    scale = 2.0**round(math.log2(first.length() / second.length()))
    offset = first.middle() - scale * second.middle() + 0.3 * first.length() * IRRATIONAL
    yield first, second.moved(scale * numpy.eye(3), offset), "scaled, irrational"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--most", type=float, default=1e5, help="triangles of a surface")
    parser.add_argument("--self", action="store_true", help="each with itself only")
    parser.add_argument("places", nargs="+", help="folders or files")
    chosen = parser.parse_args()
    files = [os.path.join(folder, name) for place in chosen.places
        for folder, _, names in (os.walk(place) if os.path.isdir(place) else [("", [], [place])]) for name in names]
    solids = []
    for file in sorted(files):
        if not re.search(r"\.(vtp|vtu|stl|ply|obj|exo|ex2)$", file):
            continue
        solid = read(file)
        if solid is None or len(solid.triangles) > chosen.most or solid.bad_edges() > 0 or solid.volume() == 0:
            print("# left out, open or too large:", os.path.basename(file), solid and len(solid.triangles),
                solid and solid.bad_edges())
            continue
        solids.append(solid)
    print("| first | second | how | triangles | in both | covers | volume error | bad edges | told | seconds | |")
    print("|---|---|---|---:|---:|---:|---:|---:|---|---:|---|")
    pairs = itertools.chain.from_iterable(map(pairs_of_one, solids))
    if not chosen.self:
        more = (pairs_of_two(*two) for two in itertools.combinations(solids, 2))
        pairs = itertools.chain(pairs, itertools.chain.from_iterable(more))
    right = [measure(*pair) for pair in pairs]
    print("# %d pairs, %d wrong" % (len(right), right.count(False)))


main()
