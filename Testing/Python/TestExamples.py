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
        command + list(arguments), capture_output=True, text=True, timeout=300,
        cwd=skdtesting.TEMPORARY_DIR)
    assert result.returncode == 0 and "ERR|" not in result.stderr, result.stdout + result.stderr
    return result.stdout


def pixels(file):
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())


def data(*names):
    return [os.path.join(skdtesting.DATA_DIR, name) for name in names]


def check(example, arguments, words, background, colours=100):
    """The example says the words, each as often as it is counted, and makes a picture: of its pixels
    the share between these two is background, the others have more than so many colours. Returns
    the pixels. Without arguments it takes data of the repository, and writes to where it runs."""
    picture = skdtesting.temporary(example + ".png")
    if os.path.exists(picture):
        os.remove(picture)
    said = run(example + ".py", *arguments, picture) if arguments else run(example + ".py")
    for word, count in words.items():
        assert said.count(word) == count, said
    seen = pixels(picture)
    is_background = (seen == 255).all(axis=1)
    assert background[0] < is_background.mean() < background[1], is_background.mean()
    assert len(numpy.unique(seen[~is_background], axis=0)) > colours
    return seen


def test_closest_point():
    check("ClosestPoint", data("disk_flow.vtu"), {"SkdDistance  from    3.2": 1}, (0.2, 0.8))


def test_boolean_operation():
    check("BooleanOperation", (), {" 0 open edges": 4, "Difference: volume": 3}, (0.2, 0.9))


def test_boolean_holes():
    check("BooleanHoles", (), {"volume 36.023772, 0 open edges": 1}, (0.3, 0.9))


def test_boolean_plane():
    check("BooleanPlane", (), {"volume 1.346577 and 1.630009, 0 open edges": 1}, (0.3, 0.9))


def test_compare_surfaces():
    words = {"Both ": 1, "largest distance of vertices of the copy: 0.000": 1}
    check("CompareSurfaces", [], words, (0.2, 0.9))


def test_rays():
    check("Rays", [], {" rays hit the surface": 1, "at most 6 hits": 1}, (0.2, 0.9))


def test_wall_thickness():
    check("WallThickness", [], {" points, thickness from": 3}, (0.2, 0.9))


def test_probe():
    check("Probe", [], {"intervals: 66": 1}, (0.2, 0.8))


def test_remap():
    words = {"of them without a height": 1, "conservation error below 1e-13: True": 1}
    check("Remap", [], words, (0.2, 0.8))


def test_spatial_query():
    words = {"129 cells overlap a box": 1, " 79 cells fill a sphere": 1, " 35 cells meet a line": 1,
        " 40 cells are nearest": 1}
    check("SpatialQuery", [], words, (0.3, 0.9))


def test_attach():
    check("Attach", [], {"without: ": 2, "with: ": 2}, (0.2, 0.95))


def test_point_in_out():
    words = {"PointsInside 230182": 1, "OpenEdges    0": 1}
    check("PointInOut", [], words, (0.5, 0.95))


def test_curve_surface_intersection():
    check("CurveSurfaceIntersection", [], {"goes in 1 times, out 0 times": 1}, (0.3, 0.95))


def test_amr():
    check("AMR", [], {"CutCells           10143": 1}, (0.2, 0.8))


def test_split_surfaces():
    check("SplitSurfaces", [], {"in 3 regions": 2}, (0.2, 0.8))


def test_mesh_refinement():
    check("MeshRefinement", [], {" 0 points hang": 3}, (0.005, 0.3))


def test_mesh_adaptation():
    words = {"cells of the Alps": 3, " shrink from": 9, "equidistribution error": 3}
    check("MeshAdaptation", [], words, (0.1, 0.5))


def test_surface_intersection():
    files = data("fly_brain_neuropil.vtp", "fly_brain_lateral_horn.vtp")
    words = {"2 trees built": 1, "0 trees built": 8}
    seen = check("SurfaceIntersection", files, words, (0.1, 0.8))
    is_red = (seen[:, 0] > 120) & (seen[:, 1] < 60) & (seen[:, 2] < 60)
    assert is_red.mean() > 5e-4, "the curves are to be seen"


def test_curve_intersection():
    check("CurveIntersection", [], {"the figure crosses itself 17 times": 1}, (0.5, 0.99))


def test_representation():
    words = {"level 9:  512 boxes": 1}
    check("Representation", [], words, (0.3, 0.9))


def test_picking():
    said = run("Picking.py")
    assert "of 1033920 cells" in said and "the same without" in said, said


skdtesting.run_tests(globals())
