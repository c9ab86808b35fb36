# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bad pieces of meshes, with every filter: no process hangs or crashes, each message is said once, there
is at most one error, and the next request, for good pieces, has the answer that it has without the bad
ones before. What is wrong with the whole gives as many cells on four processes as on one. Run without
an argument this starts the processes; with the name of a file and partitions it is one of them, and
writes there what it has found."""

import re

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkPoints, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import (VTK_LINE, VTK_POLYGON, VTK_QUAD, VTK_TETRA, VTK_TRIANGLE,
    VTK_TRIANGLE_STRIP, VTK_VERTEX, vtkCellArray, vtkMultiBlockDataSet, vtkUnstructuredGrid)

import skdcases
import skdexchange
import skdpieces

RUNS = {4: ("cuts",)}
# Cases in pieces and gathered, with all that may be wrong; any of skdcases.py may be here.
CASES = ("closest data", "in a mesh", "rays along normals found", "thickness", "intersection",
    "remap from pieces", "overlapping cells")
# Of the other filters and ways a case each, with what they do not all share with these.
MORE_CASES = ("closest signed", "inside", "probe", "boolean", "compared", "adapted",
    "remap conservatively", "grid near surfaces", "refined", "curves and a surface", "curves")
MORE_HARMS = ("good", "other cells", "a point that is not finite", "nothing anywhere",
    "other arrays on one", "no points on one", "no cells on one", "repeated ids")


def both_data(mesh):
    return mesh.GetPointData(), mesh.GetCellData()


def as_grid(mesh):
    grid = vtkUnstructuredGrid()
    grid.SetPoints(mesh.GetPoints() or vtkPoints())
    for cell in range(mesh.GetNumberOfCells()):
        points = skdpieces.points_of(mesh, cell)
        grid.InsertNextCell(mesh.GetCellType(cell), len(points), points)
    for from_data, to_data in zip(both_data(mesh), both_data(grid)):
        to_data.ShallowCopy(from_data)
    return grid


def good(mesh, _rank, _processes):
    return mesh


def of_one(harm):
    """Of the third of four processes."""
    return lambda mesh, rank, processes: harm(mesh) if rank == processes // 2 else mesh


def without_arrays(mesh, *_):
    for data in both_data(mesh):
        data.Initialize()
    return mesh


def with_other_arrays(mesh):
    """Of the same names, with two components."""
    for data in both_data(mesh):
        for array in [data.GetArray(i) for i in range(data.GetNumberOfArrays())]:
            other = numpy_to_vtk(numpy.ones((array.GetNumberOfTuples(), 2)), deep=1)
            other.SetName(array.GetName())
            data.RemoveArray(array.GetName())
            data.AddArray(other)
    return mesh


def with_short_arrays(mesh):
    for data in both_data(mesh):
        for i in range(data.GetNumberOfArrays()):
            data.GetArray(i).SetNumberOfTuples(data.GetArray(i).GetNumberOfTuples() // 2)
    return mesh


def without_cells(mesh):
    empty = mesh.NewInstance()
    empty.SetPoints(mesh.GetPoints())
    return empty


def as_blocks(mesh):
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, mesh)
    return blocks


def with_other_nesting(mesh, rank, processes):
    blocks = as_blocks(mesh)
    return as_blocks(blocks) if rank == processes // 2 else blocks


def with_other_cells(mesh, rank, processes):
    """A cell of another type each."""
    mesh = as_grid(without_arrays(mesh))
    x = ((0, 0, 0), (0.5, 0, 0), (0.5, 1, 0), (0, 1, 0.2), (-0.2, 0.5, 0))
    kinds = ((VTK_VERTEX, 1), (VTK_LINE, 2), (VTK_QUAD, 4), (VTK_TETRA, 4), (VTK_POLYGON, 5),
        (VTK_TRIANGLE_STRIP, 4))
    for number, (kind, size) in enumerate(kinds):
        if number % processes == rank:
            ids = [mesh.GetPoints().InsertNextPoint(10 + number + a, b, c) for a, b, c in x[:size]]
            mesh.InsertNextCell(kind, size, ids)
    return mesh


def with_broken_cell(mesh, rank, processes):
    if rank + 1 == processes and mesh.GetNumberOfCells() > 0:
        mesh = as_grid(without_arrays(mesh))
        mesh.InsertNextCell(VTK_TRIANGLE, 3, (0, 1, 10**6))
    return mesh


def set_far_point(mesh, value):
    if mesh.GetNumberOfPoints() > 0:
        points = vtk_to_numpy(mesh.GetPoints().GetData())
        points[numpy.argmax(points @ (1, 0.1, 0.01))] = value
    return mesh


def with_point_not_finite(mesh, rank, processes):
    return set_far_point(mesh, numpy.nan) if rank + 1 == processes else mesh


def with_repeated_ids(mesh, *_):
    skdpieces.set_global_ids(mesh)
    return mesh


def with_ids_on_some(mesh, rank, processes):
    if rank != processes // 2:
        skdpieces.set_global_ids(mesh)
        for data in both_data(mesh):
            if data.GetGlobalIds():
                vtk_to_numpy(data.GetGlobalIds())[:] += 10**6 * rank
    return mesh


# What is wrong, and whether it is so of the whole, too.
HARMS = {
    "good": (good, True),
    "no arrays": (without_arrays, True),
    "other cells": (with_other_cells, True),
    "a broken cell": (with_broken_cell, True),
    "a point that is not finite": (with_point_not_finite, True),
    "nothing anywhere": (lambda mesh, *_: mesh.NewInstance(), True),
    "no arrays on one": (of_one(without_arrays), False),
    "other arrays on one": (of_one(with_other_arrays), False),
    "short arrays on one": (of_one(with_short_arrays), False),
    "another class on one": (of_one(as_grid), False),
    "blocks on one": (of_one(as_blocks), False),
    "blocks nested otherwise on one": (with_other_nesting, False),
    "no points on one": (of_one(lambda mesh: mesh.NewInstance()), False),
    "no cells on one": (of_one(without_cells), False),
    "repeated ids": (with_repeated_ids, False),
    "ids on some": (with_ids_on_some, False),
}
ERRORS = ("blocks on one", "blocks nested otherwise on one", "repeated ids") # said if the case has any of it


def cases(partition):
    """Those of skdcases.py, and of curves."""
    from paraview import simple

    yield from skdcases.cases(partition)
    wire = skdpieces.source("wire", partition, end=(8, 7, 5))
    yield "curves and a surface", skdcases.Case(simple.SkdTreeCurveSurfaceIntersection(
        Input=wire, Source=skdpieces.source("sphere", partition), CutCurves=1), [])
    yield "curves", skdcases.Case(simple.SkdTreeCurveIntersection(Input=wire,
        Source=skdpieces.source("wire", partition, count=20, end=(8, 7, 5.5))), [])


def copy_of(mesh):
    copy = mesh.NewInstance()
    copy.DeepCopy(mesh)
    return copy


def give(made, harm):
    """Other pieces, or with nothing the good ones, to the sources of a case."""
    rank, processes = skdpieces.process()
    for producer, mesh in made:
        algorithm = producer.GetClientSideObject()
        algorithm.SetOutput(harm(copy_of(mesh), rank, processes))
        algorithm.Modified()


def update(case):
    """The messages, without addresses, and how many points or rows and cells each output has."""
    window = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(window)
    algorithm = case.proxy.GetClientSideObject()
    algorithm.UpdatePiece(*skdpieces.process(), 0)
    sizes = []
    for port in range(algorithm.GetNumberOfOutputPorts()):
        leaves = [leaf for leaf in skdexchange.leaves(algorithm.GetOutputDataObject(port)) if leaf]
        sizes.append(sum(leaf.GetNumberOfRows() if leaf.IsA("vtkTable") else leaf.GetNumberOfCells()
            for leaf in leaves if not leaf.IsA("vtkSelection")))
    messages = re.split(r"(?=(?:ERROR|Warning|Generic Warning): In )", window.GetOutput())
    return [re.sub(r"\(0x\w+\)", "", message).strip() for message in messages if message.strip()], sizes


def answers_of(partitions):
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF) # messages are what is looked at
    found = {}
    for partition in partitions:
        skdpieces.MADE = []
        for name, case in cases(partition):
            if name not in CASES + MORE_CASES:
                continue
            if "SourceDistribution" in case.proxy.ListProperties():
                case.proxy.SourceDistribution = "Exchange"
            made = list(skdpieces.MADE)
            for harm, (function, is_of_whole) in HARMS.items():
                is_asked = name in CASES or harm in MORE_HARMS
                if is_asked and (is_of_whole or skdpieces.process()[1] > 1):
                    give(made, function)
                    bad = update(case)
                    give(made, good)
                    found[f"{name}, {harm}"] = *bad, *update(case)
    return found


def write(file, partitions):
    skdpieces.tell(file, answers_of(partitions))


def key_of(message):
    """Without numbers."""
    return re.sub(r"\d+", "#", re.sub(r" \(So it is on process.*", "", message))


def sum_of(sizes):
    return [sum(of_port) for of_port in zip(*sizes)]


def check(file, processes, partitions):
    of_one_process = answers_of(partitions)
    parts = skdpieces.told(file, processes)
    errors = dict.fromkeys(HARMS, 0)
    for title in parts[0]:
        name, harm = title.rsplit(", ", 1)
        messages, sizes, later_messages, later_sizes = zip(*(part[title] for part in parts))
        said = sorted(key_of(message) for of_process in messages for message in of_process)
        errors[harm] += sum(text.startswith("ERROR") for text in said)
        assert len(said) == len(set(said)), (title, said)
        assert sum(text.startswith("ERROR") for text in said) <= 1, (title, said)
        usual, expected, *_ = zip(*(part[name + ", good"] for part in parts))
        assert sum_of(later_sizes) == sum_of(expected), (title, later_sizes, expected)
        assert sorted(map(key_of, sum(later_messages, []))) == sorted(map(key_of, sum(usual, []))), (
            title, later_messages, usual)
        if title in of_one_process:
            assert sum_of(sizes) == of_one_process[title][1], (title, sizes, of_one_process[title])
    for harm in ERRORS:
        assert errors[harm] > len(CASES) // 2, errors


skdpieces.run(__file__, RUNS, "harmed_%d.pickle", write, check)
