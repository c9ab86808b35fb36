# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is under the mouse: vtkCellPicker with an skD-tree, and without.

A picker looks at all cells of a mesh, unless it is given a locator for it. Then the same cell is
found at once, however many cells there are.

Run by pvpython or by Python, with the package vtkskdtree at hand:
    pvpython Picking.py
"""

import time

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, so that there are windows
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkCellPicker, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow)
from vtkskdtree import vtkSkdTreeCellLocator

source = vtkSphereSource()
source.SetThetaResolution(720)
source.SetPhiResolution(720)
source.Update()
mesh = source.GetOutput()

mapper = vtkPolyDataMapper()
mapper.SetInputData(mesh)
actor = vtkActor()
actor.SetMapper(mapper)
renderer = vtkRenderer()
renderer.AddActor(actor)
window = vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetSize(600, 400)
window.AddRenderer(renderer)
window.Render()

locator = vtkSkdTreeCellLocator()
locator.SetDataSet(mesh)
locator.BuildLocator()


def pick(locators):
    picker = vtkCellPicker()
    picker.SetTolerance(0)
    for one in locators:
        picker.AddLocator(one)
    start = time.perf_counter()
    picker.Pick(330, 180, 0, renderer)
    return picker.GetCellId(), picker.GetPickPosition(), time.perf_counter() - start


pick([locator])
cell, position, with_locator = pick([locator])
plain_cell, plain_position, without = pick([])
print("of %d cells the one under the mouse is %d, at %.3f %.3f %.3f"
    % (mesh.GetNumberOfCells(), cell, *position))
print("found in %.6f s with the locator, %.0f times as fast as without"
    % (with_locator, without / with_locator))
print("the same without" if plain_cell == cell else "without it is %d" % plain_cell)
