# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Boolean Operation on surfaces that stay in their pieces on two, three and four processes: all parts
together are to the last bit what one process makes of the whole, with the same ids and face numbers.
Run without an argument this starts the processes; with the name of a file and partitions it is one of
them, and writes there its part."""

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdexchange
import skdpieces

RUNS = {
    2: ("cuts", "everywhere"),
    3: ("round robin, global ids", "one process"),
    4: ("cuts, doubled", "some empty"),
}
OPERATIONS = ("Union", "Intersection", "Difference", "Reverse Difference", "Symmetric Difference")
SUMS = ("Volume", "Area", "InputVolume", "InputArea", "SourceVolume", "SourceArea")
COUNTS = ("BadEdges", "TrianglesSplit", "TrianglesFolded", "CoordinateBits", "PointsAligned")
DIFFERENT = "different"
EXCHANGED = ", exchanged"


def cases(partition):
    """Names and filters. Names of those that gather, as their pieces do not do, begin with ~."""
    from paraview import simple

    ball = skdpieces.source("sphere", partition)
    other = skdpieces.source(
        "sphere", partition, radius=3.0, center=(1.234, 0.5, 0.25), theta=20, phi=20)
    small = skdpieces.source("sphere", partition, radius=1.0, center=(0.3, 0.2, 0.1))
    far = skdpieces.source("sphere", partition, radius=1.0, center=(9.0, 0.2, 0.1))
    block = skdpieces.source("block", partition)
    flush = skdpieces.source("block", partition, corner=(1.0, 0.25, 0.5), size=(1.0, 0.5, 0.5))
    crowd = skdpieces.source("crowd", partition)
    moved = skdpieces.source("crowd", partition, shift=0.45)
    for operation in OPERATIONS:
        yield operation, simple.SkdTreeBooleanOperation(
            Input=ball, Source=other, Operation=operation)
    yield "arrays of one input", simple.SkdTreeBooleanOperation(
        Input=skdpieces.source("sphere", "one process"), Source=skdpieces.source("sphere", partition,
            radius=3.0, center=(3.234, 0.5, 0.25), has_normals=False))
    yield "nested", simple.SkdTreeBooleanOperation(Input=ball, Source=small, Operation="Difference")
    yield "apart", simple.SkdTreeBooleanOperation(Input=ball, Source=far)
    yield "flush blocks", simple.SkdTreeBooleanOperation(Input=block, Source=flush)
    turned = skdpieces.source("block", partition, angle=40.0)
    yield "~turned blocks of floats", simple.SkdTreeBooleanOperation(
        Input=turned, Source=skdpieces.source(
            "block", partition, corner=(1.0, 0.25, 0.5), size=(1.0, 0.5, 0.5), angle=40.0))
    yield "turned blocks that cross", simple.SkdTreeBooleanOperation(
        Input=turned, Source=skdpieces.source(
            "block", partition, corner=(0.7, 0.27, 0.53), size=(1.0, 0.4, 0.4), angle=40.0))
    yield "equal", simple.SkdTreeBooleanOperation(
        Input=block, Source=skdpieces.source("block", partition), Operation="Intersection")
    yield "crowd", simple.SkdTreeBooleanOperation(
        Input=crowd, Source=moved, Operation="Difference")
    yield "crowd that intersects itself", simple.SkdTreeBooleanOperation(
        Input=skdpieces.source("crowd", partition, step=0.7), Source=moved)
    yield "~dense crowd", simple.SkdTreeBooleanOperation(
        Input=skdpieces.source("crowd", partition, count=60, step=0.02),
        Source=skdpieces.source("crowd", partition, count=60, step=0.02, shift=0.1))
    yield "~split", simple.SkdTreeBooleanOperation(
        Input=ball, Source=other, Operation="Split")
    yield "~coarse", simple.SkdTreeBooleanOperation(
        Input=ball, Source=skdpieces.source("curved", partition))


def rows(proxy):
    """A row for each face of this process: its middle, number of corners, bounds and ids."""
    proxy.UpdatePipeline()
    data = proxy.GetClientSideObject().GetOutputDataObject(0)
    count = data.GetNumberOfCells()
    if count == 0:
        return numpy.empty((0, 11))
    sizes = numpy.diff(vtk_to_numpy(data.GetPolys().GetOffsetsArray()))
    names = ("SkdInputId", "SkdCellId", "SkdFaceId", "Elevation")
    columns = [vtk_to_numpy(data.GetCellData().GetArray(name)) for name in names[:3]]
    elevation = data.GetPointData().GetArray("Elevation")
    if elevation:
        corners = vtk_to_numpy(elevation)[vtk_to_numpy(data.GetPolys().GetConnectivityArray())]
        first = vtk_to_numpy(data.GetPolys().GetOffsetsArray())[:-1]
        columns.append(numpy.maximum.reduceat(corners, first))
    else:
        columns.append(numpy.zeros(count))
    return numpy.column_stack(
        [skdpieces.locations(data, of_cells=True), sizes, *columns]).astype(float)


def arrays(proxy):
    """Names of this process's arrays; of none if it has no faces."""
    data = proxy.GetClientSideObject().GetOutputDataObject(0)
    names = [of.GetArrayName(i) for of in (data.GetCellData(), data.GetPointData())
        for i in range(of.GetNumberOfArrays())]
    return numpy.array(sorted(names) if data.GetNumberOfCells() > 0 else [], dtype=str)


def report(proxy):
    values = [skdexchange.report_of(proxy, what) for what in SUMS + COUNTS]
    return numpy.array([numpy.nan if value is None else value for value in values])


def answers_of(partitions):
    """Rows, reports and names of arrays of each case, and what differs."""
    found, different = {}, []
    can = None  # whether VTK has what an exchange needs
    for partition in partitions:
        for name, proxy in cases(partition):
            title = partition + ": " + name
            found[title] = rows(proxy)
            found[title + ", report"] = report(proxy)
            found[title + ", arrays"] = arrays(proxy)
            if skdpieces.process()[1] == 1:
                continue
            proxy.SourceDistribution = "Exchange"
            found[title + EXCHANGED] = rows(proxy)
            found[title + ", report" + EXCHANGED] = report(proxy)
            found[title + ", arrays" + EXCHANGED] = arrays(proxy)
            can = skdexchange.is_exchanged(proxy) if can is None else can
            should = not name.startswith("~") and can
            if skdexchange.is_exchanged(proxy) != should:
                different.append(title + (" was gathered" if should else " was exchanged"))
    return {**found, DIFFERENT: different}


def write(file, partitions):
    skdpieces.tell(file, answers_of(partitions))


def in_order(table):
    return table[numpy.lexsort(table.T[::-1])]


def check_same(name, parts):
    """What was exchanged is to the last bit what was gathered."""
    gathered, together = (numpy.vstack([part[key] for part in parts])
        for key in (name, name + EXCHANGED))
    assert together.shape == gathered.shape, (name, gathered.shape, together.shape)
    assert numpy.array_equal(in_order(gathered), in_order(together)), name


def check(whole, parts):
    for part in parts:
        different = part.pop(DIFFERENT)
        assert not different, different
    for name, expected in whole.items():
        if name.endswith(", report"):
            for kind in ("", EXCHANGED):
                numpy.testing.assert_allclose(
                    parts[0][name + kind], expected, rtol=1e-12, atol=1e-13, err_msg=name + kind)
        elif name.endswith(", arrays"):
            for part in parts:
                own = part[name + EXCHANGED]
                assert own.size == 0 or list(own) == list(expected), (name, own, expected)
        else:
            together = numpy.vstack([part[name + EXCHANGED] for part in parts])
            # What lies between faces that are flush but for rounding depends on the order of cells.
            assert together.shape == expected.shape or "of floats" in name, (
                name, expected.shape, together.shape)
            check_same(name, parts)


def check_pieces(file, processes, partitions):
    print(processes, partitions)
    check(skdpieces.whole(answers_of, partitions), skdpieces.told(file, processes))


if __name__ == "__main__":
    skdpieces.run(__file__, RUNS, "boolean_%d.pickle", write, check_pieces)
