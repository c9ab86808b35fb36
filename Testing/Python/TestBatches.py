# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Batches of queries from numpy arrays, without a loop."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdTypeArray
from vtkskdtree import vtkSkdTreeCellLocator

import skdtesting


def make_locator(radius=1.0):
    locator = vtkSkdTreeCellLocator()
    locator.SetDataSet(skdtesting.sphere_mesh(64, radius))
    locator.BuildLocator()
    return locator


locator = make_locator()
random = numpy.random.default_rng(1)
points = random.uniform(-2, 2, (5000, 3))


def test_closest_points():
    ids, closest, distances = vtkIdTypeArray(), vtkDoubleArray(), vtkDoubleArray()
    assert locator.FindClosestPoints(numpy_to_vtk(points), ids, closest, distances) == 5000
    gaps = numpy.linalg.norm(vtk_to_numpy(closest) - points, axis=1)
    assert vtk_to_numpy(closest).shape == (5000, 3)
    assert numpy.allclose(gaps, vtk_to_numpy(distances), rtol=1e-12, atol=1e-14)
    off = numpy.abs(numpy.linalg.norm(points, axis=1) - 1)
    assert numpy.all(numpy.abs(vtk_to_numpy(distances) - off) < 0.005)
    assert vtk_to_numpy(ids).min() >= 0


def test_radius_and_points_that_are_not_finite():
    some = points.copy()
    some[7, 1] = numpy.nan
    ids, distances = vtkIdTypeArray(), vtkDoubleArray()
    found = locator.FindClosestPoints(numpy_to_vtk(some), ids, None, distances, 0.1)
    none = vtk_to_numpy(ids) < 0
    assert none[7] and found == 5000 - none.sum()
    assert numpy.array_equal(none, numpy.isnan(vtk_to_numpy(distances)))
    assert numpy.nanmax(vtk_to_numpy(distances)) <= 0.1


def test_float_arrays():
    single = points.astype(numpy.float32)
    ids, same = vtkIdTypeArray(), vtkIdTypeArray()
    locator.FindClosestPoints(numpy_to_vtk(single), ids, None, None)
    locator.FindClosestPoints(numpy_to_vtk(single.astype(float)), same, None, None)
    assert numpy.array_equal(vtk_to_numpy(ids), vtk_to_numpy(same))


def test_first_and_all_hits():
    lines = numpy.hstack([points, -points])
    ids, t, hits = vtkIdTypeArray(), vtkDoubleArray(), vtkDoubleArray()
    number = locator.IntersectWithLines(numpy_to_vtk(lines), ids, t, hits)
    is_hit = vtk_to_numpy(ids) >= 0
    assert number == is_hit.sum()
    assert numpy.array_equal(is_hit[numpy.linalg.norm(points, axis=1) > 1],
                             numpy.ones((numpy.linalg.norm(points, axis=1) > 1).sum(), bool))
    offsets, all_ids, all_t = vtkIdTypeArray(), vtkIdTypeArray(), vtkDoubleArray()
    locator.FindAllHits(numpy_to_vtk(lines), offsets, all_ids, all_t, None)
    counts = numpy.diff(vtk_to_numpy(offsets))
    assert counts.size == 5000 and counts.sum() == all_ids.GetNumberOfTuples()
    first = vtk_to_numpy(offsets)[:-1][counts > 0]
    assert numpy.array_equal(vtk_to_numpy(all_ids)[first], vtk_to_numpy(ids)[is_hit])
    assert numpy.array_equal(vtk_to_numpy(all_t)[first], vtk_to_numpy(t)[is_hit])


def test_boxes_and_pairs():
    boxes = numpy.repeat(points, 2, axis=1) + numpy.array([-.1, .1] * 3)
    offsets, ids = vtkIdTypeArray(), vtkIdTypeArray()
    number = locator.FindCellsWithinBoxes(numpy_to_vtk(boxes), offsets, ids)
    assert number == vtk_to_numpy(offsets)[-1] == vtk_to_numpy(ids).size > 0
    other = make_locator(0.98)
    assert locator.FindPairs(other, offsets, ids) > 0
    mine = numpy.repeat(numpy.arange(offsets.GetNumberOfTuples() - 1),
                        numpy.diff(vtk_to_numpy(offsets)))
    pairs = vtkIdTypeArray()
    assert locator.FindPairs(other, pairs) == mine.size
    rows = vtk_to_numpy(pairs)[numpy.lexsort(vtk_to_numpy(pairs).T[::-1])]
    assert numpy.array_equal(rows, numpy.column_stack([mine, vtk_to_numpy(ids)]))
    back = vtkIdTypeArray()
    assert other.FindPairs(locator, back, None) == mine.size


def test_cells():
    ids, pcoords = vtkIdTypeArray(), vtkDoubleArray()
    found = locator.FindCells(numpy_to_vtk(points), ids, pcoords, 0.2)
    assert found == (vtk_to_numpy(ids) >= 0).sum() > 0
    assert numpy.isnan(vtk_to_numpy(pcoords)[vtk_to_numpy(ids) < 0]).all()


def test_wrong_arrays_are_refused():
    errors = []
    locator.AddObserver("ErrorEvent", lambda caller, event: errors.append(event))
    assert locator.FindClosestPoints(numpy_to_vtk(points[:, :2].copy()), None, None, None) == -1
    assert locator.FindCellsWithinBoxes(None, None, None) == -1
    assert len(errors) == 2


for name, test in list(globals().items()):
    if name.startswith("test_"):
        test()
        print(name)
