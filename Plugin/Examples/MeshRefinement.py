# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Three meshes of the Earth, refined where the land is steep: Fig. 1 of Khamayseh and Hansen (2007).

Clockwise from the upper left: the relief, and an icosahedral mesh, a mesh of hexagons (and twelve
pentagons) and one of irregular triangles. Cells are cut in which the height of the land varies by
more than a threshold, and those beside so that no point hangs; new points go to the sphere.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython MeshRefinement.py Data/earth_relief.vti picture.png
"""

import os
import sys

import numpy
from paraview import simple
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkStructuredGrid
from vtkmodules.vtkFiltersCore import vtkDelaunay3D
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")
relief_file, picture_file = sys.argv[1:3] or (
    os.path.join(DATA, "earth_relief.vti"), "MeshRefinement.png")


def as_source(data, name):
    """Data made here, as a source of the pipeline."""
    source = simple.TrivialProducer(registrationName=name)
    source.GetClientSideObject().SetOutput(data)
    return source


def as_points(places):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(places), deep=1))
    return points


def on_sphere(longitude, latitude):
    longitude, latitude = numpy.radians(longitude), numpy.radians(latitude)
    return numpy.stack([numpy.cos(latitude) * numpy.cos(longitude),
        numpy.cos(latitude) * numpy.sin(longitude), numpy.sin(latitude)], axis=-1)


def unit(places):
    return places / numpy.linalg.norm(places, axis=-1, keepdims=True)


def read_relief(file):
    """The heights on the unit sphere; the first meridian once more, so that there is no gap."""
    reader = vtkXMLImageDataReader()
    reader.SetFileName(file)
    reader.Update()
    image = reader.GetOutput()
    columns, rows, _ = image.GetDimensions()
    longitude = image.GetOrigin()[0] + numpy.arange(columns + 1)
    latitude = image.GetOrigin()[1] + numpy.arange(rows)
    height = dataset_adapter.WrapDataObject(image).PointData["height"].reshape(rows, columns)
    height = numpy.concatenate([height, height[:, :1]], axis=1).astype(float)
    grid = vtkStructuredGrid()
    grid.SetDimensions(columns + 1, rows, 1)
    grid.SetPoints(as_points(on_sphere(*numpy.meshgrid(longitude, latitude)).reshape(-1, 3)))
    for name, values in ("height", height), ("land", numpy.maximum(height, 0)):
        array = numpy_to_vtk(values.ravel(), deep=1)
        array.SetName(name)
        grid.GetPointData().AddArray(array)
    return grid


def hull(places):
    """The triangles of the convex hull, outward."""
    surface = vtkPolyData()
    surface.SetPoints(as_points(places))
    inside, border = vtkDelaunay3D(), vtkGeometryFilter()
    inside.SetInputData(surface)
    border.SetInputConnection(inside.GetOutputPort())
    border.Update()
    return border.GetOutput()


def icosahedron():
    golden = (1 + 5**0.5) / 2
    corners = [[0, s, t * golden] for s in (-1, 1) for t in (-1, 1)]
    return hull(unit(numpy.array([numpy.roll(c, k) for c in corners for k in range(3)])))


def dual(mesh):
    """A polygon a point, around it, of the middles of its triangles."""
    surface = dataset_adapter.WrapDataObject(mesh)
    triangles = surface.Polygons.reshape(-1, 4)[:, 1:]
    middles = unit(surface.Points[triangles].mean(axis=1))
    polygons = vtkCellArray()
    for point, axis in enumerate(surface.Points):
        around = numpy.where((triangles == point).any(axis=1))[0]
        first = numpy.cross([0.3, 0.5, 0.7], axis)
        second = numpy.cross(axis, first)
        away = middles[around] - axis
        order = numpy.argsort(numpy.arctan2(away @ second, away @ first))
        polygons.InsertNextCell(len(around))
        for triangle in around[order]:
            polygons.InsertCellPoint(int(triangle))
    result = vtkPolyData()
    result.SetPoints(as_points(middles))
    result.SetPolys(polygons)
    return result


def scattered(count):
    """Points all over the sphere, each moved a little, by the same numbers every time."""
    turn = numpy.arange(count)
    places = on_sphere(137.50776405 * turn, numpy.degrees(numpy.arcsin((2 * turn + 1) / count - 1)))
    return unit(places + 0.02 * numpy.random.default_rng(1).uniform(-1, 1, places.shape))


def refined(mesh, name, threshold, levels):
    result = simple.SkdTreeMeshRefinement(Input=as_source(mesh, name), Field=relief,
        FieldArrays=["land"], FieldThreshold=threshold, MaximumLevel=levels,
        PointPlacement="Sphere")
    result.UpdatePipeline()
    report = {word: result.FieldData["SkdReport" + word].GetRange()[0]
              for word in ("CellsBefore", "Cells", "MinimumAngle", "HangingPoints")}
    print("%-12s %5d cells become %6d, smallest angle %.1f degrees, %d points hang"
        % (name, report["CellsBefore"], report["Cells"], report["MinimumAngle"],
           report["HangingPoints"]))
    return result


relief = as_source(read_relief(relief_file), "relief")

# An icosahedral mesh: the icosahedron's triangles cut into four, four times.
icosahedral = simple.SkdTreeMeshRefinement(Input=as_source(icosahedron(), "icosahedron"),
    Method="Regular", MinimumLevel=4, MaximumLevel=4, PointPlacement="Sphere")
icosahedral.UpdatePipeline()
base = icosahedral.GetClientSideObject().GetOutputDataObject(0)

views = [(relief, "Surface")] + [
    (refined(mesh, name, 900, 3), "Surface With Edges") for mesh, name in (
        (base, "icosahedral"), (dual(base), "polygonal"), (hull(scattered(2562)), "triangular"))]

colours = simple.GetColorTransferFunction("height")
colours.RGBPoints = [-7000, 0.05, 0.15, 0.4, -3000, 0.2, 0.45, 0.75, -1, 0.7, 0.85, 0.95,
    0, 0.35, 0.55, 0.3, 800, 0.75, 0.7, 0.45, 2500, 0.6, 0.4, 0.25, 5500, 1, 1, 1]
layout = simple.CreateLayout("Earth")
right = layout.SplitHorizontal(0, 0.5)
cells = [layout.SplitVertical(1, 0.5), layout.SplitVertical(2, 0.5)]
places = [3, 5, 6, 4]  # upper left, upper right, lower right, lower left
for (source, representation), place in zip(views, places):
    view = simple.CreateRenderView(OrientationAxesVisibility=0, UseColorPaletteForBackground=0,
        Background=[1, 1, 1])
    layout.AssignView(place, view)
    if source is not relief:
        source = simple.SkdTreeClosestPoint(Input=source, Source=relief, InterpolateSourceData=1)
    shown = simple.Show(source, view, Representation=representation,
        EdgeColor=[0.25, 0.25, 0.25], LineWidth=0.6, Ambient=0.45, Diffuse=0.6, Specular=0)
    simple.ColorBy(shown, ("POINTS", "height"))
    shown.SetScalarBarVisibility(view, False)
    view.CameraPosition = list(on_sphere(52.0, 37.0) * 5)
    view.CameraFocalPoint, view.CameraViewUp = [0, 0, 0], [0, 0, 1]
    view.CameraParallelProjection, view.CameraParallelScale = 1, 0.8
layout.SetSize(1000, 1000)
simple.SaveScreenshot(picture_file, layout, ImageResolution=[1000, 1000], SeparatorWidth=0,
    SeparatorColor=[1, 1, 1])
