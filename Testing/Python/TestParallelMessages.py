# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Three processes say a warning once, by the first that has it, and an error on one of them ends the
request on all with one message. Run without an argument this starts them; with one it is one of
them."""

import os
import re
import shutil
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import (VTK_TRIANGLE, vtkDataObject, vtkMultiBlockDataSet,
    vtkPolyData, vtkTable, vtkUnstructuredGrid)

import skdpieces
import skdtesting

PROCESSES = 3
WITH_BLOCK = 1  # the process that has one where others may have none
LIKE = r" \(So it is on process 0; processes 1 and 2 have the like\.\)"


def given(data):
    from paraview import simple

    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    return producer


def with_broken_cells():
    """A piece of a sphere, and one, two or three triangles of points that do not exist."""
    rank, _ = skdpieces.process()
    ball = skdpieces.piece(skdpieces.sphere(), "cuts")
    grid = vtkUnstructuredGrid()
    grid.SetPoints(ball.GetPoints())
    grid.SetCells(VTK_TRIANGLE, ball.GetPolys())
    for _ in range(rank + 1):
        grid.InsertNextCell(VTK_TRIANGLE, 3, (0, 1, 10**6))
    return grid


def blocks_here(*, here, elsewhere):
    """Composite data of such a block on one process, and of another, or none, on the others."""
    rank, _ = skdpieces.process()
    blocks = vtkMultiBlockDataSet()
    blocks.SetNumberOfBlocks(1)
    blocks.SetBlock(0, here if rank == WITH_BLOCK else elsewhere)
    return given(blocks)


def with_vectors(partition):
    """Triangles of a sphere; those of the last process lack the vectors."""
    rank, processes = skdpieces.process()
    ball = skdpieces.piece(skdpieces.sphere(has_normals=False), partition)
    if rank + 1 < processes:
        vectors = numpy_to_vtk(numpy.ones((ball.GetNumberOfCells(), 3)), deep=1)
        vectors.SetName("Vectors")
        ball.GetCellData().AddArray(vectors)
    return ball


def with_repeated_ids():
    ball = skdpieces.piece(skdpieces.sphere(), "cuts")
    for attributes, number in ((ball.GetPointData(), ball.GetNumberOfPoints()),
        (ball.GetCellData(), ball.GetNumberOfCells())):
        ids = numpy_to_vtk(numpy.arange(number), deep=1)
        ids.SetName("GlobalIds")
        attributes.SetGlobalIds(ids)
    return ball


def warned():
    """What is said, None for nothing, and the filter that says it."""
    from paraview import simple

    image = simple.Wavelet(WholeExtent=[-6, 6, -6, 6, -6, 6])
    ball = skdpieces.source("sphere", "cuts")
    nothing = given(vtkPolyData())
    for name in ("Replicate", "Exchange"):
        asked = {"SourceDistribution": name}
        yield "no closest point is found", simple.SkdTreeClosestPoint(
            Input=image, Source=nothing, **asked)
        yield "all points are outside", simple.SkdTreeProbe(Input=image, Source=nothing, **asked)
        yield "no ray hits anything", simple.SkdTreeRays(Input=ball, Source=nothing, **asked)
        yield "everything is outside", simple.SkdTreePointInOut(
            Input=image, Source=nothing, **asked)
        yield r"broken.*" + LIKE, simple.SkdTreeClosestPoint(
            Input=image, Source=given(with_broken_cells()), **asked)
        yield "Input is not closed", simple.SkdTreeCompareSurfaces(
            Input=skdpieces.source("tiles", "cuts"), Source=ball, SignedDistance=1, **asked)
        yield "the output is empty", simple.SkdTreeMeshRefinement(
            Input=nothing, Parts=ball, **asked)
        yield "Nothing is refined", simple.SkdTreeMeshRefinement(
            Input=skdpieces.source("tiles", "cuts"), Parts=nothing, **asked)
        yield "Nothing is refined", simple.SkdTreeMeshRefinement(
            Input=skdpieces.source("tiles", "cuts", corner=(50, 0, 0), first=(51, 0, 0),
                second=(50, 1, 0)), Parts=ball, **asked)
    yield "Input has no faces", simple.SkdTreeSurfaceIntersection(Input=nothing, Source=ball)
    for partition in ("one process", "everywhere"):
        yield None, simple.SkdTreeSurfaceIntersection(
            Input=skdpieces.source("tiles", partition), Source=ball)
    yield r"broken.*" + LIKE, simple.SkdTreeAttach(Input=given(with_broken_cells()))
    part = skdpieces.piece(skdpieces.sphere(), "cuts")
    for blocks in (blocks_here(here=part, elsewhere=None), blocks_here(here=part, elsewhere=vtkTable())):
        yield None, simple.SkdTreeAttach(Input=blocks)
        yield None, simple.SkdTreeClosestPoint(Input=blocks, Source=ball)
        yield None, simple.SkdTreeClosestPoint(Input=image, Source=blocks)
    yield "There is no surface to project", simple.SkdTreeMeshRefinement(
        Input=ball, MinimumLevel=1, PointPlacement="Surface", Surface=nothing)
    yield "base mesh is not refined", simple.SkdTreeAMR(
        Input=nothing, AutomaticBounds=0, BaseBounds=[0, 1, 0, 1, 0, 1])


def faulty():
    """The same for errors. Processes that have none of their own output nothing."""
    from paraview import simple

    image = simple.Wavelet(WholeExtent=[-6, 6, -6, 6, -6, 6])
    ball = skdpieces.source("sphere", "cuts")
    for name in ("Replicate", "Exchange"):
        asked = {"SourceDistribution": name}
        yield "Global ids must be", simple.SkdTreeClosestPoint(
            Input=image, Source=given(with_repeated_ids()), **asked)
        yield "Vectors", simple.SkdTreeRays(Input=given(with_vectors("cuts")), Source=ball,
            Start="Cell Centers", Along="Array", DirectionArray="Vectors", **asked)
    yield "Source is not set", simple.SkdTreeProbe(Input=ball)
    yield "neither a mesh nor composite data", simple.SkdTreeAttach(Input=given(vtkTable()))
    for others in (None, vtkTable()):
        blocks = blocks_here(here=vtkTable(), elsewhere=others)
        yield "has no mesh among its blocks", simple.SkdTreeAttach(Input=blocks)
        yield "has no mesh among its blocks", simple.SkdTreeClosestPoint(Input=blocks, Source=ball)
        yield "has no mesh among its blocks", simple.SkdTreeProbe(Input=image, Source=blocks)


def one_of_them():
    for kind, cases in (("warning", warned()), ("error", faulty())):
        for number, (_, proxy) in enumerate(cases):
            announce(f"{kind} {number}")
            proxy.UpdatePipeline()
            output = proxy.GetClientSideObject().GetOutputDataObject(0)
            if kind == "error" and skdpieces.process()[0] + 1 < PROCESSES:
                cells = output.GetNumberOfElements(vtkDataObject.CELL)
                assert cells == 0, f"there is an answer of error {number}"
    announce("end")


def announce(title):
    """By the first process, when all are there."""
    from vtkmodules.vtkParallelCore import vtkMultiProcessController

    controller = vtkMultiProcessController.GetGlobalController()
    sys.stderr.flush()
    controller.Barrier()
    if controller.GetLocalProcessId() == 0:
        print(f"== {title}", file=sys.stderr, flush=True)
    controller.Barrier()


def check(said):
    titles = re.findall("^== (.*)$", said, re.M)
    texts = re.split("^== .*$", said, flags=re.M)[1:]
    expected = [("WARN", text) for text, _ in warned()] + [("ERR", text) for text, _ in faulty()]
    assert titles[-1] == "end" and len(titles) == len(expected) + 1, said
    for title, text, (kind, wanted) in zip(titles, texts, expected):
        messages = re.findall(r"(WARN|ERR)\| (.*)", text)
        if wanted is None:
            assert not messages, (title, text)
            continue
        assert len(messages) == 1 and messages[0][0] == kind, (title, text)
        assert re.search(wanted, messages[0][1]), (title, wanted, text)


if len(sys.argv) > 1:
    one_of_them()
elif shutil.which("mpiexec") is None or shutil.which("pvbatch") is None:
    skdtesting.skip("there is no mpiexec or no pvbatch")
else:
    check(skdtesting.run_in_parallel(
        os.path.abspath(__file__), "messages", PROCESSES, listens=True))
