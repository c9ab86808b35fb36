# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""A bead split by a plane: both parts are closed, and the section is on its own output.

The parts are moved apart for the picture.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython BooleanPlane.py picture.png
"""

import sys

from paraview import simple

picture_file = sys.argv[1] if sys.argv[1:] else "BooleanPlane.png"

ball = simple.Sphere(Radius=1, ThetaResolution=64, PhiResolution=48)
rod = simple.Cylinder(Radius=0.45, Height=3, Resolution=48)
bead = simple.SkdTreeBooleanOperation(Input=ball, Source=rod, Operation="Difference")
parts = simple.SkdTreeBooleanOperation(Input=bead, Operation="Split", CutByPlane=1,
    PlaneOrigin=[0.1, 0, 0], PlaneNormal=[1, 0.3, 0.2])
parts.UpdatePipeline()
report = parts.FieldData
print("parts of volume %.6f and %.6f, %d open edges" % (*report["SkdReportPartVolumes"].GetRange(),
    report["SkdReportBadEdges"].GetRange()[0]))

view = simple.CreateRenderView(ViewSize=[900, 520], OrientationAxesVisibility=0,
    UseColorPaletteForBackground=0, Background=[1, 1, 1])
for part, shift in ((0, 0.45), (1, -0.45)):
    alone = simple.Threshold(Input=parts, Scalars=["CELLS", "SkdPartId"])
    alone.LowerThreshold = alone.UpperThreshold = part
    moved = simple.Transform(Input=alone)
    moved.Transform.Translate = [shift, 0.3 * shift, 0.2 * shift]
    display = simple.Show(moved, view, Representation="Surface",
        DiffuseColor=[0.62, 0.74, 0.86], AmbientColor=[0.62, 0.74, 0.86])
    display.Ambient, display.Diffuse = 0.3, 0.8
    display.ColorArrayName = [None, ""]
cut = simple.Show(simple.OutputPort(parts, 1), view, Representation="Surface")
cut.Ambient, cut.Diffuse = 0.3, 0.8
cut.ColorArrayName = [None, ""]
cut.DiffuseColor = cut.AmbientColor = [0.95, 0.75, 0.45]

simple.Render(view)
view.CameraPosition, view.CameraViewUp = [3, 4, 6], [0, 1, 0]
simple.ResetCamera(view)
simple.GetActiveCamera().Zoom(1.5)
simple.SaveScreenshot(picture_file, view)
