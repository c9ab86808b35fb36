# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The locator in ParaView's own filters."""

import glob
import os
import sys

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdtesting

LABEL = "SkdTreeCellLocator"


def choose(proxy, name, locator):
    """Since ParaView 5.13 scripts know VTK's own locators by names without blanks."""
    available = proxy.GetProperty(name).Available
    chosen = next(label for label in available if label.replace(" ", "") == locator)
    proxy.__setattr__(name, chosen)


def volume():
    return simple.XMLUnstructuredGridReader(
        FileName=[os.path.join(skdtesting.DATA_DIR, "disk_flow.vtu")])


def resampled(source, locator):
    probe = simple.Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
    filter = simple.ResampleWithDataset(SourceDataArrays=source, DestinationMesh=probe)
    choose(filter, "CellLocator", locator)
    return filter


def test_resample_with_dataset_offers_it():
    filter = resampled(volume(), "StaticCellLocator")
    assert LABEL in filter.GetProperty("CellLocator").Available


def test_resample_with_dataset_gives_the_same_with_it():
    source = volume()
    own = resampled(source, LABEL)
    static = resampled(source, "StaticCellLocator")
    assert own.CellLocator.SMProxy.GetXMLName() == "SkdTreeCellLocator"
    mask = skdtesting.point_array(own, "vtkValidPointMask")
    skdtesting.assert_same(mask, skdtesting.point_array(static, "vtkValidPointMask"))
    assert 0 < mask.sum() < len(mask)
    for name in ("Temp", "V", "Pres"):
        numpy.testing.assert_allclose(skdtesting.point_array(own, name),
            skdtesting.point_array(static, name), rtol=1e-5, atol=1e-6)


def test_its_properties_can_be_set_there():
    filter = resampled(volume(), LABEL)
    filter.CellLocator.LazyBuild = 1
    filter.CellLocator.Epsilon = 1e-6
    filter.CellLocator.SplitRule = "Surface Area"
    lazy = skdtesting.point_array(filter, "Temp")
    # Of the cells that share a point, VTK's filter takes that of its thread's last point, if it can.
    built = skdtesting.point_array(resampled(volume(), LABEL), "Temp")
    numpy.testing.assert_allclose(lazy, built, rtol=1e-14)


def load_lagrangian_tracker():
    """Debian's pvpython does not know where its own plugins are."""
    name = "LagrangianParticleTracker"
    places = os.path.join(sys.prefix, "lib", "*", "paraview-*", "plugins", name, name + ".so")
    files = glob.glob(places)
    if files:
        simple.LoadPlugin(files[0], remote=False, ns=vars(simple))
    return bool(files)


def with_constants(data, **functions):
    """The data with point arrays made by the calculator."""
    for name, function in functions.items():
        data = simple.Calculator(Input=data, ResultArrayName=name, Function=function)
    data.UpdatePipeline()
    return data


def tracked(locator):
    """Particles carried by the flow of a volume mesh, found in it by the locator of that name."""
    line = simple.Line(Point1=[-4, -4, 1], Point2=[4, 4, 8], Resolution=20)
    tracker = simple.LagrangianParticleTracker(
        FlowInput=with_constants(volume(), FlowDensity="1.2", FlowViscosity="0.001"),
        ParticleSeeds=with_constants(
            line, Velocity="kHat", ParticleDensity="1000", ParticleDiameter="0.1"))
    model = tracker.IntegrationModel
    choose(model, "Locator", locator)
    model.FlowVelocity = ["POINTS", "V"]
    model.FlowDensity = ["POINTS", "FlowDensity"]
    model.FlowDynamicViscosity = ["POINTS", "FlowViscosity"]
    model.ParticleInitialVelocity = ["POINTS", "Velocity"]
    model.ParticleDensity = ["POINTS", "ParticleDensity"]
    model.ParticleDiameter = ["POINTS", "ParticleDiameter"]
    tracker.UpdatePipeline()
    return tracker


def lines_of(paths):
    """The points of each line, by their first: with threads lines are in no order."""
    points = vtk_to_numpy(paths.GetPoints().GetData())
    lines = []
    for i in range(paths.GetNumberOfCells()):
        ids = paths.GetCell(i).GetPointIds()  # the same object for all cells
        lines.append(points[[ids.GetId(k) for k in range(ids.GetNumberOfIds())]])
    return sorted(lines, key=lambda line: tuple(line[0]))


def test_the_lagrangian_tracker_gives_the_same_with_it():
    if not load_lagrangian_tracker():
        print("left out: there is no plugin LagrangianParticleTracker")
        return
    own, static = tracked(LABEL), tracked("StaticCellLocator")
    assert own.IntegrationModel.Locator.SMProxy.GetXMLName() == "SkdTreeCellLocator"
    paths = [servermanager.Fetch(tracker) for tracker in (own, static)]
    assert paths[0].GetNumberOfCells() == paths[1].GetNumberOfCells() == 21
    points = [numpy.concatenate(lines_of(path)) for path in paths]
    assert len(points[0]) > 100
    numpy.testing.assert_allclose(points[0], points[1], rtol=1e-6, atol=1e-6)


skdtesting.run_tests(globals())
