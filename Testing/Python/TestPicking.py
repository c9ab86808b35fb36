# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""A locator in vtkCellPicker: the same picks as without."""

import numpy
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, so that there are windows
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkCellPicker, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow)
from vtkskdtree import vtkSkdTreeCellLocator

import skdtesting


def scene(mesh):
    """A renderer that shows the mesh askew, and the actor."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetPosition(3, -2, 1)
    actor.SetOrientation(20, 35, -50)
    actor.SetScale(1.5)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(300, 300)
    window.AddRenderer(renderer)
    renderer.ResetCamera()
    window.Render()
    return window, renderer


def picker(mesh, with_locator):
    made = vtkCellPicker()
    made.SetTolerance(0)
    if with_locator:
        locator = vtkSkdTreeCellLocator()
        locator.SetDataSet(mesh)
        locator.BuildLocator()
        made.AddLocator(locator)
    return made


def picks(picker, renderer, pixels):
    found = []
    for x, y in pixels:
        picker.Pick(x, y, 0, renderer)
        found.append((picker.GetCellId(), *picker.GetPickPosition(), *picker.GetPickNormal()))
    return numpy.array(found)


def assert_same_picks(mesh, pixels):
    window, renderer = scene(mesh)
    plain = picks(picker(mesh, False), renderer, pixels)
    ours = picks(picker(mesh, True), renderer, pixels)
    hit = plain[:, 0] >= 0
    assert hit.sum() > len(pixels) // 5, hit.sum()
    numpy.testing.assert_array_equal(ours[:, 0], plain[:, 0])
    numpy.testing.assert_allclose(ours[hit, 1:], plain[hit, 1:], rtol=0, atol=1e-9 * mesh.GetLength())
    window.Finalize()


def test_picks_on_a_surface_are_the_same():
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(skdtesting.DATA_DIR + "/fly_brain_lateral_horn.vtp")
    reader.Update()
    random = numpy.random.default_rng(1)
    assert_same_picks(reader.GetOutput(), random.uniform(80, 220, (400, 2)))


def test_picks_in_a_million_cells_are_the_same():
    mesh = skdtesting.sphere_mesh(720)
    assert mesh.GetNumberOfCells() > 1000000
    pixels = numpy.random.default_rng(2).uniform(90, 210, (2, 2))
    assert_same_picks(mesh, pixels)


skdtesting.run_tests(globals())
