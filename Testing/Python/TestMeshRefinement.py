# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The mesh refinement filter by ParaView's simple API."""

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdtesting


def sheet(**properties):
    """A square of triangles, refined around a ball that it cuts."""
    plane = simple.Triangulate(Input=simple.Plane(XResolution=10, YResolution=10))
    ball = simple.Sphere(Radius=0.2, ThetaResolution=32, PhiResolution=32)
    return simple.SkdTreeMeshRefinement(Input=plane, Parts=ball, **properties)


def fetched(source):
    source.UpdatePipeline()
    return servermanager.Fetch(source)


def cell_array(mesh, name):
    return vtk_to_numpy(mesh.GetCellData().GetArray(name))


def areas(mesh):
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return 0.5 * numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1)


def test_triangles_around_a_circle_without_hanging_points():
    refined = sheet(MaximumLevel=4, OutputPointsPrecision="Double")
    mesh = fetched(refined)
    assert mesh.GetClassName() == "vtkPolyData"
    assert skdtesting.report(refined, "HangingPoints") == 0
    assert mesh.GetPointData().GetArray("SkdHanging").GetRange() == (0, 0)
    assert abs(areas(mesh).sum() - 1) < 1e-12 and areas(mesh).min() > 0
    level, parent = cell_array(mesh, "SkdLevel"), cell_array(mesh, "SkdParentCellId")
    assert level.max() >= 4 and set(parent) == set(range(200))
    assert skdtesting.report(refined, "MinimumAngle") >= 22.5 - 1e-5


def test_regular_cuts_hang_and_can_be_balanced():
    counts = []
    for balance in ("None", "Face", "Edge", "Corner"):
        refined = sheet(MaximumLevel=4, Method="Regular", Balance=balance)
        assert fetched(refined).GetPointData().GetArray("SkdHanging").GetRange() == (0, 1)
        counts.append(skdtesting.report(refined, "Cells"))
    assert counts == sorted(counts) and counts[0] < counts[3], counts


def test_a_field_bands_the_inside_and_a_minimum_ask():
    plain = fetched(sheet()).GetNumberOfCells()
    for more in (dict(MinimumLevel=1), dict(DistanceBands=[0.1, 2]), dict(InsideLevel=3)):
        assert fetched(sheet(**more)).GetNumberOfCells() > plain, more
    waves = simple.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5])
    mesh = simple.Tetrahedralize(Input=waves)
    for field in (dict(Field=waves), dict()):
        counts = []
        for threshold in (1000, 60, 40):
            refined = simple.SkdTreeMeshRefinement(Input=mesh, FieldArrays=["RTData"],
                FieldThreshold=threshold, MaximumLevel=1, **field)
            counts.append(fetched(refined).GetNumberOfCells())
        assert skdtesting.report(refined, "CellsBefore") == counts[0] < counts[1] < counts[2], counts


def test_points_go_to_a_sphere_or_a_surface():
    cube = simple.Box(XLength=1, YLength=1, ZLength=1)
    ball = simple.Sphere(Radius=1, ThetaResolution=64, PhiResolution=64)
    for where in (dict(PointPlacement="Surface", Surface=ball), dict(PointPlacement="Sphere")):
        refined = simple.SkdTreeMeshRefinement(Input=cube, MinimumLevel=3, **where)
        points = vtk_to_numpy(fetched(refined).GetPoints().GetData())[24:]
        radius = numpy.linalg.norm(points, axis=1)
        expected = 1 if "Surface" in where else 0.75**0.5
        assert abs(radius - expected).max() < 5e-3, (radius.min(), radius.max())


def test_blocks_stay_blocks():
    blocks = simple.GroupDatasets(Input=[simple.Plane(), simple.Plane(Origin=[0.5, -0.5, 0],
        Point1=[1.5, -0.5, 0], Point2=[0.5, 0.5, 0])])
    refined = simple.SkdTreeMeshRefinement(Input=blocks, Parts=simple.Sphere(Radius=0.1),
        MaximumLevel=2)
    assert fetched(refined).GetClassName() == fetched(blocks).GetClassName()
    assert skdtesting.report(refined, "HangingPoints") == 0


def test_the_cell_limit_stops_it():
    refined = sheet(MaximumLevel=9, CellLimit=2000)
    assert fetched(refined).GetNumberOfCells() <= 2000
    assert 0 < skdtesting.report(refined, "StoppedAtLevel") < 9
    assert skdtesting.report(refined, "EstimatedCells") > 2000
    assert skdtesting.report(refined, "MemoryBytes") > 1e5


def test_the_tree_is_kept():
    refined = sheet()
    fetched(refined)
    assert skdtesting.report(refined, "TreesBuilt") == 1
    refined.MaximumLevel = 4
    fetched(refined)
    assert skdtesting.report(refined, "TreesBuilt") == 0


skdtesting.run_tests(globals())
