# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Spatial Query of an Input in pieces: the rows that it lists, with ids of cells in the joined pieces
and distances of boxes, are those of one process to the last bit, also where a box is as far from a
cell as the tolerance, which depends on the size of the whole. Run without an argument this starts the
processes; with the name of a file and partitions it is one of them, and writes there what it finds."""

import itertools

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkUnstructuredGrid

import skdpieces
import skdtesting

RUNS = {
    2: ("runs", "cuts, ghosts"),
    4: ("some empty", "cuts, mixed global ids", "cuts, doubled"),
}
COUNT = 100 # of cells in a row
RELATIONS = ("Overlap", "Exact Match", "Containment", "Enclosure", "Adjacency", "Nearest")
GAPS = (-1.2e-7, 1e-7, 1.5e-7) # 2e-7 is twice the whole's epsilon


def strip(first=0, count=COUNT):
    grid, points = vtkUnstructuredGrid(), vtkPoints()
    points.SetDataTypeToDouble()
    for x in range(first, first + count + 1):
        for y, z in ((0, 0), (1, 0), (1, 1), (0, 1)):
            points.InsertNextPoint(x, y, z)
    grid.SetPoints(points)
    for cell in range(count):
        corners = (0, 4, 5, 1, 3, 7, 6, 2)
        grid.InsertNextCell(VTK_HEXAHEDRON, 8, [4 * cell + corner for corner in corners])
    return grid


def queries():
    """Properties of the filter."""
    for relation, exact, gap in itertools.product(RELATIONS, (0, 1), GAPS):
        for length in (0.6, 1.0):
            yield {"Relation": relation, "Exact": exact, "Shape": "Box", "NumberOfNearestCells": 3,
                "BoxPosition": [50 + gap, 0.0, 0.0], "BoxLength": [length, 1.0, 1.0]}
    for relation, exact in itertools.product(("Overlap", "Enclosure", "Adjacency"), (0, 1)):
        yield {"Relation": relation, "Exact": exact, "Shape": "Source Cells"}


def found_in(input, source):
    """By query: rows of both outputs that list cells, with the names of columns before them."""
    from paraview import simple

    proxy = simple.SkdTreeSpatialQuery(Input=skdpieces.producer(input),
        Source=skdpieces.producer(source), SourceDistribution="Exchange")
    for number, asked in enumerate(queries()):
        for property, value in asked.items(): # not before, where defaults would replace some
            setattr(proxy, property, value)
        proxy.UpdatePipeline()
        for port in (0, 2):
            output = proxy.GetClientSideObject().GetOutputDataObject(port)
            data = output.GetRowData() if port == 2 else output.GetCellData()
            names = sorted(name for name in map(data.GetArrayName, range(data.GetNumberOfArrays()))
                if name.startswith("Skd"))
            columns = [vtk_to_numpy(data.GetArray(name)).astype(float) for name in names]
            yield f"{number}, {port}: {', '.join(names)}", numpy.nan_to_num(
                numpy.array(columns).T, nan=-1.0)


def write(file, partitions):
    found = {}
    for partition in partitions:
        pieces = [skdpieces.piece(mesh, partition) for mesh in (strip(), strip(40, 20))]
        for name, rows in found_in(*pieces):
            found[f"{partition}; {name}"] = rows
    numpy.savez(file, **found)


def check(file, processes, partitions):
    parts = [dict(numpy.load(file % rank)) for rank in range(processes)]
    whole = dict(found_in(strip(), strip(40, 20)))
    assert sum(len(rows) for rows in whole.values()) > 400
    for partition in partitions:
        for name, rows in whole.items():
            told = numpy.vstack([part[f"{partition}; {name}"].reshape(-1, rows.shape[1])
                for part in parts if f"{partition}; {name}" in part])
            first, second = (table[numpy.lexsort(table.T)] for table in (rows, told))
            assert numpy.array_equal(first, second), (processes, partition, name, first[:5], second[:5])


skdpieces.run(__file__, RUNS, "queries_%d.npz", write, check)
