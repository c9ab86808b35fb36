# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""How thick a scanned body is, measured in three ways.

From top to bottom: how far the inverted normal goes within the body, the median of a cone of rays,
and the diameter of the largest inscribed sphere that touches the surface at the point.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython WallThickness.py Data/fly_brain_neuropil.vtp picture.png
"""

import os
import sys

from paraview import simple

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")
data_file, picture_file = sys.argv[1:3] or (
    os.path.join(DATA, "fly_brain_neuropil.vtp"), "WallThickness.png")

surface = simple.OpenDataFile(data_file)
surface.UpdatePipeline()
x0, x1, y0, y1, z0, z1 = surface.GetDataInformation().GetBounds()
ways = (("one ray", {}), ("cone of rays", dict(NumberOfRays=30)), ("spheres", dict(Method="Spheres")))

view = simple.CreateRenderView(ViewSize=[640, 520], OrientationAxesVisibility=0,
    UseColorPaletteForBackground=0, Background=[1, 1, 1])
colours = simple.GetColorTransferFunction("SkdThickness")
# ParaView 6 calls it Viridis, earlier ones Viridis (matplotlib).
preset = next(name for name in simple.GetLookupTableNames() if name.startswith("Viridis"))
colours.ApplyPreset(preset, True)
for place, (name, properties) in enumerate(ways):
    thickness = simple.SkdTreeWallThickness(Input=surface, **properties)
    thickness.UpdatePipeline()
    found = thickness.FieldData["SkdReportPointsFound"].GetRange()[0]
    low, high = thickness.PointData["SkdThickness"].GetRange()
    print("%-13s %d points, thickness from %.1f to %.1f" % (name, found, low, high))
    placed = simple.Transform(Input=thickness, Transform="Transform")
    placed.Transform.Translate = [0, -1.1 * place * (y1 - y0), 0]
    display = simple.Show(placed, view)
    simple.ColorBy(display, ("POINTS", "SkdThickness"))
colours.RescaleTransferFunction(0, 0.6 * (y1 - y0))
display.SetScalarBarVisibility(view, True)
bar = simple.GetScalarBar(colours, view)
bar.Title, bar.ComponentTitle = "thickness", ""
bar.TitleColor = bar.LabelColor = [0, 0, 0]

view.CameraPosition, view.CameraFocalPoint = [0.1, 0.2, 1], [0, 0, 0]
view.CameraViewUp = [0, 1, 0]
simple.ResetCamera(view)
simple.SaveScreenshot(picture_file, view)
