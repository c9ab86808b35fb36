# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of the Earth that follow its mountains: Figs. 2, 3 and 4 of Khamayseh and Hansen (2007).

Upper row: the relief, and the mean height of the land in the cells of a mesh of triangles and of a
geodesic mesh of 2562 polygons. Lower row: a mesh of quadrilaterals, these polygons and these
triangles, their points moved to where the land is steep. No cell is added: cells over the plains and
the seas grow. For the root of the height, lower mountains count for more beside Tibet.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say):
    pvpython MeshAdaptation.py Data/earth_relief.vti picture.png
"""

import os
import sys

import numpy
from paraview import simple
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkStructuredGrid

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")
relief_file, picture_file = sys.argv[1:3] or (
    os.path.join(DATA, "earth_relief.vti"), "MeshAdaptation.png")

REGIONS = {"Alps": (4, 17, 43, 49), "Himalayas": (75, 100, 26, 38), "Andes": (-76, -64, -35, 0)}


def as_source(data, name):
    """Data made here, as a source of the pipeline."""
    source = simple.TrivialProducer(registrationName=name)
    source.GetClientSideObject().SetOutput(data)
    return source


def as_points(places):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(places, dtype=float), deep=1))
    return points


def unit(places):
    return places / numpy.linalg.norm(places, axis=-1, keepdims=True)


def on_sphere(longitude, latitude):
    longitude, latitude = numpy.radians(longitude), numpy.radians(latitude)
    return numpy.stack([numpy.cos(latitude) * numpy.cos(longitude),
        numpy.cos(latitude) * numpy.sin(longitude), numpy.sin(latitude)], axis=-1)


def globe(image):
    """The heights on the unit sphere; the first meridian once more, so that there is no gap."""
    columns, rows, _ = image.GetDimensions()
    longitude = image.GetOrigin()[0] + numpy.arange(columns + 1)
    latitude = image.GetOrigin()[1] + numpy.arange(rows)
    height = dataset_adapter.WrapDataObject(image).PointData["height"].reshape(rows, columns)
    height = numpy.concatenate([height, height[:, :1]], axis=1).astype(float)
    grid = vtkStructuredGrid()
    grid.SetDimensions(columns + 1, rows, 1)
    grid.SetPoints(as_points(on_sphere(*numpy.meshgrid(longitude, latitude)).reshape(-1, 3)))
    array = numpy_to_vtk(height.ravel(), deep=1)
    array.SetName("height")
    grid.GetPointData().AddArray(array)
    return grid


def surface(places, cells):
    polygons = vtkCellArray()
    for cell in cells:
        polygons.InsertNextCell(len(cell))
        for point in cell:
            polygons.InsertCellPoint(int(point))
    made = vtkPolyData()
    made.SetPoints(as_points(places))
    made.SetPolys(polygons)
    return made


def merged(corners):
    """Points and cells of cells that are given by their corners."""
    flat = unit(corners.reshape(-1, 3))
    _, first, number = numpy.unique(
        numpy.round(flat, 9), axis=0, return_index=True, return_inverse=True)
    return flat[first], number.reshape(corners.shape[:2])


def icosahedral(level):
    """The icosahedron's triangles, cut into four so many times."""
    golden = (1 + 5**0.5) / 2
    points = unit(numpy.array([numpy.roll([0, s, t * golden], k)
        for s in (-1, 1) for t in (-1, 1) for k in range(3)]))
    near = points @ points.T > 0.4
    faces = [(i, j, k) for i in range(12) for j in range(i) for k in range(j)
        if near[i, j] and near[j, k] and near[i, k]]
    faces = [f if numpy.linalg.det(points[list(f)]) > 0 else f[::-1] for f in faces]
    corners = points[numpy.array(faces)]
    for _ in range(level):
        a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
        ab, bc, ca = unit(a + b), unit(b + c), unit(c + a)
        corners = numpy.concatenate([numpy.stack(t, axis=1)
            for t in ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))])
    return merged(corners)


def dual(points, triangles):
    """A polygon a point, around it, of the middles of its triangles."""
    middles = unit(points[triangles].mean(axis=1))
    cells = []
    for point, axis in enumerate(points):
        around = numpy.where((triangles == point).any(axis=1))[0]
        first = numpy.cross([0.3, 0.5, 0.7], axis)
        away = middles[around] - axis
        turn = numpy.arctan2(away @ numpy.cross(axis, first), away @ first)
        cells.append(around[numpy.argsort(turn)])
    return middles, cells


def cubed(n):
    """A cube's faces of n x n cells, at equal angles, on the sphere."""
    steps = numpy.tan(numpy.linspace(-1, 1, n + 1) * numpy.pi / 4)
    corners = []
    for axis in range(3):
        for side in (-1, 1):
            face = numpy.stack([numpy.full((n + 1, n + 1), side),
                *numpy.meshgrid(steps, side * steps, indexing="ij")], axis=-1)
            face = numpy.roll(face, axis, axis=-1)
            corners.append(numpy.stack(
                [face[:-1, :-1], face[1:, :-1], face[1:, 1:], face[:-1, 1:]], axis=2))
    return merged(numpy.concatenate(corners).reshape(-1, 4, 3))


def with_mean_heights(mesh):
    """The same mesh with the mean of the heights that each cell contains."""
    return simple.SkdTreeRemap(Input=mesh, Source=land, Method="Contained Statistic",
        SourceCoordinates="Longitude Latitude")


def cell_areas(points, corners, offsets):
    """Of polygons between great circles: solid angles of fans of triangles."""
    areas = []
    for first, last in zip(offsets, offsets[1:]):
        a, b, c = points[corners[first]], points[corners[first + 1:last - 1]], points[
            corners[first + 2:last]]
        volume = numpy.cross(b, c) @ a
        areas.append(2 * numpy.arctan2(volume, 1 + b @ a + c @ a + (b * c).sum(axis=1)).sum())
    return numpy.abs(areas)


def cell_sizes(proxy):
    """The mean area of the cells of each region, in thousand square kilometres."""
    proxy.UpdatePipeline()
    mesh = dataset_adapter.WrapDataObject(proxy.GetClientSideObject().GetOutputDataObject(0))
    corners = vtk_to_numpy(mesh.VTKObject.GetPolys().GetConnectivityArray())
    offsets = vtk_to_numpy(mesh.VTKObject.GetPolys().GetOffsetsArray())
    areas = cell_areas(mesh.Points, corners, offsets)
    middles = unit(numpy.add.reduceat(mesh.Points[corners], offsets[:-1]))
    longitude = numpy.degrees(numpy.arctan2(middles[:, 1], middles[:, 0]))
    latitude = numpy.degrees(numpy.arcsin(middles[:, 2]))
    sizes = {}
    for name, (west, east, south, north) in REGIONS.items():
        chosen = (west < longitude) & (longitude < east) & (south < latitude) & (latitude < north)
        sizes[name] = areas[chosen].mean() * 6371**2 / 1000
    return sizes


def adapted(mesh, name):
    moved = simple.SkdTreeMeshAdaptation(Input=mesh, Source=land, FieldArray="root",
        SourceCoordinates="Longitude Latitude")
    before, after = cell_sizes(mesh), cell_sizes(moved)
    report = {word: moved.FieldData["SkdReport" + word].GetRange()[0]
              for word in ("EquidistributionBefore", "EquidistributionAfter", "SmallestQuality")}
    print("%-14s equidistribution error %.3f -> %.3f, smallest quality %.2f" % (name,
        report["EquidistributionBefore"], report["EquidistributionAfter"],
        report["SmallestQuality"]))
    for region in REGIONS:
        grows = "shrink" if after[region] < before[region] else "grow"
        print("   cells of the %-9s %s from %4.0f to %4.0f thousand km2"
            % (region, grows, before[region], after[region]))
    return with_mean_heights(moved)


relief = simple.XMLImageDataReader(FileName=[relief_file])
higher = simple.Calculator(Input=relief, ResultArrayName="land", Function="max(height,0)")
land = simple.Calculator(Input=higher, ResultArrayName="root", Function="sqrt(land)")
relief.UpdatePipeline()
triangles = icosahedral(4)
tri = as_source(surface(*triangles), "triangles")
poly = as_source(surface(*dual(*triangles)), "polygons")
quad = as_source(surface(*cubed(30)), "quadrilaterals")
earth = as_source(globe(relief.GetClientSideObject().GetOutputDataObject(0)), "relief")
views = [earth, with_mean_heights(tri), with_mean_heights(poly),
    adapted(quad, "quadrilaterals"), adapted(poly, "polygons"), adapted(tri, "triangles")]

HEIGHTS = [-7000, 0.05, 0.15, 0.4, -3000, 0.2, 0.45, 0.75, -1, 0.7, 0.85, 0.95,
    0, 0.35, 0.55, 0.3, 800, 0.75, 0.7, 0.45, 2500, 0.6, 0.4, 0.25, 5500, 1, 1, 1]
simple.GetColorTransferFunction("height").RGBPoints = HEIGHTS
simple.GetColorTransferFunction("land").RGBPoints = [0, 0.7, 0.85, 0.95, 1, 0.5, 0.7, 0.5,
    300, 0.35, 0.55, 0.3, 1000, 0.75, 0.7, 0.45, 2500, 0.6, 0.4, 0.25, 5500, 1, 1, 1]
layout = simple.CreateLayout("Earth")
layout.SplitVertical(0, 0.5)
for row in (1, 2):
    layout.SplitHorizontal(row, 1 / 3)
    layout.SplitHorizontal(2 * row + 2, 0.5)
for source, place in zip(views, (3, 9, 10, 5, 13, 14)):
    view = simple.CreateRenderView(OrientationAxesVisibility=0, UseColorPaletteForBackground=0,
        Background=[1, 1, 1])
    layout.AssignView(place, view)
    shown = simple.Show(source, view, EdgeColor=[0.2, 0.2, 0.2], LineWidth=0.6, Ambient=0.45,
        Diffuse=0.6, Specular=0,
        Representation="Surface" if source is earth else "Surface With Edges")
    simple.ColorBy(shown, ("POINTS", "height") if source is earth else ("CELLS", "land"))
    shown.SetScalarBarVisibility(view, False)
    view.CameraPosition = list(on_sphere(62.0, 37.0) * 5)
    view.CameraFocalPoint, view.CameraViewUp = [0, 0, 0], [0, 0, 1]
    view.CameraParallelProjection, view.CameraParallelScale = 1, 1.03
layout.SetSize(1200, 800)
simple.SaveScreenshot(picture_file, layout, ImageResolution=[1200, 800], SeparatorWidth=0,
    SeparatorColor=[1, 1, 1])
