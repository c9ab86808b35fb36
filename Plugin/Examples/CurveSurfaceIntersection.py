# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where a neuron enters a region of the brain, and how much of it lies within.

The neuron is a tree of polylines, the region a closed surface. The filter gives each point where a
branch goes in or out, and the branches cut there, each piece with the number of regions that hold
it.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython CurveSurfaceIntersection.py Data/fly_brain_neuron.vtp Data/fly_brain_lateral_horn.vtp \\
        picture.png
"""

import os
import sys

from paraview import servermanager, simple

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")
neuron_file, region_file, picture_file = sys.argv[1:4] or (
    os.path.join(DATA, "fly_brain_neuron.vtp"), os.path.join(DATA, "fly_brain_lateral_horn.vtp"), "CurveSurfaceIntersection.png")

neuron = simple.OpenDataFile(neuron_file)
region = simple.OpenDataFile(region_file)
crossing = simple.SkdTreeCurveSurfaceIntersection(Input=neuron, Source=region, CutCurves=1)
crossing.UpdatePipeline()

senses = servermanager.Fetch(crossing).GetPointData().GetArray("SkdSense")
values = [senses.GetValue(i) for i in range(senses.GetNumberOfTuples())]
print("goes in %d times, out %d times" % (values.count(1), values.count(-1)))

lengths = simple.IntegrateVariables(Input=simple.Threshold(
    Input=simple.OutputPort(crossing, 1), Scalars=["CELLS", "SkdPartsInside"],
    LowerThreshold=1, UpperThreshold=9))
lengths.UpdatePipeline()
print("length within: %.0f" % lengths.CellData["Length"].GetRange()[0])

view = simple.CreateRenderView(ViewSize=[900, 700], OrientationAxesVisibility=0,
    UseColorPaletteForBackground=0, Background=[1, 1, 1])
surface = simple.Show(region, view, Representation="Surface", Opacity=0.25)
surface.ColorArrayName = ["POINTS", ""]
surface.DiffuseColor = surface.AmbientColor = [0.2, 0.45, 0.7]

pieces = simple.Show(simple.OutputPort(crossing, 1), view, Representation="Surface", LineWidth=2.5)
simple.ColorBy(pieces, ("CELLS", "SkdPartsInside"))
inside = simple.GetColorTransferFunction("SkdPartsInside")
inside.RGBPoints = [0, 0.55, 0.55, 0.55, 1, 0.88, 0.4, 0.17]
pieces.SetScalarBarVisibility(view, False)

points = simple.Show(simple.Glyph(Input=simple.OutputPort(crossing, 0), GlyphType="Sphere",
    OrientationArray=["POINTS", "No orientation array"], ScaleArray=["POINTS", "No scale array"],
    ScaleFactor=600, GlyphMode="All Points"), view)
points.ColorArrayName = ["POINTS", ""]
points.DiffuseColor = points.AmbientColor = [0.1, 0.1, 0.1]

simple.Render(view)
view.CameraPosition, view.CameraViewUp = [0, -1e5, 3e4], [0, 0, 1]
simple.ResetCamera(view)
simple.GetActiveCamera().Dolly(1.5)
simple.SaveScreenshot(picture_file, view)
