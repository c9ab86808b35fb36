# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Operations on meshes from Python: volumes, areas and distances are those of formulas, results are of the
caller's kind and can be combined again, what is wrong is refused by name."""

import os
import re
import sys
import types
import warnings

import numpy
import vtkskdtree
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkskdtree import Tree, vtkSkdTreeBooleanOperation

import skdtesting

warnings.simplefilter("error")

CORNERS = numpy.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
SIDES = numpy.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
FACES = SIDES[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3)
EMPTY = (numpy.empty((0, 3)), numpy.empty((0, 3), int))
OPEN = (CORNERS, FACES[2:])


def box(low, high):
    low, high = numpy.broadcast_to(low, 3), numpy.broadcast_to(high, 3)
    return low + (numpy.asarray(high) - low) * CORNERS, FACES


def cube(low, high):
    """The same as a data set, of quads."""
    source = vtkCubeSource()
    source.SetBounds(*numpy.stack([numpy.broadcast_to(low, 3), numpy.broadcast_to(high, 3)], 1).ravel())
    source.Update()
    return source.GetOutput()


def ball(radius=1.0):
    return skdtesting.sphere_mesh(32, radius)


def volume(mesh):
    """Of the solid within triangles, which must be closed."""
    points, faces = mesh
    edges = numpy.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    forth, back = (numpy.sort(ends[:, 0] * len(points) + ends[:, 1]) for ends in (edges, edges[:, ::-1]))
    numpy.testing.assert_array_equal(forth, back)
    corners = points[faces]
    return numpy.linalg.det(corners).sum() / 6.0


def area(mesh):
    corners = mesh[0][mesh[1]]
    normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return numpy.linalg.norm(normals, axis=1).sum() / 2


def reported(mesh, name="Volume"):
    return mesh.GetFieldData().GetArray("SkdReport" + name).GetValue(0)


def near(value, expected):
    numpy.testing.assert_allclose(value, expected, rtol=1e-12, atol=1e-14)


def refused(kind, texts, ask):
    try:
        ask()
    except kind as error:
        assert all(text in str(error) for text in texts), error
        return
    raise AssertionError(("not refused", texts))


FOUR = (vtkskdtree.union, vtkskdtree.intersection, vtkskdtree.difference, vtkskdtree.symmetric_difference)


def test_volumes_of_two_and_three_boxes():
    a, b, c = (0, 1), ((0.5, 0, 0), (1.5, 1, 1)), ((0.25, 0.5, 0.5), (1.25, 1.5, 1.5))
    expected = {2: (1.5, 0.5, 0.5, 1.0), 3: (2.25, 0.125, 0.4375, 1.75)}
    for many, values in expected.items():
        for operation, value in zip(FOUR, values):
            made = operation(*(box(*bounds) for bounds in (a, b, c)[:many]))
            near(volume(made), value)
            near(reported(operation(*(cube(*bounds) for bounds in (a, b, c)[:many]))), value)


def test_operations_are_those_of_regular_grids():
    """Of boxes with corners on a grid, against the count of its cells."""
    random = numpy.random.default_rng(5)
    middles = numpy.stack(numpy.meshgrid(*[numpy.arange(6) + 0.5] * 3), -1).reshape(-1, 3)
    for _ in range(25):
        low = random.integers(0, 4, (int(random.integers(2, 6)), 3))
        high = low + random.integers(1, 4, low.shape)
        within = ((low[:, None] < middles) & (middles < high[:, None])).all(2)
        counts = (within.any(0), within.all(0), within[0] & ~within[1:].any(0), within.sum(0) % 2 == 1)
        for operation, cells in zip(FOUR, counts):
            near(volume(operation(*map(box, low, high))), cells.sum())


def test_empty_meshes_are_empty_solids():
    a, b = box(0, 1), box(0.5, 1.5)
    for many in ([], [b]):
        for place in range(len(many) + 2):
            meshes = [a, *many]
            meshes.insert(place, EMPTY)
            solid = volume(vtkskdtree.union(*meshes))
            near(solid, 1.875 if many else 1.0)
            assert len(vtkskdtree.intersection(*meshes).faces) == 0
            left = (0.875 if many else 1.0) if place else 0.0
            near(volume(vtkskdtree.difference(*meshes)), left)
            near(volume(vtkskdtree.symmetric_difference(*meshes)), 1.75 if many else 1.0)
    flat = (CORNERS * [1, 1, 0], FACES)
    assert len(vtkskdtree.intersection(a, b, flat).faces) == 0
    assert vtkskdtree.union(EMPTY, EMPTY).points.shape == (0, 3)


def test_chains_of_operations():
    plate = box(0, (8, 8, 1))
    for i in range(12):
        x, y = 0.5 + 2 * (i % 4), 0.5 + 2 * (i // 4)
        plate = vtkskdtree.difference(plate, box((x, y, -1), (x + 1, y + 1, 2)))
        near(volume(plate), 64 - (i + 1))
    mesh = cube(0, 4)
    for i in range(4):
        mesh = vtkskdtree.difference(mesh, cube((i + 0.25, 0.25, -1), (i + 0.75, 0.75, 5)))
    assert mesh.IsA("vtkPolyData")
    near(reported(mesh), 64 - 4 * 0.25 * 4)


def test_results_are_those_of_the_filter():
    a, b = ball(), ball()
    b.GetPoints().SetData(vtk_moved(b))
    for number, operation in ((0, FOUR[0]), (1, FOUR[1]), (2, FOUR[2]), (4, FOUR[3])):
        made = vtkSkdTreeBooleanOperation()
        made.SetOperation(number)
        made.SetInputData(a)
        made.SetSourceData(b)
        made.Update()
        mine, filters = operation(a, b), made.GetOutput()
        numpy.testing.assert_array_equal(vtk_to_numpy(mine.GetPoints().GetData()),
            vtk_to_numpy(filters.GetPoints().GetData()))
        numpy.testing.assert_array_equal(vtk_to_numpy(mine.GetPolys().GetConnectivityArray()),
            vtk_to_numpy(filters.GetPolys().GetConnectivityArray()))


def vtk_moved(mesh):
    from vtkmodules.util.numpy_support import numpy_to_vtk
    return numpy_to_vtk(vtk_to_numpy(mesh.GetPoints().GetData()).astype(float) + [0.5, 0.25, 0.125], deep=True)


def test_splits_by_planes_and_sheets():
    for normal in numpy.vstack([numpy.eye(3), -numpy.eye(3), numpy.random.default_rng(3).normal(size=(6, 3))]):
        parts = vtkskdtree.split(box(-0.5, 0.5), ((0, 0, 0), normal))
        near([volume(parts.front), volume(parts.behind)], 0.5)
        assert (parts.front.points @ normal > -1e-15).all() and (parts.behind.points @ normal < 1e-15).all()
    parts = vtkskdtree.split(cube(0, 1), ([5, 7, 0.25], [0, 0, 1e300]))
    near([reported(part) for part in parts], (0.75, 0.25))
    assert parts.front.GetBounds()[4] == 0.25 == parts.behind.GetBounds()[5]
    parts = vtkskdtree.split(box(0, 1), ((0, 0, 3), (0, 0, 1)))
    assert len(parts.front.faces) == 0
    near(volume(parts.behind), 1.0)
    far = ((0, 0, -1e200), (0, 1e-3, 1))
    assert len(vtkskdtree.section(box(0, 1), far).faces) == len(vtkskdtree.split(box(0, 1), far).behind.faces) == 0
    near(volume(vtkskdtree.split(box(0, 1), far).front), 1.0)
    # A roof as a sheet, and a closed cutter.
    roof = (numpy.array([[-1, -1, 0], [2, -1, 0], [2, 0.5, 0.75], [-1, 0.5, 0.75], [2, 2, 0], [-1, 2, 0]]),
        numpy.array([[0, 1, 2, 3], [3, 2, 4, 5]]))
    parts = vtkskdtree.split(box(0, 1), roof)
    near((volume(parts.front), volume(parts.behind)), (0.375, 0.625))
    near([volume(part) for part in vtkskdtree.split(box(0, 1), box(0.5, 2))], (0.875, 0.125))


def test_parts_of_data_sets_keep_their_arrays():
    mesh = cube(0, 1)
    named = numpy.arange(mesh.GetNumberOfCells(), dtype=float)
    array = vtkskdtree.arrays.to_vtk(named)
    array.SetName("number")
    mesh.GetCellData().AddArray(array)
    sheet = surface_at(0.25)
    for part, height in zip(vtkskdtree.split(mesh, sheet), ((0.25, 1.0), (0.0, 0.25))):
        assert part.GetBounds()[4:] == height
        assert part.GetCellData().GetArray("SkdPartId").GetRange() == (float(height[0] == 0), ) * 2
        assert part.GetCellData().GetArray("SkdCellId").GetNumberOfTuples() == part.GetNumberOfCells() >= 6
        near(reported(part), height[1] - height[0])
    several = (numpy.vstack([surface_at(0.25)[0], surface_at(0.5)[0]]), numpy.array([[0, 1, 2], [3, 4, 5]]))
    parts = vtkskdtree.split(box(0, 1), several)
    near((volume(parts.front), volume(parts.behind)), (0.5, 0.5))


def surface_at(z):
    """A sheet, upwards."""
    return numpy.array([[-9, -9, z], [20, -9, z], [-9, 20, z]]), numpy.array([[0, 1, 2]])


def test_sections_are_within():
    found = vtkskdtree.section(box(0, 2), ((0, 0, 0.5), (0, 0, 3)))
    near(area(found), 4.0)
    assert (found.points[:, 2] == 0.5).all()
    corners = found.points[found.faces]
    assert (numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])[:, 2] > 0).all()
    hexagon = vtkskdtree.section(box(-1, 1), ((0, 0, 0), (1, 1, 1)))
    near(area(hexagon), 3 * numpy.sqrt(3))
    hexagon = vtkskdtree.section(cube(-1, 1), ((0, 0, 0), (1, 1, 1)))
    assert hexagon.GetNumberOfCells() == 1 and hexagon.GetCell(0).GetNumberOfPoints() == 6
    hollow = vtkskdtree.difference(cube(0, 3), cube(1, 2))
    found = vtkskdtree.section(hollow, ((0, 0, 1.5), (0, 0, 1)))
    assert found.IsA("vtkPolyData")
    near(area((vtk_to_numpy(found.GetPoints().GetData()),
        vtk_to_numpy(found.GetPolys().GetConnectivityArray()).reshape(-1, 3))), 8.0)
    assert len(vtkskdtree.section(box(0, 1), ((0, 0, 5), (0, 0, 1))).faces) == 0


def test_curves():
    curve, = vtkskdtree.intersection_curves(box(0, 1), ((0, 0, 0.25), (0, 0, 1)))
    assert (curve[0] == curve[-1]).all() and (curve[:, 2] == 0.25).all()
    near(numpy.linalg.norm(numpy.diff(curve, axis=0), axis=1).sum(), 4.0)
    curves = vtkskdtree.intersection_curves(box(0, (9, 1, 1)), box((1, -1, -1), (2, 2, 2)))
    assert len(curves) == 2 and {tuple(set(each[:, 0])) for each in curves} == {(1.0, ), (2.0, )}
    apart = vtkskdtree.intersection_curves(box(0, 1), box(2, 3))
    assert apart == []
    point, = vtkskdtree.intersection_curves(box(0, 1), box(1, 2))
    assert (point == [[1, 1, 1]]).all()
    assert vtkskdtree.intersection_curves(ball(), cube(0, 2)).GetCellData().GetArray("SkdCurveLength")
    twice = vtkskdtree.intersection_curves((numpy.vstack([box(0, 2)[0], box((1, 0.5, 0.5), (3, 1.5, 1.5))[0]]),
        numpy.vstack([FACES, FACES + 8])))
    near(sum(numpy.linalg.norm(numpy.diff(each, axis=0), axis=1).sum() for each in twice), 4.0)


def moved(x):
    matrix = numpy.eye(4)
    matrix[0, 3] = x
    return matrix


def test_collisions_are_exact():
    a, b = box(0, 1), box(0, 1)
    last = numpy.nextafter(1.0, 2.0)
    for mesh in (a, Tree(a)):
        assert vtkskdtree.collide(mesh, b, moved(1.0)) is True
        assert vtkskdtree.collide(mesh, b, transform=moved(last)) is False
        assert vtkskdtree.collide(mesh, Tree(box(0.25, 0.75))) is False  # one within the other
    tree = Tree(cube(0, 1))
    for x in (0.5, last, -1.0, -last, 0.0):
        assert tree.collide(b, moved(x)) == (abs(x) <= 1)
        found = tree.collide(b, moved(x), pairs=True)
        assert found.shape[1:] == (2, ) and (len(found) > 0) == (abs(x) <= 1)
    boxes = tree.collide(b, moved(0.5), pairs=True)
    candidates = tree.pairs((b[0] + [0.5, 0, 0], b[1]))
    assert set(map(tuple, boxes)) <= set(zip(candidates.query, candidates.cell))
    numpy.testing.assert_array_equal(boxes, numpy.unique(boxes, axis=0))
    assert set(boxes[:, 0]) <= set(range(6)) and set(boxes[:, 1]) == set(range(10))


def test_distances_of_parallel_squares_and_boxes():
    square = numpy.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
    faces = numpy.array([[0, 1, 2, 3]])
    found = vtkskdtree.compare((square, faces), (square + [0, 0, 0.25], faces))
    for each in found:
        near((each.hausdorff, each.mean, each.rms, each.median), 0.25)
        near(abs(each.end - each.start), (0, 0, 0.25))
    found = vtkskdtree.compare(box(0, 1), box(0, (1, 1, 3)))
    assert 2.0 <= found.hausdorff <= found.both.hausdorff_bound <= 2.0 + 1e-4
    assert (found.a_to_b.hausdorff, found.b_to_a.hausdorff) == (1.0 * found.a_to_b.hausdorff, found.hausdorff)
    # From the tall box, of area 14: distances 0 to 2 on four sides of 2, and 2 on its top.
    numpy.testing.assert_allclose(found.b_to_a.mean, (8 * 1.0 + 2.0) / 14, rtol=0.02)
    numpy.testing.assert_allclose(found.b_to_a.rms, numpy.sqrt((8 * 4 / 3 + 4) / 14), rtol=0.02)
    assert numpy.isnan(found.both.signed_mean)
    inner = vtkskdtree.compare(ball(0.5), ball(1.0), signed=True)
    assert -0.51 < inner.a_to_b.signed_mean < -0.48 and 0.48 < inner.b_to_a.signed_mean < 0.51
    assert found.mean == found.both.mean and found.rms == found.both.rms


def test_thickness_of_a_plate():
    plate = box(0, (3, 4, 0.5))
    cells = vtkskdtree.thickness(plate, at="cells")
    near(numpy.sort(cells.thickness), numpy.repeat([0.5, 3, 4], 4))
    assert set(cells.cell) == set(range(12))
    widest = vtkskdtree.thickness(ball(), method="spheres").GetPointData().GetArray("SkdThickness").GetRange()[1]
    numpy.testing.assert_allclose(widest, 2.0, rtol=numpy.finfo(numpy.float32).eps)  # of the points
    inside_out = vtkskdtree.thickness((plate[0], FACES[:, ::-1]), at="cells", reversed=True)
    near(inside_out.thickness, cells.thickness)
    mesh = vtkskdtree.thickness(cube(0, 1), at="cells")
    near(vtk_to_numpy(mesh.GetCellData().GetArray("SkdThickness")), 1.0)
    assert numpy.isnan(caught("2 have nothing opposite", vtkskdtree.thickness,
        (CORNERS, FACES[[0, 1]]), at="cells", maximum=0.0).thickness).all()


def caught(text, function, *given, **options):
    """What a function returns that warns once, of what is in this file."""
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        result = function(*given, **options)
    assert len(found) == 1 and found[0].category is RuntimeWarning, found
    assert text in str(found[0].message) and found[0].filename == __file__, found[0]
    return result


def grid(cells, low=0.0, high=1.0):
    """A square of triangles in the plane z = 0."""
    ticks = numpy.linspace(low, high, cells + 1)
    points = numpy.stack([*numpy.meshgrid(ticks, ticks, indexing="ij"), numpy.zeros((cells + 1, cells + 1))], -1)
    first = (numpy.arange(cells)[:, None] * (cells + 1) + numpy.arange(cells)).ravel()[:, None]
    square = first + [0, cells + 1, cells + 2, 0, cells + 2, 1]
    return points.reshape(-1, 3), square.reshape(-1, 3)


def test_remapped_fields():
    coarse, fine = grid(4), grid(7)
    middles = [mesh[0][mesh[1]].mean(1) for mesh in (coarse, fine)]
    values = middles[0] @ [1, 2, 0] + 3
    found = vtkskdtree.remap(coarse, fine, {"t": values, "v": middles[0]}, method="first_order")
    assert list(found) == ["t", "v"] and found["v"].shape == (98, 3)
    near(found["t"].mean(), values.mean())  # all triangles of a mesh have the same area
    linear = coarse[0] @ [1, 2, 0] + 3
    at = vtkskdtree.remap(coarse, fine, {"t": linear}, method="interpolation", on="points")["t"]
    near(at, fine[0] @ [1, 2, 0] + 3)
    image = vtkImageData()
    image.SetDimensions(5, 5, 1)
    image.SetSpacing(0.25, 0.25, 1)
    onto = vtkskdtree.remap(coarse, image, {"t": values}, method="first_order", on="cells")
    assert onto.IsA("vtkImageData")
    near(vtk_to_numpy(onto.GetCellData().GetArray("t")).mean(), values.mean())
    again = vtkskdtree.remap(onto, coarse, ["t"])
    assert list(again) == ["t"]
    near(again["t"].mean(), values.mean())
    assert set(vtkskdtree.remap(onto, coarse)) >= {"t", "SkdCoverage"}


class Mesh(vtkPolyData):
    """What stands for a mesh of PyVista, which need not be installed here."""


Mesh.__module__ = "pyvista.core.pointset"


def stand_in_for_pyvista():
    """Its parts that vtkskdtree uses."""
    stand_in, accessors = types.ModuleType("pyvista"), {}

    def wrap(mesh):
        made = Mesh()
        made.ShallowCopy(mesh)
        return made

    stand_in.wrap = wrap
    stand_in.DataSet = Mesh
    stand_in.register_dataset_accessor = lambda name, target: lambda kind: accessors.update({(name, target): kind})
    sys.modules["pyvista"] = stand_in
    return stand_in, accessors


def test_accessor():
    """With PyVista 0.48 or later itself, where it is installed for the Python that runs this, else a stand-in."""
    pyvista = pyvista_with_accessors()
    if pyvista:
        import vtkskdtree.accessor
        mesh, kind = pyvista.Cube(center=(0.5, 0.5, 0.5)).triangulate(), pyvista.PolyData
        skd = mesh.skd
    else:
        print("PyVista 0.48 or later is not here: a stand-in for it")
        stand_in, accessors = stand_in_for_pyvista()
        import vtkskdtree.accessor
        mesh, kind = stand_in.wrap(cube(0, 1)), Mesh
        skd = accessors["skd", Mesh](mesh)
    near(skd.closest([[2.0, 0.5, 0.5]]).distance, [1.0])
    assert skd.tree is skd.tree and skd.contains([[0.5, 0.5, 0.5], [2, 0, 0]]).tolist() == [True, False]
    assert skd.collide(cube(0.5, 2)) and not skd.collide(cube(2, 3))
    united = skd.union(cube(0.5, 2))
    assert isinstance(united, kind)
    near(reported(united), 1 + 1.5 ** 3 - 0.125)
    assert "within any of the meshes" in skd.union.__doc__
    if not pyvista:
        del sys.modules["pyvista"], sys.modules["vtkskdtree.accessor"]


def pyvista_with_accessors():
    try:
        import pyvista
    except ImportError:
        return None
    return pyvista if hasattr(pyvista, "register_dataset_accessor") else None


def test_meshes_of_pyvista_give_such():
    stand_in, _ = stand_in_for_pyvista()
    wrap = stand_in.wrap
    mesh, other = wrap(cube(0, 1)), cube(0.5, 2)
    for made in (vtkskdtree.union(mesh, other), *vtkskdtree.split(mesh, other), vtkskdtree.section(mesh, other),
            vtkskdtree.intersection_curves(mesh, other), vtkskdtree.thickness(mesh, at="cells"),
            vtkskdtree.difference(Tree(mesh), other)):
        assert type(made) is Mesh and made.GetNumberOfPoints()
    assert type(vtkskdtree.union(other, mesh)) is type(other) is not Mesh
    del sys.modules["pyvista"]


def test_all_kinds_of_meshes():
    like_trimesh = types.SimpleNamespace(vertices=CORNERS, faces=FACES)
    quads, source = [CORNERS, SIDES], vtkCubeSource()
    source.SetBounds(0, 1, 0, 1, 0, 1)
    image = vtkImageData()
    image.SetDimensions(2, 2, 2)
    for mesh in (like_trimesh, quads, source, image, Tree(box(0, 1)), (CORNERS.astype(numpy.float32), FACES)):
        made = vtkskdtree.difference(mesh, box(0.5, 2))
        near(reported(made) if hasattr(made, "IsA") else volume(made), 0.875)
    assert isinstance(vtkskdtree.union(like_trimesh, image), tuple)
    assert vtkskdtree.union(source, quads).IsA("vtkPolyData")


def test_what_is_wrong_is_named():
    a = box(0, 1)
    for operation in FOUR:
        refused(TypeError, ["b"], lambda: operation(a))
        refused(ValueError, ["b", "points", "(8, 2)"], lambda: operation(a, (CORNERS[:, :2], FACES)))
        refused(ValueError, ["others[0]", "faces names points"], lambda: operation(a, a, (CORNERS, FACES + 1)))
        refused(TypeError, ["a is none of"], lambda: operation(None, a))
    refused(RuntimeError, ["a is not a closed", "4 edges are open"], lambda: vtkskdtree.union(OPEN, a))
    refused(RuntimeError, ["b is not a closed"], lambda: vtkskdtree.union(a, OPEN))
    refused(RuntimeError, ["others[0] is not a closed"], lambda: vtkskdtree.union(a, a, OPEN))
    refused(RuntimeError, ["mesh is not a closed"], lambda: vtkskdtree.split(OPEN, ((0, 0, 0.5), (0, 0, 1))))
    small = (numpy.array([[0.2, 0.2, 0.5], [0.8, 0.2, 0.5], [0.5, 0.8, 0.5]]), [[0, 1, 2]])
    near(volume(caught("does not cut through", vtkskdtree.difference, a, small)), 1.0)
    refused(ValueError, ["cutter", "normal"], lambda: vtkskdtree.split(a, ((0, 0, 0), (0, 0, 0))))
    refused(ValueError, ["cutter", "finite"], lambda: vtkskdtree.section(a, ((0, 0, 0), (0, 0, numpy.nan))))
    refused(ValueError, ["b", "finite"], lambda: vtkskdtree.intersection_curves(a, ((0, numpy.inf, 0), (0, 0, 1))))
    caught("b has no faces", vtkskdtree.intersection_curves, a, EMPTY)
    refused(ValueError, ["transform", "(3, 4)"], lambda: vtkskdtree.collide(a, a, numpy.eye(4)[:3]))
    refused(RuntimeError, ["not rigid"], lambda: vtkskdtree.collide(a, a, 2 * numpy.eye(4)))
    refused(ValueError, ["b: points"], lambda: vtkskdtree.collide(a, (CORNERS[:, :2], FACES)))
    refused(ValueError, ["a: points", "[points]"], lambda: vtkskdtree.union((CORNERS[0], FACES), a))
    assert numpy.isnan(caught("b has no finite point", vtkskdtree.compare, a, EMPTY).hausdorff)
    refused(ValueError, ["tolerance"], lambda: vtkskdtree.compare(a, a, tolerance=-1))
    for option in (dict(at="faces"), dict(method="ray"), dict(rays=0), dict(rays=1001), dict(cone_angle=90)):
        refused(ValueError, list(option), lambda: vtkskdtree.thickness(a, **option))
    refused(ValueError, ["arrays['t']", "(5,)", "8 points", "12 cells"],
        lambda: vtkskdtree.remap(a, a, {"t": numpy.zeros(5)}))
    refused(TypeError, ["arrays['t']"], lambda: vtkskdtree.remap(a, a, {"t": ["x"] * 8}))
    tetrahedron = (numpy.vstack([numpy.zeros(3), numpy.eye(3)]), [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]])
    refused(ValueError, ["not clear"], lambda: vtkskdtree.remap(tetrahedron, a, {"t": numpy.zeros(4)}))
    refused(TypeError, ["arrays is 't'"], lambda: vtkskdtree.remap(a, a, "t"))
    refused(KeyError, ["source has no array", "'t'"], lambda: vtkskdtree.remap(a, a, ["t"]))
    refused(ValueError, ["method", "second_order"], lambda: vtkskdtree.remap(a, a, method="exact"))


def test_examples_of_the_guide():
    page = os.path.join(os.environ["SKDTREE_SOURCE_DIR"], "Plugin", "Documentation", "Python.md")
    with open(page, encoding="utf-8") as file:
        codes = re.findall(r"^```python\n(.*?)^```$", file.read(), re.MULTILINE | re.DOTALL)
    codes = [code for code in codes if re.search(r"import .*\b(union|remap)\b", code, re.DOTALL)]
    assert len(codes) == 2
    found = {}
    for code in codes:
        exec(compile(code, page, "exec"), found)
    near(volume(found["plate"]), 6.0)
    near([volume(found["left"]), volume(found["right"])], 3.0)
    near(vtk_to_numpy(found["mapped"].GetCellData().GetArray("heat")).mean(), 7.5)


for name, test in list(globals().items()):
    if name.startswith("test_"):
        print(name, flush=True)
        test()
