# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tree inside ParaView's own filters, and the tree drawn."""

import os

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints, vtkVersion
from vtkmodules.vtkCommonDataModel import (VTK_POLYHEDRON, VTK_TETRA, vtkDataObject, vtkImageData, vtkPolyData,
    vtkUnstructuredGrid)
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkFiltersFlowPaths import vtkParticleTracer
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter

import vtkskdtree

import skdtesting


def flow():
    return simple.OpenDataFile(os.path.join(skdtesting.DATA_DIR, "disk_flow.vtu"))


def trace(source):
    tracer = simple.StreamTracer(Input=source, Vectors=["POINTS", "V"], SeedType="Line",
        MaximumStreamlineLength=20)
    if "CellLocator" not in tracer.ListProperties():  # up to ParaView 6.1: the one that is attached
        tracer.InterpolatorType = "Interpolator with Cell Locator"
    elif source.SMProxy.GetXMLName() == "SkdTreeAttach":
        tracer.CellLocator = "SkdTreeCellLocator"
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


class Rotating(VTKPythonAlgorithmBase):
    """Tetrahedra that rotate, and the velocity of their points; one data set for all times if it is reused."""

    OMEGA, END = 0.3, 0.7

    def __init__(self, reused):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkUnstructuredGrid")
        image = vtkImageData()
        image.SetDimensions(9, 9, 4)
        image.SetOrigin(-1, -1, -0.3)
        image.SetSpacing(0.25, 0.25, 0.2)
        tetrahedra = vtkDataSetTriangleFilter()
        tetrahedra.SetInputData(image)
        tetrahedra.Update()
        self.grid = tetrahedra.GetOutput()
        self.start = points_of(self.grid).astype(float)
        self.reused = vtkUnstructuredGrid() if reused else None

    @classmethod
    def turned(cls, points, time):
        cosine, sine = numpy.cos(cls.OMEGA * time), numpy.sin(cls.OMEGA * time)
        return points @ numpy.array([[cosine, sine, 0], [-sine, cosine, 0], [0, 0, 1]])

    def RequestInformation(self, _request, _inputs, outputs):
        times = numpy.linspace(0, self.END, 8).tolist()
        info = outputs.GetInformationObject(0)
        info.Set(vtkStreamingDemandDrivenPipeline.TIME_STEPS(), times, len(times))
        info.Set(vtkStreamingDemandDrivenPipeline.TIME_RANGE(), [0, self.END], 2)
        return 1

    def RequestData(self, _request, _inputs, outputs):
        info = outputs.GetInformationObject(0)
        time = info.Get(vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP())
        if self.reused:
            info.Set(vtkDataObject.DATA_OBJECT(), self.reused)
        output = vtkUnstructuredGrid.GetData(outputs)
        places = self.turned(self.start, time)
        points = vtkPoints()
        points.SetData(numpy_to_vtk(places, deep=True))
        output.SetPoints(points)
        output.SetCells(VTK_TETRA, self.grid.GetCells())
        velocity = numpy_to_vtk(self.OMEGA * numpy.cross([0, 0, 1], places), deep=True)
        velocity.SetName("V")
        output.GetPointData().SetVectors(velocity)
        output.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), time)
        return 1


def test_particles_stay_in_a_mesh_that_rotates():
    if (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion()) == (9, 3):
        print("not with VTK 9.3, whose tracer crashes on this source with VTK's own locator, too")
        return
    seeds = vtkPolyData()
    seeds.SetPoints(vtkPoints())
    for radius in (0.2, 0.5, 0.7):
        seeds.GetPoints().InsertNextPoint(radius, 0.03, 0.011)
    for reused in (False, True):
        for topology in (vtkParticleTracer.DIFFERENT, vtkParticleTracer.SAME_TOPOLOGY):
            source = Rotating(reused)
            attach = vtkskdtree.vtkSkdTreeAttach()
            attach.SetInputConnection(source.GetOutputPort())
            tracer = vtkParticleTracer()
            tracer.SetInputConnection(0, attach.GetOutputPort())
            tracer.SetInputDataObject(1, seeds)
            tracer.SetInputArrayToProcess(0, 0, 0, 0, "V")
            tracer.SetMeshOverTime(topology)
            if hasattr(tracer, "SetCellLocator"):  # since VTK 9.7
                tracer.SetCellLocator(vtkskdtree.vtkSkdTreeCellLocator())
            else:
                tracer.SetInterpolatorTypeToCellLocator()
            tracer.UpdateTimeStep(Rotating.END)
            traced = tracer.GetOutput()
            begin = points_of(seeds)[vtk_to_numpy(traced.GetPointData().GetArray("InjectedPointId"))]
            assert traced.GetNumberOfPoints() == 3
            error = abs(points_of(traced) - Rotating.turned(begin.astype(float), Rotating.END)).max()
            assert error < 1e-6, (reused, topology, error)


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
