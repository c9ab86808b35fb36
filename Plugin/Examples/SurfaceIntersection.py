# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""A part moves through a surface: at each step the curves along which the two meet.

The surface is a fruit fly's brain, the part a region of it. An animation shifts the region outward;
only the first step builds trees, as moving the source needs none.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython SurfaceIntersection.py Data/fly_brain_neuropil.vtp Data/fly_brain_lateral_horn.vtp picture.png
"""

import os
import sys

from paraview import simple

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")
brain_file, region_file, picture_file = sys.argv[1:4] or (
    os.path.join(DATA, "fly_brain_neuropil.vtp"), os.path.join(DATA, "fly_brain_lateral_horn.vtp"), "SurfaceIntersection.png")
STEPS, SHOWN, SHIFT = 9, 5, -9000.0

brain = simple.OpenDataFile(brain_file)
region = simple.OpenDataFile(region_file)
intersection = simple.SkdTreeSurfaceIntersection(Input=brain, Source=region)

view = simple.CreateRenderView(ViewSize=[900, 700], OrientationAxesVisibility=0,
    UseColorPaletteForBackground=0, Background=[1, 1, 1])
moved = simple.Transform(Input=region)


def show(proxy, **properties):
    display = simple.Show(proxy, view, Representation="Surface")
    display.ColorArrayName = ["POINTS", ""]  # none: one colour
    for name, value in properties.items():
        setattr(display, name, value)


def animate(proxy, name, index, start, end):
    track = simple.GetAnimationTrack(name, index, proxy)
    track.KeyFrames = [simple.CompositeKeyFrame(KeyTime=0, KeyValues=[start]),
        simple.CompositeKeyFrame(KeyTime=1, KeyValues=[end])]


show(moved, DiffuseColor=[0.95, 0.75, 0.5])
view.CameraPosition, view.CameraFocalPoint = [0.15, -0.3, -1], [0, 0, 0]
view.CameraViewUp = [0, -1, 0]
simple.ResetCamera(view)
simple.GetActiveCamera().Zoom(0.6)
show(brain, Opacity=0.45, DiffuseColor=[0.55, 0.65, 0.8])
show(intersection, DiffuseColor=[0.8, 0.1, 0.1], LineWidth=5)
animate(intersection, "Translation", 1, 0.0, SHIFT)
animate(moved.Transform, "Position", 1, 0.0, SHIFT)

scene = simple.GetAnimationScene()
scene.StartTime, scene.EndTime = 0.0, 1.0
for step in range(STEPS):
    scene.AnimationTime = step / (STEPS - 1)
    intersection.UpdatePipeline()
    report = {name: intersection.FieldData["SkdReport" + name].GetRange()[0]
        for name in ("Pairs", "Curves", "TreesBuilt")}
    print("shifted by %6.0f: %4d pairs of cells in %2d curves, %d trees built"
        % (intersection.Translation[1], report["Pairs"], report["Curves"], report["TreesBuilt"]))
    if step == SHOWN:
        simple.SaveScreenshot(picture_file, view)
