# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Solids combined: a ball and a box intersected, less three cylinders along the axes.

Four operations, one behind the other, each on the output of the one before.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython BooleanOperation.py picture.png
"""

import sys

from paraview import simple

picture_file = sys.argv[1] if sys.argv[1:] else "BooleanOperation.png"


def combine(first, second, operation):
    result = simple.SkdTreeBooleanOperation(Input=first, Source=second, Operation=operation)
    result.UpdatePipeline()
    report = result.FieldData
    print("%s: volume %.6f, %d open edges" % (operation,
        report["SkdReportVolume"].GetRange()[0], report["SkdReportBadEdges"].GetRange()[0]))
    return result


ball = simple.Sphere(Radius=1.3, ThetaResolution=64, PhiResolution=48)
box = simple.Box(XLength=2, YLength=2, ZLength=2)
body = combine(ball, box, "Intersection")
for turn in ([0, 0, 0], [90, 0, 0], [0, 0, 90]):
    rod = simple.Transform(Input=simple.Cylinder(Radius=0.5, Height=4, Resolution=48))
    rod.Transform.Rotate = turn
    body = combine(body, rod, "Difference")

view = simple.CreateRenderView(ViewSize=[900, 700], OrientationAxesVisibility=0,
    UseColorPaletteForBackground=0, Background=[1, 1, 1])
display = simple.Show(body, view, Representation="Surface")
simple.ColorBy(display, ("CELLS", "SkdInputId"), separate=True)
table = simple.GetColorTransferFunction("SkdInputId", display, separate=True)
table.RGBPoints = [0, 0.62, 0.74, 0.86, 1, 0.95, 0.75, 0.45]
display.SetScalarBarVisibility(view, False)
display.Ambient, display.Diffuse = 0.3, 0.8

simple.Render(view)
view.CameraPosition, view.CameraViewUp = [3, 2.4, 4], [0, 1, 0]
simple.ResetCamera(view)
simple.GetActiveCamera().Zoom(1.15)
simple.SaveScreenshot(picture_file, view)
