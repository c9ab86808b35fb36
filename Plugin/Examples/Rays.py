# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The height of a sheet above a scanned surface, and how often the surface folds below it.

From each point of the sheet a ray goes down through the whole surface. The lines go to the first
hits, coloured by their length; points whose rays miss the surface are grey.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython Rays.py Data/fly_brain_neuropil.vtp picture.png
"""

import os
import sys

from paraview import simple

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")
data_file, picture_file = sys.argv[1:3] or (
    os.path.join(DATA, "fly_brain_neuropil.vtp"), "Rays.png")

surface = simple.OpenDataFile(data_file)
surface.UpdatePipeline()
x0, x1, y0, y1, z0, z1 = surface.GetDataInformation().GetBounds()
top = y1 + 0.15 * (y1 - y0)
sheet = simple.Plane(Origin=[x0, top, z0], Point1=[x1, top, z0], Point2=[x0, top, z1],
    XResolution=40, YResolution=14)
down = dict(Input=sheet, Source=surface, Along="Direction", Direction=[0, -1, 0])
folds = simple.SkdTreeRays(Hits="Counts", **down)
rays = simple.SkdTreeRays(GenerateLines=True, **down)
folds.UpdatePipeline()
rays.UpdatePipeline()

number, hit = (int(rays.FieldData["SkdReport" + name].GetRange()[0])
    for name in ("Rays", "RaysWithHits"))
print("%d of %d rays hit the surface" % (hit, number))
print("heights from %.3f to %.3f" % rays.PointData["SkdRayDistance"].GetRange())
print("at most %d hits of one ray" % folds.PointData["SkdRayHits"].GetRange()[1])

view = simple.CreateRenderView(ViewSize=[720, 560], OrientationAxesVisibility=0,
    UseColorPaletteForBackground=0, Background=[1, 1, 1])
simple.Show(surface, view, ColorArrayName=[None, ""], DiffuseColor=[0.75, 0.75, 0.8])
colours = simple.GetColorTransferFunction("SkdRayDistance")
# ParaView 6 calls it Viridis, earlier ones Viridis (matplotlib).
preset = next(name for name in simple.GetLookupTableNames() if name.startswith("Viridis"))
colours.ApplyPreset(preset, True)
colours.NanColor = [0.6, 0.6, 0.6]
points = simple.Show(rays, view, Representation="Points", PointSize=5)
simple.ColorBy(points, ("POINTS", "SkdRayDistance"))
lines = simple.Show(simple.OutputPort(rays, 1), view, Representation="Wireframe", LineWidth=1.5)
simple.ColorBy(lines, ("CELLS", "SkdRayDistance"))
colours.RescaleTransferFunction(*rays.PointData["SkdRayDistance"].GetRange())
lines.SetScalarBarVisibility(view, True)
bar = simple.GetScalarBar(colours, view)
bar.Title, bar.ComponentTitle = "distance", ""
bar.TitleColor = bar.LabelColor = [0, 0, 0]

view.CameraPosition, view.CameraFocalPoint = [0.3, 0.5, 1], [0, 0, 0]
view.CameraViewUp = [0, 1, 0]
simple.ResetCamera(view)
simple.SaveScreenshot(picture_file, view)
