# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The remapping filter by ParaView's simple API."""

import os

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdtesting


def relief():
    return simple.OpenDataFile(os.path.join(skdtesting.DATA_DIR, "earth_relief.vti"))


def cell_array(proxy, name):
    simple.UpdatePipeline(proxy=proxy)
    return vtk_to_numpy(servermanager.Fetch(proxy).GetCellData().GetArray(name))


def tiles(n, name="f"):
    """The unit square in n x n cells, with a linear field's averages."""
    plane = simple.Plane(Origin=[0, 0, 0], Point1=[1, 0, 0], Point2=[0, 1, 0], XResolution=n,
        YResolution=n)
    field = simple.Calculator(Input=plane, Function="coordsX+2*coordsY", ResultArrayName=name)
    averages = simple.PointDatatoCellData(Input=field)
    return averages


def test_defaults():
    remap = simple.SkdTreeRemap(Input=tiles(3, "g"), Source=tiles(4))
    assert remap.Method == "Automatic" and remap.ResultsOn == "Automatic"
    assert remap.Geometry == "Automatic" and remap.SourceCoordinates == "As Given"
    assert remap.Limiter == "Barth-Jespersen" and remap.Normalization == "Covered"
    assert remap.EmptyCells == "Nearest" and remap.MissingValues == "Mask"
    assert remap.PassInputData == 1 and remap.GenerateWeights == 0


def test_the_first_picture_conserves():
    remap = simple.SkdTreeRemap(Input=tiles(3, "g"), Source=tiles(4))
    values = cell_array(remap, "f")
    assert abs(values.mean() - 1.5) < 1e-7  # coordinates of the plane are in single precision
    assert skdtesting.report(remap, "ConservationError") < 1e-13
    assert abs(skdtesting.report(remap, "Coverage") - 1) < 1e-7


def test_second_order_keeps_linear_fields():
    remap = simple.SkdTreeRemap(Input=tiles(3, "g"), Source=tiles(4),
        Method="Conservative Second Order", Limiter="None")
    expected = cell_array(remap, "g")
    numpy.testing.assert_allclose(cell_array(remap, "f"), expected, atol=1e-6)


def test_contained_means_are_those_of_numpy():
    sphere = simple.Sphere(Radius=1, ThetaResolution=8, PhiResolution=7)
    remap = simple.SkdTreeRemap(Input=sphere, Source=relief(), Method="Contained Statistic",
        SourceCoordinates="Longitude Latitude")
    means = cell_array(remap, "height")
    counts = cell_array(remap, "SkdCount")
    image = servermanager.Fetch(relief())
    heights = vtk_to_numpy(image.GetPointData().GetArray("height"))
    longitude, latitude = numpy.meshgrid(
        numpy.radians(20.5 + numpy.arange(360)), numpy.radians(-89.5 + numpy.arange(180)))
    weight = numpy.cos(latitude).ravel()
    places = numpy.stack([(numpy.cos(latitude) * numpy.cos(longitude)).ravel(),
        (numpy.cos(latitude) * numpy.sin(longitude)).ravel(), numpy.sin(latitude).ravel()], 1)
    mesh = servermanager.Fetch(remap)
    for cell in range(mesh.GetNumberOfCells()):
        corners = [numpy.array(mesh.GetCell(cell).GetPoints().GetPoint(i)) for i in range(3)]
        sides = [places @ numpy.cross(corners[i], corners[(i + 1) % 3]) for i in range(3)]
        turn = numpy.sign(numpy.linalg.det(corners))
        inside = numpy.all([turn * side >= 0 for side in sides], axis=0)
        assert counts[cell] == inside.sum(), cell
        mean = (weight * heights)[inside].sum() / weight[inside].sum()
        assert abs(means[cell] - mean) < 1e-9, cell


def test_interpolation_and_weights():
    remap = simple.SkdTreeRemap(Input=tiles(3, "g"), Source=simple.Wavelet(), Method="Interpolation")
    assert numpy.isfinite(skdtesting.point_array(remap, "RTData")).all()
    remap = simple.SkdTreeRemap(Input=tiles(3, "g"), Source=tiles(4), GenerateWeights=1,
        GenerateOverlapMesh=1)
    simple.UpdatePipeline(proxy=remap)
    table = servermanager.Fetch(remap, idx=1)
    weights = vtk_to_numpy(table.GetColumnByName("Weight"))
    rows = vtk_to_numpy(table.GetColumnByName("Row"))
    numpy.testing.assert_allclose(numpy.bincount(rows, weights), 1, atol=1e-13)
    overlaps = servermanager.Fetch(remap, idx=2)
    assert overlaps.GetNumberOfCells() == len(rows) == 36


skdtesting.run_tests(globals())
