# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cells and points that several processes have without ghost marks are listed once: rows of tables,
intersections, hits, weights and overlaps are as many as those of one process, and in the same places. Run without
an argument this starts the processes; with the name of a file and partitions it is one of them, and
writes there what it lists."""

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdexchange
import skdpieces
import skdtesting

RUNS = {2: ("cuts, doubled",), 3: ("random",)}
INPUTS = "hits of curves"
LEFT_OUT = "cells left out"


def filters(partition):
    """Names, filters and the output ports that are lists."""
    from paraview import simple

    def of(maker, **asked):
        return skdpieces.source(maker, partition, **asked)

    ball = of("sphere")
    other = of("sphere", radius=3.0, center=(1.234, 0.5, 0.25), theta=20, phi=20)
    cells, few, wire = of("tetrahedra"), of("tetrahedra", size=2), of("wire", end=(8, 7, 5))
    yield "intersection", simple.SkdTreeSurfaceIntersection(
        Input=ball, Source=other, JoinCurves=0, Clearance=0.3), (0, 2, 3)
    yield "found cells", simple.SkdTreeSpatialQuery(
        Input=few, Source=of("sphere", radius=2.1), Relation="Overlap", Shape="Source Cells"), (0, 1, 2)
    yield "adjacent cells", simple.SkdTreeSpatialQuery(
        Input=few, Source=few, Relation="Adjacency", Shape="Source Cells"), (0, 1, 2)
    yield "cells in a ball", simple.SkdTreeSpatialQuery(Input=cells, Relation="Overlap",
        Shape="Sphere", SphereCenter=[0.2, 0.3, 0.4], SphereRadius=2), (0, 1, 2)
    yield "curves", simple.SkdTreeCurveSurfaceIntersection(
        Input=wire, Source=ball, CutCurves=1), (0, 1)
    for lines in (0, 1):
        yield f"hits {lines}", simple.SkdTreeRays(Input=other, Source=cells, Start="Cell Centers",
            Along="Direction", Direction=[0.2, 0.3, 1.0], Hits="All Hits", GenerateLines=lines), (1,)
    yield "hits from points", simple.SkdTreeRays(Input=other, Source=cells, Along="Direction",
        Direction=[0.2, 0.3, 1.0], Hits="All Hits", GenerateLines=1), (1,)
    yield "lines to closest points", simple.SkdTreeClosestPoint(
        Input=other, Source=ball, GenerateLines=1), (1,)
    yield "lines", simple.SkdTreeProbe(Input=wire, Source=cells, ProbeLines=1), (1, 2)
    yield "overlaps", simple.SkdTreeRemap(Input=of("tiles", first=(0.9, 0, 0), count=7),
        Source=of("tiles"), Method="Conservative First Order", GenerateWeights=1,
        GenerateOverlapMesh=1), (1, 2)


def rows_of(data):
    """Where cells are, or as many rows as a table or a selection has."""
    rows = [numpy.empty((0, 6))]
    for leaf in skdexchange.leaves(data):
        if leaf.IsA("vtkTable"):
            rows.append(numpy.zeros((leaf.GetNumberOfRows(), 6)))
        elif leaf.IsA("vtkSelection"):
            rows += [numpy.zeros((leaf.GetNode(i).GetSelectionList().GetNumberOfTuples(), 6))
                for i in range(leaf.GetNumberOfNodes())]
        else:
            rows.append(skdpieces.locations(leaf, of_cells=True))
            assert not leaf.GetCellData().HasArray("vtkGhostType"), "marks are given out"
    return numpy.vstack(rows)


def hits_of_curves(partition):
    """How often each cell of the Input is hit, which all processes tell of all their cells."""
    from paraview import simple

    proxy = simple.SkdTreeCurveSurfaceIntersection(
        Input=skdpieces.source("wire", partition, end=(8, 7, 5)),
        Source=skdpieces.source("sphere", partition))
    proxy.UpdatePipeline()
    data = proxy.GetClientSideObject().GetOutputDataObject(2)
    hits = vtk_to_numpy(data.GetCellData().GetArray("SkdNumberOfHits"))
    return numpy.hstack([skdpieces.locations(data, of_cells=True), hits.reshape(-1, 1)])


def cells_left_out(partition):
    """How many cells a filter says it has left out that have a point which is not finite: of the
    Source, of which each process has all or those that may be near, as one number each."""
    from paraview import simple

    def faces(value, several):
        mesh = skdpieces.sphere(theta=8, phi=8, has_normals=False)
        points = vtk_to_numpy(mesh.GetPoints().GetData())
        points[numpy.flatnonzero(points[:, 0] > 1.0)[:several]] = value
        return mesh

    counts = []
    for value, several in ((numpy.nan, 1), (numpy.nan, 4), (numpy.inf, 1)):
        producer = skdpieces.producer(skdpieces.piece(faces(value, several), partition))
        proxy = simple.SkdTreeSurfaceIntersection(SourceDistribution="Replicate", Source=producer,
            Input=skdpieces.source("sphere", partition, radius=3.0, center=(1.2, 0.5, 0.2)))
        proxy.UpdatePipeline()
        counts.append(skdexchange.report_of(proxy, "FacesLeftOut"))
    return numpy.array([counts])


def write(file, partitions):
    found = {}
    for partition in partitions:
        for name, proxy, ports in filters(partition):
            for distribution in ("Replicate", "Exchange"):
                proxy.SourceDistribution = distribution
                proxy.UpdatePipeline()
                outputs = [proxy.GetClientSideObject().GetOutputDataObject(port) for port in ports]
                for port, data in zip(ports, outputs):
                    found[f"{partition}, {name}, {distribution}, port {port}"] = rows_of(data)
        found[f"{partition}, {INPUTS}"] = hits_of_curves(partition)
        found[f"{partition}, {LEFT_OUT}"] = cells_left_out(partition)
    numpy.savez(file, **found)


def in_order(rows, each_once=False):
    rows = numpy.round(rows, 6) + 0.0
    return numpy.unique(rows, axis=0) if each_once else rows[numpy.lexsort(rows.T[::-1])]


def check(file, processes, partitions):
    whole = skdtesting.temporary("doubled_of_one.npz")
    write(whole, partitions)
    parts = [dict(numpy.load(file % rank)) for rank in range(processes)]
    for name, rows in numpy.load(whole).items():
        together = numpy.vstack([part[name] for part in parts])
        first, second = (in_order(each, name.endswith((INPUTS, LEFT_OUT))) for each in (rows, together))
        assert len(first) > 0 and first.shape == second.shape, (name, first.shape, second.shape)
        numpy.testing.assert_allclose(first, second, atol=2e-6, err_msg=name)


skdpieces.run(__file__, RUNS, "doubled_%d.npz", write, check)
