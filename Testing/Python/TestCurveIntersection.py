# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The curve intersection filter by ParaView's simple API."""

import math

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdtesting


def lissajous(a, b, count=200):
    points = []
    for i in range(count):
        t = 2 * math.pi * i / count
        points += [math.sin(a * t + 0.3), math.sin(b * t), 0]
    return simple.PolyLineSource(Points=points + points[:3])


def scene(**properties):
    one = simple.Line(Point1=[0, 0, 0], Point2=[4, 0, 0], Resolution=3)
    other = simple.Line(Point1=[1, -1, 0], Point2=[1, 3, 0], Resolution=5)
    return simple.SkdTreeCurveIntersection(Input=one, Source=other, **properties)


def test_defaults():
    crossing = scene()
    assert crossing.PolylineForm == "Straight"
    assert crossing.Tension == crossing.Bias == crossing.Continuity == 0
    assert crossing.Clearance == 0
    assert crossing.IgnoreJoints == 1
    assert crossing.InterpolateData == 1
    assert crossing.CandidateRegions == 0
    assert crossing.ChordTolerance == 1e-3
    assert crossing.Epsilon == 1e-9


def test_two_lines():
    crossing = scene()
    skdtesting.assert_same(skdtesting.point_array(crossing, "SkdArcLength"), [1])
    skdtesting.assert_same(skdtesting.point_array(crossing, "SkdOtherArcLength"), [1])
    skdtesting.assert_same(skdtesting.point_array(crossing, "SkdAngle"), [90])
    assert skdtesting.report(crossing, "Hits") == 1


def test_curves_with_themselves():
    for a, b, expected in ((3, 4, 17), (2, 3, 7)):
        crossing = simple.SkdTreeCurveIntersection(Input=lissajous(a, b))
        crossing.UpdatePipeline()
        assert skdtesting.report(crossing, "Hits") == expected
        crossing.PolylineForm = "Cardinal Spline"
        crossing.UpdatePipeline()
        assert skdtesting.report(crossing, "Hits") == expected


def test_clearance():
    crossing = scene()
    crossing.Source.Point1, crossing.Source.Point2 = [1, -1, 0.5], [1, 3, 0.5]
    crossing.UpdatePipeline()
    assert skdtesting.report(crossing, "Hits") == 0
    crossing.Clearance = 1
    skdtesting.assert_same(skdtesting.point_array(crossing, "SkdGap"), [0.5])
    skdtesting.assert_same(skdtesting.point_array(crossing, "SkdKind"), [3])


def test_the_second_output_has_the_intervals():
    crossing = scene()
    crossing.Source.Point1, crossing.Source.Point2 = [1, 0, 0], [9, 0, 0]
    skdtesting.assert_same(skdtesting.point_array(crossing, "SkdKind"), [2, 2])
    intervals = servermanager.Fetch(crossing, idx=1)
    assert intervals.GetNumberOfCells() == 1
    low, high = intervals.GetBounds()[:2]
    assert abs(low - 1) < 1e-6 and abs(high - 4) < 1e-6, (low, high)


def test_a_kochanek_spline_of_full_tension_is_straight():
    zigzag = simple.PolyLineSource(Points=[0, 0, 0, 1, 1, 0, 2, -1, 0, 3, 0, 0])
    pole = simple.Line(Point1=[0.5, -9, 0], Point2=[0.5, 9, 0], Resolution=1)
    crossing = simple.SkdTreeCurveIntersection(
        Input=zigzag, Source=pole, PolylineForm="Kochanek Spline")
    bent = skdtesting.point_array(crossing, "SkdOtherArcLength")
    crossing.Tension = 1
    straight = skdtesting.point_array(crossing, "SkdOtherArcLength")
    assert abs(straight[0] - 9.5) < 1e-6 < abs(bent[0] - 9.5), (straight, bent)


def test_the_third_output_has_the_regions():
    crossing = simple.SkdTreeCurveIntersection(Input=lissajous(3, 4))  # it crosses within segments
    crossing.UpdatePipeline()
    assert servermanager.Fetch(crossing, idx=2).GetNumberOfCells() == 0
    crossing.CandidateRegions = 1
    crossing.UpdatePipeline()
    regions = servermanager.Fetch(crossing, idx=2)
    hits = vtk_to_numpy(regions.GetCellData().GetArray("SkdNumberOfHits"))
    assert regions.GetNumberOfCells() >= 17 and hits.sum() == 17, hits
    assert all(regions.GetCell(i).GetCellDimension() == 3 for i in range(len(hits)))
    boxes = numpy.array([regions.GetCell(i).GetBounds() for i in range(len(hits))])
    crossings = servermanager.Fetch(crossing, idx=0)
    for i in range(17):
        x = numpy.array(crossings.GetPoint(i))
        within = (boxes[:, 0::2] <= x).all(axis=1) & (x <= boxes[:, 1::2]).all(axis=1)
        assert hits[within].sum() >= 1, x
    ranges = vtk_to_numpy(regions.GetCellData().GetArray("SkdCurveParameterRange"))
    assert ((0 <= ranges[:, 0]) & (ranges[:, 0] < ranges[:, 1]) & (ranges[:, 1] <= 1)).all()


def test_composite_curves():
    lines = simple.GroupDatasets(Input=[
        simple.Line(Point1=[0, y, 0], Point2=[1, 1 - y, 0], Resolution=1) for y in (0, 1)])
    crossing = simple.SkdTreeCurveIntersection(Input=lines)
    assert len(skdtesting.point_array(crossing, "SkdCurveBlockIndex")) == 1


def test_the_trees_are_kept():
    skdtesting.assert_trees_are_kept(scene(), 2, Clearance=2)


skdtesting.run_tests(globals())
