# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The examples run, and their pictures show something."""

import os
import shutil
import subprocess

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import skdtesting


def run(example, *arguments):
    """As a reader would, by pvpython; without a display, by one that is made up."""
    command = ["pvpython", os.path.join(skdtesting.SOURCE_DIR, "Plugin", "Examples", example)]
    if not os.environ.get("DISPLAY"):
        if shutil.which("Xvfb") is None:
            skdtesting.skip("there is no display")
        command = ["bash", os.path.join(skdtesting.SOURCE_DIR, ".ci", "with_display.sh")] + command
    result = subprocess.run(
        command + list(arguments), capture_output=True, text=True, timeout=300)
    assert result.returncode == 0 and "ERR|" not in result.stderr, result.stdout + result.stderr
    return result.stdout


def pixels(file):
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())


def fresh_picture(name):
    picture = skdtesting.temporary(name)
    if os.path.exists(picture):
        os.remove(picture)
    return picture


def test_closest_point():
    picture = fresh_picture("closest_point_example.png")
    said = run("ClosestPoint.py", os.path.join(skdtesting.DATA_DIR, "disk_flow.vtu"), picture)
    assert "SkdDistance  from    3.2" in said, said
    colours = pixels(picture)
    is_background = (colours == 255).all(axis=1)
    assert 0.2 < is_background.mean() < 0.8
    assert len(numpy.unique(colours[~is_background], axis=0)) > 100


def test_probe():
    picture = fresh_picture("probe_example.png")
    said = run("Probe.py", os.path.join(skdtesting.DATA_DIR, "disk_flow.vtu"), picture)
    assert "stretches: 66" in said, said
    colours = pixels(picture)
    is_background = (colours == 255).all(axis=1)
    assert 0.2 < is_background.mean() < 0.8
    assert len(numpy.unique(colours[~is_background], axis=0)) > 100


def test_attach():
    picture = fresh_picture("attach_example.png")
    said = run("Attach.py", os.path.join(skdtesting.DATA_DIR, "disk_flow.vtu"), picture)
    assert "without: " in said and "with: " in said, said
    is_background = (pixels(picture) == 255).all(axis=1)
    assert 0.2 < is_background.mean() < 0.95


def test_point_in_out():
    picture = fresh_picture("point_in_out_example.png")
    said = run("PointInOut.py", skdtesting.DATA_DIR, picture)
    assert "PointsInside 230182" in said and "OpenEdges    0" in said, said
    is_background = (pixels(picture) == 255).all(axis=1)
    assert 0.5 < is_background.mean() < 0.95


def test_curve_surface_intersection():
    picture = fresh_picture("curve_surface_intersection_example.png")
    files = [os.path.join(skdtesting.DATA_DIR, name)
        for name in ("fly_brain_neuron.vtp", "fly_brain_lateral_horn.vtp")]
    said = run("CurveSurfaceIntersection.py", *files, picture)
    assert "goes in 1 times, out 0 times" in said, said
    colours = pixels(picture)
    is_background = (colours == 255).all(axis=1)
    assert 0.3 < is_background.mean() < 0.95
    assert len(numpy.unique(colours[~is_background], axis=0)) > 100


def test_amr():
    picture = fresh_picture("amr_example.png")
    files = [os.path.join(skdtesting.DATA_DIR, "fly_brain_%s.vtp" % name)
             for name in ("neuropil", "neuron")]
    said = run("AMR.py", *files, picture)
    assert "CutCells           10143" in said, said
    colours = pixels(picture)
    is_background = (colours == 255).all(axis=1)
    assert 0.2 < is_background.mean() < 0.8
    assert len(numpy.unique(colours[~is_background], axis=0)) > 100


def test_surface_intersection():
    picture = fresh_picture("surface_intersection_example.png")
    files = [os.path.join(skdtesting.DATA_DIR, "fly_brain_%s.vtp" % name)
        for name in ("neuropil", "lateral_horn")]
    said = run("SurfaceIntersection.py", *files, picture)
    assert said.count("2 trees built") == 1 and said.count("0 trees built") == 8, said
    colours = pixels(picture)
    is_background = (colours == 255).all(axis=1)
    assert 0.1 < is_background.mean() < 0.8
    is_red = (colours[:, 0] > 120) & (colours[:, 1] < 60) & (colours[:, 2] < 60)
    assert is_red.mean() > 5e-4, "the curves are to be seen"


def test_picking():
    said = run("Picking.py")
    assert "of 1033920 cells" in said and "the same without" in said, said


def test_curve_intersection():
    picture = fresh_picture("curve_intersection_example.png")
    said = run("CurveIntersection.py", picture)
    assert "the figure crosses itself 17 times" in said, said
    colours = pixels(picture)
    is_background = (colours == 255).all(axis=1)
    assert 0.5 < is_background.mean() < 0.99
    assert len(numpy.unique(colours[~is_background], axis=0)) > 100


skdtesting.run_tests(globals())
