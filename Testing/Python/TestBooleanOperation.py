# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Boolean operations by ParaView's simple API."""

import os

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkPolyDataNormals
from vtkmodules.vtkFiltersModeling import vtkFillHolesFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkskdtree.vtkFiltersSkdTree import vtkSkdTreeBooleanOperation

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


def test_a_split_by_a_plane_has_both_parts_and_the_section():
    plane = simple.Plane(Origin=[-1, -1, 0.25], Point1=[1, -1, 0.25], Point2=[-1, 1, 0.25])
    split = simple.SkdTreeBooleanOperation(Input=simple.Box(), Source=plane, Operation="Split")
    split.UpdatePipeline()
    numpy.testing.assert_allclose(split.FieldData["SkdReportPartVolumes"].GetRange(), (0.25, 0.75), rtol=1e-14)
    assert split.CellData["SkdPartId"].GetRange() == (0, 1)
    surface = simple.servermanager.Fetch(split)
    parts = vtk_to_numpy(surface.GetCellData().GetArray("SkdPartId"))
    for part, heights in ((0, (0.25, 0.5)), (1, (-0.5, 0.25))):
        bounds = numpy.array([surface.GetCell(i).GetBounds() for i in numpy.flatnonzero(parts == part)])
        assert (bounds[:, 4].min(), bounds[:, 5].max()) == heights
    section = simple.servermanager.Fetch(split, idx=1)
    assert section.GetNumberOfCells() == 1 and section.GetCell(0).GetNumberOfPoints() == 4
    numpy.testing.assert_array_equal(section.GetBounds(), (-0.5, 0.5, -0.5, 0.5, 0.25, 0.25))


def test_a_plane_cuts_without_a_source():
    cut = simple.SkdTreeBooleanOperation(Input=simple.Box(), CutByPlane=1, PlaneNormal=[0, 0, 1])
    assert list(cut.PlaneOrigin) == [0, 0, 0]  # the middle of the input
    cut.PlaneOrigin = [0, 0, 0.1]
    for operation, volume in (("Split", 1.0), ("Difference", 0.4), ("Intersection", 0.6)):
        cut.Operation = operation
        cut.UpdatePipeline()
        numpy.testing.assert_allclose(cut.FieldData["SkdReportVolume"].GetRange()[0], volume, rtol=1e-14)
        section = simple.servermanager.Fetch(cut, idx=1)
        assert section.GetNumberOfCells() == 1 and section.GetCell(0).GetNumberOfPoints() == 4
        numpy.testing.assert_array_equal(section.GetBounds(), (-0.5, 0.5, -0.5, 0.5, 0.1, 0.1))
    box = simple.Box(Center=[3, 4, 5])
    box.UpdatePipeline()
    away = simple.SkdTreeBooleanOperation(Input=box, CutByPlane=1, Operation="Split")
    assert list(away.PlaneOrigin) == [3, 4, 5]
    away.UpdatePipeline()
    numpy.testing.assert_allclose(away.FieldData["SkdReportPartVolumes"].GetRange(), (0.5, 0.5), rtol=1e-14)


def output_of(filter_, data, **properties):
    filter_.SetInputData(data)
    for name, value in properties.items():
        getattr(filter_, "Set" + name)(value)
    filter_.Update()
    return filter_.GetOutput()


def count_open_edges(surface):
    return output_of(vtkFeatureEdges(), surface, FeatureEdges=0, NonManifoldEdges=0).GetNumberOfCells()


def as_the_error_says(surface):
    """The holes of a surface filled again and again, and then its faces oriented."""
    size = 10 * surface.GetLength()
    while count_open_edges(surface) > 0:
        surface = output_of(vtkFillHolesFilter(), surface, HoleSize=size)
    return output_of(vtkPolyDataNormals(), surface, Consistency=1)


def test_what_the_error_about_open_scans_says_closes_them():
    scan = os.path.join(os.environ["SKDTREE_EXTRA_DATA_DIR"], "A_surface", "bunny.stl")
    if not os.path.exists(scan):
        return
    reader = vtkSTLReader()
    reader.SetFileName(scan)
    reader.Update()
    bunny = reader.GetOutput()
    assert count_open_edges(bunny) > 0
    closed = as_the_error_says(bunny)
    ball = vtkSphereSource()
    ball.SetCenter(closed.GetCenter())
    ball.SetRadius(closed.GetLength() / 8)
    ball.Update()
    combined = vtkSkdTreeBooleanOperation()
    combined.SetSourceData(ball.GetOutput())
    report = output_of(combined, closed, Operation=2).GetFieldData()
    value = lambda name: report.GetArray("SkdReport" + name).GetValue(0)
    assert value("BadEdges") == 0
    assert 0 < value("Volume") < value("InputVolume")


skdtesting.run_tests(globals())
