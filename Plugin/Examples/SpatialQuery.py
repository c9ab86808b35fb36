# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is where in a mesh: cells that overlap a box, fill a sphere, lie along a line, or are nearest.

The mesh has hexahedra around a disk. Found in it are, from below: the cells that a turned box overlaps
(orange), those that a sphere encloses (blue), those along a line (green), and of those farther up the
forty that are nearest to a point outside (red). A mesh is searched by one tree, whatever the query.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython SpatialQuery.py Data/disk_flow.vtu picture.png
"""

import os
import sys

from paraview import servermanager, simple

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")
data_file, picture_file = sys.argv[1:3] or (os.path.join(DATA, "disk_flow.vtu"), "SpatialQuery.png")
flow = simple.OpenDataFile(data_file)
outside = simple.PointSource(Center=[7, -5, 8], Radius=0, NumberOfPoints=1)

queries = {
    "overlap a box": simple.SkdTreeSpatialQuery(Input=flow, Relation="Overlap", Shape="Box",
        BoxPosition=[-4, -5, -9], BoxLength=[7, 4, 3], BoxRotation=[0, 0, 10]),
    "fill a sphere": simple.SkdTreeSpatialQuery(Input=flow, Relation="Containment", Shape="Sphere",
        SphereCenter=[3.5, -3.5, -2], SphereRadius=2.5),
    "meet a line": simple.SkdTreeSpatialQuery(Input=flow, Relation="Overlap", Shape="Line",
        LinePoint1=[-7, -4, 0], LinePoint2=[7, -2, 5]),
    "are nearest": simple.SkdTreeSpatialQuery(Input=flow, Relation="Nearest", Source=outside,
        Shape="Source Points", NumberOfNearestCells=40),
}

for what, query in queries.items():
    query.UpdatePipeline()
    pairs = servermanager.Fetch(query, idx=2)
    distances = [pairs.GetColumnByName("Skd%sDistance" % kind) for kind in (
        "Optimistic", "Minimum", "Maximum", "Pessimistic")]
    ranges = ", ".join("%6.3f to %6.3f" % column.GetRange() for column in distances)
    print("%3d cells %-14s distances %s" % (pairs.GetNumberOfRows(), what, ranges))

view = simple.CreateRenderView(ViewSize=[900, 700], OrientationAxesVisibility=0,
    UseColorPaletteForBackground=0, Background=[1, 1, 1])
mesh = simple.Show(flow, view, Representation="Surface With Edges")
mesh.ColorArrayName = [None, ""]
mesh.Opacity, mesh.AmbientColor, mesh.DiffuseColor = 0.12, [0.6] * 3, [0.6] * 3
mesh.EdgeColor = [0.5, 0.5, 0.5]


def show(proxy, colour, representation="Surface With Edges"):
    display = simple.Show(proxy, view, Representation=representation)
    display.ColorArrayName = [None, ""]
    display.AmbientColor = display.DiffuseColor = colour
    display.EdgeColor = [0.1, 0.1, 0.1]
    return display


colours = [[0.9, 0.45, 0.1], [0.2, 0.45, 0.8], [0.2, 0.65, 0.3], [0.8, 0.15, 0.2]]
for query, colour in zip(queries.values(), colours):
    show(query, colour)

box = simple.Transform(Input=simple.Box(Center=[0.5, 0.5, 0.5]), Transform="Transform")
box.Transform.Translate, box.Transform.Rotate = [-4, -5, -9], [0, 0, 10]
box.Transform.Scale = [7, 4, 3]
show(box, colours[0], "Wireframe").LineWidth = 3
sphere = simple.Sphere(Center=[3.5, -3.5, -2], Radius=2.5, ThetaResolution=24, PhiResolution=24)
show(sphere, colours[1], "Wireframe").Opacity = 0.3
line = simple.Line(Point1=[-7, -4, 0], Point2=[7, -2, 5])
show(simple.Tube(Input=line, Radius=0.08), [0, 0.4, 0.1], "Surface")
show(simple.Sphere(Center=[7, -5, 8], Radius=0.3), colours[3], "Surface")

view.CameraPosition, view.CameraViewUp = [22, -45, 18], [0, 0, 1]
simple.ResetCamera(view)
view.CameraParallelScale, view.CameraParallelProjection = 12, 1
simple.SaveScreenshot(picture_file, view)
