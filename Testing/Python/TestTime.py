# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""A Source in three files, one a time step, and an Input that does not change: the answers follow the
time of UpdatePipeline, of a view, and of the window's animation."""

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import skdtesting

CENTERS = (0.0, 2.0, 5.0)


def series():
    """A sphere of radius 1 that moves along x."""
    names = []
    for i, x in enumerate(CENTERS):
        sphere = vtkSphereSource()
        sphere.SetCenter(x, 0, 0)
        sphere.SetRadius(1)
        sphere.SetThetaResolution(60)
        sphere.SetPhiResolution(60)
        writer = vtkXMLPolyDataWriter()
        names.append(skdtesting.temporary(f"moving{i}.vtp"))
        writer.SetFileName(names[-1])
        writer.SetDataModeToBinary() # VTK 9.2 cannot read appended data with today's expat
        writer.SetInputConnection(sphere.GetOutputPort())
        writer.Write()
    return simple.XMLPolyDataReader(FileName=names)


def distances():
    line = simple.Line(Point1=[-3, 0, 3], Point2=[8, 0, 3], Resolution=22)
    return simple.SkdTreeClosestPoint(Input=line, Source=series())


def expected(step):
    """Along the line, of a sphere that is not faceted."""
    x = numpy.linspace(-3, 8, 23)
    return numpy.sqrt((x - CENTERS[step])**2 + 9.0) - 1.0


def found(closest):
    data = servermanager.Fetch(closest)
    return vtk_to_numpy(data.GetPointData().GetArray("SkdDistance"))


def check(closest, step):
    numpy.testing.assert_allclose(found(closest), expected(step), atol=0.01)


def test_times_are_those_of_the_source():
    closest = distances()
    closest.UpdatePipelineInformation()
    information = closest.GetClientSideObject().GetOutputInformation(0)
    steps = vtkStreamingDemandDrivenPipeline.TIME_STEPS()
    assert [steps.Get(information, i) for i in range(steps.Length(information))] == [0, 1, 2]


def test_update_at_a_time():
    closest = distances()
    for step in (0, 2, 1, 0):
        closest.UpdatePipeline(step)
        check(closest, step)


def test_view_and_animation():
    closest = distances()
    view = simple.CreateRenderView()
    simple.Show(closest, view)
    scene = simple.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    for step in (1, 2, 0):
        view.ViewTime = step
        simple.Render(view)
        check(closest, step)
    scene.GoToFirst()
    for step in (0, 1, 2):
        simple.Render(view)
        check(closest, step)
        scene.GoToNext()


skdtesting.run_tests(globals())
