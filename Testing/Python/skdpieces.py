# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes that lie in pieces on several processes, as a simulation leaves them: their source gives
each process its own piece, whatever piece the pipeline asks for. In one process it gives all."""

import functools
import os
import pickle
import shutil
import sys

import numpy
import skdtesting
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_LINE, VTK_QUADRATIC_TRIANGLE, VTK_VERTEX,
    vtkDataSetAttributes, vtkImageData, vtkPolyData, vtkUnstructuredGrid)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import (vtkAppendPolyData, vtkCleanPolyData, vtkElevationFilter,
    vtkPointDataToCellData, vtkPolyDataNormals)
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter, vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkFiltersSources import vtkLineSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

try:
    from vtkmodules.vtkFiltersCore import vtkExtractCells
except ImportError: # VTK 9.1
    from vtkmodules.vtkFiltersExtraction import vtkExtractCells

# Cells sorted along x and cut into runs; runs of ids; every n-th; all on the last process; runs on
# every other process; with the neighbours on other processes, marked as ghosts or not; all of it
# everywhere; by global ids; and at random, some on several. There is "cuts, mixed global ids", too, in
# whose pieces ids do not ascend.
PARTITIONS = ("cuts", "runs", "round robin", "one process", "some empty", "cuts, ghosts",
    "cuts, doubled", "everywhere", "round robin, global ids", "random")

# If a list, the sources that source() makes are added to it, each with its mesh.
MADE = None


def sphere(radius=4.0, center=(0.0, 0.0, 0.0), theta=24, phi=24, has_normals=True):
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetCenter(center)
    source.SetThetaResolution(theta)
    source.SetPhiResolution(phi)
    field = vtkElevationFilter()
    field.SetInputConnection(source.GetOutputPort())
    field.Update()
    if not has_normals:
        field.GetOutput().GetPointData().RemoveArray("Normals")
    return field.GetOutput()


def spike(end=(1e12, 0.0, 0.0)):
    """A sphere with a triangle that reaches far away."""
    surface = vtkPolyData()
    surface.DeepCopy(sphere(has_normals=False))
    far = surface.GetPoints().InsertNextPoint(*end)
    surface.GetPolys().InsertNextCell(3, (0, 2, far))
    surface.GetPointData().Initialize()
    return surface


def tetrahedra(size=4):
    """With the field of ParaView's Wavelet."""
    image = vtkRTAnalyticSource()
    image.SetWholeExtent(-size, size, -size, size, -size, size)
    cells = vtkDataSetTriangleFilter()
    cells.SetInputConnection(image.GetOutputPort())
    cells.Update()
    cells.GetOutput().GetPointData().GetArray("RTData").SetName("Field")
    return cells.GetOutput()


def tiles(count=9, corner=(0.0, 0.0, 0.0), first=(1.0, 0.0, 0.0), second=(0.0, 1.0, 0.0)):
    """A parallelogram from a corner to two others, with a field at its points and in its cells."""
    source = vtkPlaneSource()
    source.SetOrigin(*corner)
    source.SetPoint1(*first)
    source.SetPoint2(*second)
    source.SetResolution(count, count + 2)
    source.SetOutputPointsPrecision(vtkAlgorithm.DOUBLE_PRECISION)
    field = vtkElevationFilter()
    field.SetLowPoint(*corner)
    field.SetHighPoint(first[0] + 0.3, first[1] + 0.7, first[2] + 1.0)
    field.SetInputConnection(source.GetOutputPort())
    of_cells = vtkPointDataToCellData()
    of_cells.PassPointDataOn()
    of_cells.SetInputConnection(field.GetOutputPort())
    of_cells.Update()
    for name in ("Normals", "TextureCoordinates"):
        of_cells.GetOutput().GetPointData().RemoveArray(name)
        of_cells.GetOutput().GetCellData().RemoveArray(name)
    return of_cells.GetOutput()


def block(corner=(0.0, 0.0, 0.0), size=(1.0, 1.0, 1.0), count=4, angle=0.0):
    """A closed box whose sides are squares of quadrilaterals, turned by degrees: of floats."""
    cells = vtkImageData()
    cells.SetDimensions(count + 1, count + 1, count + 1)
    cells.SetOrigin(*corner)
    cells.SetSpacing(*(length / count for length in size))
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(cells)
    welded = vtkCleanPolyData()
    welded.SetInputConnection(surface.GetOutputPort())
    oriented = vtkPolyDataNormals()
    oriented.SetInputConnection(welded.GetOutputPort())
    oriented.SplittingOff()
    oriented.AutoOrientNormalsOn()
    oriented.ComputePointNormalsOff()
    oriented.Update()
    if angle == 0.0:
        return oriented.GetOutput()
    rotation = vtkTransform()
    rotation.RotateWXYZ(angle, 1.0, 2.0, 3.0)
    turned = vtkTransformPolyDataFilter()
    turned.SetTransform(rotation)
    turned.SetOutputPointsPrecision(vtkAlgorithm.SINGLE_PRECISION)
    turned.SetInputConnection(oriented.GetOutputPort())
    turned.Update()
    return turned.GetOutput()


def crowd(count=12, step=2.1, shift=0.0):
    """Spheres in a row."""
    all_of_them = vtkAppendPolyData()
    for i in range(count):
        all_of_them.AddInputData(sphere(radius=0.5, center=(i * step / 2, shift, 0.3 * shift),
            theta=8, phi=8, has_normals=False))
    all_of_them.Update()
    return all_of_them.GetOutput()


def curved():
    """Quadratic triangles of an octahedron: a closed surface."""
    corners = [(3, 0, 0), (0, 3, 0), (-3, 0, 0), (0, -3, 0), (0, 0, 3), (0, 0, -3)]
    points, ids, grid = vtkPoints(), {}, vtkUnstructuredGrid()

    def add(x):
        if x not in ids:
            ids[x] = points.InsertNextPoint(*x)
        return ids[x]

    for i in range(4):
        for top in (4, 5):
            face = [corners[i], corners[(i + 1) % 4], corners[top]][:: 1 if top == 4 else -1]
            middles = [tuple((a + b) / 2 for a, b in zip(face[k], face[(k + 1) % 3]))
                for k in range(3)]
            grid.InsertNextCell(VTK_QUADRATIC_TRIANGLE, 6, [add(x) for x in face + middles])
    grid.SetPoints(points)
    return grid


def scatter(count=60):
    """Points alone, each of them a cell."""
    cloud = vtkUnstructuredGrid()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.random.default_rng(1).uniform(-4, 4, (count, 3)), deep=1))
    cloud.SetPoints(points)
    for i in range(count):
        cloud.InsertNextCell(VTK_VERTEX, 1, (i,))
    return cloud


def wire(count=30, end=(4.0, 3.0, 2.0)):
    """Straight lines end to end, with a field in them."""
    source = vtkLineSource()
    source.SetPoint1(0.0, 0.0, 0.0)
    source.SetPoint2(*end)
    source.SetResolution(count)
    source.SetOutputPointsPrecision(vtkAlgorithm.DOUBLE_PRECISION)
    source.Update()
    points = source.GetOutput().GetPoints()
    grid = vtkUnstructuredGrid()
    grid.SetPoints(points)
    for i in range(count):
        grid.InsertNextCell(VTK_LINE, 2, (i, i + 1))
    field = numpy_to_vtk(numpy.sin(numpy.arange(count)), deep=1)
    field.SetName("Field")
    grid.GetCellData().AddArray(field)
    return grid


def producer(mesh):
    """A ParaView source of it. (A programmable source would import numpy's names into the script.)"""
    from paraview import simple

    made = simple.servermanager.sources.TrivialProducer() # without the slow registration of simple's
    made.GetClientSideObject().SetOutput(mesh)
    return made


def source(maker, partition, **arguments):
    """A ParaView source of a mesh of one of the functions above, by its name."""
    mesh = piece(globals()[maker](**arguments), partition)
    made = producer(mesh)
    if MADE is not None:
        MADE.append((made, mesh))
    return made


def process():
    from paraview import servermanager

    module = servermanager.vtkProcessModule.GetProcessModule()
    return module.GetPartitionId(), module.GetNumberOfLocalPartitions()


def leave_documentation_out():
    """Of paraview.simple, whose import seeks that of each proxy among those of all: a third of the
    time in which a process starts."""
    from paraview import servermanager

    servermanager.ProxyNamespace.getDocumentation = lambda *_: ""


def run(script, runs, name, write, check):
    """The main program of a test of several processes. For each number of processes in `runs`, and the
    partitions there, starts itself in as many: each of these calls write(file, partitions) with a
    file of its own. The process that has started them calls check(file, processes, partitions)."""
    if len(sys.argv) > 1:
        leave_documentation_out()
        file, *partitions = sys.argv[1].split("|")
        write(file % process()[0], partitions)
    elif shutil.which("mpiexec") is None or shutil.which("pvbatch") is None:
        skdtesting.skip("there is no mpiexec or no pvbatch")
    else:
        leave_documentation_out()
        for processes, partitions in runs.items():
            file = skdtesting.temporary(f"{processes}_{name}")
            for rank in range(processes):
                if os.path.exists(file % rank):
                    os.remove(file % rank)
            skdtesting.run_in_parallel(
                os.path.abspath(script), "|".join((file, *partitions)), processes)
            check(file, processes, partitions)


@functools.cache
def alone(answers_of, partition):
    """What answers_of() a partition are in one process, by what follows its name in their titles."""
    return {title[len(partition):]: answer for title, answer in answers_of((partition,)).items()
        if title.startswith(partition)}


def whole(answers_of, partitions, with_own=()):
    """The answers of one process, which has the whole mesh however it would lie in pieces: those of one
    partition serve for all but these, and those with global ids."""
    return {partition + title: answer for partition in partitions for title, answer in alone(answers_of,
        partition if partition in with_own or partition.endswith("global ids") else "cuts").items()}


def tell(file, found):
    """Writes it for told(). (Of thousands of arrays NumPy's own files take much longer.)"""
    with open(file, "wb") as stream:
        pickle.dump(found, stream)


def told(file, processes):
    """What each of these has written."""
    found = []
    for rank in range(processes):
        with open(file % rank, "rb") as stream:
            found.append(pickle.load(stream))
    return found


def points_of(mesh, cell):
    ids = vtkIdList()
    mesh.GetCellPoints(int(cell), ids)
    return [ids.GetId(i) for i in range(ids.GetNumberOfIds())]


def locations(data, of_cells):
    """A row for each point, its coordinates, or for each cell, its bounds."""
    if not data.IsA("vtkUnstructuredGrid") and not data.IsA("vtkPolyData"):
        if of_cells:
            return numpy.array([data.GetCell(i).GetBounds() for i in range(data.GetNumberOfCells())])
        return numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    points = vtk_to_numpy(data.GetPoints().GetData()) if data.GetPoints() else numpy.empty((0, 3))
    if not of_cells:
        return points
    names = ("Cells",) if data.IsA("vtkUnstructuredGrid") else ("Verts", "Lines", "Polys", "Strips")
    bounds = [numpy.empty((0, 6))]
    for cells in (getattr(data, "Get" + name)() for name in names):
        if cells is not None and cells.GetNumberOfCells() > 0:
            corners = points[vtk_to_numpy(cells.GetConnectivityArray())]
            first = vtk_to_numpy(cells.GetOffsetsArray())[:-1]
            ends = [extreme.reduceat(corners, first) for extreme in (numpy.minimum, numpy.maximum)]
            bounds.append(numpy.stack(ends, axis=2).reshape(-1, 6))
    return numpy.vstack(bounds)


def owners(mesh, partition, processes):
    cells = numpy.arange(mesh.GetNumberOfCells())
    if partition.startswith("cuts"):
        middles = [sum(mesh.GetCell(cell).GetBounds()[:2]) for cell in cells]
        places = numpy.argsort(numpy.argsort(middles, kind="stable"))
        return places * processes // len(cells)
    if partition.startswith("round robin"):
        return cells % processes
    if partition == "random":
        return numpy.random.default_rng(len(cells)).integers(processes, size=len(cells))
    if partition == "one process":
        return 0 * cells + processes - 1
    if partition == "some empty":
        return cells * (processes // 2) // len(cells) * 2 + 1
    return cells * processes // len(cells)


def neighbours(mesh, own):
    """Whether each cell has a point of one of ours."""
    used = {point for cell in numpy.flatnonzero(own) for point in points_of(mesh, cell)}
    return numpy.array([any(point in used for point in points_of(mesh, cell))
        for cell in range(mesh.GetNumberOfCells())])


def set_global_ids(mesh):
    for data, number in ((mesh.GetPointData(), mesh.GetNumberOfPoints()),
        (mesh.GetCellData(), mesh.GetNumberOfCells())):
        ids = numpy_to_vtk(numpy.arange(number), deep=1)
        ids.SetName("GlobalIds")
        data.SetGlobalIds(ids)


def extract(mesh, cells):
    ids = vtkIdList()
    for cell in cells:
        ids.InsertNextId(int(cell))
    extraction = vtkExtractCells()
    extraction.SetInputData(mesh)
    extraction.SetCellList(ids)
    extraction.Update()
    grid = extraction.GetOutput()
    grid.GetCellData().RemoveArray("vtkOriginalCellIds")  # which a whole mesh does not have
    if not mesh.IsA("vtkPolyData"):
        return grid
    surface = vtkPolyData()
    surface.SetPoints(grid.GetPoints())
    surface.SetPolys(grid.GetCells())
    surface.GetPointData().ShallowCopy(grid.GetPointData())
    surface.GetCellData().ShallowCopy(grid.GetCellData())
    return surface


def in_order(mesh, order):
    """A copy whose cells are in this order."""
    copy = mesh.NewInstance()
    copy.SetPoints(mesh.GetPoints())
    copy.AllocateEstimate(len(order), 4)
    for cell in order:
        points = points_of(mesh, cell)
        copy.InsertNextCell(mesh.GetCellType(int(cell)), len(points), points)
    copy.GetPointData().ShallowCopy(mesh.GetPointData())
    from_data, to_data = mesh.GetCellData(), copy.GetCellData()
    for i in range(from_data.GetNumberOfArrays()):
        array = from_data.GetArray(i)
        ordered = numpy_to_vtk(vtk_to_numpy(array)[order], deep=1)
        ordered.SetName(array.GetName())
        is_global_id = from_data.GetGlobalIds() and from_data.GetGlobalIds().GetName() == array.GetName()
        (to_data.SetGlobalIds if is_global_id else to_data.AddArray)(ordered)
    return copy


def piece(mesh, partition):
    """This process's piece of a mesh that all processes have."""
    rank, processes = process()
    if partition.endswith("global ids"):
        set_global_ids(mesh)
    if partition == "everywhere" or processes == 1:
        return mesh
    own = owners(mesh, partition, processes) == rank
    if partition == "random":
        own |= numpy.random.default_rng(rank).random(len(own)) < 0.1
    if not own.any():
        return mesh.NewInstance()
    if partition.endswith("mixed global ids"): # which do not ascend
        part = extract(mesh, numpy.flatnonzero(own))
        return in_order(part, numpy.random.default_rng(7).permutation(part.GetNumberOfCells()))
    if not partition.endswith(("ghosts", "doubled")):
        return extract(mesh, numpy.flatnonzero(own))
    chosen = numpy.flatnonzero(neighbours(mesh, own))
    part = extract(mesh, chosen)
    if partition.endswith("ghosts"):
        marks = numpy.where(own[chosen], 0, vtkDataSetAttributes.DUPLICATECELL)
        array = numpy_to_vtk(marks.astype(numpy.uint8), deep=1, array_type=VTK_UNSIGNED_CHAR)
        array.SetName(vtkDataSetAttributes.GhostArrayName())
        part.GetCellData().AddArray(array)
    return part
