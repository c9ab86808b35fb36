# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where curves in pieces on several processes meet a surface in pieces is what one process finds of the
joined pieces, to the last bit: points, also those at joints of curve cells of different processes,
numbers and ids of curves, data, the curves cut there, and how often each cell is hit. Run without an
argument this starts the processes; with the name of a file and partitions it is one of them, and writes
there what it outputs."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_LINE, VTK_POLY_LINE, VTK_QUADRATIC_EDGE, VTK_VERTEX,
    vtkDataSetAttributes, vtkMultiBlockDataSet, vtkUnstructuredGrid)

import skdexchange
import skdpieces

RUNS = {
    2: ("everywhere", "cuts, ghosts"),
    3: ("round robin", "cuts, mixed global ids", "cuts, doubled"),
    4: ("runs", "some empty", "random", "one process"),
    8: ("round robin",),
}
NUMBERS = ("Number", "SourceNumber") # of cells of Input and Source
PORTS = ("hits", "cut curves")


def grid_of(points, cells):
    """Of types and point numbers."""
    grid = vtkUnstructuredGrid()
    at = vtkPoints()
    at.SetDataTypeToDouble()
    at.SetData(numpy_to_vtk(numpy.array(points, dtype=float), deep=1))
    grid.SetPoints(at)
    for kind, ids in cells:
        grid.InsertNextCell(kind, len(ids), ids)
    heights = numpy_to_vtk(numpy.sin(numpy.array(points) @ (5, 7, 11)), deep=1)
    heights.SetName("Height")
    grid.GetPointData().AddArray(heights)
    return grid


def joints(height=0.0):
    """Lines end to end at points, on edges and inside of faces of tiles(), that go through, come back,
    go along it, or are three or four at one point; and cells that are no curves."""
    places = [(i / 9, j / 11) for i in range(1, 9, 2) for j in range(1, 11, 3)]
    places += [(i / 9 + 1 / 18, j / 11) for i in range(2, 8, 2) for j in range(2, 10, 4)]
    places += [(0.05 + 0.13 * i, 0.03 + 0.17 * i) for i in range(5)]
    points, cells = [], []

    def line(*ends):
        first = len(points)
        points.extend(ends)
        cells.append((VTK_LINE if len(ends) == 2 else VTK_POLY_LINE, range(first, len(points))))

    for n, (x, y) in enumerate(places):
        middle = (x, y, height)
        line((x + 0.01, y, height - 1), (x, y, height - 0.3), middle)
        if n % 4 != 1:
            line(middle, (x, y + 0.02, height + (1 if n % 4 != 2 else -1)))
        if n % 4 == 1: # the other way around
            line((x - 0.03, y, height + 1), middle)
        if n % 5 == 0:
            line(middle, (x + 1 / 9, y, height))
        if n % 7 == 0:
            line(middle, (x - 0.2, y + 0.1, height + 0.7))
    cells.insert(7, (VTK_VERTEX, (3,)))
    cells.insert(20, (VTK_LINE, (4, 4)))
    bend = len(points)
    points += [(0.31, 0.41, height - 0.5), (0.33, 0.4, height), (0.36, 0.43, height - 0.2),
        (0.37, 0.48, height + 0.4), (0.34, 0.45, height + 0.3)]
    cells.append((VTK_QUADRATIC_EDGE, (bend, bend + 1, bend + 2)))
    cells.append((VTK_QUADRATIC_EDGE, (bend + 1, bend + 3, bend + 4)))
    order = numpy.random.default_rng(3).permutation(len(cells))
    return grid_of(points, [cells[i] for i in order])


def as_blocks(*meshes):
    if len(meshes) == 1:
        return meshes[0]
    blocks = vtkMultiBlockDataSet()
    for i, mesh in enumerate(meshes):
        blocks.SetBlock(i, mesh)
    return blocks


def meshes():
    """Names, and the meshes that are blocks of Input and Source."""
    wire = skdpieces.wire(end=(8, 7, 5))
    yield "a wire", [wire], [skdpieces.sphere()]
    yield "a wire in a mesh", [skdpieces.wire(count=24, end=(4, 3, 2))], [skdpieces.tetrahedra(size=2)]
    yield "joints", [joints()], [skdpieces.tiles()]
    yield "joints of blocks", [joints(), skdpieces.wire(end=(0.6, 0.7, 0.4)), joints()], [
        skdpieces.tiles(), skdpieces.tiles(corner=(0, 0, 0.25), first=(1, 0, 0.25), second=(0, 1, 0.25))]


def numbered(mesh, side):
    mesh.GetCellData().RemoveArray("Elevation") # which points have, too
    number = numpy_to_vtk(numpy.arange(mesh.GetNumberOfCells()), deep=1)
    number.SetName(NUMBERS[side])
    mesh.GetCellData().AddArray(number)
    return mesh


def numbers_of(piece, side):
    """Which of all its cells are that are no ghosts."""
    array = piece.GetCellData().GetArray(NUMBERS[side])
    numbers = vtk_to_numpy(array).copy() if array else numpy.empty(0, dtype=int)
    ghosts = piece.GetCellData().GetArray(vtkDataSetAttributes.GhostArrayName())
    return numbers[vtk_to_numpy(ghosts) == 0] if ghosts else numbers


def outputs(proxy):
    """The points of each cell and all arrays of lists, and how often each cell of the Input is hit."""
    proxy.UpdatePipeline()
    algorithm = proxy.GetClientSideObject()
    for port, name in enumerate(PORTS):
        data = algorithm.GetOutputDataObject(port)
        cells = data.GetLines() if port else data.GetVerts()
        ids = vtk_to_numpy(cells.GetConnectivityArray())
        yield f"{name}; sizes", numpy.diff(vtk_to_numpy(cells.GetOffsetsArray()))
        if len(ids):
            yield f"{name}; of points", vtk_to_numpy(data.GetPoints().GetData())[ids]
            for array, values in skdexchange.arrays_of(data.GetPointData(), ""):
                yield f"{name}; of points {array}", values[ids]
        for array, values in skdexchange.arrays_of(data.GetCellData(), ""):
            yield f"{name}; of cells {array}", values
    for block, leaf in enumerate(skdexchange.leaves(algorithm.GetOutputDataObject(2))):
        array = leaf.GetCellData().GetArray("SkdNumberOfHits") if leaf else None
        if array:
            ghosts = leaf.GetCellData().GetArray(vtkDataSetAttributes.GhostArrayName())
            own = vtk_to_numpy(ghosts) == 0 if ghosts else slice(None)
            yield f"counts; {block}", numpy.stack(
                [numbers_of(leaf, 0), vtk_to_numpy(array)[own]], axis=1)
    yield "report", numpy.array([skdexchange.report_of(proxy, name)
        for name in ("Curves", "CurvePieces", "Hits")])


def found_in(input, source, title):
    """What the filter finds, by the ways in which it is asked."""
    from paraview import simple

    sides = [skdpieces.producer(as_blocks(*side)) for side in (input, source)]
    for distribution in ("Replicate", "Exchange"):
        for name, asked in (("all", {}), ("second, splines", {"HitSelection": "Nth", "HitNumber": 2,
            "PolylineForm": "Cardinal Spline"}), ("cut", {"CutCurves": 1})):
            proxy = simple.SkdTreeCurveSurfaceIntersection(
                Input=sides[0], Source=sides[1], SourceDistribution=distribution, **asked)
            yield f"{title}; {name}, {distribution}", dict(outputs(proxy))


def write(file, partitions):
    found = {}
    for partition in partitions:
        for name, *sides in meshes():
            title = f"{partition}; {name}"
            pieces = [[skdpieces.piece(numbered(mesh, side), partition) for mesh in blocks]
                for side, blocks in enumerate(sides)]
            for side, blocks in enumerate(pieces):
                for block, mesh in enumerate(blocks):
                    found[f"{title}; numbers; {side} {block}"] = numbers_of(mesh, side)
            found.update(found_in(*pieces, title))
    skdpieces.tell(file, found)


def alone(parts, partitions):
    """What one process finds of the joined pieces."""
    found = {}
    for partition in partitions:
        for name, *sides in meshes():
            title = f"{partition}; {name}"
            for side, blocks in enumerate(sides):
                for block, mesh in enumerate(blocks):
                    order = numpy.concatenate(
                        [part[f"{title}; numbers; {side} {block}"] for part in parts])
                    order = numpy.array(list(dict.fromkeys(order)), dtype=int)
                    if partition.endswith("global ids"):
                        order = numpy.sort(order)
                        skdpieces.set_global_ids(mesh)
                    blocks[block] = skdpieces.in_order(numbered(mesh, side), order)
            found.update(found_in(*sides, title))
    return found


def rows(found, port):
    """The rows of a list, each as bytes, in order: whoever outputs them."""
    of_points, of_cells = ([values for name, values in sorted(found.items())
        if name.startswith(f"{port}; of {kind}")] for kind in ("points", "cells"))
    return skdexchange.cells_as_bytes(found[port + "; sizes"], of_points, of_cells)


def check(file, processes, partitions):
    parts = skdpieces.told(file, processes)
    whole = alone(parts, partitions)
    different, some = [], set()
    for title, expected in whole.items():
        own = [part[title] for part in parts]
        for port in PORTS:
            first = sorted(rows(expected, port))
            second = sorted(sum((rows(part, port) for part in own), []))
            some.update([port] if first else [])
            if first != second:
                different.append(f"{processes}; {title}; {port}: {len(first)}, {len(second)}, "
                    f"{len(set(first) & set(second))}")
        reports = expected["report"], sum(part["report"] for part in own)
        if (reports[0] != reports[1]).any():
            different.append(f"{processes}; {title}: {reports}")
        for name in [name for name in expected if name.startswith("counts")]:
            told = numpy.vstack([part[name] for part in own if name in part])
            if not numpy.array_equal(
                numpy.unique(told, axis=0), expected[name][numpy.argsort(expected[name][:, 0])]):
                different.append(f"{processes}; {title}; {name}")
    assert some == set(PORTS), some
    assert not different, "\n".join(different)


skdpieces.run(__file__, RUNS, "joints_%d.pickle", write, check)
