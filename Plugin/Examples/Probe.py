# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""A flow sampled on a sheet, and along lines from cell to cell.

The flow is a mesh of hexahedra. The sheet's points take the temperature where they are in the mesh;
points outside have none. The lines are cut exactly where they pass from one cell to the next, at the
green points. The temperature's mean along each is its integral by its length.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython Probe.py Data/disk_flow.vtu picture.png
"""

import os
import sys

from paraview import servermanager, simple

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")
data_file, picture_file = sys.argv[1:3] or (os.path.join(DATA, "disk_flow.vtu"), "Probe.png")

flow = simple.OpenDataFile(data_file)
sheet = simple.Plane(
    Origin=[-6, 0, -11], Point1=[6, 0, -11], Point2=[-6, 0, 11], XResolution=240, YResolution=440)
on_sheet = simple.SkdTreeProbe(Input=sheet, Source=flow)
inside = simple.Threshold(
    Input=on_sheet, Scalars=["POINTS", "SkdValid"], LowerThreshold=1, UpperThreshold=1)

lines = simple.GroupDatasets(Input=[
    simple.Line(Point1=[-6.5, -2.0, z], Point2=[6.5, -3.5, z + 2], Resolution=1)
    for z in (-7.0, -1.0, 5.0)])
along = simple.SkdTreeProbe(Input=lines, Source=flow, ProbeLines=1)
along.UpdatePipeline()

integrals = servermanager.Fetch(along, idx=2)
for row in range(integrals.GetNumberOfRows()):
    length = integrals.GetColumnByName("SkdLength").GetValue(row)
    total = integrals.GetColumnByName("Temp_Integral").GetValue(row)
    print("line %d: %6.3f within the flow, mean temperature %8.3f" % (row, length, total / length))
print("intervals: %d" % along[1].GetDataInformation().GetNumberOfCells())

view = simple.CreateRenderView(ViewSize=[900, 700], OrientationAxesVisibility=0,
    UseColorPaletteForBackground=0, Background=[1, 1, 1])
colours = simple.GetColorTransferFunction("Temp")
# ParaView 6 calls it Inferno, earlier ones Inferno (matplotlib).
preset = next(name for name in simple.GetLookupTableNames() if name.startswith("Inferno"))
colours.ApplyPreset(preset, True)


def show(proxy, **properties):
    display = simple.Show(proxy, view, Representation="Surface")
    simple.ColorBy(display, ("POINTS", "Temp"))
    for name, value in properties.items():
        setattr(display, name, value)
    return display


outline = simple.Show(flow, view, Representation="Outline")
outline.AmbientColor = outline.DiffuseColor = [0.4, 0.4, 0.4]
show(inside).SetScalarBarVisibility(view, True)
intervals = simple.OutputPort(along, 1)
show(simple.Tube(Input=intervals, Radius=0.05))
balls = simple.Glyph(Input=intervals, GlyphType="Sphere", GlyphMode="All Points",
    ScaleArray=["POINTS", "No scale array"], ScaleFactor=0.22)
ends = simple.Show(balls, view)
ends.ColorArrayName = [None, ""]
ends.AmbientColor = ends.DiffuseColor = [0.1, 0.7, 0.3]
colours.RescaleTransferFunction(*on_sheet.PointData["Temp"].GetRange())
bar = simple.GetScalarBar(colours, view)
bar.TitleColor = bar.LabelColor = [0, 0, 0]

view.CameraPosition, view.CameraViewUp = [12, -40, 10], [0, 0, 1]
simple.ResetCamera(view)
view.CameraParallelScale, view.CameraParallelProjection = 12, 1
simple.SaveScreenshot(picture_file, view)
