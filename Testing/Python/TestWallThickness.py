# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Wall thickness by ParaView's simple API, and of real meshes."""

import os

import numpy
from paraview import simple

import skdtesting


def ball(**properties):
    return simple.Sphere(ThetaResolution=32, PhiResolution=32, **properties)


def test_a_ball_by_each_method():
    for properties in ({}, dict(Method="Spheres")):
        thickness = simple.SkdTreeWallThickness(Input=ball(Radius=1), **properties)
        values = skdtesting.point_array(thickness, "SkdThickness")
        numpy.testing.assert_allclose(values, 2, atol=0.05)


def test_against_a_source_and_of_cells():
    thickness = simple.SkdTreeWallThickness(
        Input=ball(Radius=2), Source=ball(Radius=1), Start="Cell Centers")
    thickness.UpdatePipeline()
    low, high = thickness.CellData["SkdThickness"].GetRange()
    assert 0.98 < low <= high < 1.02, (low, high)


def test_spheres_are_never_thicker_than_a_ray():
    surface = simple.OpenDataFile(os.path.join(skdtesting.DATA_DIR, "fly_brain_neuropil.vtp"))
    rays, spheres = (skdtesting.point_array(
        simple.SkdTreeWallThickness(Input=surface, Method=method), "SkdThickness")
        for method in ("Rays", "Spheres"))
    both = numpy.isfinite(rays) & numpy.isfinite(spheres)
    assert both.mean() > 0.99
    assert (spheres[both] <= rays[both] * (1 + 1e-9)).all()
    assert 0.1 < numpy.median(spheres[both] / rays[both]) < 1



def test_bodies_of_volume_cells():
    body = simple.Wavelet(WholeExtent=[0, 3, 0, 3, 0, 3])
    surface = simple.ExtractSurface(Input=body)
    for measured in (simple.SkdTreeWallThickness(Input=surface, Source=body),
            simple.SkdTreeWallThickness(Input=surface)):
        thickness = skdtesting.point_array(measured, "SkdThickness")
        assert numpy.nanmin(thickness) > 2.9, thickness
    own = skdtesting.point_array(simple.SkdTreeWallThickness(Input=body), "SkdThickness")
    assert numpy.isnan(own).sum() == 8 and numpy.nanmin(own) > 2.9, own


skdtesting.run_tests(globals())
