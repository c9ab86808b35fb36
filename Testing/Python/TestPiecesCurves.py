# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Curves, lone points, overlaps and pairs of surfaces in pieces on several processes are those of one
process to the last bit: points in the same order, from the same start, with the same cells. Run
without an argument this starts the processes; with the name of a file and partitions it is one of
them, and writes there what it outputs."""

import os
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkRegularPolygonSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import skdexchange
import skdpieces
import skdtesting

sys.path.append(os.path.join(skdtesting.SOURCE_DIR, "Plugin"))
import inline_xml

RUNS = {
    2: ("everywhere", "cuts, ghosts", "one process"),
    3: ("cuts", "round robin, global ids", "cuts, mixed global ids", "cuts, doubled"),
    4: ("runs", "round robin", "some empty", "random"),
    8: ("runs",),
}
# Where cells keep their order, and so which pair of several at one segment is the lowest.
IN_ORDER = ("everywhere", "one process", "runs", "some empty", "round robin, global ids",
    "cuts, mixed global ids")
# With larger meshes, too.
WITH_PIECES = ("spheres", "waves", "volume cells", "volume cells of both") # are split, too
GATHERED = ("volume cells", "volume cells of both")
WITH_DATA = ("cuts, ghosts", "cuts", "round robin", "random")
KINDS = ("curves", "overlaps", "pairs", "gaps")
SPLIT = 2 # beside segments joined (1) or not (0)
SPLIT_KINDS = ("pieces", "pieces of the other")
NUMBER = "Number"
ALONE = {} # what one process has, whatever the partition: by the name of meshes and what is done


def joined(*meshes):
    """Without the arrays."""
    all_of_them = vtkAppendPolyData()
    for mesh in meshes:
        plain = vtkPolyData()
        plain.CopyStructure(mesh)
        all_of_them.AddInputData(plain)
    all_of_them.Update()
    return all_of_them.GetOutput()


def waves(height, slope):
    """Open, and not flat."""
    mesh = skdpieces.tiles(count=14, corner=(0, 0, height), first=(1, 0, height + slope),
        second=(0, 1, height))
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    points[:, 2] += 0.1 * numpy.sin(11 * points[:, 0] + 30 * height) * numpy.cos(9 * points[:, 1])
    triangles = vtkTriangleFilter()
    triangles.SetInputData(mesh)
    triangles.Update()
    return triangles.GetOutput()


def book():
    """Three leaves on one edge."""
    return joined(*(skdpieces.tiles(corner=(0, 0, 0), first=end, second=(0, 0, 1), count=6)
        for end in ((1, 0.1, 0), (-0.7, 0.8, 0), (-0.4, -1, 0))))


def spikes():
    """Upside down on points, on edges and inside of the faces of tiles(), and between them."""
    floor = skdpieces.tiles()
    tops = [floor.GetPoint(i) for i in (12, 13, 25, 37, 44, 45, 60, 61, 80)]
    tops += [(0.5 * (a + b), c, d) for (a, c, d), (b, _, _) in zip(
        [floor.GetPoint(i) for i in (23, 52)], [floor.GetPoint(i + 1) for i in (23, 52)])]
    tops += [(0.321, 0.654, 0.0), (0.77, 0.31, 0.0)]
    cones = []
    for x, y, z in tops:
        ring = vtkRegularPolygonSource()
        ring.SetNumberOfSides(5)
        ring.SetRadius(0.02)
        ring.SetCenter(x, y, z + 0.05)
        ring.SetOutputPointsPrecision(1)
        ring.Update()
        cone = vtkPolyData()
        cone.DeepCopy(ring.GetOutput())
        top = cone.GetPoints().InsertNextPoint(x, y, z)
        cone.Initialize()
        cone.SetPoints(ring.GetOutput().GetPoints())
        cone.GetPoints().InsertNextPoint(x, y, z)
        cone.AllocateExact(5, 15)
        for i in range(5):
            cone.InsertNextCell(5, 3, (i, (i + 1) % 5, top))
        cones.append(cone)
    return joined(*cones)


def walls():
    """On lines of tiles(), and across them."""
    return joined(
        skdpieces.tiles(corner=(4 / 9, 0, 0), first=(4 / 9, 1, 0), second=(4 / 9, 0, 0.3), count=9),
        skdpieces.tiles(corner=(0, 3 / 11, 0), first=(1, 3 / 11, 0), second=(0, 3 / 11, 0.3), count=7),
        skdpieces.tiles(corner=(0, 0, -0.2), first=(1, 1, -0.2), second=(0, 0, 0.3), count=7))


def tiny():
    """What is flat beside the largest coordinate, which other pieces have."""
    height = 5e-81
    return joined(skdpieces.tiles(corner=(0, 0, height), first=(1e-3, 0, 2 * height),
            second=(0, 1e-3, height)),
        skdpieces.tiles(corner=(1, 0, 0), first=(2, 0, 0), second=(1, 1, 0)))


def read(file):
    """Of a copy that VTK can read whatever its parser, in each process one of its own."""
    copy = skdtesting.temporary(f"{skdpieces.process()[0]}_{os.path.basename(file)}")
    inline_xml.main(file, copy)
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(copy)
    reader.Update()
    return reader.GetOutput()


def moved(mesh, shift):
    result = vtkPolyData()
    result.DeepCopy(mesh)
    vtk_to_numpy(result.GetPoints().GetData())[:] += numpy.array(shift, dtype="f4")
    return result


def meshes(partition):
    """Names, Input, Source, and the largest gap that is looked for."""
    ball = skdpieces.sphere()
    yield "spheres", ball, skdpieces.sphere(3.0, (1.234, 0.5, 0.25), 20, 20), 0.1
    yield "many spheres", skdpieces.crowd(), skdpieces.crowd(shift=0.4), 0.0
    yield "equal spheres", ball, ball, 0.0
    yield "waves", waves(0.0, 0.0), waves(0.02, 0.05), 0.0
    yield "junctions", book(), waves(0.4, 0.1), 0.0
    yield "a plane along edges of leaves", book(), skdpieces.tiles(
        corner=(-1, -1, 0.5), first=(1, -1, 0.5), second=(-1, 1, 0.5), count=3), 0.0
    yield "points", skdpieces.tiles(), spikes(), 0.0
    yield "points of the other", spikes(), skdpieces.tiles(), 0.0
    yield "edges", skdpieces.tiles(), walls(), 0.0
    yield "edges of the other", walls(), skdpieces.tiles(), 0.0
    yield "overlap", skdpieces.tiles(), joined(walls(),
        skdpieces.tiles(corner=(0.2, 0.25, 0), first=(0.9, 0.3, 0), second=(0.2, 0.8, 0))), 0.0
    yield "equal tiles", skdpieces.tiles(), skdpieces.tiles(), 0.0
    yield "tiny", tiny(), skdpieces.tiles(corner=(4.1e-4, 0, -1e-3), first=(4.3e-4, 1e-3, -1e-3),
        second=(4.1e-4, 0, 1e-3)), 0.0
    yield "volume cells", skdpieces.tetrahedra(size=2), skdpieces.sphere(1.9, (0.2, 0.1, 0.3)), 0.05
    yield "volume cells of both", skdpieces.tetrahedra(size=2), skdpieces.tetrahedra(size=3), 0.7
    if partition not in WITH_DATA:
        return
    brain = read(os.path.join(skdtesting.DATA_DIR, "fly_brain_lateral_horn.vtp"))
    yield "a brain", brain, moved(brain, (2.0, 1.0, 0.5)), 0.0
    extra = os.environ.get("SKDTREE_EXTRA_DATA_DIR", "")
    for name, shift in (("blade", 0.02), ("mech-holes-shark", 0.03)):
        file = os.path.join(extra, "A_surface", name + ".vtp")
        if os.path.exists(file):
            mesh = read(file)
            yield name, mesh, moved(mesh, [shift * each for each in mesh.GetLength() * numpy.array(
                [1.0, 0.7, 0.4])]), 0.0


def source(mesh, partition):
    """A source of this process's piece, whose cells tell which of all they are, and these numbers of
    those that are no ghosts."""
    whole = mesh.NewInstance()
    whole.CopyStructure(mesh)
    number = numpy_to_vtk(numpy.arange(mesh.GetNumberOfCells()), deep=1)
    number.SetName(NUMBER)
    whole.GetCellData().AddArray(number)
    piece = skdpieces.piece(whole, partition)
    numbers = piece.GetCellData().GetArray(NUMBER)
    numbers = vtk_to_numpy(numbers).copy() if numbers else numpy.empty(0, dtype=int)
    ghosts = piece.GetCellData().GetArray("vtkGhostType")
    if ghosts:
        numbers = numbers[vtk_to_numpy(ghosts) == 0]
    return skdpieces.producer(piece), numbers


def points_of_cells(data, cells, name):
    """The points of each cell, one after the other, as many as each has."""
    array = getattr(data, "Get" + cells)()
    ids = vtk_to_numpy(array.GetConnectivityArray())
    yield f"{name}, {cells}", numpy.diff(vtk_to_numpy(array.GetOffsetsArray()))
    if len(ids):
        yield f"{name}, {cells} points", vtk_to_numpy(data.GetPoints().GetData())[ids]


def pieces(proxy):
    """The triangles that surfaces are split into."""
    proxy.UpdatePipeline()
    for port, kind in enumerate(SPLIT_KINDS, 4):
        data = proxy.GetClientSideObject().GetOutputDataObject(port)
        yield from points_of_cells(data, "Polys", kind)
    yield "report", numpy.array([[skdexchange.report_of(proxy, "InputTrianglesSplit")]])


def outputs(proxy):
    """What points_of_cells() has, and all arrays."""
    proxy.UpdatePipeline()
    for port, kind in enumerate(KINDS):
        data = proxy.GetClientSideObject().GetOutputDataObject(port)
        if data.IsA("vtkTable"):
            yield from skdexchange.arrays_of(data.GetRowData(), f"{kind}, row ")
            continue
        for cells in ("Verts", "Lines", "Polys"):
            yield from points_of_cells(data, cells, kind)
            ids = vtk_to_numpy(getattr(data, "Get" + cells)().GetConnectivityArray())
            if len(ids):
                for name, values in skdexchange.arrays_of(data.GetPointData(), ""):
                    yield f"{kind}, {cells} point {name}", values[ids]
        yield from skdexchange.arrays_of(data.GetCellData(), f"{kind}, cell ")
    yield "report", numpy.array([[skdexchange.report_of(proxy, name)
        for name in ("Curves", "Overlaps", "Pairs")]])


def found_in(input, other, joins, clearance):
    from paraview import simple

    proxy = simple.SkdTreeSurfaceIntersection(Input=input, Source=other,
        JoinCurves=int(joins == 1), Clearance=clearance, SplitSurfaces=int(joins == SPLIT),
        SourceDistribution="Exchange" if joins else "Replicate")
    return dict(pieces(proxy) if joins == SPLIT else outputs(proxy))


def answers_of(partitions):
    """What is found in each case, and which cells its meshes have here."""
    found = {}
    for partition in partitions:
        for name, first, second, clearance in meshes(partition):
            input, found[f"{partition}, {name}; first"] = source(first, partition)
            other, found[f"{partition}, {name}; second"] = source(second, partition)
            for joins in (1, 0, SPLIT)[:3 if name in WITH_PIECES else 2]:
                title = f"{partition}, {name}; {joins}"
                found[title] = ALONE.get((name, joins)) or found_in(input, other, joins, clearance)
                if skdpieces.process()[1] == 1:
                    ALONE[name, joins] = found[title]
    return found


def write(file, partitions):
    skdpieces.tell(file, answers_of(partitions))


def numbers_of(ids, parts, key, partition):
    """Which cells of all those are that have ids in the joined pieces."""
    pieces = [part[key] for part in parts]
    if partition.endswith("global ids"):
        return ids
    of_joined = numpy.array(list(dict.fromkeys(numpy.concatenate(pieces))), dtype=int)
    return of_joined[ids] if len(of_joined) else ids


def label(name, values, parts, case, partition):
    for key in ("First", "Second"):
        if name.endswith(f"Skd{key}CellId"):
            return numbers_of(values, parts, f"{case}; {key.lower()}", partition)
    return values


def cells_of(parts, case, joins, partition, labels):
    """All cells and rows, each as bytes, in order: whoever outputs them."""
    found = {}
    for part in parts:
        own = {name: label(name, values, parts, case, partition)
            for name, values in part[f"{case}; {joins}"].items()}
        if not labels:
            own = {name: values for name, values in own.items()
                if not name.endswith("CellId") or name.startswith(("pairs", "overlaps", "gaps"))}
        rows = [values for name, values in sorted(own.items()) if name.startswith("pairs, row")]
        found.setdefault("pairs", []).extend(
            b"".join(value.tobytes() for value in row) for row in zip(*rows))
        for kind in KINDS + SPLIT_KINDS:
            before = 0
            for cells in ("Verts", "Lines", "Polys"):
                sizes = own.get(f"{kind}, {cells}", ())
                of_points = [values for name, values in sorted(own.items())
                    if name.startswith(f"{kind}, {cells} ")]
                of_cells = [values[before:before + len(sizes)] for name, values in sorted(own.items())
                    if name.startswith(f"{kind}, cell ")]
                found.setdefault(f"{kind}, {cells}", []).extend(
                    skdexchange.cells_as_bytes(sizes, of_points, of_cells))
                before += len(sizes)
    return {name: sorted(cells) for name, cells in found.items()}


def counts_of(parts, case, joins):
    """Of all processes, but each one's where each has found all."""
    is_gathered = joins == SPLIT or case.endswith(GATHERED)
    counts = [part[f"{case}; {joins}"]["report"] for part in parts]
    return numpy.max(counts, axis=0) if is_gathered else sum(counts)


def check(file, processes, partitions):
    alone, parts = [answers_of(partitions)], skdpieces.told(file, processes)
    cases = [name[:-len("; first")] for name in alone[0] if name.endswith("; first")]
    different, some = [], set()
    for case in cases:
        partition = next(each for each in partitions if case.startswith(each + ", ")
            and not any(len(other) > len(each) and case.startswith(other + ", ")
                for other in partitions))
        for joins in (0, 1, SPLIT)[:3 if f"{case}; {SPLIT}" in alone[0] else 2]:
            for labels in (False, True)[: 2 if partition in IN_ORDER else 1]:
                first = cells_of(alone, case, joins, partition, labels)
                second = cells_of(parts, case, joins, partition, labels)
                for name, cells in first.items():
                    some.update([name] if cells else [])
                    if cells != second[name]:
                        common = len(set(cells) & set(second[name]))
                        different.append(f"{processes}, {case}, {joins}, {labels}, {name}: "
                            f"{len(cells)}, {len(second[name])}, {common}")
            counts = counts_of(alone, case, joins), counts_of(parts, case, joins)
            if (counts[0] != counts[1]).any():
                different.append(f"{processes}, {case}, {joins}: {counts}")
    assert some >= {"curves, Verts", "curves, Lines", "overlaps, Polys", "pairs", "gaps, Lines",
        "pieces, Polys", "pieces of the other, Polys"}, some
    assert not different, "\n".join(different)


skdpieces.run(__file__, RUNS, "curves_%d.pickle", write, check)
