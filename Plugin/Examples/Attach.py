# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's own Stream Tracer on the skD-tree, and the tree's boxes.

The same streamlines of a flow twice: without and with a skD-tree attached to the mesh. Drawn are the
lines, and the boxes of one level of the tree.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython Attach.py Data/disk_flow.vtu picture.png
"""

import sys
import time

from paraview import simple

data_file, picture_file = sys.argv[1:3]


def trace(source):
    source.UpdatePipeline()
    tracer = simple.StreamTracer(Input=source, Vectors=["POINTS", "V"], SeedType="Line",
        InterpolatorType="Interpolator with Cell Locator", MaximumStreamlineLength=40)
    tracer.SeedType.Point1, tracer.SeedType.Point2 = [-5, -2, 0.5], [5, 2, 9]
    tracer.SeedType.Resolution = 60
    start = time.perf_counter()
    tracer.UpdatePipeline()
    points = tracer.GetDataInformation().GetNumberOfPoints()
    return tracer, points, time.perf_counter() - start


flow = simple.OpenDataFile(data_file)
attached = simple.SkdTreeAttach(Input=flow)
_, points, seconds = trace(flow)
print("without: %6d points in %.2f s" % (points, seconds))
lines, points, seconds = trace(attached)
print("with:    %6d points in %.2f s" % (points, seconds))

boxes = simple.SkdTreeRepresentation(Input=flow, Level=6)
view = simple.CreateRenderView(ViewSize=[900, 700], OrientationAxesVisibility=0,
    UseColorPaletteForBackground=0, Background=[1, 1, 1])
shown = simple.Show(boxes, view, Representation="Wireframe")
shown.ColorArrayName = [None, ""]
shown.AmbientColor = shown.DiffuseColor = [0.55, 0.6, 0.7]
shown.Opacity = 0.5
tubes = simple.Show(simple.Tube(Input=lines, Radius=0.06), view)
simple.ColorBy(tubes, ("POINTS", "Temp"))
colours = simple.GetColorTransferFunction("Temp")
colours.ApplyPreset("Inferno (matplotlib)", True)
tubes.SetScalarBarVisibility(view, True)
bar = simple.GetScalarBar(colours, view)
bar.TitleColor = bar.LabelColor = [0, 0, 0]
view.CameraPosition, view.CameraViewUp = [14, -40, 14], [0, 0, 1]
simple.ResetCamera(view)
simple.SaveScreenshot(picture_file, view)
