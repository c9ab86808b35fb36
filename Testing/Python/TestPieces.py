# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes in pieces on two, three and four processes give the answers of one process: for every
filter, and for each way in which the pieces may lie. Run without an argument this starts the
processes; with the name of a file and partitions it is one of them, and writes its part of the
answers there."""

import os
import shutil
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdpieces
import skdtesting

# Each partition is tested with one number of processes.
RUNS = {
    2: ("everywhere", "cuts, ghosts", "one process"),
    3: ("cuts", "round robin, global ids", "one reader"),
    4: ("runs", "round robin", "cuts, doubled"),
}
WITHOUT_VALUE = 12345.0 # stands for NaN, which is not equal to itself


def rows(proxy, arrays, port=0, of_cells=False):
    """A row for each point, or cell that is no ghost, of this process: where it is, and the arrays;
    of a table the columns."""
    proxy.UpdatePipeline()
    data = proxy.GetClientSideObject().GetOutputDataObject(port)
    if data.IsA("vtkTable"):
        columns = [vtk_to_numpy(data.GetColumnByName(name)) for name in arrays
            if data.GetColumnByName(name)]
        return numpy.array(columns).T if columns else None
    count = data.GetNumberOfCells() if of_cells else data.GetNumberOfPoints()
    if count == 0:
        return None
    get = (lambda i: data.GetCell(i).GetBounds()) if of_cells else data.GetPoint
    attributes = data.GetCellData() if of_cells else data.GetPointData()
    columns = [numpy.array([get(i) for i in range(count)])]
    for name in arrays:
        columns.append(vtk_to_numpy(attributes.GetArray(name)).reshape(count, -1))
    result = numpy.nan_to_num(numpy.hstack(columns), nan=WITHOUT_VALUE)
    ghosts = attributes.GetArray("vtkGhostType") if of_cells else None
    return result if ghosts is None else result[vtk_to_numpy(ghosts) & 1 == 0]


def answers_of_one_reader():
    """Input and Source come of the same source, which can give any piece."""
    from paraview import simple

    image = simple.Wavelet(WholeExtent=[-6, 6, -6, 6, -6, 6])
    contour = simple.Contour(Input=image, ContourBy=["POINTS", "RTData"], Isosurfaces=[157.0])
    cells = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5]))
    outer = simple.ExtractSurface(Input=cells)
    yield "contour", rows(
        simple.SkdTreeClosestPoint(Input=image, Source=contour), ["SkdDistance"])
    yield "outer surface", rows(
        simple.SkdTreeClosestPoint(Input=cells, Source=outer), ["SkdDistance"])
    yield "itself", rows(simple.SkdTreeProbe(Input=outer, Source=image), ["SkdDistance"])
    yield "image", rows(
        simple.SkdTreeRemap(Input=cells, Source=image, PassInputData=0), ["RTData"])


def answers(partition):
    """Of each filter, with meshes in pieces as Input, as Source and as a third input."""
    from paraview import simple

    if partition == "one reader":
        yield from answers_of_one_reader()
        return
    image = simple.Wavelet(WholeExtent=[-6, 6, -6, 6, -6, 6])
    ball = skdpieces.source("sphere", partition)
    other = skdpieces.source(
        "sphere", partition, radius=3.0, center=(1.234, 0.5, 0.25), theta=20, phi=20)
    cells = skdpieces.source("tetrahedra", partition)
    yield "closest", rows(simple.SkdTreeClosestPoint(Input=image, Source=ball), ["SkdDistance"])
    yield "closest of both", rows(
        simple.SkdTreeClosestPoint(Input=ball, Source=other, SignedDistance=1), ["SkdDistance"])
    yield "closest signed", rows(
        simple.SkdTreeClosestPoint(Input=image, Source=cells, SignedDistance=1), ["SkdDistance"])
    yield "inside", rows(
        simple.SkdTreePointInOut(Input=image, Source=ball), ["SkdInside", "SkdConfidence"])
    yield "inside cells", rows(
        simple.SkdTreePointInOut(Input=image, Source=cells), ["SkdInside", "SkdConfidence"])
    yield "probe", rows(simple.SkdTreeProbe(Input=image, Source=cells), ["Field"])
    yield "rays", rows(simple.SkdTreeRays(Input=other, Source=ball), ["SkdRayDistance"])
    yield "rays along normals found", rows(
        simple.SkdTreeRays(Input=skdpieces.source("sphere", partition, has_normals=False),
            Source=other), ["SkdRayDistance"])
    yield "thickness", rows(simple.SkdTreeWallThickness(Input=ball), ["SkdThickness"])
    yield "thickness to", rows(
        simple.SkdTreeWallThickness(Input=other, Source=ball), ["SkdThickness"])
    yield "boolean", rows(
        simple.SkdTreeBooleanOperation(Input=ball, Source=other), [], of_cells=True)
    yield "compared", rows(simple.SkdTreeCompareSurfaces(Input=ball, Source=other),
        ["HausdorffDistance", "Area"], port=2)
    yield "intersection", rows(
        simple.SkdTreeSurfaceIntersection(Input=ball, Source=other, JoinCurves=0), [],
        of_cells=True)
    yield "split", rows(
        simple.SkdTreeSurfaceIntersection(Input=ball, Source=other, SplitSurfaces=1), [], port=5,
        of_cells=True)
    yield "remap", rows(simple.SkdTreeRemap(Input=cells, Source=image), ["RTData"])
    yield "remap from pieces", rows(simple.SkdTreeRemap(Input=image, Source=cells), ["Field"])
    yield "remap conservatively", rows(
        simple.SkdTreeRemap(Input=image, Source=cells, Method="Conservative Second Order",
            ResultsOn="Cells"), ["Field"], of_cells=True)
    yield "remap to points", rows(
        simple.SkdTreeRemap(Input=cells, Source=image, Method="Conservative First Order",
            ResultsOn="Points"), ["RTData"])
    blocks = simple.GroupDatasets(Input=[ball, other])
    yield "blocks", rows(
        simple.SkdTreeClosestPoint(Input=image, Source=blocks),
        ["SkdDistance", "SkdClosestBlockIndex"])
    yield "nearest cells", rows(
        simple.SkdTreeSpatialQuery(Input=cells, Relation="Nearest", Shape="Sphere",
            SphereCenter=[0.2, 0.3, 0.4], SphereRadius=0, NumberOfNearestCells=50),
        ["SkdDistance"], of_cells=True)
    yield "overlapping cells", rows(
        simple.SkdTreeSpatialQuery(
            Input=cells, Source=ball, Relation="Overlap", Shape="Source Cells"), [],
        of_cells=True)
    yield "grid", rows(
        simple.SkdTreeAMR(Input=ball, Field=cells, FieldArrays=["Field"], ComputeInside=1,
            OutputType="Unstructured Grid", MaximumLevel=3), ["SkdInside"], of_cells=True)
    yield "refined", rows(
        simple.SkdTreeMeshRefinement(Input=cells, Parts=ball, MaximumLevel=1), [], of_cells=True)


def write(file, partitions):
    found = {}
    for partition in partitions:
        for name, part in answers(partition):
            if part is not None:
                found[partition + ": " + name] = part
    numpy.savez(file, **found)


def in_order(table):
    """Each row once (processes share the points where their pieces meet), in order but for
    rounding."""
    table = numpy.unique(table, axis=0)
    return table[numpy.lexsort(numpy.round(table, 9).T[::-1])]


def check(whole, parts):
    for name, expected in whole.items():
        together = numpy.vstack([part[name] for part in parts if name in part])
        first, second = in_order(expected), in_order(together)
        assert first.shape == second.shape, (name, first.shape, second.shape)
        numpy.testing.assert_allclose(first, second, rtol=1e-12, atol=1e-12, err_msg=name)


if len(sys.argv) > 1:
    file, *partitions = sys.argv[1].split("|")
    rank, count = skdpieces.process()
    write(file % rank, partitions)
elif shutil.which("mpiexec") is None or shutil.which("pvbatch") is None:
    skdtesting.skip("there is no mpiexec or no pvbatch")
else:
    for processes, partitions in RUNS.items():
        whole = skdtesting.temporary("pieces_of_one.npz")
        write(whole, partitions)
        file = skdtesting.temporary(f"pieces_of_{processes}_%d.npz")
        skdtesting.run_in_parallel(
            os.path.abspath(__file__), "|".join((file, *partitions)), processes)
        check(dict(numpy.load(whole)),
            [dict(numpy.load(file % rank)) for rank in range(processes)])
