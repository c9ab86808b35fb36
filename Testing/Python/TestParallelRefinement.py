# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes and grids refined in two and three processes of pvbatch, each a piece, are together those
that one makes, cell for cell. Run without an argument this starts them; with the name of a file it
is one of them, and writes its part of the answers there."""

import itertools
import os
import shutil
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdpieces
import skdtesting

BALANCES = ("None", "Face", "Edge", "Corner")
ONE_BASE_CELL = 16 # the grid that one process has all of


def rows_of(proxy, names):
    """A row for each cell of this process: its corners in order, how many of them hang, and arrays."""
    proxy.UpdatePipeline()
    data = proxy.GetClientSideObject().GetOutputDataObject(0)
    count = data.GetNumberOfCells()
    rows = numpy.full((count, 25 + len(names)), -99.0)
    if count == 0:
        return rows
    points, places = numpy.unique(
        vtk_to_numpy(data.GetPoints().GetData()), axis=0, return_inverse=True)
    hanging = vtk_to_numpy(data.GetPointData().GetArray("SkdHanging"))
    cells = data.GetPolys() if data.IsA("vtkPolyData") else data.GetCells()
    starts = vtk_to_numpy(cells.GetOffsetsArray())
    ids = vtk_to_numpy(cells.GetConnectivityArray())
    sizes = numpy.diff(starts)
    for size in numpy.unique(sizes):
        of_size = numpy.where(sizes == size)[0]
        corners = ids[starts[of_size][:, None] + numpy.arange(size)]
        in_order = numpy.sort(places.ravel()[corners], axis=1)
        rows[of_size, :3 * size] = points[in_order].reshape(len(of_size), 3 * size)
        rows[of_size, 24] = hanging[corners].sum(axis=1)
    for i, name in enumerate(names):
        rows[:, 25 + i] = vtk_to_numpy(data.GetCellData().GetArray(name))
    return rows


def sphere(radius, **arguments):
    """A source whose cells have the same ids on any number of processes."""
    return skdpieces.source("sphere", "runs", radius=radius, **arguments)


# What each process runs to have its share of the tetrahedra. (RedistributeDataSet would do, but hands
# data over as XML with appended arrays, which VTK 9.2 cannot read with today's expat.)
TETRAHEDRA = """
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersCore import vtkThreshold
try:
    from vtkmodules.vtkFiltersCore import vtkGenerateIds  # VTK 9.4
except ImportError:
    from vtkmodules.vtkFiltersCore import vtkIdFilter as vtkGenerateIds
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkParallelCore import vtkMultiProcessController

reader = vtkXMLUnstructuredGridReader()
reader.SetFileName("%s")
cut = vtkDataSetTriangleFilter()
cut.SetInputConnection(reader.GetOutputPort())
cut.Update()
controller = vtkMultiProcessController.GetGlobalController()
size = controller.GetNumberOfProcesses() if controller else 1
rank = controller.GetLocalProcessId() if controller else 0
count = cut.GetOutput().GetNumberOfCells()
numbered = vtkGenerateIds()
numbered.SetInputConnection(cut.GetOutputPort())
numbered.SetCellIdsArrayName("Number")
share = vtkThreshold()
share.SetInputConnection(numbered.GetOutputPort())
share.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, "Number")
share.SetLowerThreshold(count * rank // size)
share.SetUpperThreshold(count * (rank + 1) // size - 1)
share.Update()
self.GetOutput().ShallowCopy(share.GetOutput())
"""
IN_PIECES = """
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
self.GetExecutive().GetOutputInformation(0).Set(vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST(), 1)
"""


def meshes():
    """A surface, hexahedra (with ghost cells in parallel) and tetrahedra, in pieces."""
    from paraview import simple

    bricks = simple.Wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3])
    return [
        simple.Contour(Input=bricks, ContourBy="RTData", Isosurfaces=[190]),
        bricks,
        simple.ProgrammableSource(OutputDataSetType="vtkUnstructuredGrid",
            Script=TETRAHEDRA % os.path.join(skdtesting.DATA_DIR, "disk_flow.vtu"),
            ScriptRequestInformation=IN_PIECES),
    ]


def refined(mesh, **asked):
    from paraview import simple

    return rows_of(simple.SkdTreeMeshRefinement(
        Input=mesh, OutputPointsPrecision="Double", **asked), ["SkdLevel"])


def refined_by_rules():
    """By each rule, around a ball that is in several pieces."""
    from paraview import simple

    ball = sphere(0.7, center=(0.6, 0.1, 2.4), theta=8, phi=8)
    rules = [{"Method": "Bisection", "GrowingLayers": layers} for layers in (0, 2)]
    rules += [{"Method": "Regular", "Balance": balance, "GrowingLayers": layers}
        for balance, layers in itertools.product(BALANCES, (0, 1))]
    return [refined(mesh, Parts=ball, MaximumLevel=level, **rule)
        for rule in rules for mesh, level in zip(meshes(), (3, 2, 1))
        if level > 1 or rule["GrowingLayers"] == (rule.get("Balance") == "Edge")]


def refined_by_placements():
    from paraview import simple

    surface, bricks, flow = meshes()
    ball = sphere(0.7, center=(0.6, 0.1, 2.4), theta=8, phi=8)
    around = sphere(6.0, theta=32, phi=32)
    return [refined(mesh, Parts=ball, MaximumLevel=2, Method=method, **placement)
        for mesh in (surface, bricks)
        for method in ("Bisection", "Regular")
        for placement in ({"PointPlacement": "Sphere"},
            {"PointPlacement": "Surface", "Surface": around})]


def refined_by_criteria():
    """The other criteria, and the limit of cells."""
    from paraview import simple

    surface, bricks, _ = meshes()
    cone = simple.Cone(Height=4, Radius=1.4, Resolution=12, Center=[0.2, 0.3, 0.1])
    values = simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4])
    field = {"Field": values, "FieldArrays": ["RTData"]}
    asked = [
        {"Parts": cone, "DistanceBands": [0.4, 1]},
        {"Parts": cone, "InsideLevel": 2, "PartLevels": [0, 0]},
        {"Parts": cone, "RefineByNormalDeviation": 1, "MinimumSurfaceLevel": 1, "NormalDeviation": 20},
        {"FieldTest": "Difference", "FieldThreshold": 40, **field},
        {"FieldTest": "Gradient", "FieldThreshold": 25, **field},
        {"FieldTest": "Value", "FieldRange": [200, 220], **field},
        {"MinimumLevel": 3, "CellLimit": 5000},
    ]
    return [refined(mesh, MaximumLevel=2 + (i == 6), Method=method, Balance="Edge", **criterion)
        for i, criterion in enumerate(asked)
        for mesh in (surface, bricks) for method in ("Bisection", "Regular")]


def refined_in_common():
    """Several processes have some of the cells, which none marks as ghosts: one refines each."""
    cells = skdpieces.source("tetrahedra", "cuts, doubled", size=2)
    ball = skdpieces.source("sphere", "random", theta=12, phi=9)
    return [refined(mesh, MinimumLevel=3, MaximumLevel=3, CellLimit=limit, Method=method)
        for mesh, limit in ((cells, 10000), (ball, 2000)) for method in ("Bisection", "Regular")]


def refined_by_own_field():
    """By values in the adjacent cells of other processes, too, and relative to those of all."""
    cells = skdpieces.source("tetrahedra", "cuts", size=3)
    lines = skdpieces.source("wire", "cuts")
    asked = [{"FieldTest": test, "FieldThreshold": threshold, "RelativeFieldThreshold": relative}
        for test, threshold, relative in (("Difference", 0.2, 1), ("Gradient", 60, 0),
            ("Gradient", 2.0, 1), ("Second Difference", 0.3, 0))]
    asked.append({"FieldTest": "Value", "FieldRange": [0.8, 1.0], "RelativeFieldThreshold": 1})
    return [refined(mesh, FieldArrays=["Field"], MaximumLevel=2, Method="Regular",
            SourceDistribution=distribution, **criterion)
        for criterion in asked for mesh in (cells, lines)
        for distribution in ("Replicate", "Exchange")]


def grids():
    """Leaves, by each rule and for all criteria."""
    from paraview import simple

    cone = simple.Cone(Height=4, Radius=1.4, Resolution=12, Center=[0.2, 0.3, 0.1])
    values = simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4])
    field = {"Field": values, "FieldArrays": ["RTData"]}
    asked = [{"Balance": balance, "GrowingLayers": layers}
        for balance, layers in itertools.product(BALANCES, (0, 1))]
    asked += [
        {"DistanceBands": [0.5, 2]},
        {"InsideLevel": 3, "PartLevels": [0, 1], "Balance": "Corner"},
        {"RefineByNormalDeviation": 1, "MinimumSurfaceLevel": 1, "NormalDeviation": 20},
        {"FieldTest": "Difference", "FieldThreshold": 40, **field},
        {"FieldTest": "Gradient", "FieldThreshold": 25, **field},
        {"FieldTest": "Value", "FieldRange": [200, 220], **field},
        {"CellLimit": 2500},
        {"CellLimit": 2500, "Balance": "Face"},
        {"BaseDimensions": [1, 1, 1]},
    ]
    arrays = ["SkdLevel", "SkdCut", "SkdCandidates", "SkdInside", "SkdVolumeFraction", "SkdDistance"]
    return [rows_of(simple.SkdTreeAMR(Input=cone, OutputType="Unstructured Grid", MaximumLevel=3,
        ComputeInside=1, ComputeVolumeFraction=1, ComputeDistance=1,
        **{"BaseDimensions": [4, 3, 3], **criterion}), arrays) for criterion in asked]


def all_rows():
    return (grids() + refined_by_placements() + refined_by_criteria() + refined_by_rules()
        + refined_in_common() + refined_by_own_field())


def rows_of_two():
    """The cases of two processes, of all those of three."""
    return grids()


def sorted_rows(rows):
    return rows[numpy.lexsort(rows.T)]


if len(sys.argv) > 1:
    rows = rows_of_two() if "two" in sys.argv[1] else all_rows()
    numpy.savez(sys.argv[1] % skdtesting.process_id(), *rows)
elif shutil.which("mpiexec") is None or shutil.which("pvbatch") is None:
    skdtesting.skip("there is no mpiexec or no pvbatch")
else:
    alone = all_rows()
    for count, name in ((2, "two"), (3, "three")):
        file = skdtesting.temporary("refined_by_%s_%%d.npz" % name)
        skdtesting.run_in_parallel(os.path.abspath(__file__), file, count)
        parts = [list(numpy.load(file % process).values()) for process in range(count)]
        for case, (whole, *pieces) in enumerate(zip(alone, *parts)):
            together = numpy.vstack(pieces)
            assert together.shape == whole.shape, (count, case, together.shape, whole.shape)
            is_of_one = case == ONE_BASE_CELL
            assert (numpy.max([len(piece) for piece in pieces]) == len(whole)) == is_of_one, (count, case)
            numpy.testing.assert_array_equal(
                sorted_rows(together), sorted_rows(whole), str((count, case)))
