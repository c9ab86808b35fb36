# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The closest point filter by ParaView's simple API."""

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdtesting

RADIUS = 5.0


def scene(**properties):
    points = simple.Wavelet(WholeExtent=[-8, 8, -8, 8, -8, 8])
    sphere = simple.Sphere(Radius=RADIUS, ThetaResolution=128, PhiResolution=128)
    return simple.SkdTreeClosestPoint(Input=points, Source=sphere, **properties)


def expected_distances(closest):
    data = servermanager.Fetch(closest)
    where = numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    return numpy.linalg.norm(where, axis=1) - RADIUS


def test_defaults():
    closest = scene()
    assert closest.SignedDistance == 0
    assert closest.InterpolateSourceData == 0
    assert closest.GenerateLines == 0
    assert closest.MaximumDistance == 1e299
    assert closest.Epsilon == 1e-9


def test_distances_are_those_to_the_sphere():
    found = skdtesting.point_array(scene(), "SkdDistance")
    numpy.testing.assert_allclose(found, abs(expected_distances(scene())), atol=5e-3)


def test_signed_distances_are_negative_inside():
    closest = scene(SignedDistance=1)
    found = skdtesting.point_array(closest, "SkdDistance")
    numpy.testing.assert_allclose(found, expected_distances(closest), atol=5e-3)
    assert skdtesting.report(closest, "OpenEdges") == 0


def test_points_too_far_away_get_no_answer():
    closest = scene(MaximumDistance=1.0)
    distances = skdtesting.point_array(closest, "SkdDistance")
    cells = skdtesting.point_array(closest, "SkdClosestCellId")
    is_far = abs(expected_distances(closest)) > 1.01
    assert numpy.isnan(distances[is_far]).all() and (cells[is_far] == -1).all()
    assert (distances[~numpy.isnan(distances)] <= 1.0).all()


def test_the_second_output_has_the_lines():
    closest = scene(GenerateLines=1)
    points = skdtesting.point_array(closest, "SkdClosestPoint")
    lines = servermanager.Fetch(closest, idx=1)
    assert lines.GetNumberOfCells() == len(points) == 17**3
    ends = vtk_to_numpy(lines.GetPoints().GetData())[1::2]
    skdtesting.assert_same(ends, points)
    assert lines.GetCellData().GetArray("SkdDistance") is not None


def test_the_sources_data_are_interpolated():
    sphere = simple.Sphere(Radius=RADIUS, ThetaResolution=32, PhiResolution=32)
    field = simple.Calculator(Input=sphere, Function="coordsX - 3 * coordsZ", ResultArrayName="F")
    closest = scene(InterpolateSourceData=1)
    closest.Source = field
    at = skdtesting.point_array(closest, "SkdClosestPoint")
    found = skdtesting.point_array(closest, "F")
    numpy.testing.assert_allclose(found, at[:, 0] - 3 * at[:, 2], atol=1e-5)


def test_composite_inputs_and_sources():
    parts = simple.GroupDatasets(
        Input=[simple.Sphere(Center=[-3, 0, 0]), simple.Sphere(Center=[3, 0, 0])])
    box = simple.Box(XLength=10, YLength=10, ZLength=10)
    closest = simple.SkdTreeClosestPoint(Input=parts, Source=parts)
    closest.UpdatePipeline()
    assert closest.PointData["SkdDistance"].GetRange() == (0, 0)
    assert closest.PointData["SkdClosestBlockIndex"].GetRange() == (1, 2)
    kinds = [proxy.GetDataInformation().GetCompositeDataSetType() for proxy in (closest, parts)]
    assert kinds[0] == kinds[1], kinds
    closest.Input = box
    closest.UpdatePipeline()
    low, high = closest.PointData["SkdDistance"].GetRange()
    assert 6.8 < low <= high < 7.0, (low, high)


def test_the_tree_is_kept_over_time_steps_and_settings():
    closest = scene()
    sphere = closest.Source
    closest.UpdatePipeline()
    assert skdtesting.report(closest, "TreesBuilt") == 1
    closest.MaximumDistance = 2.0
    closest.UpdatePipeline()
    assert skdtesting.report(closest, "TreesBuilt") == 0
    closest.Source = simple.Calculator(Input=sphere, Function="coordsX", ResultArrayName="New")
    closest.UpdatePipeline()
    assert skdtesting.report(closest, "TreesBuilt") == 0
    sphere.Radius = 1.0
    closest.UpdatePipeline()
    assert skdtesting.report(closest, "TreesBuilt") == 1


def test_the_first_picture_is_coloured_by_distance():
    view = simple.CreateRenderView(ViewSize=[200, 200])
    plane = simple.Plane(XResolution=20, YResolution=20)
    display = simple.Show(simple.SkdTreeClosestPoint(Input=plane, Source=simple.Cone()), view)
    simple.Render(view)
    assert list(display.ColorArrayName) == ["POINTS", "SkdDistance"], display.ColorArrayName


skdtesting.run_tests(globals())
