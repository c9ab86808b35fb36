# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""A Source in pieces of which each process gets what is near its own part of the Input: outputs are
those of a Source that is gathered everywhere, on each process, to the last bit, and sums over all
processes but for rounding. Run without an
argument this starts the processes; with the name of a file and partitions it is one of them, and
writes there in what they differ."""

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_LAGRANGE_HEXAHEDRON
from vtkmodules.vtkFiltersSources import vtkCellTypeSource

import skdpieces

RUNS = {
    2: ("everywhere", "cuts, ghosts"),
    3: ("cuts", "round robin, global ids", "one process"),
    4: ("cuts, doubled",),
}
REPORT = "SkdReportSourceExchanged"
SUMS = ("SourceIntegral", "OverlapIntegral", "TargetIntegral", "Coverage")


def curved(partition):
    """Lagrange hexahedra."""
    source = vtkCellTypeSource()
    source.SetCellType(VTK_LAGRANGE_HEXAHEDRON)
    source.SetBlocksDimensions(3, 3, 3)
    source.Update()
    return skdpieces.producer(skdpieces.piece(source.GetOutput(), partition))


def filters(partition):
    """Names, how each is made, and its output ports. What depends on the mean radius of all points
    or on the middle of a process's part of the Input, or is a sum over what is brought, is named ~:
    it is the same but for rounding."""
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
    yield "volume cells and a surface", lambda: simple.SkdTreeSurfaceIntersection(
        Input=other, Source=cells), (0, 1, 2)
    yield "curves and volume cells", lambda: simple.SkdTreeCurveSurfaceIntersection(
        Input=edges, Source=cells), (0, 2)
    yield "probe the nearest cells", lambda: simple.SkdTreeProbe(
        Input=image, Source=other, OutsidePoints="Nearest Cell", PassInputData=0), (0,)
    yield from remaps(partition, image, ball, cells, with_both)
    yield from refinements(ball, few, with_both)
    yield "remap by interpolation", lambda: simple.SkdTreeRemap(Input=image, Source=cells,
        Method="Interpolation", EmptyCells="Leave", PassInputData=0), (0,)


def refinements(ball, few, with_both):
    """By a field, and with its values."""
    from paraview import simple

    field = {"Field": with_both, "FieldArrays": ["Field"], "MaximumLevel": 2}
    grid = {"OutputType": "Unstructured Grid", "BaseDimensions": [5, 4, 3]}
    tests = [("a field", {"FieldThreshold": 20}),
        ("gradients", {"FieldTest": "Gradient", "FieldThreshold": 60}),
        ("a relative field", {"FieldThreshold": 0.1, "RelativeFieldThreshold": 1})]
    for name, test in tests:
        for input in (ball, few):
            yield "refined by " + name, lambda input=input, test=test: simple.SkdTreeMeshRefinement(
                Input=input, Method="Regular", **field, **test), (0,)
        yield "grid refined by " + name, lambda test=test: simple.SkdTreeAMR(
            Input=ball, **grid, **field, **test), (0,)
    for name, asked in (("", {}), (" of what is inside", {"ComputeInside": 1})):
        yield "~field on a grid" + name, lambda asked=asked: simple.SkdTreeAMR(
            Input=few, ComputeField=1, **grid, **field, **asked), (0,)


def remaps(partition, image, ball, cells, with_both):
    """Of what cells contain, of surfaces and of lines."""
    from paraview import simple

    def remap(input, source, **asked):
        return lambda: simple.SkdTreeRemap(Input=input, Source=source, PassInputData=0, **asked)

    few = skdpieces.source("tetrahedra", partition, size=3)
    yield "remap automatically", remap(few, with_both), (0,)
    yield "remap to what is outside", remap(image, with_both, Method="Conservative First Order",
        Extrapolation="Nearest"), (0,)
    for empty in ("Leave", "Nearest"):
        yield "remap what is contained, " + empty, remap(
            few, ball, Method="Contained Statistic", EmptyCells=empty), (0,)
    both_of_ball = simple.PointDatatoCellData(Input=ball, PassPointData=1)
    other = skdpieces.source("sphere", partition, radius=4.0, theta=17, phi=15)
    yield "remap what is contained on a sphere", remap(
        other, both_of_ball, Method="Contained Statistic"), (0,)
    yield "~remap on a sphere", remap(
        other, both_of_ball, Method="Conservative First Order", GenerateWeights=1), (0, 1)
    yield "~remap on a sphere by gradients", remap(
        other, both_of_ball, Method="Conservative Second Order"), (0,)
    world = skdpieces.source("tiles", partition, corner=(0, -90, 0), first=(360, -90, 0),
        second=(0, 90, 0), count=12)
    yield "~remap longitudes and latitudes", remap(other, world, Method="Conservative First Order",
        SourceCoordinates="Longitude Latitude", SourceEdgesAlongParallels=1), (0,)
    nearly = skdpieces.source("sphere", partition, radius=4.01, theta=17, phi=15)
    yield "~remap nearly coinciding surfaces", remap(nearly, both_of_ball,
        Geometry="Curved Surface", Method="Conservative First Order"), (0,)
    for name, third in (("", 0.0), (" across no axis", 0.6)):
        floor = skdpieces.source("tiles", partition, first=(1.0, 0.0, third))
        other = skdpieces.source("tiles", partition, first=(0.9, 0.0, 0.9 * third), count=7)
        yield ("~" if third else "") + "remap in a plane" + name, remap(other, floor,
            Method="Conservative First Order", GenerateWeights=1, GenerateOverlapMesh=1), (0, 1, 2)
    yield "remap on a line", remap(skdpieces.source("wire", partition, count=23),
        skdpieces.source("wire", partition), Method="Conservative Second Order"), (0,)


def are_alike(first, second, is_sum):
    """To the last bit; of sums, `is_sum`, to rounding."""
    if first is None or second is None or first.shape != second.shape:
        return False
    if not is_sum or first.dtype.kind != "f":
        return first.tobytes() == second.tobytes()
    largest = numpy.nanmax(numpy.abs(first), initial=0.0)
    return numpy.allclose(first, second, rtol=0.0, atol=2e-14 * largest, equal_nan=True)


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
        if cells is None:  # there never was one
            continue
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
        if not numpy.allclose(sums["Replicate"], sums["Exchange"], rtol=1e-13, atol=1e-13):
            yield f"{partition}, {name}: {sums}"
        for port, gathered, near in zip(ports, found["Replicate"], found["Exchange"]):
            for array in sorted(set(gathered) | set(near)):
                first, second = gathered.get(array), near.get(array)
                if not are_alike(first, second, name.startswith("~")):
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


def check(file, processes, _partitions):
    for rank in range(processes):
        with open(file % rank, encoding="utf-8") as stream:
            found = stream.read()
        assert not found, f"process {rank} of {processes}:\n{found}"


skdpieces.run(__file__, RUNS, "nearby_%d.txt", write, check)
