# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tree inside ParaView's own filters, and the tree drawn."""

import os

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, vtkUnstructuredGrid

import vtkskdtree

import skdtesting


def flow():
    return simple.OpenDataFile(os.path.join(skdtesting.DATA_DIR, "disk_flow.vtu"))


def trace(source, interpolator="Interpolator with Cell Locator"):
    tracer = simple.StreamTracer(Input=source, Vectors=["POINTS", "V"], SeedType="Line",
        InterpolatorType=interpolator, MaximumStreamlineLength=20)
    tracer.SeedType.Point1, tracer.SeedType.Point2 = [-4, -4, 1], [4, 4, 8]
    tracer.SeedType.Resolution = 20
    tracer.UpdatePipeline()
    return servermanager.Fetch(tracer)


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def test_streamlines_are_traced_on_it():
    plain = trace(flow())
    ours = trace(simple.SkdTreeAttach(Input=flow()))
    assert ours.GetNumberOfCells() >= plain.GetNumberOfCells() > 20
    assert ours.GetNumberOfPoints() > 0.99 * plain.GetNumberOfPoints()
    count = min(len(points_of(ours)), len(points_of(plain)), 200)
    numpy.testing.assert_allclose(points_of(ours)[:count], points_of(plain)[:count], atol=1e-2)


def test_it_has_the_locator_and_keeps_the_tree():
    reader = vtkUnstructuredGrid()
    reader.ShallowCopy(servermanager.Fetch(flow()))
    attach = vtkskdtree.vtkSkdTreeAttach()
    attach.SetInputDataObject(reader)
    attach.Update()
    locator = attach.GetOutputDataObject(0).GetCellLocator()
    assert locator.GetClassName() == "vtkSkdTreeCellLocator", locator
    assert locator.GetDataSet() is attach.GetOutputDataObject(0)
    assert reader.GetCellLocator() is None
    assert attach.GetTreesBuilt() == 1
    assert locator.FindCell([5, 0, 2]) >= 0
    reader.Modified()
    attach.Update()
    assert attach.GetTreesBuilt() == 0
    attach.SetLazyBuild(True)
    attach.Update()
    assert attach.GetTreesBuilt() == 1
    assert attach.GetOutputDataObject(0).GetCellLocator().GetLazyBuild()


def polyhedral(data):
    """The same mesh with every cell a polyhedron."""
    mesh = vtkUnstructuredGrid()
    mesh.SetPoints(data.GetPoints())
    mesh.GetPointData().ShallowCopy(data.GetPointData())
    for i in range(data.GetNumberOfCells()):
        cell = data.GetCell(i)
        faces = [cell.GetNumberOfFaces()]
        for face in (cell.GetFace(k) for k in range(cell.GetNumberOfFaces())):
            ids = face.GetPointIds()
            faces += [ids.GetNumberOfIds()] + [ids.GetId(k) for k in range(ids.GetNumberOfIds())]
        mesh.InsertNextCell(VTK_POLYHEDRON, as_id_list(faces))
    return mesh


def as_id_list(numbers):
    ids = vtkIdList()
    for number in numbers:
        ids.InsertNextId(number)
    return ids


def test_streamlines_are_traced_on_polyhedra():
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(polyhedral(servermanager.Fetch(flow())))
    plain = trace(producer)
    ours = trace(simple.SkdTreeAttach(Input=producer))
    assert ours.GetNumberOfCells() >= plain.GetNumberOfCells() > 20
    assert ours.GetNumberOfPoints() > 0.99 * plain.GetNumberOfPoints()
    count = min(len(points_of(ours)), len(points_of(plain)), 50)
    numpy.testing.assert_allclose(points_of(ours)[:count], points_of(plain)[:count], atol=1e-2)


def test_in_a_time_series_the_tree_is_kept():
    files = []
    for step in range(3):
        scaled = simple.Calculator(
            Input=flow(), ResultArrayName="V", Function="V*%d" % (step + 1))
        files.append(skdtesting.temporary("attach_%d.vtu" % step))
        simple.SaveData(files[-1], proxy=scaled, DataMode="Binary")
    series = simple.XMLUnstructuredGridReader(FileName=files)
    attached = simple.SkdTreeAttach(Input=series)
    built, lengths = [], []
    for step in range(3):
        attached.UpdatePipeline(step)
        built.append(attached.GetClientSideObject().GetTreesBuilt())
        lengths.append(trace(attached).GetNumberOfPoints())
    assert built == [1, 0, 0], built
    assert min(lengths) > 100, lengths


def test_images_and_blocks_are_passed():
    parts = simple.GroupDatasets(Input=[simple.Wavelet(), flow(), simple.Sphere()])
    attached = simple.SkdTreeAttach(Input=parts)
    attached.UpdatePipeline()
    before, after = parts.GetDataInformation(), attached.GetDataInformation()
    assert before.GetNumberOfCells() == after.GetNumberOfCells() > 0
    assert before.GetCompositeDataSetType() == after.GetCompositeDataSetType()


def test_the_tree_is_drawn_level_by_level():
    source = flow()
    source.UpdatePipeline()
    drawn = simple.SkdTreeRepresentation(Input=source, Level=0)
    cells = source.GetDataInformation().GetNumberOfCells()
    counts = []
    for level in (0, 1, 3, -1, 64):
        drawn.Level = level
        drawn.UpdatePipeline()
        counts.append(drawn.GetDataInformation().GetNumberOfCells())
    assert counts == [6, 12, 48, 6 * cells, 6 * cells], counts
    table = servermanager.Fetch(drawn, idx=1)
    row = {table.GetColumnName(i): table.GetValue(0, i).ToDouble()
           for i in range(table.GetNumberOfColumns())}
    assert row["Cells"] == cells and row["PaperNodes"] == 2 * cells - 1
    assert row["PaperDepth"] == numpy.ceil(numpy.log2(cells))
    assert 0 < row["Overlap"] < 1 and 1 < row["Cost"] < cells
    assert row["Bytes"] > 20 * cells and row["Nodes"] < cells


def test_of_blocks_each_has_its_tree():
    parts = simple.GroupDatasets(Input=[simple.Sphere(), simple.Wavelet()])
    drawn = simple.SkdTreeRepresentation(Input=parts, Level=2)
    drawn.UpdatePipeline()
    assert drawn.GetDataInformation().GetNumberOfCells() == 2 * 4 * 6
    assert drawn.CellData["BlockIndex"].GetRange() == (1, 2)
    assert servermanager.Fetch(drawn, idx=1).GetNumberOfRows() == 2


skdtesting.run_tests(globals())
