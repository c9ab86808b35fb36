# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Remapping and mesh adaptation in three processes of pvbatch give what one gives, integrals and the
file of weights included. Run without an argument this starts them; with the name of a file it is one of them, and writes its
part of the answers there."""

import os
import shutil
import struct
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

import skdpieces
import skdtesting

PROCESSES = 3
PARTITIONS = ("round robin, global ids", "cuts, ghosts", "cuts, doubled", "one process")
COLUMNS = 10 # of the rows of cells
INTEGRALS = ("SourceIntegral", "OverlapIntegral", "TargetIntegral", "Coverage")


def output(proxy):
    """Of this process alone."""
    proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(0)


def rows_of(data, name):
    """A row for each cell of this process: where it is and what it got."""
    if data.IsA("vtkMultiBlockDataSet"):
        blocks = [data.GetBlock(i) for i in range(data.GetNumberOfBlocks())]
        return numpy.vstack([rows_of(block, name) for block in blocks if block is not None])
    array = data.GetCellData().GetArray(name)
    rows = [data.GetCell(i).GetBounds() + middle_of(data.GetCell(i)) + (array.GetTuple1(i),)
        for i in range(data.GetNumberOfCells())]
    return numpy.array(rows).reshape(-1, COLUMNS)


def middle_of(cell):
    """The mean of its points: the tetrahedra of a cube have the same bounds."""
    return tuple(vtk_to_numpy(cell.GetPoints().GetData()).mean(axis=0))


def integrals(data):
    return numpy.array(
        [vtk_to_numpy(data.GetFieldData().GetArray("SkdReport" + name)) for name in INTEGRALS])


def with_cell_data(mesh, function="2+coordsX*coordsY+coordsZ"):
    from paraview import simple

    field = simple.Calculator(Input=mesh, Function=function, ResultArrayName="field")
    return simple.PointDatatoCellData(Input=field)


def remapped(mesh, source, method="Conservative First Order", **asked):
    from paraview import simple

    return output(simple.SkdTreeRemap(Input=mesh, Source=source, Method=method, **asked))


def assured(mesh, source):
    """Of second order, clipped, with the sum given back wherever there is room."""
    return remapped(
        mesh, source, "Conservative Second Order", Limiter="Clip And Assured Sum")


def sphere(theta, phi):
    from paraview import simple

    return simple.Sphere(Radius=1, ThetaResolution=theta, PhiResolution=phi)


def all_doubled(step):
    """Processes have cells of the input in common, which none marks as ghosts: they count once."""
    from paraview import simple

    cells = skdpieces.source("tetrahedra", "cuts, doubled", size=3)
    ball = skdpieces.source("sphere", "random", theta=20, phi=14)
    around = skdpieces.source("sphere", "random", theta=16, phi=12, radius=4.01)
    image = simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4])
    at_points = simple.Calculator(
        Input=image, Function="2+coordsX*coordsY", ResultArrayName="field")
    return {
        "doubled, assured": assured(cells, with_cell_data(image, step)),
        "doubled, of points": remapped(cells, at_points),
        "doubled ball as curved": remapped(ball, with_cell_data(around),
            Geometry="Curved Surface", Normalization="Whole"),
        "doubled ball": remapped(ball, with_cell_data(around), GenerateWeights=1)
    }


def all_remapped():
    """The input in pieces on both processes: a volume, a sphere; and all on one of them."""
    from paraview import simple

    image = simple.Wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3])
    finer = with_cell_data(simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4]))
    ball = with_cell_data(sphere(30, 20))
    plane = simple.Plane(XResolution=5, YResolution=4)
    tiles = with_cell_data(simple.Plane(XResolution=7, YResolution=9))
    # Gradients at a jump go beyond the values, in target cells that are smaller than the source's.
    step = "if(coordsX+0.3*coordsY>0.05,1,0)"
    jump = with_cell_data(simple.Plane(XResolution=4, YResolution=3), step)
    # Of these blocks the first process has one and the last the other, and the second none.
    blocks = simple.GroupDatasets(Input=[plane, skdpieces.source(
        "tiles", "one process", count=6, corner=(-0.4, -0.3, 0), first=(0.5, -0.3, 0),
        second=(-0.4, 0.45, 0))])
    return {
        **all_doubled(step),
        "plane, assured": assured(plane, jump),
        "blocks, assured": assured(blocks, jump),
        "volume, assured": assured(
            skdpieces.source("tetrahedra", "cuts", size=3), with_cell_data(finer, step)),
        "volume": remapped(image, finer),
        "sphere": remapped(sphere(20, 14), ball),
        "sphere as curved": remapped(
            sphere(20, 14), ball, Geometry="Curved Surface", Normalization="Whole"),
        "plane": remapped(plane, tiles)
    }


def write_files():
    for partition in PARTITIONS:
        mesh = skdpieces.source("sphere", partition, theta=20, phi=14)
        source = skdpieces.source("sphere", partition, theta=16, phi=12)
        remapped(mesh, source, WeightsFileName=name_of_file(partition, skdpieces.process()[1]))


def adapted():
    from paraview import simple

    data = output(simple.SkdTreeMeshAdaptation(Input=simple.Plane(XResolution=12, YResolution=12),
        Source=with_cell_data(simple.Plane(XResolution=40, YResolution=40)), MaximumIterations=3,
        Strength=3))
    return rows_of(data, "SkdMonitor") if data.GetNumberOfCells() > 0 else numpy.empty((0, COLUMNS))


def dealt(mesh, pieces=5):
    """What a reader of pieces that cells are dealt to at random gives this process: every other one, as
    many as there are processes, put together. Points where they meet are there once a piece."""
    rank, processes = skdpieces.process()
    owners = numpy.random.default_rng(3).integers(pieces, size=mesh.GetNumberOfCells())
    append = vtkAppendPolyData()
    append.SetOutputPointsPrecision(vtkAlgorithm.DOUBLE_PRECISION)
    for piece in range(rank, pieces, processes):
        append.AddInputData(skdpieces.extract(mesh, numpy.flatnonzero(owners == piece)))
    append.Update()
    return append.GetOutput()


def adapted_to_itself():
    """Input and Source come of one reader; all that is found, to the last bit."""
    from paraview import simple

    tiles = skdpieces.tiles(16)
    x, y, _ = vtk_to_numpy(tiles.GetPoints().GetData()).T
    field = numpy_to_vtk(1 + numpy.exp(-40 * (numpy.hypot(x - 0.4, y - 0.3) - 0.3)**2), deep=1)
    field.SetName("ring")
    tiles.GetPointData().AddArray(field)
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(dealt(tiles))
    data = output(simple.SkdTreeMeshAdaptation(Input=producer, Source=producer, FieldArray="ring",
        Monitor="Value", MaximumIterations=2))
    report = data.GetFieldData()
    if skdpieces.process()[1] > 1:
        assert report.GetArray("SkdReportSourceExchanged").GetValue(0) == 0
    if data.GetNumberOfCells() == 0:
        return numpy.empty((0, COLUMNS))
    measures = [report.GetArray("SkdReportEquidistribution" + name).GetValue(0)
        for name in ("Before", "After", "OfField")]
    measures.append(report.GetArray("SkdReportSamples").GetValue(0))
    return numpy.vstack([rows_of(data, "SkdFieldMean"),
        measures + [0.0] * (COLUMNS - len(measures))])


def all_answers():
    write_files()
    answers = {"adapted": adapted(), "adapted to itself": adapted_to_itself()}
    for name, data in all_remapped().items():
        has_cells = data.GetNumberOfCells() > 0
        answers[name] = rows_of(data, "field") if has_cells else numpy.empty((0, COLUMNS))
        answers[name + " integrals"] = integrals(data)
    return answers


def sorted_rows(rows):
    return rows[numpy.lexsort(numpy.round(rows, 4).T + 0.0)]


def once(rows):
    """One of the rows of each cell, which are all alike."""
    _, first, cells = numpy.unique(
        numpy.round(rows[:, :-1], 6) + 0.0, axis=0, return_index=True, return_inverse=True)
    numpy.testing.assert_allclose(rows, rows[first][cells.ravel()], rtol=0, atol=1e-13)
    return rows[first]


def is_sum(name):
    """Whether values depend on sums over processes."""
    return name.endswith("assured") or name.startswith("doubled")


def check(alone, parts):
    for name, whole in alone.items():
        # Points of a sphere's pieces are rounded otherwise, in single precision.
        is_rounded = name.startswith("sphere")
        if name.endswith("integrals"):
            for part in parts[1:]:
                numpy.testing.assert_array_equal(parts[0][name], part[name])
            numpy.testing.assert_allclose(
                parts[0][name], whole, rtol=1e-5 if is_rounded else 1e-14, atol=1e-13)
            assert (whole[3] > 0.9).all()
        else:
            together = numpy.vstack([part[name] for part in parts])
            if name.startswith("doubled"):
                assert len(together) > len(whole)
                together = once(together)
            numpy.testing.assert_allclose(
                sorted_rows(together), sorted_rows(whole), rtol=0,
                atol=1e-5 if is_rounded else 1e-13 if is_sum(name) else 0)
    assert_sums_are_kept(alone)
    for name in ("volume", "sphere"):
        assert min(len(part[name]) for part in parts) > 0
    assert sorted(len(part["plane"]) for part in parts) == [0, 0, 20]
    assert sorted(len(part["blocks, assured"]) for part in parts) == [0, 20, 48]


def assert_sums_are_kept(answers):
    for name in ("plane", "blocks", "volume", "doubled"):
        _, overlap, target, _ = answers[name + ", assured integrals"]
        numpy.testing.assert_allclose(target, overlap, rtol=1e-13)


def read_netcdf(name):
    """The variables of a file in the classic format with 64-bit offsets."""
    with open(name, "rb") as file:
        data = file.read()
    at = 8

    def number(size=4):
        nonlocal at
        at += size
        return int.from_bytes(data[at - size:at], "big")

    def skip(size):
        nonlocal at
        at += (size + 3) // 4 * 4
        return data[at - (size + 3) // 4 * 4:][:size]

    def text():
        return skip(number()).decode()

    def many():
        return number() and range(number()) or range(number())

    def skip_attributes():
        for _ in many():
            text()
            size = {2: 1, 4: 4, 6: 8}[number()]
            skip(size * number())

    sizes = [(text(), number())[1] for _ in many()]
    skip_attributes()
    variables = {}
    for _ in many():
        name = text()
        shape = [sizes[number()] for _ in range(number())]
        skip_attributes()
        kind = {4: ">i4", 6: ">f8"}[number()]
        number()
        first = number(8)
        variables[name] = numpy.frombuffer(data, kind, int(numpy.prod(shape)), first)
    return variables


def in_order(file, suffix):
    """The cells of a grid by their centres."""
    centres = [numpy.round(file[axis + suffix], 6) for axis in ("xc", "yc")]
    return numpy.lexsort(centres)


def check_files(names):
    """The weights of a file, its areas and shares, are those of one process, in another order."""
    of_one, of_all = (read_netcdf(name) for name in names)
    assert list(of_one) == list(of_all)
    matrices = []
    for file in (of_one, of_all):
        assert len(file["S"]) > 500 and (numpy.diff(file["row"]) >= 0).all()
        matrix = numpy.zeros((len(file["area_b"]), len(file["area_a"])))
        matrix[file["row"] - 1, file["col"] - 1] = file["S"]
        matrices.append(matrix[in_order(file, "_b")][:, in_order(file, "_a")])
    numpy.testing.assert_allclose(*matrices, rtol=1e-11, atol=1e-13)
    for name in ("area_a", "area_b", "frac_a", "frac_b", "mask_b", "xv_b", "yc_a"):
        columns = []
        for file in (of_one, of_all):
            order = in_order(file, name[-2:])
            columns.append(file[name].reshape(len(order), -1)[order])
        numpy.testing.assert_allclose(*columns, rtol=1e-11, atol=1e-11, err_msg=name)
    if "global" in names[1]:
        numpy.testing.assert_array_equal(of_one["row"], of_all["row"])
        numpy.testing.assert_array_equal(of_one["col"], of_all["col"])


def name_of_file(partition, processes):
    return skdtesting.temporary(f"weights {partition} of {processes}.nc")


def remove_files():
    for partition in PARTITIONS:
        for processes in (1, PROCESSES):
            for share in ("", *(f"_{rank}" for rank in range(PROCESSES))):
                name = name_of_file(partition, processes).replace(".nc", share + ".nc")
                if os.path.exists(name):
                    os.remove(name)


if len(sys.argv) > 1:
    numpy.savez(sys.argv[1] % skdtesting.process_id(), **all_answers())
elif shutil.which("mpiexec") is None or shutil.which("pvbatch") is None:
    skdtesting.skip("there is no mpiexec or no pvbatch")
else:
    remove_files()
    file = skdtesting.temporary("remapped%d.npz")
    skdtesting.run_in_parallel(os.path.abspath(__file__), file, PROCESSES)
    check(all_answers(), [dict(numpy.load(file % rank)) for rank in range(PROCESSES)])
    for partition in PARTITIONS:
        files = [name_of_file(partition, processes) for processes in (1, PROCESSES)]
        if os.path.exists(files[0]):  # not in a build without netCDF
            check_files(files)
            assert not os.path.exists(files[1].replace(".nc", "_0.nc"))
