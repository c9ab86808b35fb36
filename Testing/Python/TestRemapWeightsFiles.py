# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of weights of vtkSkdTreeRemap that CDO and NCO apply, where they are installed, and files of
theirs that the filter applies."""

import math
import shutil
import subprocess

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkskdtree import vtkSkdTreeRemap

from skdtesting import run_tests, temporary

CDO, NCKS = shutil.which("cdo"), shutil.which("ncks")
A, B = (24, 12), (36, 18)  # cells along longitude and latitude
FIRST, SECOND, FROM_FILE = 3, 4, 5


def call(*arguments, text=None):
    """What a program writes; a message where it fails."""
    done = subprocess.run(arguments, input=text, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    return done.stdout


def edges(count):
    step = 360 / count[0]
    return numpy.linspace(0, 360, count[0] + 1) - step / 2, numpy.linspace(-90, 90, count[1] + 1)


def grid(count, values=None):
    """The cells of CDO's grid r<nx>x<ny> on the unit sphere."""
    longitudes, latitudes = (numpy.radians(a) for a in edges(count))
    across = numpy.where(abs(latitudes) > 1.57079, 0.0, numpy.cos(latitudes))
    x = numpy.stack([numpy.outer(across, numpy.cos(longitudes)),
        numpy.outer(across, numpy.sin(longitudes)),
        numpy.outer(numpy.sin(latitudes), numpy.ones(count[0] + 1))], -1)
    data, points = vtkStructuredGrid(), vtkPoints()
    points.SetData(numpy_to_vtk(x.reshape(-1, 3), deep=1))
    data.SetDimensions(count[0] + 1, count[1] + 1, 1)
    data.SetPoints(points)
    if values is not None:
        array = numpy_to_vtk(numpy.ascontiguousarray(values, float), deep=1)
        array.SetName("f")
        data.GetCellData().AddArray(array)
    return data


def field():
    """A smooth one on the cells of A."""
    lon, lat = (numpy.radians((a[1:] + a[:-1]) / 2) for a in edges(A))
    return (2 + numpy.outer(numpy.cos(lat)**2, numpy.cos(2 * lon)) + 0.5 *
        numpy.sin(lat)[:, None]).ravel()


def write_field(name):
    """The field as the variable var1 of a netCDF file."""
    text = "".join("%.17g\n" % value for value in field())
    call(CDO, "-s", "-O", "-f", "nc", "-b", "F64", "input,r%dx%d" % A, name, text=text)


def read_values(name):
    """Of the only field of a file."""
    return numpy.array(call(CDO, "-s", "outputf,%.17g,1", name).split(), float)


def remap(method, source=None, target=None):
    filter_ = vtkSkdTreeRemap()
    filter_.SetMethod(method)
    filter_.SetLimiter(0)
    filter_.SetSourceEdgesAlongParallels(True)
    filter_.SetInputEdgesAlongParallels(True)
    filter_.SetInputDataObject(0, target or grid(B))
    filter_.SetInputDataObject(1, source or grid(A, field()))
    return filter_


def written(method, form, name):
    filter_ = remap(method)
    filter_.SetWeightsFileFormat(form)
    filter_.SetWeightsFileName(name)
    return result(filter_)


def result(filter_):
    filter_.Update()
    return vtk_to_numpy(filter_.GetOutputDataObject(0).GetCellData().GetArray("f"))


def from_file(name):
    filter_ = remap(FROM_FILE)
    filter_.SetAppliedWeightsFileName(name)
    return result(filter_)


def needs(program):
    if not program:
        print("left out: the program is not installed")
    return bool(program)


def test_cdo_applies_both_orders():
    if not needs(CDO):
        return
    data, weights, out = (temporary(name) for name in ("f.nc", "weights.nc", "out.nc"))
    write_field(data)
    for method in (FIRST, SECOND):
        own = written(method, vtkSkdTreeRemap.SCRIP, weights)
        call(CDO, "-s", "-O", "remap,r%dx%d,%s" % (*B, weights), data, out)
        read = read_values(out)
        if method == FIRST:
            numpy.testing.assert_allclose(read, own, atol=1e-13)
        else:  # with gradients of its own, which are not the filter's
            call(CDO, "-s", "-O", "remapcon2,r%dx%d" % B, data, out)
            numpy.testing.assert_allclose(read, read_values(out), atol=1e-3)
            assert abs(read - result(remap(FIRST))).max() > 1e-2


def test_cdo_refuses_second_order_without_grid_dimensions():
    if not needs(CDO):
        return
    data, weights, out = (temporary(name) for name in ("f.nc", "weights.nc", "out.nc"))
    write_field(data)
    append = vtkAppendFilter()
    append.AddInputData(grid(A, field()))
    append.Update()
    filter_ = remap(SECOND, append.GetOutput())
    filter_.SetWeightsFileFormat(vtkSkdTreeRemap.SCRIP)
    filter_.SetWeightsFileName(weights)
    filter_.Update()
    try:
        call(CDO, "-s", "-O", "remap,r%dx%d,%s" % (*B, weights), data, out)
    except AssertionError as refused:
        assert "not available for unstructured" in str(refused), refused
        return
    raise AssertionError("applied as of first order")


def test_nco_applies_first_order():
    if not (needs(CDO) and needs(NCKS)):
        return
    data, weights, out = (temporary(name) for name in ("f.nc", "weights.nc", "out.nc"))
    write_field(data)
    for form in (vtkSkdTreeRemap.SCRIP, vtkSkdTreeRemap.ESMF):
        own = written(FIRST, form, weights)
        call(NCKS, "-O", "-t", "1", "--map_fl=" + weights, data, out)
        selected = temporary("selected.nc")
        call(CDO, "-s", "-O", "selname,var1", out, selected)
        numpy.testing.assert_allclose(read_values(selected), own, atol=1e-13)


def deviation(first, second):
    return math.sqrt(((first - second)**2).mean())


def assert_second_order(values):
    """Far nearer to the filter's own than first order is."""
    own = result(remap(SECOND))
    assert deviation(values, own) < 0.2 * deviation(result(remap(FIRST)), own)


def test_own_files_are_applied():
    name = temporary("own.nc")
    for form in (vtkSkdTreeRemap.ESMF, vtkSkdTreeRemap.SCRIP):
        own = written(FIRST, form, name)
        numpy.testing.assert_allclose(from_file(name), own, atol=1e-14)
    written(SECOND, vtkSkdTreeRemap.SCRIP, name)
    assert_second_order(from_file(name))


def test_files_of_cdo_are_applied():
    if not needs(CDO):
        return
    data, weights, out = (temporary(name) for name in ("f.nc", "cdo.nc", "out.nc"))
    write_field(data)
    for method in ("bil", "con", "nn"):
        call(CDO, "-s", "-O", "gen%s,r%dx%d" % (method, *B), data, weights)
        call(CDO, "-s", "-O", "remap,r%dx%d,%s" % (*B, weights), data, out)
        numpy.testing.assert_allclose(from_file(weights), read_values(out), atol=1e-12)
    call(CDO, "-s", "-O", "gencon2,r%dx%d" % B, data, weights)
    assert_second_order(from_file(weights))


run_tests(globals())
