# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rays by ParaView's simple API."""

import numpy
from paraview import simple

import skdtesting


def ball(**properties):
    return simple.Sphere(ThetaResolution=48, PhiResolution=48, **properties)


def test_normals_reach_the_outer_sphere():
    rays = simple.SkdTreeRays(Input=ball(Radius=1), Source=ball(Radius=2))
    distances = skdtesting.point_array(rays, "SkdRayDistance")
    numpy.testing.assert_allclose(distances, 1, atol=1e-2)
    assert (skdtesting.point_array(rays, "SkdRaySide") == -1).all()
    hits = simple.OutputPort(rays, 1)
    hits.UpdatePipeline()
    assert hits.GetDataInformation().GetNumberOfPoints() == len(distances)


def test_an_array_of_vectors_is_chosen_by_name():
    source = simple.Calculator(
        Input=ball(Radius=1), ResultArrayName="Down", Function="-kHat", ResultNormals=0)
    rays = simple.SkdTreeRays(
        Input=source, Source=simple.Plane(Origin=[-5, -5, -3], Point1=[5, -5, -3],
            Point2=[-5, 5, -3]), Along="Array", DirectionArray="Down", Hits="All Hits")
    heights = skdtesting.point_array(rays, "SkdRayDistance")
    assert abs(heights.min() - 2) < 1e-6 and abs(heights.max() - 4) < 1e-6
    assert (skdtesting.point_array(rays, "SkdRayHits") == 1).all()


def test_blocks_are_told_apart():
    group = simple.GroupDatasets(Input=[ball(Radius=2), ball(Radius=1)])
    rays = simple.SkdTreeRays(Input=simple.Line(Point1=[0, 0, 5], Point2=[0.1, 0, 5]), Source=group,
        Along="Direction", Direction=[0, 0, -1], Hits="All Hits", GenerateLines=1)
    assert (skdtesting.point_array(rays, "SkdRayHits") == 4).all()
    assert (skdtesting.point_array(rays, "SkdRayBlockIndex") == 1).all()
    lines = simple.OutputPort(rays, 1)
    lines.UpdatePipeline()
    assert lines.CellData["SkdRayBlockIndex"].GetRange() == (1, 2)


skdtesting.run_tests(globals())
