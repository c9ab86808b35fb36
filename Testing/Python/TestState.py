# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""A pipeline with the plugin's filter, saved as a state and loaded again."""

from paraview import simple

import skdtesting

SETTINGS = dict(
    SignedDistance=1, InterpolateSourceData=1, GenerateLines=1, MaximumDistance=4.5, Epsilon=1e-7)


def make_pipeline():
    points = simple.Wavelet(registrationName="points", WholeExtent=[-5, 5, -5, 5, -5, 5])
    source = simple.Sphere(registrationName="source", Radius=3)
    return simple.SkdTreeClosestPoint(
        registrationName="closest", Input=points, Source=source, **SETTINGS)


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


skdtesting.run_tests(globals())
