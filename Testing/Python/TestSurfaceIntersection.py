# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The surface intersection filter by ParaView's simple API."""

import math

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdtesting


def sphere(*center):
    return simple.Sphere(Center=center, ThetaResolution=64, PhiResolution=64, Radius=1.0)


def output(proxy, port):
    simple.UpdatePipeline(proxy=proxy)
    return servermanager.Fetch(proxy, idx=port)


def column(table, name):
    get = getattr(table, "GetColumnByName", None) or table.GetArray
    return vtk_to_numpy(get(name))


def test_defaults():
    intersection = simple.SkdTreeSurfaceIntersection(Input=sphere(0, 0, 0))
    assert intersection.Source is None
    assert intersection.Pairs == "All"
    assert intersection.JoinCurves == 1
    assert intersection.SplitSurfaces == 0
    assert intersection.Clearance == 0
    for name in ("Translation", "Rotation", "RotationCenter"):
        assert list(getattr(intersection, name)) == [0, 0, 0]


def test_two_spheres_meet_in_a_circle():
    intersection = simple.SkdTreeSurfaceIntersection(Input=sphere(0, 0, 0), Source=sphere(1, 0.1, 0.2))
    curves = output(intersection, 0)
    assert curves.GetNumberOfLines() == curves.GetNumberOfCells() == 1
    radius = math.sqrt(1 - 1.05 / 4)
    length = curves.GetCellData().GetArray("SkdCurveLength").GetValue(0)
    assert abs(length - 2 * math.pi * radius) < 0.02, length
    at = vtk_to_numpy(curves.GetPoints().GetData())
    numpy.testing.assert_allclose(numpy.linalg.norm(at, axis=1), 1, atol=3e-3)
    pairs = output(intersection, 2)
    assert pairs.GetNumberOfRows() == skdtesting.report(intersection, "Pairs")
    assert set(column(pairs, "SkdContact")) <= {1, 2}


def test_a_sphere_does_not_meet_itself():
    intersection = simple.SkdTreeSurfaceIntersection(Input=sphere(0, 0, 0))
    assert output(intersection, 2).GetNumberOfRows() == 0


def test_moving_the_source_builds_no_tree():
    intersection = simple.SkdTreeSurfaceIntersection(Input=sphere(0, 0, 0), Source=sphere(0, 0, 0))
    intersection.Translation = [1, 0.1, 0.2]
    moved = output(intersection, 2)
    assert skdtesting.report(intersection, "TreesBuilt") == 2
    intersection.Translation = [2.5, 0, 0]
    assert output(intersection, 2).GetNumberOfRows() == 0
    assert skdtesting.report(intersection, "TreesBuilt") == 0
    there = simple.SkdTreeSurfaceIntersection(Input=sphere(0, 0, 0), Source=sphere(1, 0.1, 0.2))
    assert abs(output(there, 2).GetNumberOfRows() - moved.GetNumberOfRows()) < 4  # floats rounded


def test_boxes_of_one_plane_overlap():
    boxes = simple.Box(), simple.Box(Center=[0.5, 0.25, 1.0])
    intersection = simple.SkdTreeSurfaceIntersection(Input=boxes[0], Source=boxes[1])
    overlaps = simple.IntegrateVariables(Input=simple.OutputPort(intersection, 1))
    area = output(overlaps, 0).GetCellData().GetArray("Area").GetValue(0)
    assert abs(area - 0.5 * 0.75) < 1e-12, area
    assert 3 in column(output(intersection, 2), "SkdContact")


def test_a_clearance_gives_gaps():
    intersection = simple.SkdTreeSurfaceIntersection(
        Input=simple.Box(), Source=simple.Box(Center=[0, 0, 1.25]), Clearance=0.3)
    pairs = output(intersection, 2)
    assert (column(pairs, "SkdContact") == 0).all()
    numpy.testing.assert_allclose(column(pairs, "SkdDistance"), 0.25)
    assert output(intersection, 3).GetNumberOfLines() == pairs.GetNumberOfRows() > 0


def test_split_surfaces_fit_together():
    intersection = simple.SkdTreeSurfaceIntersection(
        Input=sphere(0, 0, 0), Source=sphere(1, 0.1, 0.2), SplitSurfaces=1)
    split = [output(intersection, port) for port in (4, 5)]
    for surface in split:
        assert set(column(surface.GetCellData(), "SkdRegionId")) == {0, 1}
        assert surface.GetPointData().HasArray("Normals")
    first, second = (set(map(tuple, vtk_to_numpy(s.GetPoints().GetData()))) for s in split)
    curve = set(map(tuple, vtk_to_numpy(output(intersection, 0).GetPoints().GetData())))
    assert curve <= first and curve <= second


def test_composite_inputs_tell_blocks():
    parts = simple.GroupDatasets(Input=[sphere(-5, 0, 0), sphere(0.5, 0, 0)])
    intersection = simple.SkdTreeSurfaceIntersection(Input=sphere(0, 0, 0), Source=parts)
    pairs = output(intersection, 2)
    assert pairs.GetNumberOfRows() > 50
    assert len(set(column(pairs, "SkdSecondBlockIndex"))) == 1
    assert pairs.GetColumnByName("SkdFirstBlockIndex") is None


skdtesting.run_tests(globals())
