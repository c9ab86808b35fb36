# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The curve surface intersection filter by ParaView's simple API."""

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdtesting


def scene(**properties):
    line = simple.Line(Point1=[-2, 0.25, 0.125], Point2=[2, 0.25, 0.125], Resolution=7)
    box = simple.Box(XLength=2, YLength=2, ZLength=2)
    return simple.SkdTreeCurveSurfaceIntersection(Input=line, Source=box, **properties)


def test_defaults():
    crossing = scene()
    assert crossing.PolylineForm == "Straight"
    assert crossing.Tension == crossing.Bias == crossing.Continuity == 0
    assert crossing.VolumeFaces == 1
    assert crossing.Parts == "Blocks"
    assert crossing.PartArray == ""
    assert crossing.HitSelection == "All"
    assert crossing.HitNumber == 1
    assert crossing.InterpolateData == 1
    assert crossing.CutCurves == 0
    assert crossing.ChordTolerance == 1e-3
    assert crossing.Epsilon == 1e-9


def test_a_line_goes_in_and_out():
    crossing = scene()
    skdtesting.assert_same(skdtesting.point_array(crossing, "SkdSense"), [1, -1])
    skdtesting.assert_same(skdtesting.point_array(crossing, "SkdArcLength"), [1, 3])
    skdtesting.assert_same(skdtesting.point_array(crossing, "SkdAngle"), [90, 90])
    assert skdtesting.report(crossing, "Hits") == 2


def test_the_first_and_the_nth_hit():
    first = scene(HitSelection="First")
    skdtesting.assert_same(skdtesting.point_array(first, "SkdSense"), [1])
    second = scene(HitSelection="Nth", HitNumber=2)
    skdtesting.assert_same(skdtesting.point_array(second, "SkdHitNumber"), [2])


def test_the_second_output_has_the_pieces():
    crossing = scene(CutCurves=1)
    crossing.UpdatePipeline()
    pieces = servermanager.Fetch(crossing, idx=1)
    inside = vtk_to_numpy(pieces.GetCellData().GetArray("SkdPartsInside"))
    skdtesting.assert_same(inside, [0, 1, 0])


def pieces_of(crossing):
    crossing.UpdatePipeline()
    pieces = servermanager.Fetch(crossing, idx=1).GetCellData()
    return [list(vtk_to_numpy(pieces.GetArray(name))) for name in ("SkdPartsInside", "SkdPartId")]


def test_parts_are_blocks_pieces_or_values():
    boxes = [simple.Box(XLength=size, YLength=size, ZLength=size) for size in (3, 2)]
    names = [simple.Calculator(Input=box, AttributeType="Cell Data", ResultArrayName="name",
        Function=str(name)) for box, name in zip(boxes, (41, 7))]
    blocks = simple.GroupDatasets(Input=names)
    both = simple.AppendGeometry(Input=names)
    line = simple.Line(Point1=[-2, 0.25, 0.125], Point2=[2, 0.25, 0.125], Resolution=1)
    crossing = simple.SkdTreeCurveSurfaceIntersection(Input=line, Source=blocks, CutCurves=1)
    ids = skdtesting.point_array(crossing, "SkdPartId")
    skdtesting.assert_same(ids, skdtesting.point_array(crossing, "SkdBlockIndex"))
    assert ids[0] == ids[3] != ids[1] == ids[2], ids
    assert pieces_of(crossing) == [[0, 1, 2, 1, 0], [-1, ids[0], ids[1], ids[0], -1]]
    crossing = simple.SkdTreeCurveSurfaceIntersection(Input=line, Source=both, CutCurves=1)
    skdtesting.assert_same(skdtesting.point_array(crossing, "SkdPartId"), [0, 0, 0, 0])
    crossing.Parts = "Cell Array"
    assert "name" in crossing.GetProperty("PartArray").GetAvailable()
    crossing.PartArray = "name"
    skdtesting.assert_same(skdtesting.point_array(crossing, "SkdPartId"), [41, 7, 7, 41])
    assert pieces_of(crossing) == [[0, 1, 2, 1, 0], [-1, 41, 7, 41, -1]]
    merged = simple.CleantoGrid(Input=both)  # faces that share points
    crossing = simple.SkdTreeCurveSurfaceIntersection(
        Input=line, Source=merged, CutCurves=1, Parts="Connected Pieces")
    skdtesting.assert_same(skdtesting.point_array(crossing, "SkdPartId"), [0, 1, 1, 0])
    assert pieces_of(crossing) == [[0, 1, 2, 1, 0], [-1, 0, 1, 0, -1]]


def angle_at_the_start(loop, *others):
    """Of a closed curve that begins on a plane and is read first."""
    curves = [simple.PolyLineSource(Points=[x for point in curve for x in point])
        for curve in (loop, *others)]
    plane = simple.Plane(Origin=[0, 0, 0], Point1=[1, 0, 0], Point2=[0, 1, 0], XResolution=16,
        YResolution=8)
    crossing = simple.SkdTreeCurveSurfaceIntersection(
        Input=simple.AppendGeometry(Input=curves), Source=plane)
    of_loop = skdtesting.point_array(crossing, "SkdCurveCellId") == 0
    starts = of_loop & (skdtesting.point_array(crossing, "SkdCurveParameter") == 0)
    assert numpy.count_nonzero(starts) == 1, starts
    return skdtesting.point_array(crossing, "SkdAngle")[starts][0]


def test_a_closed_curve_has_the_angle_of_its_first_line_where_it_begins():
    expected = numpy.degrees(numpy.arctan2(0.125, 1 / 64))
    for x, y in ((0.25, 0.25), (0.3125, 0.625), (0.5, 0.5)): # corners of faces
        loop = [(x, y, 0), (x + 1 / 64, y, 0.125), (x + 0.1875, y, 0.125), (x + 0.25, y, -0.125),
            (x + 0.0625, y, -0.125), (x, y, 0)]
        for others in ([], [loop[:3]], [loop[2:]], [loop[:3], loop[2:]], [loop, loop[:3]]):
            numpy.testing.assert_allclose(angle_at_the_start(loop, *others), expected, rtol=1e-12)


def test_the_third_output_counts():
    crossing = scene()
    crossing.UpdatePipeline()
    curves = servermanager.Fetch(crossing, idx=2)
    assert curves.GetCellData().GetArray("SkdNumberOfHits").GetValue(0) == 2


def test_data_of_both_sides():
    crossing = scene()
    crossing.Source = simple.Elevation(
        Input=crossing.Source, LowPoint=[0, 0, 0], HighPoint=[1, 0, 0])
    for name in ("Texture Coordinates", "Elevation"):
        assert len(skdtesting.point_array(crossing, name)) == 2


def test_a_spline_leaves_its_polygon():
    points = simple.PolyLineSource(Points=[0, 0, 0, 1, 1, 0, 2, 1, 0, 3, 0, 0])
    lid = simple.Plane(Origin=[-1, 1.01, -1], Point1=[5, 1.01, -1], Point2=[-1, 1.01, 1])
    crossing = simple.SkdTreeCurveSurfaceIntersection(Input=points, Source=lid)
    crossing.UpdatePipeline()
    assert skdtesting.report(crossing, "Hits") == 0
    crossing.PolylineForm = "Cardinal Spline"
    crossing.UpdatePipeline()
    assert skdtesting.report(crossing, "Hits") == 2
    crossing.PolylineForm = "Kochanek Spline"
    crossing.UpdatePipeline()
    assert skdtesting.report(crossing, "Hits") == 2
    crossing.Tension = 1
    crossing.UpdatePipeline()
    assert skdtesting.report(crossing, "Hits") == 0


def test_composite_inputs_and_volumes():
    lines = simple.GroupDatasets(Input=[
        simple.Line(Point1=[-9, y, 0.3], Point2=[9, y, 0.3], Resolution=1) for y in (-2, 2)])
    volume = simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4])
    crossing = simple.SkdTreeCurveSurfaceIntersection(Input=lines, Source=volume)
    skdtesting.assert_same(skdtesting.point_array(crossing, "SkdSense"), [1, -1, 1, -1])
    assert len(set(skdtesting.point_array(crossing, "SkdCurveBlockIndex"))) == 2
    assert numpy.isfinite(skdtesting.point_array(crossing, "RTData")).all()


def test_the_tree_is_kept():
    crossing = scene()
    crossing.UpdatePipeline()
    assert skdtesting.report(crossing, "TreesBuilt") == 1
    crossing.Input.Point1 = [-2, 0.5, 0.5]
    crossing.UpdatePipeline()
    assert skdtesting.report(crossing, "TreesBuilt") == 0


skdtesting.run_tests(globals())
