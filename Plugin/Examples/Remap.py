# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The relief of the Earth as the mean height of each cell of a mesh of the sphere.

The relief is an image of longitude and latitude, a height a degree. Each triangle of the sphere takes
the mean of the heights that it contains, weighted with the cosine of the latitude: near the poles
there are as many heights as elsewhere, in less room. Then a coarser sphere takes the means of the
finer one's triangles, by their exact overlaps: the mean of all is kept.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython Remap.py Data/earth_relief.vti picture.png
"""

import os
import sys

from paraview import simple

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")
data_file, picture_file = sys.argv[1:3] or (os.path.join(DATA, "earth_relief.vti"), "Remap.png")

relief = simple.OpenDataFile(data_file)
fine = simple.Sphere(Radius=1, ThetaResolution=96, PhiResolution=49)
means = simple.SkdTreeRemap(Input=fine, Source=relief, Method="Contained Statistic",
    SourceCoordinates="Longitude Latitude", PassInputData=0)
coarse = simple.Sphere(Radius=1, ThetaResolution=32, PhiResolution=17)
coarser = simple.SkdTreeRemap(Input=coarse, Source=means, Method="Conservative First Order")
coarser.UpdatePipeline()


def reported(proxy, name):
    return proxy.FieldData["SkdReport" + name].GetRange()[0]


print("%d triangles, %d of them without a height" % (
    reported(means, "InputCells"), reported(means, "InputCellsEmpty")))
area = 4 * 3.141592653589793
print("mean height of the fine sphere %.2f m, of the coarse one %.2f m" % (
    reported(coarser, "SourceIntegral") / area, reported(coarser, "TargetIntegral") / area))
print("conservation error below 1e-13: %s" % (reported(coarser, "ConservationError") < 1e-13))

view = simple.CreateRenderView(ViewSize=[1100, 600], OrientationAxesVisibility=0,
    UseColorPaletteForBackground=0, Background=[1, 1, 1])
colours = simple.GetColorTransferFunction("height")
colours.ApplyPreset("Cool to Warm (Extended)", True)
for proxy, position in ((means, -1.1), (coarser, 1.1)):
    moved = simple.Transform(Input=proxy)
    moved.Transform.Translate = [position, 0, 0]
    display = simple.Show(moved, view, Representation="Surface With Edges")
    display.EdgeColor = [0.35, 0.35, 0.35]
    display.Ambient, display.Diffuse = 0.4, 0.6
    simple.ColorBy(display, ("CELLS", "height"))
colours.RescaleTransferFunction(-6000, 6000)
display.SetScalarBarVisibility(view, True)
bar = simple.GetScalarBar(colours, view)
bar.TitleColor = bar.LabelColor = [0, 0, 0]
bar.Title, bar.ComponentTitle = "height [m]", ""

view.CameraFocalPoint = [0, 0, 0]
view.CameraPosition, view.CameraViewUp = [1.2, 9, 3], [0, 0, 1]
view.CameraParallelProjection, view.CameraParallelScale = 1, 1.3
simple.SaveScreenshot(picture_file, view)
