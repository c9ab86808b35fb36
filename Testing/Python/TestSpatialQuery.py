# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The spatial query by ParaView's simple API."""

import os

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdtesting

SHAPES = ["Box", "Sphere", "Plane", "Line", "Source Points", "Source Cells"]
RELATIONS = ["Exact Match", "Overlap", "Enclosure", "Containment", "Adjacency", "Nearest"]


def flow():
    reader = simple.OpenDataFile(os.path.join(skdtesting.DATA_DIR, "disk_flow.vtu"))
    reader.UpdatePipeline()  # as the GUI does: shapes begin in the bounds
    return reader


def cell_ids(query):
    simple.UpdatePipeline(proxy=query)
    array = servermanager.Fetch(query, idx=0).GetCellData().GetArray("SkdCellId")
    return vtk_to_numpy(array)


def table(query):
    simple.UpdatePipeline(proxy=query)
    fetched = servermanager.Fetch(query, idx=2)
    return {
        fetched.GetColumnName(i): vtk_to_numpy(fetched.GetColumn(i))
        for i in range(fetched.GetNumberOfColumns())
    }


def test_defaults_give_a_part_of_the_input():
    query = simple.SkdTreeSpatialQuery(Input=flow())
    assert query.Relation == "Overlap" and query.Shape == "Box" and query.Exact == 1
    assert query.NumberOfNearestCells == 1 and query.SharedPart == "Point"
    bounds = query.Input.GetDataInformation().GetBounds()
    middle = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
    half = [0.5 * (bounds[2 * i + 1] - bounds[2 * i]) for i in range(3)]
    numpy.testing.assert_allclose(list(query.BoxPosition), middle)
    numpy.testing.assert_allclose(list(query.BoxLength), half)
    cells = query.Input.GetDataInformation().GetNumberOfCells()
    assert 0 < len(cell_ids(query)) < cells


def test_every_shape_finds_something_by_default():
    source = simple.Sphere(Radius=4, Center=[0, 0, 2])
    for shape in SHAPES:
        query = simple.SkdTreeSpatialQuery(Input=flow(), Source=source, Shape=shape)
        found = cell_ids(query)
        assert 0 < len(found) < query.Input.GetDataInformation().GetNumberOfCells(), shape
        assert (numpy.diff(found) > 0).all()


def test_all_relations_and_shapes():
    source = simple.Wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3])
    for shape in SHAPES:
        counts = {}
        for relation in RELATIONS:
            query = simple.SkdTreeSpatialQuery(
                Input=source, Source=source, Shape=shape, Relation=relation)
            exact = set(cell_ids(query))
            counts[relation] = len(exact)
            query.Exact = 0
            assert exact <= set(cell_ids(query)), (shape, relation)
        assert counts["Overlap"] >= max(
            counts[name] for name in ("Exact Match", "Enclosure", "Containment", "Adjacency"))
        assert counts["Nearest"] > 0


def test_neighbours_of_cells():
    grid = simple.Wavelet(WholeExtent=[0, 3, 0, 3, 0, 3])
    middle = simple.Wavelet(WholeExtent=[1, 2, 1, 2, 1, 2])
    for part, count in (("Point", 26), ("Edge", 18), ("Face", 6)):
        query = simple.SkdTreeSpatialQuery(
            Input=grid, Source=middle, Shape="Source Cells", Relation="Adjacency", SharedPart=part)
        assert len(cell_ids(query)) == count


def test_nearest_is_what_closest_point_says():
    mesh = flow()
    points = simple.Sphere(Radius=9)
    query = simple.SkdTreeSpatialQuery(
        Input=mesh, Source=points, Shape="Source Points", Relation="Nearest")
    closest = simple.SkdTreeClosestPoint(Input=points, Source=mesh)
    pairs = table(query)
    # Cells share points and faces: which of them is nearest may depend on the last digit.
    numpy.testing.assert_allclose(
        pairs["SkdMinimumDistance"], skdtesting.point_array(closest, "SkdDistance"), atol=1e-12)
    same = pairs["SkdCellId"] == skdtesting.point_array(closest, "SkdClosestCellId")
    assert same.mean() > 0.8
    assert (pairs["SkdOptimisticDistance"] <= pairs["SkdMinimumDistance"]).all()
    assert (pairs["SkdMaximumDistance"] <= pairs["SkdPessimisticDistance"]).all()


def test_the_selection_is_one_for_extract_selection():
    query = simple.SkdTreeSpatialQuery(Input=flow())
    extracted = simple.ExtractSelection(Input=query.Input, Selection=simple.OutputPort(query, 1))
    extracted.UpdatePipeline()
    assert extracted.GetDataInformation().GetNumberOfCells() == len(cell_ids(query)) > 0


def test_composite_inputs():
    parts = simple.GroupDatasets(Input=[simple.Wavelet(), flow()])
    query = simple.SkdTreeSpatialQuery(Input=parts, Shape="Sphere", SphereCenter=[0.1, 0, 0],
        SphereRadius=4)
    query.UpdatePipeline()
    information = query.GetDataInformation()
    assert information.GetCompositeDataClassName() == "vtkMultiBlockDataSet"
    assert set(table(query)["SkdBlockIndex"]) == {1, 2}
    extracted = simple.ExtractSelection(Input=parts, Selection=simple.OutputPort(query, 1))
    extracted.UpdatePipeline()
    assert extracted.GetDataInformation().GetNumberOfCells() == information.GetNumberOfCells()


def test_the_tree_is_built_when_the_shape_moves_and_kept():
    query = simple.SkdTreeSpatialQuery(Input=flow(), Shape="Plane")
    query.UpdatePipeline()
    assert skdtesting.report(query, "TreesBuilt") == 0
    for normal, built in (([0, 1, 1], 1), ([1, 1, 0], 0)):
        query.PlaneNormal = normal
        query.UpdatePipeline()
        assert skdtesting.report(query, "TreesBuilt") == built


skdtesting.run_tests(globals())
