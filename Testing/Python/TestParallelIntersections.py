# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Intersections and distances of surfaces in two processes of pvbatch are those in one. Run without an
argument this starts them; with the name of a file it is one of them, and writes its part of the
answers there."""

import math
import os
import shutil
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdpieces
import skdtesting


def output(proxy, port=0):
    """Of this process alone."""
    proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(port)


def sphere(*center):
    """Whose cells have the same ids on any number of processes."""
    return skdpieces.source("sphere", "runs", radius=1.0, center=center, theta=40, phi=30)


def figure():
    """Lissajous (2, 3), which crosses itself seven times; closed."""
    from paraview import simple

    points = []
    for i in range(120):
        t = 2 * math.pi * i / 120
        points += [1.5 * math.sin(2 * t + 0.3), 1.5 * math.sin(3 * t), 0.1]
    return simple.PolyLineSource(Points=points + points[:3])


def places(data):
    return numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())]).reshape(-1, 3)


def crossings():
    """All of them, in the first process."""
    from paraview import simple

    return places(output(simple.SkdTreeCurveIntersection(
        Input=figure(), PolylineForm="Cardinal Spline", InterpolateData=0)))


def hits():
    """Of the curves of this process."""
    from paraview import simple

    return places(output(simple.SkdTreeCurveSurfaceIntersection(
        Input=figure(), Source=sphere(0.1, 0.2, 0), InterpolateData=0)))


def intersection(source):
    """Of the Input's piece: how many pairs of cells, and what length of curves."""
    from paraview import simple

    proxy = simple.SkdTreeSurfaceIntersection(Input=sphere(0, 0, 0), Source=source, JoinCurves=0)
    curves = output(proxy)
    ends = places(curves)
    lines = vtk_to_numpy(curves.GetLines().GetConnectivityArray()).reshape(-1, 2)
    length = numpy.linalg.norm(ends[lines[:, 0]] - ends[lines[:, 1]], axis=1).sum()
    pairs = output(proxy, 2).GetNumberOfRows()
    return numpy.array([pairs, length])


def corners(surface):
    """The coordinates of each triangle's corners."""
    ids = vtk_to_numpy(surface.GetPolys().GetConnectivityArray())
    return places(surface)[ids].reshape(-1, 9)


def ends(curves):
    """The coordinates of both ends of each line."""
    return places(curves)[vtk_to_numpy(curves.GetLines().GetConnectivityArray())].reshape(-1, 6)


def split():
    """Both surfaces, and the curves that they are cut along; the regions, the cells' rows."""
    from paraview import simple

    proxy = simple.SkdTreeSurfaceIntersection(Input=sphere(0, 0, 0),
        Source=sphere(0.9, 0.3, 0.2), JoinCurves=0, SplitSurfaces=1)
    answers = {"curves": ends(output(proxy))}
    pairs = output(proxy, 2)
    columns = [pairs.GetColumnByName(name) for name in ("SkdFirstCellId", "SkdSecondCellId")]
    answers["rows"] = numpy.column_stack([vtk_to_numpy(column) for column in columns])
    for port, name in ((4, "input"), (5, "source")):
        surface = output(proxy, port)
        answers[name] = corners(surface)
        cells = surface.GetCellData()
        answers[name + " ids"] = numpy.column_stack(
            [vtk_to_numpy(cells.GetArray(array)) for array in ("SkdCellId", "SkdRegionId")])
    return {"split " + name: answer for name, answer in answers.items()}


def compared():
    """The table of two surfaces, one of them in blocks, in the first process."""
    from paraview import simple

    blocks = simple.GroupDatasets(Input=[sphere(0.9, 0.3, 0.2), sphere(3, 0, 0)])
    proxy = simple.SkdTreeCompareSurfaces(Input=sphere(0, 0, 0), Source=blocks, SignedDistance=1)
    answers = {}
    points = output(proxy)
    distances = points.GetPointData().GetArray("SkdDistance")
    answers["distances"] = numpy.column_stack([places(points), vtk_to_numpy(distances)])
    assert output(proxy, 1).GetNumberOfBlocks() == 2
    table = output(proxy, 2)
    numbers = [vtk_to_numpy(table.GetColumn(column)).ravel()
        for column in range(1, table.GetNumberOfColumns())]
    answers["compared"] = numpy.concatenate(numbers) if numbers else numpy.empty(0)
    return answers


def thickness():
    """Of a surface alone, in the first process."""
    from paraview import simple

    found = output(simple.SkdTreeWallThickness(Input=sphere(0.1, 0.2, 0)))
    array = found.GetPointData().GetArray("SkdThickness")
    return vtk_to_numpy(array) if array else numpy.empty(0)


def all_answers():
    return {
        **split(),
        **compared(),
        "crossings": crossings(),
        "hits": hits(),
        "intersection": intersection(sphere(0.9, 0.3, 0.2)),
        "itself": intersection(None),
        "thickness": thickness()
    }


def sorted_rows(rows):
    return numpy.unique(numpy.round(rows, 6), axis=0)


def check(alone, parts):
    assert len(alone["crossings"]) == 7, alone["crossings"]
    assert numpy.isfinite(alone["compared"]).sum() > 60
    numpy.testing.assert_array_equal(parts[0]["compared"], alone["compared"])
    assert parts[1]["compared"].size == 0
    numpy.testing.assert_array_equal(
        numpy.unique(numpy.vstack([part["distances"] for part in parts]), axis=0),
        numpy.unique(alone["distances"], axis=0))
    for name in ("crossings", "thickness"):
        numpy.testing.assert_array_equal(numpy.sort(parts[0][name]), numpy.sort(alone[name]))
        assert parts[1][name].size == 0, name
    together = numpy.vstack([part["hits"] for part in parts])
    assert len(alone["hits"]) > 2
    numpy.testing.assert_array_equal(sorted_rows(together), sorted_rows(alone["hits"]))
    total = sum(part["intersection"] for part in parts)
    assert all(part["intersection"][0] > 0 for part in parts)
    numpy.testing.assert_allclose(total, alone["intersection"], rtol=1e-6)
    for part in parts + [alone]:
        assert (part["itself"] == 0).all()
    for name in (name for name in alone if name.startswith("split")):
        assert all(len(part[name]) > 0 for part in parts), name
        numpy.testing.assert_array_equal(
            numpy.vstack([part[name] for part in parts]), alone[name], name)


if len(sys.argv) > 1:
    numpy.savez(sys.argv[1] % skdtesting.process_id(), **all_answers())
elif shutil.which("mpiexec") is None or shutil.which("pvbatch") is None:
    skdtesting.skip("there is no mpiexec or no pvbatch")
else:
    file = skdtesting.temporary("intersections%d.npz")
    skdtesting.run_in_parallel(os.path.abspath(__file__), file)
    check(all_answers(), [dict(numpy.load(file % process)) for process in (0, 1)])
