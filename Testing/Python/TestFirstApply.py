# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the window shows after the first Apply of each filter, with nothing changed before; and that
these pipelines are saved and loaded as states."""

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import skdtesting

CONTROLLER = servermanager.vtkSMParaViewPipelineControllerWithRendering()


def ball(**properties):
    return simple.Sphere(ThetaResolution=24, PhiResolution=24, **properties)


def line(slope):
    return simple.Line(Point1=[-1, -slope, 0.1], Point2=[1, slope, -0.1])


def grid():
    return simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4])


def ramp(source):
    return simple.Elevation(Input=source, LowPoint=[-3, 0, 0], HighPoint=[3, 0, 0])


# The inputs of each filter: properties that they need, and none else.
PIPELINES = {
    "SkdTreeAMR": lambda: dict(Input=ball()),
    "SkdTreeAttach": lambda: dict(Input=grid()),
    "SkdTreeBooleanOperation": lambda: dict(Input=ball(), Source=ball(Radius=0.6)),
    "SkdTreeClosestPoint": lambda: dict(Input=grid(), Source=ball()),
    "SkdTreeCompareSurfaces": lambda: dict(Input=ball(), Source=ball(Radius=0.6)),
    "SkdTreeCurveIntersection": lambda: dict(Input=line(0.2), Source=line(-0.2)),
    "SkdTreeCurveSurfaceIntersection": lambda: dict(Input=line(0.2), Source=ball()),
    "SkdTreeMeshAdaptation": lambda: dict(Input=ball(Radius=3), Source=ramp(ball(Radius=3))),
    "SkdTreeMeshRefinement": lambda: dict(Input=grid(), Parts=ball(Radius=3)),
    "SkdTreePointInOut": lambda: dict(Input=grid(), Source=ball(Radius=3)),
    "SkdTreeProbe": lambda: dict(Input=ball(Radius=3), Source=grid()),
    "SkdTreeRays": lambda: dict(Input=ball(), Source=ball(Radius=0.6)),
    "SkdTreeRemap": lambda: dict(
        Input=simple.Plane(XResolution=5), Source=ramp(simple.Plane(XResolution=7))),
    "SkdTreeRepresentation": lambda: dict(Input=ball()),
    "SkdTreeSpatialQuery": lambda: dict(Input=grid()),
    "SkdTreeSurfaceIntersection": lambda: dict(Input=ball(Center=[0.4, 0.1, 0]), Source=ball()),
    "SkdTreeWallThickness": lambda: dict(Input=ball()),
}


def make(name, inputs):
    return getattr(simple, name)(registrationName=name, **inputs)


def apply(name):
    """Does what the window does with a new filter: (filter, render view, number of views made)."""
    view = simple.CreateRenderView(ViewSize=[300, 300], Background=[1, 1, 1],
        OrientationAxesVisibility=0, UseColorPaletteForBackground=0)
    inputs = PIPELINES[name]()
    for source in inputs.values():
        simple.Show(source, view, DiffuseColor=[0.5, 0.5, 0.5], ColorArrayName=[None, ""])
    made = make(name, inputs)
    before = len(simple.GetViews())
    for port in range(made.SMProxy.GetNumberOfOutputPorts()):
        CONTROLLER.ShowInPreferredView(made.SMProxy, port, view.SMProxy)
    return made, view, len(simple.GetViews()) - before


def number_of_pixels(view, is_meant):
    simple.ResetCamera(view)
    file = skdtesting.temporary("first_apply.png")
    simple.SaveScreenshot(file, view)
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    colours = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)
    return numpy.count_nonzero(is_meant(*colours[:, :3].T))


def is_coloured(red, green, blue):
    return numpy.maximum(red, numpy.maximum(green, blue)) - numpy.minimum(
        red, numpy.minimum(green, blue)) > 60


def test_every_filter_has_a_pipeline_here():
    names = [proxy.get("name") for group, proxy in skdtesting.our_proxies() if group == "filters"]
    assert sorted(names) == sorted(PIPELINES)


def test_no_filter_opens_a_view():
    for name in PIPELINES:
        _, _, views = apply(name)
        assert views == 0, (name, views)
        simple.ResetSession()


def test_intersections_stand_out_of_opaque_inputs():
    for name, pixels in (("SkdTreeSurfaceIntersection", 300), ("SkdTreeCurveIntersection", 20),
            ("SkdTreeCurveSurfaceIntersection", 20)):
        made, view, _ = apply(name)
        shown = simple.GetRepresentation(made, view)
        assert shown.Representation == "Thick Lines", name
        for parallel in (1, 0):
            view.CameraParallelProjection = parallel
            found = number_of_pixels(view, is_coloured)
            assert found > pixels, (name, parallel, found)
        shown.Representation = "Surface"
        assert number_of_pixels(view, is_coloured) < found, name
        simple.ResetSession()


def test_hits_of_rays_can_be_seen():
    made, view, _ = apply("SkdTreeRays")
    hits = simple.GetRepresentation(simple.OutputPort(made, 1), view)
    assert hits.Representation == "Thick Lines"
    simple.ResetSession()


def test_thick_lines_have_settings_of_their_own():
    made, view, _ = apply("SkdTreeSurfaceIntersection")
    shown = simple.GetRepresentation(made, view)
    thin = number_of_pixels(view, is_coloured)
    shown.ThickLineWidth = 12
    assert number_of_pixels(view, is_coloured) > 2 * thin
    shown.ThickLineColor = [0, 0, 0]
    assert number_of_pixels(view, is_coloured) == 0
    simple.ResetSession()


def test_shapes_of_queries_start_in_the_middle_of_the_data():
    simple.ResetSession()
    source = simple.Sphere(Center=[100, 50, -30], Radius=4)
    simple.UpdatePipeline(proxy=source)
    query = simple.SkdTreeSpatialQuery(Input=source)
    line = numpy.add(query.LinePoint1, query.LinePoint2) / 2
    for middle in (query.SphereCenter, query.PlaneOrigin, query.BoxPosition, line):
        assert numpy.linalg.norm(numpy.subtract(middle, [100, 50, -30])) < 0.1, middle
    assert 0.5 < query.SphereRadius < 4
    assert 2 < min(query.BoxLength) <= max(query.BoxLength) < 6
    simple.ResetSession()


def test_states_with_every_filter_load():
    for file in ("every_filter.pvsm", "every_filter.py"):
        for name, inputs in PIPELINES.items():
            make(name, inputs())
        simple.SaveState(skdtesting.temporary(file))
        simple.ResetSession()
        simple.LoadState(skdtesting.temporary(file))
        for name in PIPELINES:
            loaded = simple.FindSource(name)
            assert loaded is not None, name
            simple.UpdatePipeline(proxy=loaded)
        simple.ResetSession()


skdtesting.run_tests(globals())
