# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which region of a brain a voxel is in.

The parts are scanned surfaces, one within the other: a fruit fly's brain and one of its regions, the
lateral horn. The voxels of a grid are classified by their centres: they are outside (depth 0), in the brain
(1) or in the lateral horn, too (2).

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython PointInOut.py Data picture.png
"""

import os
import sys

from paraview import simple

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")
data_folder, picture_file = sys.argv[1:3] or (DATA, "PointInOut.png")

brain = simple.OpenDataFile(os.path.join(data_folder, "fly_brain_neuropil.vtp"))
region = simple.OpenDataFile(os.path.join(data_folder, "fly_brain_lateral_horn.vtp"))
parts = simple.GroupDatasets(Input=[brain, region])
parts.UpdatePipeline()

bounds = brain.GetDataInformation().GetBounds()
spacing = (bounds[1] - bounds[0]) / 150
counts = [int((bounds[2 * axis + 1] - bounds[2 * axis]) / spacing) + 1 for axis in range(3)]
unit = simple.FastUniformGrid(
    WholeExtent=[0, counts[0], 0, counts[1], 0, counts[2]], GenerateDistanceSquaredScalars=0)
grid = simple.Transform(Input=unit)
grid.Transform.Translate = bounds[::2]
grid.Transform.Scale = [spacing] * 3

voxels = simple.SkdTreePointInOut(Input=grid, Source=parts, Ask="Cell Centers")
voxels.UpdatePipeline()
for name in ("Points", "PointsInside", "Parts", "OpenEdges"):
    print("%-12s %d" % (name, voxels.FieldData["SkdReport" + name].GetRange()[0]))

view = simple.CreateRenderView(ViewSize=[900, 700], OrientationAxesVisibility=0,
    UseColorPaletteForBackground=0, Background=[1, 1, 1])


def show(low, high, colour, opacity):
    some = simple.Threshold(Input=voxels, Scalars=["CELLS", "SkdDepth"],
        LowerThreshold=low, UpperThreshold=high)
    display = simple.Show(some, view, Representation="Surface")
    display.ColorArrayName = [None, ""]
    display.AmbientColor = display.DiffuseColor = colour
    display.Opacity = opacity


show(1, 2, [0.55, 0.62, 0.75], 0.25)
show(2, 2, [0.85, 0.4, 0.15], 1.0)
view.CameraPosition, view.CameraViewUp = [-25000, -60000, -80000], [0, -1, 0]
simple.ResetCamera(view)
simple.SaveScreenshot(picture_file, view)
