# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two processes of pvbatch give what one gives. Run without an argument this starts them; with the
name of a file it is one of them, and writes its part of the answers there."""

import os
import shutil
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdpieces
import skdtesting


def lattice():
    from paraview import simple

    return simple.Wavelet(WholeExtent=[-6, 6, -6, 6, -6, 6])


def ball(radius, **arguments):
    """A source whose cells have the same ids on any number of processes."""
    return skdpieces.source("sphere", "runs", radius=radius, **arguments)


def answers(proxy, arrays):
    """A row for each point of this process: where it is and what was found."""
    proxy.UpdatePipeline()
    data = proxy.GetClientSideObject().GetOutputDataObject(0)
    columns = [numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])]
    for name in arrays:
        values = vtk_to_numpy(data.GetPointData().GetArray(name))
        columns.append(values.reshape(len(values), -1))
    return numpy.hstack(columns)


def nearest(source):
    from paraview import simple

    field = simple.Calculator(Input=source, Function="coordsX", ResultArrayName="F")
    closest = simple.SkdTreeClosestPoint(
        Input=lattice(), Source=field, SignedDistance=1, InterpolateSourceData=1)
    return answers(closest, ("SkdDistance", "SkdClosestPoint", "SkdClosestCellId", "F"))


def probed(source):
    from paraview import simple

    probe = simple.SkdTreeProbe(Input=lattice(), Source=source, OutsidePoints="Nearest Cell")
    return answers(probe, ("SkdSourceCellId", "SkdDistance", "SkdParametricCoordinates", "Temp"))


def inside(source):
    from paraview import simple

    test = simple.SkdTreePointInOut(Input=lattice(), Source=source, BoundaryBand=0.1)
    return answers(test, ("SkdInside", "SkdPartId", "SkdDepth", "SkdConfidence", "SkdOnBoundary"))


def all_answers():
    """Of each filter and source."""
    from paraview import simple

    brain = simple.XMLPolyDataReader(
        FileName=[os.path.join(skdtesting.DATA_DIR, "fly_brain_lateral_horn.vtp")])
    flow = simple.XMLUnstructuredGridReader(
        FileName=[os.path.join(skdtesting.DATA_DIR, "disk_flow.vtu")])
    sphere = ball(4.0, theta=50, phi=50)
    return [nearest(sphere), nearest(brain), probed(flow), inside(sphere), inside(flow)]


def centres_found(**asked):
    """A row for each cell of this process that a query finds: where it is, and its distance."""
    from paraview import simple

    query = simple.SkdTreeSpatialQuery(Input=simple.Wavelet(WholeExtent=[-6, 6, -6, 6, -6, 6]),
        Source=ball(3.0, theta=8, phi=8), **asked)
    query.UpdatePipeline()
    data = query.GetClientSideObject().GetOutputDataObject(0)
    boxes = numpy.array([data.GetCell(i).GetBounds() for i in range(data.GetNumberOfCells())])
    distances = vtk_to_numpy(data.GetCellData().GetArray("SkdDistance"))
    return numpy.hstack([boxes.reshape(-1, 6), distances.reshape(-1, 1)])


def all_centres_found():
    box = {"Shape": "Box", "BoxPosition": [-4.5, -4.5, -4.5], "BoxLength": [9, 9, 9]}
    point = {"Shape": "Sphere", "SphereCenter": [0.2, 0.3, 0.4], "SphereRadius": 0}
    return [
        centres_found(Relation="Overlap", **box),
        centres_found(Relation="Containment", **box),
        centres_found(Relation="Overlap", Shape="Source Cells"),
        centres_found(Relation="Nearest", NumberOfNearestCells=100, **point),
    ]


def cells_of(proxy):
    """A row for each cell of this process: its corners in order."""
    proxy.UpdatePipeline()
    data = proxy.GetClientSideObject().GetOutputDataObject(0)
    rows = numpy.full((data.GetNumberOfCells(), 24), -99.0)
    for i, row in enumerate(rows):
        points = data.GetCell(i).GetPoints()
        corners = sorted(points.GetPoint(k) for k in range(points.GetNumberOfPoints()))
        row[:3 * len(corners)] = numpy.array(corners).ravel()
    return rows


def all_refined():
    """Without hanging points: what one process cuts the other does, too, where they meet."""
    from paraview import simple

    image = simple.Wavelet(WholeExtent=[-6, 6, -6, 6, -6, 6])
    parts = ball(2.3, center=(0.3, 0.2, 0.4), theta=8, phi=8)
    return [
        cells_of(simple.SkdTreeMeshRefinement(Input=image, Parts=parts, MaximumLevel=2)),
        cells_of(simple.SkdTreeMeshRefinement(
            Input=image, Parts=parts, MaximumLevel=1, GrowingLayers=1)),
        cells_of(simple.SkdTreeAMR(Input=parts, OutputType="Unstructured Grid", Balance="Face",
            BaseDimensions=[3, 2, 2])),
    ]


def all_cells():
    return all_centres_found() + all_refined()


if len(sys.argv) > 1:
    numpy.savez(sys.argv[1] % skdtesting.process_id(), *all_answers(), *all_cells())
elif shutil.which("mpiexec") is None or shutil.which("pvbatch") is None:
    skdtesting.skip("there is no mpiexec or no pvbatch")
else:
    alone = all_answers()
    file = skdtesting.temporary("parallel%d.npz")
    skdtesting.run_in_parallel(os.path.abspath(__file__), file)
    parts = [list(numpy.load(file % process).values()) for process in (0, 1)]
    count = len(alone)
    for whole, first, second in zip(alone, *(part[:count] for part in parts)):
        assert len(whole) == 13**3 and min(len(first), len(second)) > 0
        assert max(len(first), len(second)) < len(whole)
        # The processes share the points where their pieces meet.
        together = numpy.unique(numpy.vstack([first, second]), axis=0)
        skdtesting.assert_same(together, numpy.unique(whole, axis=0))
    # Cells are on one process each: together they are those that one finds, each once.
    for whole, first, second in zip(all_cells(), *(part[count:] for part in parts)):
        assert min(len(first), len(second)) > 0
        together = numpy.vstack([first, second])
        skdtesting.assert_same(
            together[numpy.lexsort(together.T)], whole[numpy.lexsort(whole.T)])
