# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The mesh adaptation filter by ParaView's simple API."""

import os

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdtesting


def sheet(n):
    return simple.Plane(Origin=[0, 0, 0], Point1=[1, 0, 0], Point2=[0, 1, 0], XResolution=n,
        YResolution=n)


def ridge():
    return simple.Calculator(Input=sheet(80), ResultArrayName="Ridge",
        Function="exp(-100*(coordsX-0.3)*(coordsX-0.3))")


def table(proxy, column):
    proxy.UpdatePipeline()
    rows = servermanager.Fetch(proxy, idx=1)
    return vtk_to_numpy(rows.GetColumnByName(column))


def cell_array(proxy, name):
    return vtk_to_numpy(servermanager.Fetch(proxy).GetCellData().GetArray(name))


def test_defaults():
    adaptation = simple.SkdTreeMeshAdaptation(Input=sheet(8), Source=ridge())
    assert adaptation.Monitor == "Arc Length" and adaptation.Strength == 10
    assert adaptation.Smoothing == 4 and adaptation.MaximumRatio == 100
    assert adaptation.Surface == "Automatic" and adaptation.Borders == "Slide"
    assert adaptation.SourceCoordinates == "As Given" and adaptation.SampleWeights == "Automatic"
    assert adaptation.MaximumIterations == 50 and adaptation.Relaxation == 0.5
    assert adaptation.AnimateIterations == 0 and adaptation.TargetSizes == "Relative To Input"


def test_cells_follow_a_ridge():
    adaptation = simple.SkdTreeMeshAdaptation(Input=sheet(20), Source=ridge(), FieldArray="Ridge")
    measures = table(adaptation, "SkdEquidistributionError")
    assert measures.min() < measures[0] / 3, measures
    assert (table(adaptation, "SkdSmallestQuality") > 0.1).all()
    ratios = cell_array(adaptation, "SkdAreaRatio")
    assert ratios.min() < 0.6 and ratios.max() > 1.2


def test_iterations_are_time_steps():
    adaptation = simple.SkdTreeMeshAdaptation(
        Input=sheet(12), Source=ridge(), FieldArray="Ridge", AnimateIterations=1,
        MaximumIterations=6)
    adaptation.UpdatePipelineInformation()
    assert list(adaptation.TimestepValues) == list(range(7))
    farthest = []
    for time in (0, 1, 6):
        adaptation.UpdatePipeline(time)
        farthest.append(adaptation.PointData["SkdDisplacement"].GetRange(-1)[1])
    assert farthest[0] == 0 and 0 < farthest[1] != farthest[2] > 0, farthest


def test_mean_heights_of_the_earth():
    relief = simple.OpenDataFile(os.path.join(skdtesting.DATA_DIR, "earth_relief.vti"))
    ball = simple.Sphere(Radius=1, ThetaResolution=36, PhiResolution=18)
    means = simple.SkdTreeMeshAdaptation(Input=ball, Source=relief, FieldArray="height",
        SourceCoordinates="Longitude Latitude", MaximumIterations=0)
    height = cell_array(means, "SkdFieldMean")
    area = cell_array(means, "SkdArea")
    assert abs(area.sum() / (4 * numpy.pi) - 1) < 1e-6
    mean = (height * area).sum() / area.sum()
    data = servermanager.Fetch(relief)
    values = vtk_to_numpy(data.GetPointData().GetArray("height")).reshape(180, 360)
    cosine = numpy.cos(numpy.radians(numpy.arange(180) - 89.5))[:, None] * numpy.ones((1, 360))
    exact = (values * cosine).sum() / cosine.sum()
    assert abs(mean - exact) < 30, (mean, exact)  # of -2400 m; cells hold whole samples
    equal = simple.SkdTreeMeshAdaptation(Input=ball, Source=relief, FieldArray="height",
        SourceCoordinates="Longitude Latitude", MaximumIterations=0, SampleWeights="Equal")
    other = cell_array(equal, "SkdFieldMean")
    assert abs(other - height).max() > 10  # near the poles


skdtesting.run_tests(globals())
