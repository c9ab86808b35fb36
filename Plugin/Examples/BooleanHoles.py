# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""A plate with a hundred holes: one operation, whose source is a hundred cylinders.

Flat faces are triangulated anew, without points that only pieces of them needed.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython BooleanHoles.py picture.png
"""

import sys

from paraview import simple

picture_file = sys.argv[1] if sys.argv[1:] else "BooleanHoles.png"

plate = simple.Box(XLength=10, YLength=0.5, ZLength=10)
places = simple.Plane(Origin=[-4.5, 0, -4.5], Point1=[4.5, 0, -4.5], Point2=[-4.5, 0, 4.5],
    XResolution=9, YResolution=9)
rods = simple.Glyph(Input=places, GlyphType="Cylinder", GlyphMode="All Points")
rods.OrientationArray, rods.ScaleArray = ["POINTS", "No orientation array"], ["POINTS", "No scale array"]
rods.ScaleFactor = 1  # set last, because the choice of arrays changes it
rods.GlyphType.Resolution, rods.GlyphType.Radius, rods.GlyphType.Height = 24, 0.3, 2

rest = simple.SkdTreeBooleanOperation(Input=plate, Source=rods, Operation="Difference")
rest.UpdatePipeline()
report = rest.FieldData
print("%d cells, volume %.6f, %d open edges" % (rest.GetDataInformation().GetNumberOfCells(),
    report["SkdReportVolume"].GetRange()[0], report["SkdReportBadEdges"].GetRange()[0]))

view = simple.CreateRenderView(ViewSize=[900, 520], OrientationAxesVisibility=0,
    UseColorPaletteForBackground=0, Background=[1, 1, 1])
display = simple.Show(rest, view, Representation="Surface")
simple.ColorBy(display, ("CELLS", "SkdInputId"), separate=True)
table = simple.GetColorTransferFunction("SkdInputId", display, separate=True)
table.RGBPoints = [0, 0.62, 0.74, 0.86, 1, 0.95, 0.75, 0.45]
display.SetScalarBarVisibility(view, False)
display.Ambient, display.Diffuse = 0.3, 0.8

simple.Render(view)
view.CameraPosition, view.CameraViewUp = [5, 8, 9], [0, 1, 0]
simple.ResetCamera(view)
simple.GetActiveCamera().Zoom(1.3)
simple.SaveScreenshot(picture_file, view)
