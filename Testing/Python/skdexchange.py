# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""A Source that stays in its pieces, beside one that is gathered: for tests of several processes."""

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

try:
    from vtkmodules import vtkParallelDIY # without it all is gathered
except ImportError:
    vtkParallelDIY = None

import skdpieces

# Cases whose Source stays in its pieces; the others gather.
EXCHANGED = {"closest", "closest beside a far point", "closest data", "closest of both",
    "closest signed", "inside", "inside cells", "inside of blocks", "blocks", "data of blocks",
    "contour", "outer surface", "rays from outside", "all hits", "hits within a length", "in a mesh", "probe", "intersection",
    "overlapping cells", "thickness of cells", "refined", "compared", "compared by sides",
    "grid near surfaces"}
# Cases in which it turns out that pieces do not do, or the filter gathers always.
GATHERED = {"signed, bodies that overlap", "signed, open", "inside of open", "compared by sides with bodies that overlap",
    "compared by sides with an open one", "compared, signed", "compared points", "adapted"}
# Cases in which each process outputs a part, instead of the first all: TestBooleanPieces.py.
DEALT_OUT = {"boolean"}
# Cases that are asked again, within another distance.
ASKED_AGAIN = {"closest", "closest signed"}


def leaves(data):
    """The data sets and tables in a data object."""
    if data is None:
        return
    if not data.IsA("vtkCompositeDataSet"):
        yield data
        return
    iterator = data.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        yield iterator.GetCurrentDataObject()
        iterator.GoToNextItem()


def arrays_of(data, prefix):
    for i in range(data.GetNumberOfArrays()):
        array = data.GetArray(i)
        if array is not None:
            yield prefix + array.GetName(), vtk_to_numpy(array)


def everything(proxy):
    """All that this process has of the outputs: each array, points, and the bounds of cells."""
    proxy.UpdatePipeline()
    algorithm = proxy.GetClientSideObject()
    found = {}
    for port in range(algorithm.GetNumberOfOutputPorts()):
        for number, data in enumerate(leaves(algorithm.GetOutputDataObject(port))):
            name = f"output {port}, block {number}, "
            if data.IsA("vtkTable"):
                found.update(arrays_of(data.GetRowData(), name))
                continue
            if data.IsA("vtkSelection"):
                for node in range(data.GetNumberOfNodes()):
                    ids = data.GetNode(node).GetSelectionList()
                    found[f"{name}node {node}"] = vtk_to_numpy(ids)
                continue
            found[name + "points"] = skdpieces.locations(data, of_cells=False)
            found[name + "cells"] = skdpieces.locations(data, of_cells=True)
            found.update(arrays_of(data.GetPointData(), name + "point array "))
            found.update(arrays_of(data.GetCellData(), name + "cell array "))
    return found


def cells_as_bytes(sizes, of_points, of_cells):
    """Each cell as bytes: its rows of arrays that have one for each point of each cell, of which
    `sizes` tells how many there are, and of arrays that have one for each cell."""
    last, own = numpy.cumsum(sizes, dtype=int), numpy.arange(1, len(sizes) + 1)
    columns = [[b""] * len(sizes)]
    columns += [cut(values, last - sizes, last) for values in of_points]
    columns += [cut(values, own - 1, own) for values in of_cells]
    return [b"".join(column) for column in zip(*columns)]


def cut(values, first, last):
    """The bytes of rows of an array, from each of the first to before each of the last."""
    width, content = values[:1].nbytes, values.tobytes()
    return [content[begin:end] for begin, end in zip((first * width).tolist(), (last * width).tolist())]


def is_same(first, second):
    return first.shape == second.shape and first.dtype == second.dtype and numpy.array_equal(
        first, second, equal_nan=first.dtype.kind == "f")


def report_of(proxy, name):
    field = proxy.GetClientSideObject().GetOutputDataObject(0).GetFieldData()
    array = field.GetArray("SkdReport" + name)
    return None if array is None else array.GetValue(0)


def is_exchanged(proxy):
    return report_of(proxy, "SourceExchanged") == 1


def is_rebuilt(proxy):
    """Whether trees are built again for another limit, although no piece has changed."""
    proxy.MaximumDistance = 100.0
    proxy.UpdatePipeline()
    return report_of(proxy, "TreesBuilt") != 0


def is_as_expected(name, proxy):
    """Whether the Source stayed in its pieces where it should, and nowhere else."""
    if name in EXCHANGED and vtkParallelDIY:
        return is_exchanged(proxy)
    return name not in GATHERED or report_of(proxy, "SourceExchanged") == 0


def compare(name, proxy):
    """What differs if the Source, which is gathered by default, stays in its pieces. All processes call
    it together."""
    if "SourceDistribution" not in proxy.ListProperties() or name in DEALT_OUT:
        return []
    gathered = everything(proxy)
    different = ["it was exchanged by default"] if is_exchanged(proxy) else []
    proxy.SourceDistribution = "Exchange"
    exchanged = everything(proxy)
    if not is_as_expected(name, proxy):
        different.append("it was exchanged" if is_exchanged(proxy) else "it was gathered")
    different += sorted(set(gathered) ^ set(exchanged))
    different += [name for name in gathered
        if name in exchanged and not is_same(gathered[name], exchanged[name])]
    if name in ASKED_AGAIN and is_rebuilt(proxy):
        different.append("trees were built again")
    return different
