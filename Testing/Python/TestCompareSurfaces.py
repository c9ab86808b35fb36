# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The comparison of surfaces by ParaView's simple API."""

import math

import numpy
from paraview import servermanager, simple

import skdtesting


def ball(**properties):
    return simple.Sphere(ThetaResolution=64, PhiResolution=64, **properties)


def column(compared, name):
    table = servermanager.Fetch(compared, idx=2)
    return [table.GetValueByName(row, name).ToDouble() for row in range(3)]


def test_concentric_spheres():
    compared = simple.SkdTreeCompareSurfaces(
        Input=ball(Radius=1), Source=ball(Radius=2), SignedDistance=1)
    low = numpy.array(column(compared, "HausdorffDistance"))
    high = numpy.array(column(compared, "HausdorffUpperBound"))
    assert (low <= high).all() and (high - low < 1e-5 * 8).all(), (low, high)
    numpy.testing.assert_allclose(low, 1, atol=5e-3)
    numpy.testing.assert_allclose(column(compared, "Mean"), 1, atol=5e-3)
    numpy.testing.assert_allclose(column(compared, "SignedMean")[:2], [-1, 1], atol=5e-3)
    area = 4 * math.pi
    numpy.testing.assert_allclose(column(compared, "Area"), [area, 4 * area, 5 * area], rtol=5e-3)
    assert (skdtesting.point_array(compared, "SkdDistance") < 0).all()
    assert (skdtesting.point_array(compared, "SkdDistance", port=1) > 0).all()


def test_a_surface_equals_itself():
    source = ball()
    compared = simple.SkdTreeCompareSurfaces(Input=source, Source=source)
    for name in ("HausdorffDistance", "Mean", "Quantile99"):
        assert max(column(compared, name)) < 1e-8, name
    assert max(column(compared, "HausdorffUpperBound")) < 2e-5


def test_each_output_is_like_its_input():
    group = simple.GroupDatasets(Input=[ball(), ball(Center=[3, 0, 0])])
    compared = simple.SkdTreeCompareSurfaces(Input=simple.Box(), Source=group)
    compared.UpdatePipeline()
    assert compared.PointData["SkdClosestBlockIndex"].GetRange() == (1, 1)
    other = simple.OutputPort(compared, 1)
    assert other.GetDataInformation().GetCompositeDataSetType() == (
        group.GetDataInformation().GetCompositeDataSetType())
    assert "SkdClosestBlockIndex" not in other.PointData.keys()
    assert column(compared, "FromBlockIndex") == [0, 2, 2]
    assert skdtesting.report(compared, "TreesBuilt") == 2


skdtesting.run_tests(globals())
