# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two surfaces cut along the curves in which they meet: what is inside of the other is a region.

A pipe goes through a ball. Both come back as triangles that fit together along the curves, each with
the number of its region: the ball without the caps that the pipe covers, the pipe without one end.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython SplitSurfaces.py picture.png
"""

import sys

from paraview import servermanager, simple

picture_file = sys.argv[1] if sys.argv[1:] else "SplitSurfaces.png"

ball = simple.Sphere(Radius=1, ThetaResolution=48, PhiResolution=32)
pipe = simple.Transform(Input=simple.Cylinder(Radius=0.45, Height=4, Resolution=40, Capping=0))
pipe.Transform.Rotate = [25, 0, 35]
intersection = simple.SkdTreeSurfaceIntersection(Input=ball, Source=pipe, SplitSurfaces=1)
intersection.UpdatePipeline()

for port, name in ((4, "ball"), (5, "pipe")):
    split = servermanager.Fetch(intersection, idx=port)
    regions = split.GetCellData().GetArray("SkdRegionId").GetRange()[1] + 1
    print("%s: %d triangles in %d regions" % (name, split.GetNumberOfCells(), regions))

view = simple.CreateRenderView(ViewSize=[900, 700], OrientationAxesVisibility=0,
    UseColorPaletteForBackground=0, Background=[1, 1, 1])


def show(proxy, colors):
    display = simple.Show(proxy, view, Representation="Surface With Edges")
    simple.ColorBy(display, ("CELLS", "SkdRegionId"), separate=True)
    display.RescaleTransferFunctionToDataRange(False)
    table = simple.GetColorTransferFunction("SkdRegionId", display, separate=True)
    table.RGBPoints = colors
    display.EdgeColor = [0.35, 0.35, 0.35]
    display.Ambient, display.Diffuse = 0.3, 0.8
    display.SetScalarBarVisibility(view, False)



def regions(port, first, last):
    """Of one of the surfaces the regions from one number to another."""
    threshold = simple.Threshold(Input=simple.OutputPort(intersection, port))
    threshold.Scalars = ["CELLS", "SkdRegionId"]
    threshold.LowerThreshold, threshold.UpperThreshold = first, last
    return threshold


show(regions(4, 0, 0), [0, 0.62, 0.74, 0.86, 2, 0.62, 0.74, 0.86])
show(regions(5, 1, 2), [1, 0.8, 0.35, 0.3, 2, 0.95, 0.75, 0.45])

simple.Render(view)
view.CameraPosition, view.CameraViewUp = [1, -4.5, -4], [0, 1, 0]
simple.ResetCamera(view)
simple.GetActiveCamera().Zoom(1.4)
simple.SaveScreenshot(picture_file, view)
