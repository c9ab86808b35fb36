# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Boolean operations that users of PyVista reported as wrong or crashing, rebuilt from the texts of
https://github.com/pyvista/pyvista/issues/NUMBER. Files that are not in a text are replaced by meshes
of the same kind."""

import collections

import numpy
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkDelaunay3D, vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkTransformFilter
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkCubeSource, vtkCylinderSource, vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkSTLReader, vtkSTLWriter

import skdtesting
from vtkskdtree import vtkSkdTreeBooleanOperation

UNION, INTERSECTION, DIFFERENCE, REVERSE_DIFFERENCE, SYMMETRIC_DIFFERENCE = range(5)


def new(kind, **properties):
    made = kind()
    for name, value in properties.items():
        getattr(made, "Set" + name)(value)
    return made


def made_by(algorithm, *steps):
    """What an algorithm and those after it make."""
    for step in steps:
        step.SetInputConnection(algorithm.GetOutputPort())
        algorithm = step
    algorithm.Update()
    return algorithm.GetOutput()


def box(*bounds):
    return made_by(new(vtkCubeSource, Bounds=bounds))


def cube(x, y, z):
    return box(-x / 2, x / 2, -y / 2, y / 2, -z / 2, z / 2)


def sphere(radius, center, resolution=30):
    return made_by(new(vtkSphereSource, Radius=radius, Center=center, ThetaResolution=resolution,
        PhiResolution=resolution))


def moved(mesh, *steps):
    """Steps are names of methods of vtkTransform and their arguments."""
    transform = vtkTransform()
    for name, *arguments in steps:
        getattr(transform, name)(*arguments)
    return made_by(new(vtkTransformFilter, Transform=transform, InputData=mesh))


def triangles_of(mesh):
    """Points, and triangles as rows of their numbers."""
    output = dataset_adapter.WrapDataObject(made_by(new(vtkTriangleFilter, InputData=mesh)))
    if output.GetNumberOfPolys() == 0:
        return numpy.zeros((0, 3)), numpy.zeros((0, 3), dtype=int)
    return numpy.asarray(output.Points, dtype=float), vtk_to_numpy(
        output.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def volume_of(mesh):
    points, triangles = triangles_of(mesh)
    a, b, c = (points[triangles[:, i]] - points[:1] for i in range(3))
    return numpy.einsum("ij,ij->i", a, numpy.cross(b, c)).sum() / 6


def polydata(points, faces):
    mesh = vtkPolyData()
    mesh.SetPoints(vtkPoints())
    mesh.GetPoints().SetDataTypeToDouble()
    for point in points:
        mesh.GetPoints().InsertNextPoint(point)
    mesh.Allocate(len(faces))
    for face in faces:
        mesh.InsertNextCell(5 if len(face) == 3 else 7, len(face), [int(i) for i in face])
    return mesh


def combine(first, second, operation):
    """The combination, which must be closed, without a word of warning."""
    filter = new(vtkSkdTreeBooleanOperation, Operation=operation, SourceData=second, InputData=first)
    said = []

    def listen(caller, event, text):
        said.append(text)

    listen.CallDataType = "string0"
    filter.AddObserver("WarningEvent", listen)
    filter.AddObserver("ErrorEvent", listen)
    filter.Update()
    output = filter.GetOutputDataObject(0)
    passes = collections.Counter()
    for triangle in triangles_of(output)[1].tolist():
        for a, b in zip(triangle, triangle[1:] + triangle[:1]):
            passes[min(a, b), max(a, b)] += 1 if a < b else -1
    assert not any(passes.values())
    assert not said, said
    return output


def check(first, second):
    """All five combinations add up. Returns their volumes."""
    volumes = [volume_of(combine(first, second, operation)) for operation in range(5)]
    a, b = abs(volume_of(first)), abs(volume_of(second))
    common = volumes[INTERSECTION]
    expected = [a + b - common, common, a - common, b - common, a + b - 2 * common]
    numpy.testing.assert_allclose(volumes, expected, rtol=0, atol=1e-13 * (a + b))
    return volumes


def by_stl(mesh, name):
    """Written and read: triangles without common points, in single precision."""
    file = skdtesting.temporary(name)
    triangles = made_by(new(vtkTriangleFilter, InputData=mesh))
    new(vtkSTLWriter, FileName=file, FileType=2, InputData=triangles).Write()
    return made_by(new(vtkSTLReader, FileName=file, Merging=False))


def hull(points):
    return made_by(new(vtkDelaunay3D, InputData=polydata(points, [])), vtkGeometryFilter())


def test_1120_access_violation_of_hulls_that_share_most_faces():
    points = numpy.random.default_rng(1).uniform(-1, 1, (40, 3))
    before = hull(points)
    after = hull(numpy.vstack([points, [[1.5, 1.25, 1.75]]]))
    volumes = check(after, before)
    assert abs(volumes[REVERSE_DIFFERENCE]) < 1e-13
    assert volumes[DIFFERENCE] > 0.1


# The corners that the text has of the first three of its solids, prisms over these outlines.
POINTS_OF_1560 = numpy.array([[-2.20416667, -2.12961111, 3.76386111], [-1.96416667, -5.25561111, 3.76386111],
    [-1.96416667, -5.25561111, -2.44013889], [-2.20416667, -2.12961111, -2.44013889],
    [-6.08516667, -5.55861111, 3.76386111], [-6.08516667, -5.55861111, -2.44013889],
    [-6.28916667, -2.49461111, 3.76286111], [-6.28916667, -2.49461111, -2.44013889],
    [-2.11916667, 3.22438889, 1.13886111], [-1.72116667, -2.22661111, 1.13886111],
    [-1.72116667, -2.22661111, -2.86813889], [-2.11916667, 3.22438889, -2.86813889],
    [-6.02416667, -2.64161111, 1.13886111], [-6.02416667, -2.64161111, -2.86813889],
    [-6.22716667, -0.12461111, 1.13886111], [-6.22716667, -0.12461111, -2.86813889],
    [-4.34216667, 0.04638889, 1.13886111], [-4.34216667, 0.04638889, -2.86813889],
    [-4.59116667, 3.03038889, 1.13886111], [-4.59116667, 3.03038889, -2.86813889],
    [8.38683333, 4.08538889, 5.28386111], [8.97183333, -5.02861111, 5.28386111],
    [8.97183333, -5.02861111, -2.72113889], [8.38683333, 4.08538889, -2.72113889],
    [-2.19016667, -5.75961111, 5.28386111], [-2.19016667, -5.75961111, -2.72113889],
    [-2.86516667, 3.43338889, 5.28386111], [-2.86516667, 3.43338889, -2.72113889]])
OUTLINES_OF_1560 = [([0, 1, 4, 6], [3, 2, 5, 7]), ([8, 9, 12, 14, 16, 18], [11, 10, 13, 15, 17, 19]),
    ([20, 21, 24, 26], [23, 22, 25, 27])]


def test_1560_union_of_rooms():
    solids = []
    for top, low in OUTLINES_OF_1560:
        sides = [[top[i - 1], low[i - 1], low[i], top[i]] for i in range(len(top))]
        solids.append(polydata(POINTS_OF_1560, [top, low[::-1]] + sides))
    volumes = [abs(volume_of(solid)) for solid in solids]
    first, second, third = solids
    check(first, second)
    check(combine(first, second, UNION), third)
    whole = volume_of(combine(combine(first, second, UNION), third, UNION))
    common = [volume_of(combine(*pair, INTERSECTION))
        for pair in ((first, second), (first, third), (second, third))]
    three = volume_of(combine(combine(first, second, INTERSECTION), third, INTERSECTION))
    numpy.testing.assert_allclose(whole, sum(volumes) - sum(common) + three, rtol=1e-13)


def test_2788_union_of_sphere_cylinder_and_cone():
    center = (2.4623486548662186, 15.274176120758057, 2.042705088853836)
    head = sphere(1, center)
    stick = moved(made_by(new(vtkCylinderSource, Radius=0.5, Height=center[1], Resolution=100)),
        ("Translate", center[0], center[1] / 2, center[2]))
    cone = made_by(new(vtkConeSource, Center=(1.7672341, 16.30967, 1.2092979), Height=3, Radius=1, Resolution=8,
        Direction=(-0.4634096920490265, 0.6903295516967773, -0.5556047558784485)))
    check(head, stick)
    check(combine(head, stick, UNION), cone)


def test_3290_no_points_to_subdivide():
    block = cube(2, 2, 2)
    inner, outer = sphere(0.5, (0, 0, 0)), sphere(0.5, (4, 0, 0))
    numpy.testing.assert_allclose(check(block, inner)[DIFFERENCE], 8 - volume_of(inner), rtol=1e-14)
    assert check(block, outer)[DIFFERENCE] == 8
    assert check(block, outer)[INTERSECTION] == 0
    rod = made_by(new(vtkCylinderSource, Radius=0.5, Height=3, Resolution=64))
    area = 64 / 2 * 0.25 * numpy.sin(2 * numpy.pi / 64)
    numpy.testing.assert_allclose(check(block, rod)[INTERSECTION], 2 * area, rtol=1e-6)


def heights(x, y):
    return (numpy.sin(x**2) + numpy.cos(y**2)) / 2 - 0.8


def solid_below(n=32, low=-3):
    """Between the text's surface, which is open, and a plane."""
    x, y = (grid.ravel() for grid in numpy.meshgrid(*2 * [numpy.linspace(-1.6, 1.6, n)], indexing="ij"))
    points = numpy.vstack([numpy.column_stack([x, y, heights(x, y)]), numpy.column_stack([x, y, x * 0 + low])])
    at = numpy.arange(n * n).reshape(n, n)
    corners = [corner.ravel() for corner in (at[:-1, :-1], at[1:, :-1], at[1:, 1:], at[:-1, 1:])]
    top = [numpy.column_stack([corners[0], corners[i], corners[i + 1]]) for i in (1, 2)]
    around = numpy.concatenate([at[:-1, 0], at[-1, :-1], at[:0:-1, -1], at[0, :0:-1]])
    after = numpy.roll(around, -1)
    faces = numpy.vstack(top + [triangles[:, ::-1] + n * n for triangles in top] +
        [numpy.column_stack([after, around, around + n * n]),
            numpy.column_stack([after, around + n * n, after + n * n])])
    return polydata(points, faces)


def test_4059_intersection_of_two_manifolds():
    block = cube(3, 3, 4.2)
    dx, dy, dz, dk = -0.804, 1.6, 2.2, 2
    points = [[-dx, -dy, -dz], [-dx, dy, -dz], [dx, -dy, dz], [dx, dy, dz], [dk, -dy, -dz], [dk, dy, -dz],
        [dk, -dy, dz], [dk, dy, dz]]
    wedge = polydata(points, [[0, 2, 3, 1], [4, 5, 7, 6], [0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3]])
    numpy.testing.assert_allclose(check(block, wedge)[INTERSECTION], 1.5 * 3 * 4.2, rtol=1e-6)
    ground = solid_below()
    check(ground, block)
    check(combine(ground, block, INTERSECTION), wedge)


def test_4796_identical_spheres():
    ball = sphere(0.5, (0, 0, 0))
    volumes = check(ball, sphere(0.5, (0, 0, 0)))
    numpy.testing.assert_allclose(volumes, [volume_of(ball)] * 2 + [0] * 3, rtol=1e-14)


def test_4810_stl_files():
    plate = by_stl(cube(4, 3, 0.7), "TestBooleanThreadsPlate.stl")
    rod = moved(made_by(new(vtkCylinderSource, Radius=0.5, Height=2, Resolution=48)), ("RotateX", 90),
        ("Translate", 0.3, 0.1, 0.2))
    check(plate, by_stl(rod, "TestBooleanThreadsRod.stl"))


def test_4843_crossing_boxes():
    volumes = check(cube(1, 18, 27), cube(1.1, 10, 10))
    numpy.testing.assert_allclose(volumes[DIFFERENCE], 18 * 27 - 100, rtol=1e-14)


def test_4973_bracket_in_a_box_of_half_its_bounds():
    bracket = combine(box(0, 4, 0, 3, 0, 0.5), box(0, 0.5, 0, 3, 0, 2), UNION)
    rod = moved(made_by(new(vtkCylinderSource, Radius=0.6, Height=2, Resolution=40)), ("Translate", 2.5, 1.5, 0),
        ("RotateX", 90))
    bracket = by_stl(combine(bracket, rod, DIFFERENCE), "TestBooleanThreadsBracket.stl")
    half = box(0, 2, 0, 3, 0, 2)
    check(half, bracket)


def test_5995_before_and_after():
    before = sphere(1, (0, 0, 0), 40)
    points, triangles = triangles_of(before)
    is_moved = points[:, 2] > 0.6
    points[is_moved] *= 1 + 0.2 * (points[is_moved, 2:] - 0.6)
    points[:, 0] *= numpy.where(points[:, 2] < -0.7, 0.9, 1)
    check(before, polydata(points, triangles))


def test_6688_union_of_two_spheres():
    check(sphere(22.443613622177708, (60.69442458, 148.23356447, -607.05434454), 50),
        sphere(19.99923563231063, (60.83777191, 147.54242583, -610.92167808), 50))


def test_7548_window_in_a_wall():
    for width in (3, 6):
        volumes = check(box(0, width, 0, 3, -0.1, 0.1), box(1, 2, 1, 2, -0.2, 0.2))
        numpy.testing.assert_allclose(volumes[DIFFERENCE], 0.2 * (3 * width - 1), rtol=1e-6)
        numpy.testing.assert_allclose(volumes[UNION], 0.2 * (3 * width + 1), rtol=1e-6)


skdtesting.run_tests(globals())
