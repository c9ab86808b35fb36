# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""A Source in pieces of which each process gets what is near its own part of the Input: outputs are
those of a Source that is gathered everywhere, on each process, to the last bit, and sums over all
processes but for rounding. Run without an
argument this starts the processes; with the name of a file and partitions it is one of them, and
writes there in what they differ."""

import os
import shutil
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_LAGRANGE_HEXAHEDRON
from vtkmodules.vtkFiltersSources import vtkCellTypeSource

import skdpieces
import skdtesting

RUNS = {
    2: ("everywhere", "cuts, ghosts"),
    3: ("cuts", "round robin, global ids", "one process"),
    4: ("cuts, doubled",),
}
REPORT = "SkdReportSourceExchanged"
SUMS = ("SourceIntegral", "OverlapIntegral", "TargetIntegral", "Coverage")


def curved(partition):
    """Lagrange hexahedra."""
    from paraview import simple

    source = vtkCellTypeSource()
    source.SetCellType(VTK_LAGRANGE_HEXAHEDRON)
    source.SetBlocksDimensions(3, 3, 3)
    source.Update()
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(skdpieces.piece(source.GetOutput(), partition))
    return producer


def filters(partition):
    """Names, how each is made, and its output ports."""
    from paraview import simple

    image = simple.Wavelet(WholeExtent=[-6, 6, -6, 6, -6, 6])
    ball = skdpieces.source("sphere", partition)
    cells = skdpieces.source("tetrahedra", partition)
    line = simple.Line(Point1=[-5, -4.5, -4], Point2=[4.7, 4.2, 5], Resolution=7)
    blocks = simple.GroupDatasets(Input=[ball, cells])
    yield "probe", lambda: simple.SkdTreeProbe(
        Input=image, Source=cells, GradientArrays=["Field"], PassInputData=0), (0,)
    yield "probe a surface", lambda: simple.SkdTreeProbe(
        Input=image, Source=ball, AbsoluteTolerance=0.3), (0,)
    yield "probe outside", lambda: simple.SkdTreeProbe(Input=ball, Source=cells, PassInputData=0,
        OutsidePoints="Nearest Cell Within Distance", MaximumDistance=1.5), (0,)
    yield "probe curved cells", lambda: simple.SkdTreeProbe(
        Input=image, Source=curved(partition)), (0,)
    yield "probe along lines", lambda: simple.SkdTreeProbe(
        Input=line, Source=cells, ProbeLines=1), (0, 1, 2)
    yield "probe blocks", lambda: simple.SkdTreeProbe(Input=image, Source=blocks), (0,)
    yield "probe a grid", lambda: simple.SkdTreeProbe(
        Input=cells, Source=image, GradientArrays=["RTData"]), (0,)
    other = skdpieces.source(
        "sphere", partition, radius=3.0, center=(1.234, 0.5, 0.25), theta=20, phi=20)
    yield "intersection", lambda: simple.SkdTreeSurfaceIntersection(
        Input=other, Source=ball, JoinCurves=0), (0, 1, 2)
    yield "intersection of equal surfaces", lambda: simple.SkdTreeSurfaceIntersection(
        Input=ball, Source=ball), (0, 1, 2)
    yield "gaps", lambda: simple.SkdTreeSurfaceIntersection(
        Input=other, Source=ball, Clearance=0.3), (0, 1, 2, 3)
    edges = simple.ExtractEdges(Input=other)
    yield "curves and a surface", lambda: simple.SkdTreeCurveSurfaceIntersection(
        Input=edges, Source=ball), (0, 2)
    yield "curves and blocks", lambda: simple.SkdTreeCurveSurfaceIntersection(
        Input=edges, Source=simple.GroupDatasets(Input=[ball, other])), (0, 2)
    yield "overlapping cells", lambda: simple.SkdTreeSpatialQuery(
        Input=cells, Source=ball, Relation="Overlap", Shape="Source Cells"), (0, 2)
    few = skdpieces.source("tetrahedra", partition, size=2)
    yield "adjacent cells", lambda: simple.SkdTreeSpatialQuery(
        Input=few, Source=few, Relation="Adjacency", Shape="Source Cells"), (0, 2)
    with_both = simple.PointDatatoCellData(Input=cells, PassPointData=1)
    on_one = skdpieces.source("tetrahedra", "one process", size=3)
    for name, input in (("a grid", image), ("one process", on_one)):
        yield "remap conservatively to " + name, lambda input=input: simple.SkdTreeRemap(
            Input=input, Source=with_both, Method="Conservative First Order", PassInputData=0), (0,)
    for limiter in ("Barth-Jespersen", "None"):
        yield "remap by gradients, " + limiter, lambda limiter=limiter: simple.SkdTreeRemap(
            Input=on_one, Source=with_both, Method="Conservative Second Order", Limiter=limiter,
            PassInputData=0), (0,)
    yield "remap by interpolation", lambda: simple.SkdTreeRemap(Input=image, Source=cells,
        Method="Interpolation", EmptyCells="Leave", PassInputData=0), (0,)


def arrays(data):
    if data.IsA("vtkTable"):
        return {data.GetColumnName(i): vtk_to_numpy(data.GetColumn(i))
            for i in range(data.GetNumberOfColumns())}
    found = {}
    if data.IsA("vtkCompositeDataSet"):
        for i in range(data.GetNumberOfBlocks()):
            if data.GetBlock(i):
                found.update({f"{i} {name}": array for name, array in arrays(data.GetBlock(i)).items()})
        return found
    for kind, attributes in (("point", data.GetPointData()), ("cell", data.GetCellData())):
        for i in range(attributes.GetNumberOfArrays()):
            found[f"{kind} {attributes.GetArrayName(i)}"] = vtk_to_numpy(attributes.GetArray(i))
    if data.IsA("vtkPointSet") and data.GetNumberOfPoints() > 0:
        found["points"] = vtk_to_numpy(data.GetPoints().GetData())
    names = {"vtkUnstructuredGrid": ["Cells"], "vtkPolyData": ["Verts", "Lines", "Polys"]}
    for name in names.get(data.GetClassName(), []):
        cells = getattr(data, "Get" + name)()
        found[name] = vtk_to_numpy(cells.GetConnectivityArray())
        found["Offsets of " + name] = vtk_to_numpy(cells.GetOffsetsArray())
    return found


def outputs(proxy, ports):
    proxy.UpdatePipeline()
    algorithm = proxy.GetClientSideObject()
    report = algorithm.GetOutputDataObject(0).GetFieldData()
    sums = [vtk_to_numpy(report.GetArray("SkdReport" + name)) for name in SUMS
        if report.GetArray("SkdReport" + name)]
    return ([arrays(algorithm.GetOutputDataObject(port)) for port in ports],
        report.GetArray(REPORT).GetTuple1(0), numpy.array(sums))


def differences(partition):
    for name, make, ports in filters(partition):
        found, sums = {}, {}
        for distribution in ("Replicate", "Exchange"):
            proxy = make()
            proxy.SourceDistribution = distribution
            found[distribution], exchanged, sums[distribution] = outputs(proxy, ports)
            if exchanged != (distribution == "Exchange"):
                yield f"{partition}, {name}: {distribution} reports {exchanged}"
        if not numpy.allclose(sums["Replicate"], sums["Exchange"], rtol=1e-13, atol=0.0):
            yield f"{partition}, {name}: {sums}"
        for port, gathered, near in zip(ports, found["Replicate"], found["Exchange"]):
            for array in sorted(set(gathered) | set(near)):
                first, second = gathered.get(array), near.get(array)
                if first is None or second is None or first.tobytes() != second.tobytes():
                    yield f"{partition}, {name}, port {port}: {array}"


def of_moved_piece():
    """The tree is kept while nothing changes; then the points of one process's piece move."""
    from paraview import simple

    rank, _ = skdpieces.process()
    cells = skdpieces.source("tetrahedra", "cuts")
    image = simple.Wavelet(WholeExtent=[-6, 6, -6, 6, -6, 6])
    proxies = [simple.SkdTreeProbe(Input=image, Source=cells, SourceDistribution=distribution)
        for distribution in ("Replicate", "Exchange")]
    for proxy in proxies:
        proxy.UpdatePipeline()
        proxy.UseFillValue = 1
        proxy.UpdatePipeline()
        report = proxy.GetClientSideObject().GetOutputDataObject(0).GetFieldData()
        if report.GetArray("SkdReportTreesBuilt").GetTuple1(0) != 0:
            yield "a tree is built again"
    before = outputs(proxies[1], (0,))[0][0]["point Field"].sum()
    producer = cells.GetClientSideObject()
    piece = producer.GetOutputDataObject(0)
    if rank == 0:
        points = vtk_to_numpy(piece.GetPoints().GetData())
        points *= 1.01
        piece.GetPoints().Modified()
    piece.Modified()
    producer.Modified()
    cells.MarkModified(cells)
    first, second = [outputs(proxy, (0,))[0][0] for proxy in proxies]
    if skdpieces.process()[1] == 2 and numpy.nansum(second["point Field"]) == before:
        yield "nothing has moved"
    for array in first:
        if first[array].tobytes() != second[array].tobytes():
            yield f"moved piece: {array}"


def largest_share():
    """Of the cells that a process needs of a mesh which all together have, when both are cut
    alike."""
    from paraview import simple

    cells = skdpieces.source("tetrahedra", "cuts", size=6)
    proxy = simple.SkdTreeProbe(Input=cells, Source=cells, SourceDistribution="Exchange")
    proxy.UpdatePipeline()
    report = proxy.GetClientSideObject().GetOutputDataObject(0).GetFieldData()
    return report.GetArray("SkdReportSourceCells").GetTuple1(0) / (12**3 * 5)


def write(file, partitions):
    found = [difference for partition in partitions for difference in differences(partition)]
    found.extend(of_moved_piece())
    share = largest_share()
    if share > 0.7:
        found.append(f"a process has {share} of the cells")
    with open(file, "w", encoding="utf-8") as stream:
        stream.write("\n".join(found))


if len(sys.argv) > 1:
    file, *partitions = sys.argv[1].split("|")
    rank, count = skdpieces.process()
    write(file % rank, partitions)
elif shutil.which("mpiexec") is None or shutil.which("pvbatch") is None:
    skdtesting.skip("there is no mpiexec or no pvbatch")
else:
    for processes, partitions in RUNS.items():
        file = skdtesting.temporary(f"nearby_of_{processes}_%d.txt")
        for rank in range(processes):
            if os.path.exists(file % rank):
                os.remove(file % rank)
        skdtesting.run_in_parallel(
            os.path.abspath(__file__), "|".join((file, *partitions)), processes)
        for rank in range(processes):
            with open(file % rank, encoding="utf-8") as stream:
                found = stream.read()
            assert not found, f"process {rank} of {processes}:\n{found}"
