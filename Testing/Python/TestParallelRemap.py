# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Remapping and mesh adaptation in two processes of pvbatch give what one gives, integrals included.
Run without an argument this starts them; with the name of a file it is one of them, and writes its
part of the answers there."""

import os
import shutil
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdtesting

INTEGRALS = ("SourceIntegral", "OverlapIntegral", "TargetIntegral", "Coverage")


def output(proxy):
    """Of this process alone."""
    proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(0)


def rows_of(data, name):
    """A row for each cell of this process: where it is and what it got."""
    array = data.GetCellData().GetArray(name)
    rows = [data.GetCell(i).GetBounds() + (array.GetTuple1(i),)
        for i in range(data.GetNumberOfCells())]
    return numpy.array(rows).reshape(-1, 7)


def integrals(data):
    return numpy.array(
        [vtk_to_numpy(data.GetFieldData().GetArray("SkdReport" + name)) for name in INTEGRALS])


def with_cell_data(mesh):
    from paraview import simple

    field = simple.Calculator(
        Input=mesh, Function="2+coordsX*coordsY+coordsZ", ResultArrayName="field")
    return simple.PointDatatoCellData(Input=field)


def remapped(mesh, source, **asked):
    from paraview import simple

    return output(simple.SkdTreeRemap(
        Input=mesh, Source=source, Method="Conservative First Order", **asked))


def sphere(theta, phi):
    from paraview import simple

    return simple.Sphere(Radius=1, ThetaResolution=theta, PhiResolution=phi)


def all_remapped():
    """The input in pieces on both processes: a volume, a sphere; and all on one of them."""
    from paraview import simple

    image = simple.Wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3])
    finer = with_cell_data(simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4]))
    ball = with_cell_data(sphere(30, 20))
    plane = simple.Plane(XResolution=5, YResolution=4)
    tiles = with_cell_data(simple.Plane(XResolution=7, YResolution=9))
    file = skdtesting.temporary("parallel_weights.nc")
    return {
        "volume": remapped(image, finer),
        "sphere": remapped(sphere(20, 14), ball, WeightsFileName=file),
        "sphere as curved": remapped(
            sphere(20, 14), ball, Geometry="Curved Surface", Normalization="Whole"),
        "plane": remapped(plane, tiles)
    }


def adapted():
    from paraview import simple

    data = output(simple.SkdTreeMeshAdaptation(Input=simple.Plane(XResolution=12, YResolution=12),
        Source=with_cell_data(simple.Plane(XResolution=40, YResolution=40)), MaximumIterations=3,
        Strength=3))
    return rows_of(data, "SkdMonitor") if data.GetNumberOfCells() > 0 else numpy.empty((0, 7))


def all_answers():
    answers = {"adapted": adapted()}
    for name, data in all_remapped().items():
        has_field = data.GetCellData().HasArray("field")
        answers[name] = rows_of(data, "field") if has_field else numpy.empty((0, 7))
        answers[name + " integrals"] = integrals(data)
    return answers


def sorted_rows(rows):
    return rows[numpy.lexsort(numpy.round(rows, 4).T + 0.0)]


def check(alone, parts):
    for name, whole in alone.items():
        # Points of a sphere's pieces are rounded otherwise, in single precision.
        is_rounded = name.startswith("sphere")
        if name.endswith("integrals"):
            numpy.testing.assert_array_equal(parts[0][name], parts[1][name])
            numpy.testing.assert_allclose(
                parts[0][name], whole, rtol=1e-5 if is_rounded else 1e-14, atol=1e-13)
            assert (whole[3] > 0.9).all()
        else:
            together = numpy.vstack([part[name] for part in parts])
            numpy.testing.assert_allclose(
                sorted_rows(together), sorted_rows(whole), rtol=0, atol=1e-5 * is_rounded)
    for name in ("volume", "sphere"):
        assert min(len(part[name]) for part in parts) > 0
    assert sorted(len(part["plane"]) for part in parts) == [0, 20]


if len(sys.argv) > 1:
    numpy.savez(sys.argv[1] % skdtesting.process_id(), **all_answers())
elif shutil.which("mpiexec") is None or shutil.which("pvbatch") is None:
    skdtesting.skip("there is no mpiexec or no pvbatch")
else:
    files = [skdtesting.temporary(f"parallel_weights{part}.nc") for part in ("", "_0", "_1")]
    for name in files:
        if os.path.exists(name):
            os.remove(name)
    file = skdtesting.temporary("remapped%d.npz")
    skdtesting.run_in_parallel(os.path.abspath(__file__), file)
    has_files = os.path.exists(files[1])  # not in a build without netCDF
    assert [os.path.exists(name) for name in files] == [False, has_files, has_files]
    check(all_answers(), [dict(numpy.load(file % process)) for process in (0, 1)])
