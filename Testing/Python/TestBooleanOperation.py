# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Boolean operations by ParaView's simple API."""

import numpy
from paraview import simple

import skdtesting


def volume(**properties):
    combined = simple.SkdTreeBooleanOperation(**properties)
    combined.UpdatePipeline()
    report = combined.FieldData
    assert report["SkdReportBadEdges"].GetRange() == (0, 0)
    return report["SkdReportVolume"].GetRange()[0]


def test_boxes_with_coplanar_sides():
    boxes = dict(Input=simple.Box(), Source=simple.Box(Center=[0.5, 0, 0]))
    volumes = {"Union": 1.5, "Intersection": 0.5, "Difference": 0.5, "Reverse Difference": 0.5,
        "Symmetric Difference": 1}
    for operation, expected in volumes.items():
        numpy.testing.assert_allclose(volume(Operation=operation, **boxes), expected, rtol=1e-14)


def test_an_operation_on_the_output_of_another():
    two = simple.SkdTreeBooleanOperation(Input=simple.Box(), Source=simple.Box(Center=[1, 0, 0]))
    third = simple.Box(Center=[1.5, 0, 0], YLength=2)
    numpy.testing.assert_allclose(volume(Input=two, Source=third), 3.5, rtol=1e-14)


skdtesting.run_tests(globals())
