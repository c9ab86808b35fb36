# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The boxes of three levels of the tree of a scanned surface.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython Representation.py Data/fly_brain_neuropil.vtp picture.png
"""

import os
import sys

from paraview import servermanager, simple

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")
data_file, picture_file = sys.argv[1:3] or (
    os.path.join(DATA, "fly_brain_neuropil.vtp"), "Representation.png")

surface = simple.OpenDataFile(data_file)
layout = simple.CreateLayout()
layout.SplitHorizontal(0, 0.33)
layout.SplitHorizontal(2, 0.5)
views = []
for level, place in ((3, 1), (6, 5), (9, 6)):
    boxes = simple.SkdTreeRepresentation(Input=surface, Level=level)
    boxes.UpdatePipeline()
    print("level %d: %4d boxes" % (level, boxes.GetDataInformation().GetNumberOfCells() // 6))
    view = simple.CreateView("RenderView", OrientationAxesVisibility=0,
        UseColorPaletteForBackground=0, Background=[1, 1, 1])
    layout.AssignView(place, view)
    shown = simple.Show(boxes, view, Representation="Surface With Edges")
    shown.ColorArrayName = [None, ""]
    shown.DiffuseColor, shown.EdgeColor = [0.75, 0.82, 0.92], [0.25, 0.35, 0.5]
    shown.Ambient, shown.Diffuse = 0.3, 0.7
    view.CameraPosition, view.CameraViewUp = [-25000, -40000, -80000], [0, -1, 0]
    views.append(view)

statistics = servermanager.Fetch(boxes, idx=1)
print("depth of the tree that is searched: %d" % statistics.GetColumnByName("Depth").GetValue(0))
layout.SetSize(900, 300)
for view in views:
    simple.Render(view)
    simple.ResetCamera(view)
simple.SaveScreenshot(picture_file, layout, ImageResolution=[900, 300])
