# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's own Stream Tracer on the skD-tree, and the tree's boxes.

The same streamlines of a flow, left without and right with a skD-tree attached to the mesh; below once
more with the mesh's hexahedra as polyhedra. Drawn are the lines, and the boxes of one level of the
tree. The seconds are those of the processor, the search structures' construction included.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython Attach.py Data/disk_flow.vtu picture.png
"""

import os
import sys
import time

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, vtkUnstructuredGrid

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")
data_file, picture_file = sys.argv[1:3] or (os.path.join(DATA, "disk_flow.vtu"), "Attach.png")


def polyhedron(cell):
    """The faces of a cell: their number, then of each the number of points and the points."""
    stream = vtkIdList()
    stream.InsertNextId(cell.GetNumberOfFaces())
    for face in range(cell.GetNumberOfFaces()):
        ids = cell.GetFace(face).GetPointIds()
        for number in [ids.GetNumberOfIds()] + [ids.GetId(i) for i in range(ids.GetNumberOfIds())]:
            stream.InsertNextId(number)
    return stream


def as_polyhedra(reader):
    """A source of the same mesh whose cells are polyhedra."""
    data = servermanager.Fetch(reader)
    mesh = vtkUnstructuredGrid()
    mesh.SetPoints(data.GetPoints())
    mesh.GetPointData().ShallowCopy(data.GetPointData())
    for i in range(data.GetNumberOfCells()):
        mesh.InsertNextCell(VTK_POLYHEDRON, polyhedron(data.GetCell(i)))
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(mesh)
    producer.UpdatePipeline()
    return producer


def streamlines(name, mesh, on_tree):
    """The streamlines through a mesh, whose pipeline is up to date but for an attached tree."""
    tracer = simple.StreamTracer(Input=mesh, Vectors=["POINTS", "V"], SeedType="Line",
        MaximumStreamlineLength=40)
    if "CellLocator" not in tracer.ListProperties():  # up to ParaView 6.1: the one that is attached
        tracer.InterpolatorType = "Interpolator with Cell Locator"
    elif on_tree:
        tracer.CellLocator = "SkdTreeCellLocator"
    tracer.SeedType.Point1, tracer.SeedType.Point2 = [-5, -2, 0.5], [5, 2, 9]
    tracer.SeedType.Resolution = 10
    start = time.process_time()
    tracer.UpdatePipeline()
    seconds = time.process_time() - start
    print("%-20s %6d points in %6.2f s" % (
        name, tracer.GetDataInformation().GetNumberOfPoints(), seconds))
    return tracer


def show(lines, boxes, view):
    shown = simple.Show(boxes, view, Representation="Wireframe")
    shown.ColorArrayName = [None, ""]
    shown.AmbientColor = shown.DiffuseColor = [0.55, 0.6, 0.7]
    shown.Opacity = 0.5
    tubes = simple.Show(simple.Tube(Input=lines, Radius=0.08), view)
    simple.ColorBy(tubes, ("POINTS", "Temp"))
    # ParaView 6 calls it Inferno, earlier ones Inferno (matplotlib).
    preset = next(name for name in simple.GetLookupTableNames() if name.startswith("Inferno"))
    simple.GetColorTransferFunction("Temp").ApplyPreset(preset, True)
    view.CameraPosition, view.CameraViewUp = [14, -40, 14], [0, 0, 1]
    simple.ResetCamera(view)


hexahedra = simple.OpenDataFile(data_file)
hexahedra.UpdatePipeline()
polyhedra = as_polyhedra(hexahedra)
boxes = simple.SkdTreeRepresentation(Input=hexahedra, Level=6)

layout = simple.CreateLayout()
layout.SplitVertical(0, 0.5)
layout.SplitHorizontal(1, 0.5)
layout.SplitHorizontal(2, 0.5)
places = iter((3, 4, 5, 6))
for name, mesh in (("hexahedra", hexahedra), ("polyhedra", polyhedra)):
    for how, searched in (("without", mesh), ("with", simple.SkdTreeAttach(Input=mesh))):
        view = simple.CreateView("RenderView", OrientationAxesVisibility=0,
            UseColorPaletteForBackground=0, Background=[1, 1, 1])
        layout.AssignView(next(places), view)
        show(streamlines("%s, %s:" % (name, how), searched, how == "with"), boxes, view)
layout.SetSize(900, 700)
simple.SaveScreenshot(picture_file, layout, ImageResolution=[900, 700])
