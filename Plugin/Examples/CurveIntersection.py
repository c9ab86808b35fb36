# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where a closed curve crosses itself, and where it crosses another.

A Lissajous figure and a circle are given by points and taken as the splines through them: the filter
finds all crossings on the splines themselves.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython CurveIntersection.py picture.png
"""

import math
import sys

from paraview import simple

picture_file = sys.argv[1] if sys.argv[1:] else "CurveIntersection.png"


def closed_curve(function, count):
    points = []
    for i in range(count):
        points += function(2 * math.pi * i / count)
    return simple.PolyLineSource(Points=points + points[:3])


figure = closed_curve(lambda t: [1.5 * math.sin(3 * t + 0.8), math.sin(4 * t), 0], 160)
circle = closed_curve(lambda t: [0.6 * math.cos(t), 0.6 * math.sin(t), 0], 40)

own = simple.SkdTreeCurveIntersection(Input=figure, PolylineForm="Cardinal Spline", InterpolateData=0)
both = simple.SkdTreeCurveIntersection(
    Input=figure, Source=circle, PolylineForm="Cardinal Spline", InterpolateData=0)
for name, crossing in (("itself", own), ("the circle", both)):
    crossing.UpdatePipeline()
    hits = crossing.FieldData["SkdReportHits"].GetRange()[0]
    print("the figure crosses %s %d times" % (name, hits))

view = simple.CreateRenderView(ViewSize=[900, 600], OrientationAxesVisibility=0,
    UseColorPaletteForBackground=0, Background=[1, 1, 1])


def show(proxy, colour, **properties):
    display = simple.Show(proxy, view, **properties)
    display.ColorArrayName = ["POINTS", ""]
    display.DiffuseColor = display.AmbientColor = colour


def show_points(proxy, colour):
    show(simple.Glyph(Input=proxy, GlyphType="Sphere", ScaleFactor=0.06, GlyphMode="All Points",
        OrientationArray=["POINTS", "No orientation array"],
        ScaleArray=["POINTS", "No scale array"]), colour)


show(figure, [0.18, 0.44, 0.7], LineWidth=3)
show(circle, [0.55, 0.55, 0.55], LineWidth=3)
show_points(own, [0.88, 0.4, 0.17])
show_points(both, [0.25, 0.25, 0.25])

simple.Render(view)
simple.ResetCamera(view)
simple.GetActiveCamera().Dolly(1.3)
simple.SaveScreenshot(picture_file, view)
