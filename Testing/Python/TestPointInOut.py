# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The point in/out filter by ParaView's simple API."""

import os

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdtesting


def grid(size=8):
    return simple.Wavelet(WholeExtent=[-size, size] * 3)


def ball(radius, centre=(0, 0, 0)):
    return simple.Sphere(
        Radius=radius, Center=list(centre), ThetaResolution=64, PhiResolution=64)


def radii(proxy):
    data = servermanager.Fetch(proxy)
    where = numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    return numpy.linalg.norm(where, axis=1)


def test_defaults():
    test = simple.SkdTreePointInOut(Input=grid(), Source=ball(5))
    assert test.Model == "Boundaries" and test.Parts == "Blocks" and test.Method == "Automatic"
    assert test.NumberOfRays == 10 and test.Seed == 0 and test.Ask == "Points"
    assert test.BoundaryBand == 0 and test.UseOuterFaces == 1
    assert test.RepairOrientation == 0 and test.Extract == "Nothing"


def test_every_method_voxelises_a_ball():
    for method in ("Axis Rays", "Random Rays", "Winding Number", "Nearest Feature"):
        test = simple.SkdTreePointInOut(Input=grid(), Source=ball(5.1), Method=method)
        inside = skdtesting.point_array(test, "SkdInside")
        clear = abs(radii(test) - 5.1) > 0.02
        numpy.testing.assert_array_equal(inside[clear] == 1, (radii(test) < 5.1)[clear])
        assert skdtesting.report(test, "OpenEdges") == 0
        has_winding = test.PointData.GetArray("SkdWindingNumber") is not None
        assert has_winding == (method == "Winding Number")


def test_nested_parts():
    parts = simple.GroupDatasets(Input=[ball(7.1), ball(3.1), ball(5.1)])
    test = simple.SkdTreePointInOut(Input=grid(), Source=parts)
    depth = skdtesting.point_array(test, "SkdDepth")
    part = skdtesting.point_array(test, "SkdPartId")
    r = radii(test)
    clear = (abs(r[:, None] - [3.1, 5.1, 7.1]) > 0.02).all(axis=1)
    expected = (r[:, None] < [3.1, 5.1, 7.1]).sum(axis=1)
    numpy.testing.assert_array_equal(depth[clear], expected[clear])
    numpy.testing.assert_array_equal(part[clear], numpy.array([-1, 1, 3, 2])[expected][clear])
    merged = simple.MergeBlocks(Input=parts, MergePoints=0)
    pieces = simple.SkdTreePointInOut(Input=grid(), Source=merged, Parts="Connected Pieces")
    skdtesting.assert_same(skdtesting.point_array(pieces, "SkdDepth"), depth)


def test_cells_are_asked_too():
    test = simple.SkdTreePointInOut(Input=grid(), Source=ball(5.1))
    counts = []
    for ask in ("Cells All Points", "Cell Centers", "Cells Any Point"):
        test.Ask = ask
        test.UpdatePipeline()
        data = servermanager.Fetch(test)
        counts.append(vtk_to_numpy(data.GetCellData().GetArray("SkdInside")).sum())
    assert 0 < counts[0] < counts[1] < counts[2] < 16**3, counts


def test_a_mesh_that_fills_the_parts():
    flow = simple.OpenDataFile(os.path.join(skdtesting.DATA_DIR, "disk_flow.vtu"))
    fitted = simple.SkdTreePointInOut(Input=grid(), Source=flow, Model="Body Fitted Mesh")
    faces = simple.SkdTreePointInOut(Input=grid(), Source=flow)
    a = skdtesting.point_array(fitted, "SkdInside")
    b = skdtesting.point_array(faces, "SkdInside")
    assert 500 < a.sum() < len(a)
    assert (a != b).mean() < 0.01  # faces are warped: cut into triangles they are others a little


def test_extraction():
    test = simple.SkdTreePointInOut(
        Input=grid(), Source=ball(5.1), Ask="Cells All Points", Extract="Inside")
    test.UpdatePipeline()
    inside = servermanager.Fetch(test, idx=1)
    assert inside.GetNumberOfCells() == skdtesting.report(test, "PointsInside") > 100
    assert max(abs(value) for value in inside.GetBounds()) == 4
    test.Extract = "Outside"
    test.UpdatePipeline()
    outside = servermanager.Fetch(test, idx=1)
    assert outside.GetNumberOfCells() + inside.GetNumberOfCells() == 16**3
    assert outside.GetPointData().GetArray("RTData") is not None


def test_trees_are_kept():
    test = simple.SkdTreePointInOut(Input=grid(), Source=ball(5))
    test.UpdatePipeline()
    assert skdtesting.report(test, "TreesBuilt") == 1
    test.BoundaryBand = 1.0
    test.UpdatePipeline()
    assert skdtesting.report(test, "TreesBuilt") == 0
    assert skdtesting.point_array(test, "SkdOnBoundary").any()


skdtesting.run_tests(globals())
