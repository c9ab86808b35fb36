# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which of several points and cells that are equally near is taken, without global ids: the lowest of
the joined pieces, on any number of processes, gathered or exchanged. Where each process has a run of
the cells that is the one which one process takes of the whole. Run without an argument this starts the
processes; with the name of a file and partitions it is one of them, and writes there what it finds."""

import itertools

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_VERTEX, vtkUnstructuredGrid

import skdpieces
import skdtesting

RUNS = {2: ("runs", "one process"), 4: ("runs", "some empty", "round robin", "cuts"), 8: ("runs",)}
IN_ORDER = ("runs", "one process", "some empty")
NUMBER = "Number"
ARRAYS = ("SkdDistance", "SkdClosestPoint", "SkdClosestCellId")


def questions():
    """Points in the middle of block(), of its sides and edges, on and above what its cells share."""
    cloud = vtkUnstructuredGrid()
    points = vtkPoints()
    at = numpy.array(list(itertools.product((-0.25, 0, 0.125, 0.25, 0.5, 0.75, 1, 1.25), repeat=3)))
    points.SetData(numpy_to_vtk(at, deep=1))
    cloud.SetPoints(points)
    for i in range(len(at)):
        cloud.InsertNextCell(VTK_VERTEX, 1, (i,))
    return cloud


def surface():
    mesh = skdpieces.block()
    mesh.GetPointData().Initialize()
    mesh.GetCellData().Initialize()
    number = numpy_to_vtk(numpy.arange(mesh.GetNumberOfCells()), deep=1)
    number.SetName(NUMBER)
    mesh.GetCellData().AddArray(number)
    return mesh


def found_in(input, source):
    """Rows of what is found at each point, both ways."""
    from paraview import simple

    sides = [skdpieces.producer(mesh) for mesh in (input, source)]
    for distribution in ("Replicate", "Exchange"):
        proxy = simple.SkdTreeClosestPoint(
            Input=sides[0], Source=sides[1], SourceDistribution=distribution)
        proxy.UpdatePipeline()
        data = proxy.GetClientSideObject().GetOutputDataObject(0)
        count = data.GetNumberOfPoints()
        columns = [skdpieces.locations(data, of_cells=False).reshape(count, 3)]
        columns += [vtk_to_numpy(data.GetPointData().GetArray(name)).reshape(count, -1)
            for name in ARRAYS if count]
        yield distribution, numpy.hstack(columns) if count else numpy.empty((0, 8))


def write(file, partitions):
    found = {}
    for partition in partitions:
        source = skdpieces.piece(surface(), partition)
        number = source.GetCellData().GetArray(NUMBER)
        found[partition] = vtk_to_numpy(number).copy() if number else numpy.empty(0, dtype=int)
        for distribution, rows in found_in(skdpieces.piece(questions(), partition), source):
            found[f"{partition}, {distribution}"] = rows
    numpy.savez(file, **found)


def check(file, processes, partitions):
    parts = [dict(numpy.load(file % rank)) for rank in range(processes)]
    for partition in partitions:
        order = numpy.concatenate([part[partition] for part in parts])
        assert partition not in IN_ORDER or (order == numpy.arange(len(order))).all()
        whole = dict(found_in(questions(), skdpieces.in_order(surface(), order)))
        for distribution, rows in whole.items():
            told = numpy.vstack([part[f"{partition}, {distribution}"] for part in parts])
            first, second = numpy.unique(rows, axis=0), numpy.unique(told, axis=0)
            assert numpy.array_equal(first, second), (processes, partition, distribution,
                len(first), len(second))
            assert len(first) == len(rows), "each point has one answer"


skdpieces.run(__file__, RUNS, "ties_%d.npz", write, check)
