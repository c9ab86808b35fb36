# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two processes of pvbatch give what one gives. Run without an argument this starts them; with the
name of a file it is one of them, and writes its part of the answers there."""

import os
import shutil
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdtesting


def lattice():
    from paraview import simple

    return simple.Wavelet(WholeExtent=[-6, 6, -6, 6, -6, 6])


def answers(proxy, arrays):
    """A row for each point of this process: where it is and what was found."""
    proxy.UpdatePipeline()
    data = proxy.GetClientSideObject().GetOutputDataObject(0)
    columns = [numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])]
    for name in arrays:
        values = vtk_to_numpy(data.GetPointData().GetArray(name))
        columns.append(values.reshape(len(values), -1))
    return numpy.hstack(columns)


def nearest(source):
    from paraview import simple

    field = simple.Calculator(Input=source, Function="coordsX", ResultArrayName="F")
    closest = simple.SkdTreeClosestPoint(
        Input=lattice(), Source=field, SignedDistance=1, InterpolateSourceData=1)
    return answers(closest, ("SkdDistance", "SkdClosestPoint", "SkdClosestCellId", "F"))


def probed(source):
    from paraview import simple

    probe = simple.SkdTreeProbe(Input=lattice(), Source=source, OutsidePoints="Nearest Cell")
    return answers(probe, ("SkdSourceCellId", "SkdDistance", "SkdParametricCoordinates", "Temp"))


def inside(source):
    from paraview import simple

    test = simple.SkdTreePointInOut(Input=lattice(), Source=source, BoundaryBand=0.1)
    return answers(test, ("SkdInside", "SkdPartId", "SkdDepth", "SkdConfidence", "SkdOnBoundary"))


def all_answers():
    """Of each filter and source."""
    from paraview import simple

    brain = simple.XMLPolyDataReader(
        FileName=[os.path.join(skdtesting.DATA_DIR, "fly_brain_lateral_horn.vtp")])
    flow = simple.XMLUnstructuredGridReader(
        FileName=[os.path.join(skdtesting.DATA_DIR, "disk_flow.vtu")])
    sphere = simple.Sphere(Radius=4, ThetaResolution=50, PhiResolution=50)
    return [nearest(sphere), nearest(brain), probed(flow), inside(sphere), inside(flow)]


if len(sys.argv) > 1:
    numpy.savez(sys.argv[1] % skdtesting.process_id(), *all_answers())
elif shutil.which("mpiexec") is None or shutil.which("pvbatch") is None:
    skdtesting.skip("there is no mpiexec or no pvbatch")
else:
    alone = all_answers()
    file = skdtesting.temporary("parallel%d.npz")
    skdtesting.run_in_parallel(os.path.abspath(__file__), file)
    parts = [list(numpy.load(file % process).values()) for process in (0, 1)]
    for whole, first, second in zip(alone, *parts):
        assert len(whole) == 13**3 and min(len(first), len(second)) > 0
        assert max(len(first), len(second)) < len(whole)
        # The processes share the points where their pieces meet.
        together = numpy.unique(numpy.vstack([first, second]), axis=0)
        skdtesting.assert_same(together, numpy.unique(whole, axis=0))
