# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin in a client and a server of its own. Run without an argument this starts both; with a
port it is the client."""

import os
import shutil
import subprocess
import sys
import threading

import skdtesting


def start_server():
    """A server on a port that the system chooses, and that port."""
    server = subprocess.Popen(["pvserver", "--server-port=0", "--hostname=localhost"],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    watchdog = threading.Timer(60, server.kill)
    watchdog.start()
    for line in server.stdout:
        if line.startswith("Accepting connection(s)"):
            watchdog.cancel()
            return server, line.rsplit(":", 1)[1].strip()
    raise RuntimeError("pvserver did not start")


def distances():
    from paraview import simple

    closest = simple.SkdTreeClosestPoint(Input=simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4]),
        Source=simple.Sphere(Radius=3), SignedDistance=1)
    return skdtesting.point_array(closest, "SkdDistance")


def probed():
    from paraview import simple

    probe = simple.SkdTreeProbe(Input=simple.Plane(Origin=[-9, -9, 0.3], Point1=[9, -9, 0.3],
        Point2=[-9, 12, 0.4], XResolution=20, YResolution=20), Source=simple.Wavelet(),
        OutsidePoints="Nearest Cell")
    return skdtesting.point_array(probe, "RTData")


def depths():
    from paraview import simple

    parts = simple.GroupDatasets(Input=[simple.Sphere(Radius=radius) for radius in (2, 3)])
    inside = simple.SkdTreePointInOut(
        Input=simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4]), Source=parts)
    return skdtesting.point_array(inside, "SkdDepth")


def cells_found():
    from paraview import servermanager, simple

    query = simple.SkdTreeSpatialQuery(Input=simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4]),
        Source=simple.Sphere(Radius=3), Shape="Source Cells")
    query.UpdatePipeline()
    pairs = servermanager.Fetch(query, idx=2)
    extracted = simple.ExtractSelection(
        Input=query.Input, Selection=simple.OutputPort(query, 1))
    extracted.UpdatePipeline()
    cells = extracted.GetDataInformation().GetNumberOfCells()
    assert cells == query.GetDataInformation().GetNumberOfCells() > 0
    return [[pairs.GetValue(row, column).ToDouble() for column in range(pairs.GetNumberOfColumns())]
        for row in range(pairs.GetNumberOfRows())]


def resampled_mask():
    from paraview import simple

    resampled = simple.ResampleWithDataset(
        SourceDataArrays=simple.Wavelet(), DestinationMesh=simple.Sphere(Radius=3))
    resampled.CellLocator = "SkdTreeCellLocator"
    return skdtesting.point_array(resampled, "vtkValidPointMask")


def crossings():
    """Of spheres with each other, and of a line with one."""
    from paraview import servermanager, simple

    spheres = simple.Sphere(Radius=3), simple.Sphere(Radius=2.5, Center=[2, 0.3, 0.1])
    line = simple.Line(Point1=[-4, 0.3, 0.2], Point2=[4, 0.1, 0.7])
    proxies = (simple.SkdTreeSurfaceIntersection(
                   Input=spheres[0], Source=spheres[1], SplitSurfaces=1),
        simple.SkdTreeCurveSurfaceIntersection(Input=line, Source=spheres[0]))
    found = []
    for proxy in proxies:
        proxy.UpdatePipeline()
        data = servermanager.Fetch(proxy)
        found += [data.GetPoint(i) for i in range(data.GetNumberOfPoints())]
    return found


def compared():
    from paraview import servermanager, simple

    compared = simple.SkdTreeCompareSurfaces(
        Input=simple.Sphere(Radius=3), Source=simple.Sphere(Radius=2.5), SignedDistance=1)
    compared.UpdatePipeline()
    table = servermanager.Fetch(compared, idx=2)
    return [number for column in range(1, table.GetNumberOfColumns()) for row in range(3)
        for number in table.GetColumn(column).GetTuple(row)]


def traced():
    """Streamlines on an attached tree."""
    from paraview import servermanager, simple

    flow = simple.OpenDataFile(os.path.join(skdtesting.DATA_DIR, "disk_flow.vtu"))
    tracer = simple.StreamTracer(Input=simple.SkdTreeAttach(Input=flow), Vectors=["POINTS", "V"],
        SeedType="Line", MaximumStreamlineLength=5)
    if "CellLocator" in tracer.ListProperties():  # since ParaView 6.2
        tracer.CellLocator = "SkdTreeCellLocator"
    else:
        tracer.InterpolatorType = "Interpolator with Cell Locator"
    tracer.SeedType.Point1, tracer.SeedType.Point2 = [-4, -4, 1], [4, 4, 8]
    tracer.SeedType.Resolution = 5
    tracer.UpdatePipeline()
    lines = servermanager.Fetch(tracer)
    return [lines.GetPoint(i) for i in range(lines.GetNumberOfPoints())]


def tree_drawn():
    """The boxes of a level, and the table but for its last column, the seconds."""
    from paraview import servermanager, simple

    drawn = simple.SkdTreeRepresentation(Input=simple.Sphere(), Level=3)
    drawn.UpdatePipeline()
    boxes, table = servermanager.Fetch(drawn), servermanager.Fetch(drawn, idx=1)
    return [boxes.GetPoint(i) for i in range(boxes.GetNumberOfPoints())], [
        table.GetValue(0, i).ToDouble() for i in range(table.GetNumberOfColumns() - 1)]


def relief():
    from paraview import simple

    return simple.OpenDataFile(os.path.join(skdtesting.DATA_DIR, "earth_relief.vti"))


def cell_array(proxy, name):
    from paraview import servermanager

    proxy.UpdatePipeline()
    array = servermanager.Fetch(proxy).GetCellData().GetArray(name)
    return [array.GetTuple1(i) for i in range(array.GetNumberOfTuples())]


def remapped():
    """Mean heights in the cells of a sphere, and mapped on from these to another one."""
    from paraview import simple

    means = simple.SkdTreeRemap(Input=simple.Sphere(ThetaResolution=12, PhiResolution=9),
        Source=relief(), Method="Contained Statistic", SourceCoordinates="Longitude Latitude")
    mapped = simple.SkdTreeRemap(
        Input=simple.Sphere(), Source=means, Method="Conservative Second Order")
    return cell_array(means, "height"), cell_array(mapped, "height")


def adapted():
    from paraview import servermanager, simple

    adaptation = simple.SkdTreeMeshAdaptation(
        Input=simple.Sphere(ThetaResolution=12, PhiResolution=9), Source=relief(),
        SourceCoordinates="Longitude Latitude", MaximumIterations=2)
    adaptation.UpdatePipeline()
    mesh = servermanager.Fetch(adaptation)
    return [mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())]


def assert_all_same(first, second):
    """The same values, or lists of them."""
    if isinstance(first, tuple):
        for one, other in zip(first, second):
            skdtesting.assert_same(one, other)
        return
    skdtesting.assert_same(first, second)


def be_client(port):
    from paraview import simple

    questions = (distances, probed, depths, crossings, cells_found, traced, tree_drawn,
        remapped, adapted, compared)
    alone = [ask() for ask in questions]
    assert set(alone[2]) == {0, 1, 2}
    assert len(alone[3]) > 10
    assert len(alone[5]) > 100
    simple.Connect("localhost", int(port))
    for ask, before in zip(questions, alone):
        assert_all_same(ask(), before)
    assert resampled_mask().all()


if len(sys.argv) > 1:
    be_client(sys.argv[1])
elif shutil.which("pvserver") is None:
    skdtesting.skip("there is no pvserver")
else:
    server, port = start_server()
    try:
        subprocess.run(["pvpython", os.path.abspath(__file__), port], check=True, timeout=300)
        said = server.communicate(timeout=60)[0]  # it ends when its client does
        assert "ERR|" not in said, said
    finally:
        server.kill()
