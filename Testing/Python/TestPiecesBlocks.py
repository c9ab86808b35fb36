# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Blocks that two processes have one each, or parts of which one process alone meets: outputs of several
blocks have them at the numbers that one process gives them, Remap chooses and warns as one process
does, and points are listed that one process hides and another shows. Run without an argument this starts
the processes; with the name of a file and partitions it is one of them, and writes there what it finds."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkUnstructuredGrid
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkPointDataToCellData
from vtkmodules.vtkFiltersGeneral import vtkTransformFilter

import skdpieces

RUNS = {2: ("blocks",)}


def together(*meshes):
    """As blocks, some None."""
    blocks = vtkMultiBlockDataSet()
    blocks.SetNumberOfBlocks(len(meshes))
    for i, mesh in enumerate(meshes):
        blocks.SetBlock(i, mesh)
    return blocks


def own(*meshes):
    """As blocks, of which each process has every n-th; one process has all."""
    rank, processes = skdpieces.process()
    return together(*(mesh if i % processes == rank else None for i, mesh in enumerate(meshes)))


def appended(*meshes):
    append = vtkAppendFilter()
    for mesh in meshes:
        append.AddInputData(mesh)
    append.Update()
    return append.GetOutput()


def volume(size, to=0.0):
    """Tetrahedra, moved along x."""
    transform = vtkTransform()
    transform.Translate(to + 0.1, 0.2, 0.3)
    moved = vtkTransformFilter()
    moved.SetTransform(transform)
    moved.SetInputData(skdpieces.tetrahedra(size))
    moved.Update()
    return moved.GetOutput()


def donor(partition=None):
    """Tetrahedra with a field of cells."""
    mesh = skdpieces.tetrahedra(3)
    fields = vtkPointDataToCellData()
    fields.PassPointDataOn()
    fields.SetInputData(mesh if partition is None else skdpieces.piece(mesh, partition))
    fields.Update()
    return skdpieces.producer(fields.GetOutput())


def half_hidden():
    """Two triangles with a common edge, the first of which is hidden; two processes have one each."""
    rank, processes = skdpieces.process()
    corners = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0))
    shown = (((0, 1, 2), 32), ((1, 3, 2), 0))
    mesh = vtkUnstructuredGrid()
    parts = shown if processes == 1 else shown[rank:rank + 1]
    points = skdpieces.vtkPoints()
    mesh.SetPoints(points)
    used = sorted({point for ids, _ in parts for point in ids})
    for point in used:
        points.InsertNextPoint(corners[point])
    for ids, _ in parts:
        mesh.InsertNextCell(5, 3, [used.index(point) for point in ids])
    marks = numpy_to_vtk(numpy.array([mark for _, mark in parts], numpy.uint8), deep=1)
    marks.SetName("vtkGhostType")
    mesh.GetCellData().AddArray(marks)
    return mesh


class Messages:
    """The warnings of a filter."""

    def __init__(self, algorithm):
        self.count = 0
        algorithm.AddObserver("WarningEvent", self.hear)

    def hear(self, *_):
        self.count += 1


def cells_of_blocks(data):
    """Of each block how many cells it has, -1 where there is none."""
    blocks = (data.GetBlock(i) for i in range(data.GetNumberOfBlocks()))
    return [block.GetNumberOfCells() if block else -1 for block in blocks]


def output(proxy, port):
    proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(port)


def numbers_of_blocks(found):
    """Blocks at their numbers."""
    from paraview import simple

    source = donor()
    mesh = skdpieces.producer(own(volume(2), None, None, volume(1), None))
    found["inside"] = cells_of_blocks(
        output(simple.SkdTreePointInOut(Input=mesh, Source=source, Extract="Inside"), 1))
    found["overlaps"] = cells_of_blocks(output(simple.SkdTreeRemap(Input=mesh, Source=source,
        Method="Conservative First Order", GenerateOverlapMesh=1), 2))


def arrays_of_remap(found):
    """Which arrays the blocks of two dimensions get."""
    from paraview import simple

    source = donor()
    for name, meshes in (("surface first", (skdpieces.sphere(1.0), volume(1))),
        ("volume first", (volume(1), skdpieces.sphere(1.0)))):
        for method in ("Automatic", "Conservative First Order"):
            data = output(simple.SkdTreeRemap(
                Input=skdpieces.producer(own(*meshes)), Source=source, Method=method), 0)
            blocks = [data.GetBlock(i) for i in range(2)]
            found[f"{name}, {method}"] = [block and sorted(attributes.GetArrayName(i)
                for attributes in (block.GetPointData(), block.GetCellData())
                for i in range(attributes.GetNumberOfArrays())) for block in blocks]
            valid = [block and block.GetCellData().GetArray("SkdValid") for block in blocks]
            found[f"{name}, {method}, valid"] = [
                each and int(vtk_to_numpy(each).sum()) for each in valid]


def warnings_of_remap(found):
    """Of an Input that Source does not meet everywhere."""
    from paraview import simple

    rank, processes = skdpieces.process()
    near, far = volume(1), volume(1, to=20.0)
    mesh = appended(near, far) if processes == 1 else (near, far)[rank]
    for distribution in ("Replicate", "Exchange"):
        proxy = simple.SkdTreeRemap(Input=skdpieces.producer(mesh),
            Source=donor("cuts"), SourceDistribution=distribution,
            Method="Conservative First Order")
        messages = Messages(proxy.GetClientSideObject())
        proxy.UpdatePipeline()
        found[f"warnings, {distribution}"] = messages.count


def points_half_hidden(found):
    """Those of the shown triangle."""
    from paraview import simple

    source = skdpieces.producer(
        skdpieces.tiles(corner=(-1, -1, 1), first=(3, 0, 0.1), second=(0, 3, 0.2)))
    mesh = skdpieces.producer(half_hidden())
    found["lines"] = output(simple.SkdTreeClosestPoint(
        Input=mesh, Source=source, GenerateLines=1), 1).GetNumberOfCells()
    found["hits"] = output(simple.SkdTreeRays(Input=mesh, Source=source, Along="Direction",
        Direction=[0, 0, 1], GenerateLines=1), 1).GetNumberOfCells()


def write(file, _):
    found = {}
    for find in (numbers_of_blocks, arrays_of_remap, warnings_of_remap, points_half_hidden):
        find(found)
    skdpieces.tell(file, found)


def merged(first, second):
    """Blocks that one of two processes has each."""
    assert len(first) == len(second), (first, second)
    missing = (None, -1)
    assert all(a in missing or b in missing for a, b in zip(first, second)), (first, second)
    return [b if a in missing else a for a, b in zip(first, second)]


def check(file, processes, partitions):
    write(file % processes, partitions)
    *parts, alone = skdpieces.told(file, processes + 1)
    for name, expected in alone.items():
        of_parts = [part[name] for part in parts]
        if isinstance(expected, list):
            assert merged(*of_parts) == expected, (name, of_parts, expected)
        else:
            assert sum(of_parts) == expected, (name, of_parts, expected)
    for name in ("inside", "overlaps"):
        assert alone[name][2] == -1 and alone[name][0] > alone[name][3] > 0, alone[name]
    name = "Conservative First Order, valid"
    assert alone[f"surface first, {name}"][1] == alone[f"volume first, {name}"][0] > 0, alone
    assert alone["lines"] == alone["hits"] == 3, alone
    assert alone["warnings, Replicate"] == 0, alone


skdpieces.run(__file__, RUNS, "blocks_%d", write, check)
