# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rays by ParaView's simple API."""

import numpy
from paraview import simple
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_QUADRATIC_TRIANGLE, vtkImageData, vtkUnstructuredGrid
from vtkskdtree import Tree, vtkSkdTreeRays

import skdtesting


def ball(**properties):
    return simple.Sphere(ThetaResolution=48, PhiResolution=48, **properties)


def test_normals_reach_the_outer_sphere():
    rays = simple.SkdTreeRays(Input=ball(Radius=1), Source=ball(Radius=2))
    distances = skdtesting.point_array(rays, "SkdRayDistance")
    numpy.testing.assert_allclose(distances, 1, atol=1e-2)
    assert (skdtesting.point_array(rays, "SkdRaySide") == -1).all()
    hits = simple.OutputPort(rays, 1)
    hits.UpdatePipeline()
    assert hits.GetDataInformation().GetNumberOfPoints() == len(distances)


def test_an_array_of_vectors_is_chosen_by_name():
    source = simple.Calculator(
        Input=ball(Radius=1), ResultArrayName="Down", Function="-kHat", ResultNormals=0)
    rays = simple.SkdTreeRays(
        Input=source, Source=simple.Plane(Origin=[-5, -5, -3], Point1=[5, -5, -3],
            Point2=[-5, 5, -3]), Along="Array", DirectionArray="Down", Hits="All Hits")
    heights = skdtesting.point_array(rays, "SkdRayDistance")
    assert abs(heights.min() - 2) < 1e-6 and abs(heights.max() - 4) < 1e-6
    assert (skdtesting.point_array(rays, "SkdRayHits") == 1).all()


def test_blocks_are_told_apart():
    group = simple.GroupDatasets(Input=[ball(Radius=2), ball(Radius=1)])
    rays = simple.SkdTreeRays(Input=simple.Line(Point1=[0, 0, 5], Point2=[0.1, 0, 5]), Source=group,
        Along="Direction", Direction=[0, 0, -1], Hits="All Hits", GenerateLines=1)
    assert (skdtesting.point_array(rays, "SkdRayHits") == 4).all()
    assert (skdtesting.point_array(rays, "SkdRayBlockIndex") == 1).all()
    lines = simple.OutputPort(rays, 1)
    lines.UpdatePipeline()
    assert lines.CellData["SkdRayBlockIndex"].GetRange() == (1, 2)



def cast(mesh, source, **properties):
    """The filter after its execution, and the text of its errors and warnings."""
    texts = []

    @calldata_type(VTK_STRING)
    def hear(_caller, _event, text):
        texts.append(text)

    rays = vtkSkdTreeRays()
    rays.AddObserver("ErrorEvent", hear)
    rays.AddObserver("WarningEvent", hear)
    rays.SetInputData(mesh)
    rays.SetSourceData(source)
    for name, value in properties.items():
        getattr(rays, "Set" + name)(value)
    rays.Update()
    return rays.GetOutputDataObject(0), "".join(texts)


def with_array(mesh, values):
    copy = mesh.NewInstance()
    copy.ShallowCopy(mesh)
    array = numpy_to_vtk(numpy.ascontiguousarray(values, float), deep=True)
    array.SetName("array")
    copy.GetPointData().AddArray(array)
    return copy


def distances(output):
    return vtk_to_numpy(output.GetPointData().GetArray("SkdRayDistance"))


def test_too_few_directions_are_refused():
    mesh = with_array(skdtesting.sphere_mesh(24, 1), numpy.ones((3, 3)))
    output, text = cast(mesh, skdtesting.sphere_mesh(24, 2), Along=vtkSkdTreeRays.ARRAY, DirectionArray="array")
    assert "array has 3 tuples for" in text and "no point array" in text, text
    assert numpy.isnan(distances(output)).all()


def test_towards_positions_and_the_nearest_point():
    inner, outer = skdtesting.sphere_mesh(24, 1), skdtesting.sphere_mesh(24, 2)
    corners = vtk_to_numpy(outer.GetPoints().GetData()).astype(float)
    gaps = numpy.linalg.norm(corners - vtk_to_numpy(inner.GetPoints().GetData()), axis=1)
    output, text = cast(with_array(inner, corners), outer, Along=vtkSkdTreeRays.TO_POSITIONS,
        DirectionArray="array")
    numpy.testing.assert_allclose(distances(output), gaps, rtol=1e-12)
    assert not text
    assert "Set DirectionArray" in cast(inner, outer, Along=vtkSkdTreeRays.TO_POSITIONS)[1]
    output, text = cast(inner, outer, Along=vtkSkdTreeRays.TO_NEAREST)
    nearest = Tree(outer).closest(vtk_to_numpy(inner.GetPoints().GetData())).distance
    numpy.testing.assert_allclose(distances(output), nearest, rtol=1e-12)
    assert not text


def test_normals_of_volumes_and_of_nodes_on_edges():
    image = vtkImageData()
    image.SetDimensions(3, 3, 3)
    image.SetOrigin(-1, -1, -1)
    output, text = cast(image, skdtesting.sphere_mesh(24, 9))
    assert not text and numpy.isnan(distances(output)).nonzero()[0].tolist() == [13]
    curved = vtkUnstructuredGrid()
    points = vtkPoints()
    for point in ([0, 0, 0], [1, 0, 0], [0, 1, 0], [.5, 0, 0], [.5, .5, 0], [0, .5, 0]):
        points.InsertNextPoint(point)
    curved.SetPoints(points)
    curved.InsertNextCell(VTK_QUADRATIC_TRIANGLE, 6, range(6))
    output, text = cast(curved, skdtesting.sphere_mesh(24, 9))
    assert not text and (distances(output) > 8).all()


skdtesting.run_tests(globals())
