# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The probe filter by ParaView's simple API."""

import os

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdtesting


def flow():
    return simple.OpenDataFile(os.path.join(skdtesting.DATA_DIR, "disk_flow.vtu"))


def sheet():
    return simple.Plane(
        Origin=[-6, 0, -1], Point1=[6, 0, -1], Point2=[-6, 0, 12], XResolution=120, YResolution=130)


def test_defaults():
    probe = simple.SkdTreeProbe(Input=sheet(), Source=flow())
    assert probe.ProbeLines == 0 and probe.PassInputData == 1 and probe.UseFillValue == 0
    assert probe.OutsidePoints == "Leave"
    assert probe.RelativeTolerance == 1e-3 and probe.AbsoluteTolerance == 0
    assert list(probe.GradientArrays) == [] and list(probe.CategoricalArrays) == []


def test_it_says_what_resample_with_dataset_says():
    source = flow()
    probe = simple.SkdTreeProbe(Input=sheet(), Source=source)
    other = simple.ResampleWithDataset(SourceDataArrays=source, DestinationMesh=sheet())
    valid = skdtesting.point_array(probe, "SkdValid")
    theirs = skdtesting.point_array(other, "vtkValidPointMask")
    assert valid.sum() > 5000
    assert (valid >= theirs).all(), (valid.sum(), theirs.sum())
    both = (valid == 1) & (theirs == 1)
    ours = skdtesting.point_array(probe, "Temp")
    span = numpy.nanmax(ours) - numpy.nanmin(ours)
    difference = abs(ours - skdtesting.point_array(other, "Temp"))[both]
    assert numpy.median(difference) < 1e-5 * span and difference.max() < 0.02 * span
    assert numpy.isnan(ours[valid == 0]).all()


def test_outside_points_and_fill_value():
    probe = simple.SkdTreeProbe(Input=sheet(), Source=flow(), UseFillValue=1, FillValue=-5)
    missing = skdtesting.point_array(probe, "SkdValid") == 0
    assert missing.any() and (skdtesting.point_array(probe, "Temp")[missing] == -5).all()
    probe.OutsidePoints = "Nearest Cell"
    assert skdtesting.point_array(probe, "SkdValid").all()
    farthest = skdtesting.point_array(probe, "SkdDistance").max()
    probe.OutsidePoints = "Nearest Cell Within Distance"
    probe.MaximumDistance = farthest / 2
    valid = skdtesting.point_array(probe, "SkdValid")
    assert 0 < valid.sum() < len(valid)


def test_gradients():
    source = simple.Calculator(
        Input=simple.Wavelet(), Function="2*coordsX - 3*coordsY + coordsZ", ResultArrayName="L")
    probe = simple.SkdTreeProbe(
        Input=simple.Sphere(Radius=5), Source=source, GradientArrays=["L"])
    found = skdtesting.point_array(probe, "L_Gradient")
    numpy.testing.assert_allclose(found, [[2, -3, 1]] * len(found), atol=1e-10)


def test_lines_are_cut_and_integrated():
    source = simple.Calculator(Input=simple.Wavelet(), Function="coordsX", ResultArrayName="X")
    line = simple.Line(Point1=[-20, 0.5, 0.5], Point2=[20, 0.5, 0.5], Resolution=1)
    probe = simple.SkdTreeProbe(Input=line, Source=source, ProbeLines=1)
    simple.UpdatePipeline(proxy=probe)
    intervals = servermanager.Fetch(probe, idx=1)
    entries = vtk_to_numpy(intervals.GetCellData().GetArray("SkdEntry"))
    numpy.testing.assert_allclose(entries, numpy.arange(10.0, 30.0), atol=1e-9)
    lengths = vtk_to_numpy(intervals.GetCellData().GetArray("SkdLength"))
    numpy.testing.assert_allclose(lengths, 1.0, atol=1e-9)
    table = servermanager.Fetch(probe, idx=2)
    assert table.GetNumberOfRows() == 1
    assert abs(table.GetColumnByName("SkdLength").GetValue(0) - 20) < 1e-9
    assert abs(table.GetColumnByName("X_Integral").GetValue(0)) < 1e-9


def test_composite_inputs_and_sources():
    parts = simple.GroupDatasets(Input=[simple.Wavelet(), flow()])
    probe = simple.SkdTreeProbe(Input=parts, Source=parts, PassInputData=0)
    probe.UpdatePipeline()
    assert probe.PointData["SkdValid"].GetRange() == (1, 1)
    assert probe.PointData["SkdSourceBlockIndex"].GetRange() == (1, 2)


def test_the_tree_is_kept():
    probe = simple.SkdTreeProbe(Input=sheet(), Source=flow())
    probe.UpdatePipeline()
    assert skdtesting.report(probe, "TreesBuilt") == 1
    probe.GradientArrays = ["Temp"]
    probe.UpdatePipeline()
    assert skdtesting.report(probe, "TreesBuilt") == 0
    assert probe.PointData["Temp_Gradient"].GetNumberOfComponents() == 3


skdtesting.run_tests(globals())
