# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tree: numpy in, numpy out. Answers are those of the locator's batches and of the filters, to the bit;
memory is shared; what is wrong is refused by name."""

import copy
import gc
import itertools
import pickle
import warnings

import numpy
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import (VTK_HEXAHEDRON, VTK_QUAD, VTK_TETRA, vtkImageData, vtkMultiBlockDataSet,
    vtkPolyData, vtkUnstructuredGrid)
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkskdtree import (Locator, Tree, vtkSkdTreeCellLocator, vtkSkdTreeClosestPoint, vtkSkdTreePointInOut,
    vtkSkdTreeRays)

import skdtesting

random = numpy.random.default_rng(17)
POINTS = random.uniform(-1, 1, (3000, 3))
POINTS[7, 1] = numpy.nan


def sphere(radius=0.5):
    return skdtesting.sphere_source(48, radius)


def grid():
    """A tetrahedron beside a hexahedron, and a field that is linear."""
    corners = numpy.array(list(itertools.product([0, 1], repeat=3)) + [[2, 0, 0], [2, 1, 0], [2, 0, 1]], float)
    mesh = vtkUnstructuredGrid()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(corners, deep=True))
    mesh.SetPoints(points)
    mesh.InsertNextCell(VTK_HEXAHEDRON, 8, [0, 4, 6, 2, 1, 5, 7, 3])
    mesh.InsertNextCell(VTK_TETRA, 4, [4, 8, 9, 10])
    for data, name, values in ((mesh.GetPointData(), "field", corners @ [1, 2, 3] + 4),
            (mesh.GetPointData(), "place", corners), (mesh.GetCellData(), "part", numpy.array([5, 6]))):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        data.AddArray(array)
    return mesh


def same(answer, *arrays):
    """Equal to the bit, of NaN too."""
    assert len(answer) == len(arrays)
    for mine, array in zip(answer, arrays):
        array = vtk_to_numpy(array) if hasattr(array, "IsA") else array
        assert mine.dtype == array.dtype and mine.shape == array.shape, (mine, array)
        assert mine.tobytes() == numpy.ascontiguousarray(array).tobytes()


def refused(kind, text, ask):
    try:
        ask()
    except kind as error:
        assert text in str(error), error
        return
    raise AssertionError("not refused: " + text)


tree = Tree(sphere())
at = numpy_to_vtk(POINTS)
ids, offsets = vtkIdTypeArray(), vtkIdTypeArray()
numbers, places = vtkDoubleArray(), vtkDoubleArray()


def test_nearest_are_those_of_the_batches():
    tree.locator.FindClosestPoints(at, ids, places, numbers)
    same(tree.closest(POINTS), places, numbers, ids)
    tree.locator.FindClosestPoints(at, ids, places, numbers, 0.1)
    near = tree.closest(POINTS, maximum=0.1)
    same(near, places, numbers, ids)
    assert near.cell[7] == -1 and numpy.isnan(near.distance[7]) and numpy.nanmax(near.distance) <= 0.1
    tree.locator.FindClosestNCells(at, 4, ids, numbers)
    same(tree.k_nearest(POINTS, 4), numbers, ids)
    few = Tree(numpy.eye(3)).k_nearest(POINTS, 5)
    assert few.cell.shape == (3000, 5) and (few.cell[:, 3:] == -1).all()
    assert numpy.isnan(few.distance[:, 3:]).all() and (few.cell[7] == -1).all()


def test_neighbours_against_brute_force():
    cloud = random.uniform(-1, 1, (400, 3))
    distances = numpy.linalg.norm(POINTS[8:200, None] - cloud, axis=2)
    order = numpy.argsort(distances, axis=1, kind="stable")
    points = Tree(cloud)
    assert numpy.array_equal(points.k_nearest(POINTS[8:200], 6).cell, order[:, :6])
    assert numpy.array_equal(points.k_nearest(POINTS[8:200], 1).cell, order[:, :1])
    radii = random.uniform(0.1, 0.5, 192)
    for radius in (0.3, radii):
        near = points.within(POINTS[8:200], radius)
        expected = numpy.argwhere(distances <= numpy.reshape(radius, (-1, 1)))
        assert numpy.array_equal(near.query, expected[:, 0])
        assert numpy.array_equal(near.cell, expected[:, 1])
        assert numpy.allclose(near.distance, distances[near.query, near.cell], rtol=1e-14)
        assert near.offsets[-1] == len(near.cell) and len(near.offsets) == 193


def test_rays_and_segments():
    tree.locator.IntersectWithLines(numpy_to_vtk(numpy.hstack([POINTS, -POINTS])), ids, numbers, places)
    same(tree.segments(POINTS, -POINTS), ids, numbers, places)
    both = numpy.stack([POINTS, -POINTS], axis=1)
    same(tree.segments(both), ids, numbers, places)
    tree.locator.FindAllHits(numpy_to_vtk(both.reshape(-1, 6)), offsets, ids, numbers, places)
    same(tree.segments(both, all_hits=True), offsets, ids, numbers, places)
    same(tree.segments(POINTS, -POINTS, all_hits=True), offsets, ids, numbers, places)

    hits = tree.rays(POINTS, -7 * POINTS)
    first = tree.segments(POINTS, -1000 * POINTS)
    assert numpy.array_equal(hits.cell, first.cell) and (hits.cell >= 0).sum() == 2999
    length = numpy.linalg.norm(1001 * POINTS, axis=1)
    assert numpy.allclose(hits.distance, first.parameter * length, rtol=1e-10, equal_nan=True)
    gaps = numpy.linalg.norm(POINTS - hits.point, axis=1)
    assert numpy.allclose(hits.distance, gaps, rtol=1e-12, atol=1e-14, equal_nan=True)
    every = tree.rays(POINTS, -7 * POINTS, all_hits=True)
    assert (numpy.diff(every.offsets)[hits.cell >= 0] >= 1).all()
    starts = every.offsets[:-1][hits.cell >= 0]
    assert numpy.array_equal(every.cell[starts], hits.cell[hits.cell >= 0])
    assert numpy.array_equal(every.query[starts], numpy.nonzero(hits.cell >= 0)[0])


def test_rays_end():
    box = Tree(grid())
    origins = numpy.array([[-3, 0.25, 0.5]] * 3 + [[1e9, 0.25, 0.5], [0.5, 0.25, 0.5], [-3, 0.25, 0.5]])
    along = numpy.array([[1, 0, 0], [0, 0, 0], [numpy.nan, 0, 0], [-1e300, 0, 0], [0, 0, 1e-310], [1, 0, 0]])
    assert box.rays(origins, along).cell.tolist() == [0, -1, -1, 1, 0, 0]
    assert numpy.allclose(box.rays(origins, [1, 0, 0]).distance[:3], 3, rtol=1e-15)
    assert (box.rays(origins, along, maximum=3).cell[[0, 5]] == 0).all()
    assert (box.rays(origins, along, maximum=2.999999).cell[[0, 5]] == -1).all()
    assert (Tree(vtkPolyData()).rays(origins, along).cell == -1).all()


def test_cells_weights_and_data():
    mesh = grid()
    box = Tree(mesh)
    inside = random.uniform(0, 1, (500, 3)) * [2, 1, 1]
    found = box.find_cells(inside)
    assert found.weights.shape == found.point_ids.shape == (500, 8)
    assert set(found.cell) == {-1, 0, 1}
    for cell in (0, 1):
        points = vtkIdList()
        mesh.GetCellPoints(cell, points)
        size = points.GetNumberOfIds()
        own = found.point_ids[found.cell == cell]
        assert (own[:, :size] == [points.GetId(i) for i in range(size)]).all() and (own[:, size:] == -1).all()
    is_in = found.cell >= 0
    assert (found.point_ids[~is_in] == -1).all() and numpy.isnan(found.weights[~is_in]).all()
    place = vtk_to_numpy(mesh.GetPoints().GetData())
    again = (place[found.point_ids] * found.weights[:, :, None]).sum(axis=1)
    assert numpy.allclose(again[is_in], inside[is_in], atol=1e-14)
    one = vtkIdTypeArray()
    plain = vtkSkdTreeCellLocator()
    plain.SetDataSet(mesh)
    plain.FindCells(numpy_to_vtk(inside), one, places)
    same(found[:2], one, places)

    field = box.interpolate("field", inside)
    assert numpy.allclose(field[is_in], inside[is_in] @ [1, 2, 3] + 4, atol=1e-14)
    assert numpy.isnan(field[~is_in]).all()
    assert numpy.isfinite(box.interpolate("field", inside, outside=True)).all()
    assert box.interpolate("place", inside).shape == (500, 3)
    part = box.interpolate("part", inside)
    assert part.dtype == numpy.int64 and (part[is_in] == found.cell[is_in] + 5).all()
    refused(KeyError, "field", lambda: box.interpolate("fields", inside))
    assert (box.find_cells(inside + [0, 0, 0.01], tolerance=2).cell >= 0).all()
    assert Tree(numpy.eye(3)).find_cells(numpy.eye(3)).weights.tolist() == [[1]] * 3


def test_boxes_and_pairs():
    bounds = numpy.repeat(POINTS, 2, axis=1) + numpy.array([-.1, .1] * 3)
    tree.locator.FindCellsWithinBoxes(numpy_to_vtk(bounds), offsets, ids)
    same(tree.in_boxes(bounds), offsets, ids)
    same(tree.in_boxes(bounds.reshape(-1, 3, 2).transpose(0, 2, 1)), offsets, ids)
    pairs = tree.pairs(sphere(0.49))
    back = Tree(sphere(0.49)).pairs(tree)
    assert len(pairs.cell) > 0 and len(pairs.offsets) == len(tree) + 1
    assert set(zip(pairs.query, pairs.cell)) == set(zip(back.cell, back.query))


def test_sides_are_those_of_the_filters():
    asked = vtkPolyData()
    asked.SetPoints(vtkPoints())
    asked.GetPoints().SetData(numpy_to_vtk(POINTS))

    def output(made):
        made.SetInputData(asked)
        made.SetSourceData(tree.mesh)
        made.Update()
        return made.GetOutput().GetPointData()

    signed = vtkSkdTreeClosestPoint()
    signed.SignedDistanceOn()
    data = output(signed)
    same(tree.signed_distance(POINTS), *(data.GetArray("Skd" + name)
        for name in ("ClosestPoint", "Distance", "ClosestCellId")))
    winding = vtkSkdTreePointInOut()
    winding.SetMethod(vtkSkdTreePointInOut.WINDING_NUMBER)
    same([tree.winding_number(POINTS)], output(winding).GetArray("SkdWindingNumber"))
    inside = tree.contains(POINTS)
    assert inside.dtype == bool and inside.sum() > 100
    assert numpy.array_equal(inside, tree.signed_distance(POINTS).distance < 0)
    assert numpy.array_equal(inside[:300], tree.winding_number(POINTS[:300], tolerance=0) > 0.5)
    near = tree.signed_distance(POINTS, maximum=0.1)
    assert numpy.nanmax(abs(near.distance)) <= 0.1
    assert numpy.nanmax(abs(tree.signed_distance(POINTS).distance)) > 0.5


class Like:
    """What trimesh's meshes have."""

    def __init__(self, vertices, faces):
        self.vertices, self.faces = vertices, faces


class Vectors:
    """What Open3D's arrays are: no arrays, but numpy makes such of them."""

    def __init__(self, values):
        self.values = values

    def __array__(self, dtype=None, copy=None):
        return numpy.array(self.values, dtype)


class LikeOpen3D:
    """What Open3D's meshes have."""

    def __init__(self, vertices, triangles):
        self.vertices, self.triangles = Vectors(vertices), Vectors(triangles)


class Derived(vtkPolyData):
    """What PyVista's meshes are."""


def test_what_trees_are_made_of():
    source = sphere()
    source.Update()
    mesh = source.GetOutput()
    derived = Derived()
    derived.ShallowCopy(mesh)
    corners = vtk_to_numpy(mesh.GetPoints().GetData())
    faces = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    expected = tree.closest(POINTS)
    flat = numpy.insert(faces, 0, 3, axis=1).reshape(-1)
    for made_of in (mesh, derived, source, dataset_adapter.WrapDataObject(mesh), (corners, faces),
            [corners, faces], [corners.tolist(), faces.tolist()], (corners, flat), [corners, flat.tolist()],
            (corners.astype(float), faces.astype(numpy.int32)), (corners.tolist(), faces.tolist()),
            Like(corners, faces), Like(corners, flat), LikeOpen3D(corners, faces)):
        same(Tree(made_of).closest(POINTS), *expected)
    normals = Tree(derived).interpolate("Normals", POINTS, outside=True)
    same([normals], tree.interpolate("Normals", POINTS, outside=True))
    same(tree.closest(POINTS.tolist()), *expected)
    same(tree.closest(numpy.asfortranarray(POINTS)), *expected)
    same(tree.closest(POINTS.astype(">f8")), *expected)
    single = POINTS.astype(numpy.float32)
    same(tree.closest(single), *tree.closest(single.astype(float)))
    assert len(tree.closest([]).cell) == len(tree.rays([], []).cell) == len(Tree((corners, faces))) - len(faces)
    assert tree.contains([]).shape == tree.within([], 1).cell.shape == (0, )
    assert tree.k_nearest([], 3).cell.shape == (0, 3) and tree.find_cells([]).cell.shape == (0, )


def test_faces_of_four_and_more_points():
    corners = numpy.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0], [2, 1, 0], [3, 0.5, 0]], float)
    quads = numpy.array([[0, 1, 2, 3], [1, 4, 5, 2]])
    at = [[0.5, 0.5, 1], [1.5, 0.5, 2], [2.5, 0.5, 3]]
    for faces in (quads, quads.astype(numpy.uint8), numpy.insert(quads, 0, 4, axis=1).reshape(-1)):
        made = Tree((corners, faces))
        assert len(made) == 2 and made.mesh.GetCellType(1) == VTK_QUAD
        assert made.closest(at).cell.tolist() == [0, 1, 1]
    mixed = Tree((corners, [4, 0, 1, 2, 3, 4, 1, 4, 5, 2, 3, 4, 6, 5]))
    gc.collect()
    numpy.random.default_rng(1).random(1000)
    assert mixed.closest(at).cell.tolist() == [0, 1, 2] and mixed.closest(at).distance.tolist() == [1, 2, 3]
    assert len(Tree(([], []))) == len(Tree([[], []])) == 0
    assert len(Tree([[0, 0, 0], [1, 1, 1]])) == len(Tree(([0, 0, 0], [1, 1, 1], [2, 2, 2]))) - 1 == 2


def cube():
    """Twelve triangles, so that the middle of each side is on an edge."""
    source = vtkCubeSource()
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    return triangles


def test_hits_of_several_cells_at_one_place_are_one():
    whole = Tree(cube())
    origins = numpy.array([[0, 0, -3], [-3, -3, -3], [0.2, 0.1, -3], [-3, 0, 0], [9, 9, 9], [0.1, 0.1, -0.5]], float)
    along = numpy.array([[0, 0, 2], [1, 1, 1], [0, 0, 1], [5, 0, 0], [0, 0, 1], [0, 0, 1]], float)
    edge_on = random.uniform(-1, 1, (200, 3))
    edge_on[:, 1] = edge_on[:, 0]
    origins = numpy.vstack([origins, edge_on + [0, 0, -3]])
    along = numpy.vstack([along, numpy.tile([0.0, 0, 1], (200, 1))])
    points = vtkPolyData()
    points.SetPoints(vtkPoints())
    points.GetPoints().SetData(numpy_to_vtk(origins, deep=True))
    directions = numpy_to_vtk(along, deep=True)
    directions.SetName("along")
    points.GetPointData().AddArray(directions)
    rays = vtkSkdTreeRays()
    rays.SetInputDataObject(0, points)
    rays.SetInputDataObject(1, whole.mesh)
    rays.SetAlongToArray()
    rays.SetDirectionArray("along")
    rays.SetHitsToAllHits()
    rays.IncludeStartOn()
    rays.Update()
    counts = vtk_to_numpy(rays.GetOutputDataObject(0).GetPointData().GetArray("SkdRayHits"))
    found = whole.rays(origins, along, all_hits=True)
    assert numpy.diff(found.offsets).tolist() == counts.tolist()
    assert counts[:6].tolist() == [2, 2, 2, 2, 0, 2], counts[:6]
    assert found.cell[found.offsets[0]] == whole.rays(origins, along).cell[0]
    assert len(vtk_to_numpy(ids)) and whole.locator.FindAllRayHits(origins, along, offsets, ids, numbers, None) > len(found.cell)
    between = whole.segments(origins, origins + 10 * along, all_hits=True)
    assert numpy.array_equal(between.cell, found.cell) and numpy.array_equal(between.offsets, found.offsets)
    nothing = whole.rays(numpy.full((3, 3), 7.0), [1, 0, 0], all_hits=True)
    assert nothing.offsets.tolist() == [0, 0, 0, 0] and len(nothing.point) == 0


def test_a_row_of_close_hits_is_divided_by_the_tolerance():
    sheets = 7
    corners = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]] * sheets, float)
    corners[:, 2] = numpy.repeat(numpy.arange(sheets) * 0.6e-9, 3)
    corners = numpy.vstack([corners, [[0, 0, 1], [0.01, 0, 1], [0, 0.01, 1]]])
    stack = Tree((corners, numpy.arange(len(corners)).reshape(-1, 3)))
    found = stack.rays([[0.2, 0.2, -1]], [0, 0, 1], all_hits=True)  # the diagonal is sqrt(3)
    kept = [0.0]
    for z in corners[:-3:3, 2]:
        kept += [z] if z - kept[-1] > 1e-9 * 3**0.5 else []
    assert numpy.allclose(found.point[:, 2], kept, atol=1e-15), (found.point, kept)


def test_pickled_and_copied():
    image = vtkImageData()
    image.SetDimensions(4, 5, 6)
    image.SetSpacing(0.1, 1 / 3, 0.7)
    marked = grid()
    ghosts = numpy_to_vtk(numpy.array([1, 0], numpy.uint8), deep=True)
    ghosts.SetName("vtkGhostType")
    marked.GetCellData().AddArray(ghosts)
    large = numpy_to_vtk(numpy.array([2**40 + 1, -5]), deep=True)
    large.SetName("large")
    marked.GetCellData().AddArray(large)
    for made in (tree, Tree((random.uniform(-1, 1, (300, 3)), numpy.arange(300).reshape(-1, 3))), Tree(image),
            Tree(marked), Tree(POINTS[8:50]), Tree(vtkPolyData())):
        for copied in (pickle.loads(pickle.dumps(made)), copy.deepcopy(made), copy.copy(made)):
            same(copied.closest(POINTS), *made.closest(POINTS))
            same(copied.rays(POINTS, -POINTS, all_hits=True), *made.rays(POINTS, -POINTS, all_hits=True))
            assert repr(copied) == repr(made)
    assert copy.copy(tree).mesh is tree.mesh and copy.deepcopy(tree).mesh is not tree.mesh
    again = pickle.loads(pickle.dumps(Tree(marked)))
    same([again.interpolate("field", [[1.2, 0.2, 0.1]])], Tree(marked).interpolate("field", [[1.2, 0.2, 0.1]]))
    assert vtk_to_numpy(again.mesh.GetCellData().GetArray("large")).tolist() == [2**40 + 1, -5]
    made = Tree(sphere())
    made.locator.SetEpsilon(1e-4)
    made.locator.SkipGhostCellsOff()
    motion = vtkMatrix4x4()
    motion.SetElement(0, 3, 0.25)
    made.locator.SetTransform(motion)
    for copied in (pickle.loads(pickle.dumps(made)), copy.deepcopy(made), copy.copy(made)):
        assert copied.locator.GetEpsilon() == 1e-4 and not copied.locator.GetSkipGhostCells()
        same(copied.closest(POINTS), *made.closest(POINTS))


def test_memory_is_shared_and_kept():
    corners = random.uniform(-1, 1, (300, 3))
    faces = numpy.arange(300).reshape(-1, 3)
    made = Tree((corners, faces))
    assert numpy.shares_memory(vtk_to_numpy(made.mesh.GetPoints().GetData()), corners)
    expected = made.closest(POINTS)
    corners += 0.5
    made.update()
    moved = made.closest(POINTS + 0.5)
    assert numpy.array_equal(moved.cell[8:], expected.cell[8:])
    copied = faces.copy(), corners.copy()
    mesh = made.mesh
    del made, faces, corners
    gc.collect()
    numpy.random.default_rng(1).random(10000)
    same(Tree(mesh).closest(POINTS), *Tree((copied[1], copied[0])).closest(POINTS))

    answer = tree.closest(POINTS)
    again = tree.closest(POINTS[::-1], out=answer)
    assert all(a is b for a, b in zip(answer, again))
    same(again, *tree.closest(POINTS[::-1]))
    frozen = POINTS.copy()
    frozen.flags.writeable = False
    same(tree.closest(frozen), *tree.closest(POINTS))
    for ask in (lambda **out: tree.rays(POINTS, -POINTS, **out), lambda **out: tree.k_nearest(POINTS, 3, **out),
            lambda **out: tree.segments(POINTS, -POINTS, **out), lambda **out: tree.find_cells(POINTS, 1, **out)):
        expected = ask()
        zeros = type(expected)(*map(numpy.zeros_like, expected))
        same(ask(out=zeros), *expected)
        same(zeros, *expected)


def test_locator_takes_arrays():
    locator = Locator()
    locator.SetDataSet(tree.mesh)
    cells, distances = numpy.zeros(3000, numpy.int64), numpy.zeros(3000)
    assert locator.FindClosestPoints(POINTS, cells, None, distances) == 2999
    expected = tree.closest(POINTS)
    same([distances, cells], expected.distance, expected.cell)
    assert isinstance(locator, vtkSkdTreeCellLocator) and "nearest" in locator.FindClosestPoints.__doc__
    refused(ValueError, "(5,), (3000,) is needed",
        lambda: locator.FindClosestPoints(POINTS, cells[:5].copy(), None, None))
    refused(TypeError, "argument 3 holds int32",
        lambda: locator.FindClosestPoints(POINTS, cells, numpy.zeros((3000, 3), "i4"), None))
    refused(ValueError, "not contiguous", lambda: locator.FindClosestPoints(POINTS, cells[::2], None, None))


def test_wrong_queries_are_refused_by_name():
    closest = tree.closest(POINTS)
    for kind, text, ask in (
            (ValueError, "points has the shape (3000, 2), (n, 3)", lambda: tree.closest(POINTS[:, :2])),
            (ValueError, "write [points]", lambda: tree.contains([1, 2, 3])),
            (TypeError, "points holds complex128", lambda: tree.signed_distance(POINTS + 1j)),
            (TypeError, "points holds bool", lambda: tree.find_cells(POINTS > 0)),
            (TypeError, "points holds object (NoneType)", lambda: tree.within(None, 1)),
            (ValueError, "radius has the shape (2,), () or (3000,)", lambda: tree.within(POINTS, [1, 2])),
            (ValueError, "k is 0", lambda: tree.k_nearest(POINTS, 0)),
            (ValueError, "maximum is -1.0", lambda: tree.closest(POINTS, maximum=-1)),
            (ValueError, "tolerance is nan", lambda: tree.find_cells(POINTS, numpy.nan)),
            (TypeError, "maximum is 'far'", lambda: tree.rays(POINTS, POINTS, "far")),
            (ValueError, "origins has 3000 rows, but directions has 2", lambda: tree.rays(POINTS, POINTS[:2])),
            (ValueError, "starts has 2 rows, but ends has 3000", lambda: tree.segments(POINTS[:2], POINTS)),
            (ValueError, "(n, 6) is needed without ends, or (n, 2, 3)", lambda: tree.segments(POINTS)),
            (ValueError, "(n, 6) is needed, or (n, 2, 3)", lambda: tree.in_boxes(POINTS)),
            (ValueError, "out has 2 arrays", lambda: tree.closest(POINTS, out=closest[:2])),
            (ValueError, "out.point has the shape (3000, 3), (5, 3)", lambda: tree.closest(POINTS[:5], out=closest)),
            (TypeError, "out.cell is no array of int64", lambda: tree.closest(POINTS, out=(*closest[:2], closest[1]))),
            (ValueError, "not known", lambda: tree.rays(POINTS, POINTS, all_hits=True, out=closest)),
            (ValueError, "radius is -1, it must not be negative", lambda: tree.within(POINTS, -1)),
            (ValueError, "radius is nan, it must not be negative",
                lambda: tree.within(POINTS[:2], [1.0, numpy.nan])),
            (ValueError, "radius is -0.5, it", lambda: tree.within(POINTS[:2], [1.0, -0.5])),
            (TypeError, "k is 2.5, an integer is needed", lambda: tree.k_nearest(POINTS, 2.5)),
            (ValueError, "less than 2**31", lambda: tree.k_nearest(POINTS, 2**40)),
            (TypeError, "name is 3", lambda: tree.interpolate(3, POINTS)),
            (TypeError, "out is int: an earlier result", lambda: tree.closest(POINTS, out=5)),
            (TypeError, "other is none of", lambda: tree.pairs(None)),
            (ValueError, "faces names points 0 to 3, but there are 3 points", lambda: Tree((numpy.eye(3), [[0, 1, 3]]))),
            (ValueError, "faces names points 0 to 3", lambda: Tree([numpy.eye(3), [3, 0, 1, 3]])),
            (TypeError, "faces holds float64", lambda: Tree((numpy.eye(3), [[0.0, 1.0, 2.0]]))),
            (ValueError, "faces has the shape (1, 5), (n, 3) is needed, or (n, 4)", lambda: Tree((numpy.eye(3), [[0] * 5]))),
            (ValueError, "faces[4] is 4, and 3 follow", lambda: Tree((numpy.eye(3), [3, 0, 1, 2, 4, 0, 1, 2]))),
            (ValueError, "faces[0] is 2", lambda: Tree((numpy.eye(3), [2, 0, 1]))),
            (TypeError, "vtkMultiBlockDataSet: a vtkDataSet is needed", lambda: Tree(vtkMultiBlockDataSet())),
            (TypeError, "mesh is none of a vtkDataSet, a pair", lambda: Tree("sphere.vtp"))):
        refused(kind, text, ask)


def test_a_gap_far_away_changes_nothing_where_bodies_overlap():
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(40)
    sphere.SetPhiResolution(20)
    sphere.Update()
    points = 2 * vtk_to_numpy(sphere.GetOutput().GetPoints().GetData())
    triangles = vtk_to_numpy(sphere.GetOutput().GetPolys().GetConnectivityArray())
    triangles = triangles.reshape(-1, 3)
    farthest = points[triangles].mean(axis=1)[:, 0].argmin()
    tree = Tree((numpy.concatenate([points, 0.3 * points + [0.9, 0, 0]]),
        numpy.concatenate([numpy.delete(triangles, farthest, 0), triangles + len(points)])))
    both = numpy.random.default_rng(3).uniform([0.7, -0.2, -0.2], [0.9, 0.2, 0.2], (400, 3))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        assert tree.contains(both).all()
        assert (tree.signed_distance(both).distance < 0).all()


def test_what_vtk_says_is_pythons():
    half = Tree((numpy.eye(3), [[0, 1, 2]]))
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        half.contains(POINTS)
    messages = [str(warning.message) for warning in caught]
    assert len(messages) == 2 and any("3 open edges" in message for message in messages), messages
    assert any("1 of %d points are NaN" % len(POINTS) in message for message in messages), messages
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        half.signed_distance(POINTS)
        Tree(vtkPolyData()).signed_distance(POINTS)
        Tree(vtkPolyData()).contains(POINTS)
    texts = [str(warning.message) for warning in caught + said]
    assert len(texts) == 8, texts  # one of each call is about the point that is not finite
    assert not any(name in text for text in texts for name in ("Source", "Input", "Skd")), texts
    assert caught[0].filename == __file__ and issubclass(caught[0].category, RuntimeWarning)
    image = vtkImageData()
    image.SetDimensions(3, 3, 3)
    assert repr(Tree(image)) == "Tree(vtkImageData of 8 cells)"
    assert Tree(image).contains([[1, 1, 1], [3, 1, 1]]).tolist() == [True, False]


for name, test in list(globals().items()):
    if name.startswith("test_"):
        test()
        print(name)
