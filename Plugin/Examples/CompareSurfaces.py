# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""How far a coarse copy of a scanned surface is from the original, at most and on average.

The copy has a tenth of the triangles. Its vertices are some of the original's, so that their
distance is 0 and says nothing. The original is coloured by its distance from the copy, whose edges
are drawn; the red line is the pair of points where the Hausdorff distance is attained.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython CompareSurfaces.py Data/fly_brain_lateral_horn.vtp picture.png
"""

import os
import sys

from paraview import servermanager, simple

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")
data_file, picture_file = sys.argv[1:3] or (
    os.path.join(DATA, "fly_brain_lateral_horn.vtp"), "CompareSurfaces.png")

surface = simple.OpenDataFile(data_file)
coarse = simple.Decimate(Input=surface, TargetReduction=0.9)
compared = simple.SkdTreeCompareSurfaces(Input=coarse, Source=surface)
table = servermanager.Fetch(compared, idx=2)

columns = ("HausdorffDistance", "HausdorffUpperBound", "Mean", "RootMeanSquare", "Quantile99")
print("%-16s" % "" + "".join("%21s" % name for name in columns))
for row in range(table.GetNumberOfRows()):
    values = [table.GetValueByName(row, name).ToDouble() for name in columns]
    print("%-16s" % table.GetValueByName(row, "Direction").ToString() + "".join("%21.3f" % x for x in values))
at_vertices = compared.PointData["SkdDistance"].GetRange()[1]
print("largest distance of vertices of the copy: %.3f" % at_vertices)

view = simple.CreateRenderView(ViewSize=[900, 700], OrientationAxesVisibility=0,
    UseColorPaletteForBackground=0, Background=[1, 1, 1])
original = simple.OutputPort(compared, 1)
display = simple.Show(original, view, Opacity=0.8)
simple.ColorBy(display, ("POINTS", "SkdDistance"))
colours = simple.GetColorTransferFunction("SkdDistance")
# ParaView 6 calls it Viridis, earlier ones Viridis (matplotlib).
preset = next(name for name in simple.GetLookupTableNames() if name.startswith("Viridis"))
colours.ApplyPreset(preset, True)
colours.RescaleTransferFunction(0, original.PointData["SkdDistance"].GetRange()[1])
display.SetScalarBarVisibility(view, True)
bar = simple.GetScalarBar(colours, view)
bar.Title, bar.ComponentTitle = "distance", ""
bar.TitleColor = bar.LabelColor = [0, 0, 0]

simple.Show(coarse, view, Representation="Wireframe", ColorArrayName=[None, ""], AmbientColor=[0.2] * 3, DiffuseColor=[0.2] * 3)

ends = [table.GetColumnByName(name).GetTuple3(2) for name in ("From", "To")]
low, high = surface.GetDataInformation().GetBounds()[0:2]
radius = 0.008 * (high - low)
line = simple.Line(Point1=ends[0], Point2=ends[1])
for shape in (simple.Tube(Input=line, Radius=radius),
        simple.Sphere(Center=ends[0], Radius=2 * radius),
        simple.Sphere(Center=ends[1], Radius=2 * radius)):
    simple.Show(shape, view, ColorArrayName=[None, ""], DiffuseColor=[0.85, 0.1, 0.1])

middle = [sum(surface.GetDataInformation().GetBounds()[2 * i:2 * i + 2]) / 2 for i in range(3)]
view.CameraFocalPoint = middle
out = [from_ - centre for from_, centre in zip(ends[0], middle)]
length = sum(x * x for x in out)**0.5
view.CameraPosition = [centre + 10 * x / length for centre, x in zip(middle, out)]
simple.ResetCamera(view)
view.CameraParallelProjection = 1
view.CameraParallelScale *= 0.7
simple.SaveScreenshot(picture_file, view)
