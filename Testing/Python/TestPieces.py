# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes in pieces on two, three and four processes give the answers of one process, and to the last
bit the same if the Source stays in its pieces instead of being gathered: for every filter, and for
each way in which the pieces may lie. Run without an argument this starts the processes; with the
name of a file and partitions it is one of them, and writes there its part of the answers, and what
differs."""

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdcases
import skdexchange
import skdpieces

# Each partition is tested with one number of processes.
RUNS = {
    2: ("everywhere", "cuts, ghosts", "one process"),
    3: ("cuts", "round robin, global ids", "one reader"),
    4: ("runs", "round robin", "cuts, doubled", "some empty", "random"),
}
ONLY_EXCHANGED = "random" # cells that several processes have count once, in one process as often
DIFFERENT = "different"
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
    attributes = data.GetCellData() if of_cells else data.GetPointData()
    columns = [skdpieces.locations(data, of_cells)]
    for name in arrays:
        columns.append(vtk_to_numpy(attributes.GetArray(name)).reshape(count, -1))
    result = numpy.nan_to_num(numpy.hstack(columns), nan=WITHOUT_VALUE)
    ghosts = attributes.GetArray("vtkGhostType") if of_cells else None
    return result if ghosts is None else result[vtk_to_numpy(ghosts) & 1 == 0]


def answers_of(partitions):
    """The rows of each case, and what differs."""
    found, different = {}, []
    for partition in partitions:
        for name, case in skdcases.cases(partition):
            title = partition + ": " + name
            part = rows(*case)
            if part is not None and partition != ONLY_EXCHANGED:
                found[title] = part
            if skdpieces.process()[1] > 1:
                different += [f"{title}: {what}" for what in skdexchange.compare(name, case.proxy)]
    return {**found, DIFFERENT: different}


def write(file, partitions):
    skdpieces.tell(file, answers_of(partitions))


def in_order(table):
    """Each row once (processes share the points where their pieces meet), in order but for
    rounding."""
    table = table[numpy.lexsort(table.T)]
    is_first = numpy.append(True, (table[1:] != table[:-1]).any(axis=1))
    table = table[is_first]
    return table[numpy.lexsort(numpy.round(table, 9).T[::-1])]


def check(whole, parts):
    for rank, part in enumerate(parts):
        different = part.pop(DIFFERENT)
        assert not different, (rank, *different)
    for name, expected in whole.items():
        together = numpy.vstack([part[name] for part in parts if name in part])
        first, second = in_order(expected), in_order(together)
        assert first.shape == second.shape, (name, first.shape, second.shape)
        numpy.testing.assert_allclose(first, second, rtol=1e-12, atol=1e-12, err_msg=name)


def check_pieces(file, processes, partitions):
    compared = [partition for partition in partitions if partition != ONLY_EXCHANGED]
    check(skdpieces.whole(answers_of, compared, ("one reader",)), skdpieces.told(file, processes))


skdpieces.run(__file__, RUNS, "pieces_%d.pickle", write, check_pieces)
