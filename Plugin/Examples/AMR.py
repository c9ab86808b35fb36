# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""An adaptive grid around the surface of a fruit fly's brain and a neuron that runs in it.

The surface and the curves are two parts with a level each. Cells of the grid that the one or the
other meets are refined; faces of cells that differ by more than one level do not touch. What is in
front is clipped away, so that the levels show.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython AMR.py Data/fly_brain_neuropil.vtp Data/fly_brain_neuron.vtp picture.png
"""

import os
import sys

from paraview import simple

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")
surface_file, neuron_file, picture_file = sys.argv[1:4] or (
    os.path.join(DATA, "fly_brain_neuropil.vtp"), os.path.join(DATA, "fly_brain_neuron.vtp"), "AMR.png")

surface = simple.OpenDataFile(surface_file)
neuron = simple.OpenDataFile(neuron_file)
parts = simple.GroupDatasets(Input=[surface, neuron])
amr = simple.SkdTreeAMR(Input=parts, OutputType="Unstructured Grid", MaximumLevel=8,
    PartLevels=[1, 5], Balance="Face")
amr.UpdatePipeline()

report = amr.FieldData
for name in ("SkdReportCells", "SkdReportCutCells"):
    print("%-18s %d" % (name[9:], report[name].GetRange()[0]))

view = simple.CreateRenderView(ViewSize=[1000, 560], OrientationAxesVisibility=0,
    UseColorPaletteForBackground=0, Background=[1, 1, 1])
low = amr.GetDataInformation().GetBounds()[::2]
high = amr.GetDataInformation().GetBounds()[1::2]
middle = [0.5 * (a + b) for a, b in zip(low, high)]

behind = simple.Clip(Input=amr, ClipType="Plane", Crinkleclip=1)
behind.ClipType.Origin, behind.ClipType.Normal = middle, [0, 0, 1]
grid = simple.Show(behind, view, Representation="Surface With Edges", EdgeColor=[0.2, 0.2, 0.2],
    Ambient=0.4)
simple.ColorBy(grid, ("CELLS", "SkdLevel"))
colours = simple.GetColorTransferFunction("SkdLevel")
# ParaView 6 calls it Viridis, earlier ones Viridis (matplotlib).
preset = next(name for name in simple.GetLookupTableNames() if name.startswith("Viridis"))
colours.ApplyPreset(preset, True)
grid.SetScalarBarVisibility(view, True)
bar = simple.GetScalarBar(colours, view)
bar.TitleColor = bar.LabelColor = [0, 0, 0]
simple.Show(surface, view, DiffuseColor=[0.9, 0.4, 0.17], ColorArrayName=[None, ""], Opacity=0.35)
simple.Show(neuron, view, AmbientColor=[0.8, 0, 0], DiffuseColor=[0.8, 0, 0],
    ColorArrayName=[None, ""], LineWidth=2)

size = max(b - a for a, b in zip(low, high))
view.CameraPosition = [middle[0] + 0.3 * size, middle[1] - 0.2 * size, middle[2] + 2 * size]
view.CameraFocalPoint, view.CameraViewUp = middle, [0, -1, 0]
simple.ResetCamera(view)
simple.GetActiveCamera().Dolly(1.7)
simple.SaveScreenshot(picture_file, view)
