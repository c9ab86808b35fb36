# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pipelines with the plugin's filters, saved as states and loaded again."""

import os

from paraview import servermanager, simple

import skdtesting

SETTINGS = dict(
    SignedDistance=1, InterpolateSourceData=1, GenerateLines=1, MaximumDistance=4.5, Epsilon=1e-7)


def make_pipeline():
    points = simple.Wavelet(registrationName="points", WholeExtent=[-5, 5, -5, 5, -5, 5])
    source = simple.Sphere(registrationName="source", Radius=3)
    return simple.SkdTreeClosestPoint(
        registrationName="closest", Input=points, Source=source, **SETTINGS)


REMAP = dict(Method="Contained Statistic", SourceCoordinates="Longitude Latitude",
    Statistic="Median", EmptyCells="Leave", WeightsFileFormat="SCRIP")
ADAPTATION = dict(SourceCoordinates="Longitude Latitude", MaximumIterations=2, Strength=2.5,
    Monitor="Gradient", AnimateIterations=1)


def make_earth():
    """Mean heights in the cells of a mesh that was adapted to them."""
    relief = simple.OpenDataFile(os.path.join(skdtesting.DATA_DIR, "earth_relief.vti"))
    sphere = simple.Sphere(ThetaResolution=12, PhiResolution=9)
    adapted = simple.SkdTreeMeshAdaptation(
        registrationName="adapted", Input=sphere, Source=relief, **ADAPTATION)
    return simple.SkdTreeRemap(registrationName="means", Input=adapted, Source=relief, **REMAP)


def heights(proxy):
    simple.UpdatePipeline(time=2, proxy=proxy)
    mesh = servermanager.Fetch(proxy)
    array = mesh.GetCellData().GetArray("height")
    return ([array.GetTuple1(i) for i in range(array.GetNumberOfTuples())],
        [mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())])


def earth_round_trip(name):
    before = heights(make_earth())
    simple.SaveState(skdtesting.temporary(name))
    simple.ResetSession()
    simple.LoadState(skdtesting.temporary(name))
    for proxy, settings in (("means", REMAP), ("adapted", ADAPTATION)):
        loaded = simple.FindSource(proxy)
        for key, value in settings.items():
            assert getattr(loaded, key) == value, key
    after = heights(simple.FindSource("means"))
    for one, other in zip(before, after):
        skdtesting.assert_same(one, other)
    simple.ResetSession()


def round_trip(name):
    before = skdtesting.point_array(make_pipeline(), "SkdDistance")
    simple.SaveState(skdtesting.temporary(name))
    simple.ResetSession()
    assert simple.FindSource("closest") is None
    simple.LoadState(skdtesting.temporary(name))
    loaded = simple.FindSource("closest")
    for key, value in SETTINGS.items():
        assert getattr(loaded, key) == value, key
    skdtesting.assert_same(skdtesting.point_array(loaded, "SkdDistance"), before)
    simple.ResetSession()


def test_state_as_xml():
    round_trip("closest.pvsm")


def test_state_as_python():
    round_trip("closest_state.py")


def test_remapping_and_adaptation():
    earth_round_trip("earth.pvsm")
    earth_round_trip("earth_state.py")


skdtesting.run_tests(globals())
