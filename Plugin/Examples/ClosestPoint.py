# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each point of a sheet takes the pressure at the nearest place in a flow.

The flow is a volume mesh with data; the sheet runs past it on one side. The filter gives each point
of the sheet its nearest point in the mesh, the distance to it and the mesh's data there, and the
lines between the two.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython ClosestPoint.py Data/disk_flow.vtu picture.png
"""

import os
import sys

from paraview import simple

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")
data_file, picture_file = sys.argv[1:3] or (os.path.join(DATA, "disk_flow.vtu"), "ClosestPoint.png")

flow = simple.OpenDataFile(data_file)
sheet = simple.Plane(Origin=[9, -9, -12], Point1=[9, 9, -12], Point2=[9, -9, 12],
    XResolution=24, YResolution=32)
closest = simple.SkdTreeClosestPoint(
    Input=sheet, Source=flow, InterpolateSourceData=True, GenerateLines=True)
closest.UpdatePipeline()

for name in ("SkdDistance", "Pres"):
    print("%-12s from %8.3f to %8.3f" % (name, *closest.PointData[name].GetRange()))

view = simple.CreateRenderView(ViewSize=[900, 700], OrientationAxesVisibility=0,
    UseColorPaletteForBackground=0, Background=[1, 1, 1])
colours = simple.GetColorTransferFunction("Pres")
# ParaView 6 calls it Viridis, earlier ones Viridis (matplotlib).
preset = next(name for name in simple.GetLookupTableNames() if name.startswith("Viridis"))
colours.ApplyPreset(preset, True)


def show(proxy, port, representation, **properties):
    display = simple.Show(simple.OutputPort(proxy, port), view, Representation=representation)
    simple.ColorBy(display, ("CELLS" if port else "POINTS", "Pres"))
    for name, value in properties.items():
        setattr(display, name, value)
    return display


show(flow, 0, "Surface With Edges", EdgeColor=[0.6, 0.6, 0.6])
show(closest, 0, "Points", PointSize=9, RenderPointsAsSpheres=1)
lines = show(closest, 1, "Surface", Opacity=0.5)
lines.SetScalarBarVisibility(view, True)
colours.RescaleTransferFunction(*closest.PointData["Pres"].GetRange())
bar = simple.GetScalarBar(colours, view)
bar.TitleColor = bar.LabelColor = [0, 0, 0]

view.CameraPosition, view.CameraViewUp = [25, -45, 12], [0, 0, 1]
simple.ResetCamera(view)
simple.SaveScreenshot(picture_file, view)
