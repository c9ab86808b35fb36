# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python package in a Python without ParaView."""

import os
import shutil
import subprocess
import sys
import tempfile

SCRIPT = """
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkCommonCore import reference
from vtkskdtree import vtkSkdTreeCellLocator, vtkSkdTreeClosestPoint

sphere = vtkSphereSource(radius=1.0, theta_resolution=64, phi_resolution=64) \\
    if hasattr(vtkSphereSource, "radius") else vtkSphereSource()
sphere.SetRadius(1.0)
sphere.SetThetaResolution(64)
sphere.SetPhiResolution(64)
sphere.Update()

locator = vtkSkdTreeCellLocator()
locator.SetDataSet(sphere.GetOutput())
locator.BuildLocator()
point, cell, sub, dist2 = [0.0] * 3, reference(0), reference(0), reference(0.0)
locator.FindClosestPoint([0.0, 0.0, 3.0], point, cell, sub, dist2)
assert abs(dist2 - 4.0) < 1e-12 and cell >= 0, (dist2, cell)
assert abs(point[2] - 1.0) < 1e-12, point

closest = vtkSkdTreeClosestPoint()
closest.SetInputConnection(sphere.GetOutputPort())
closest.SetSourceConnection(sphere.GetOutputPort())
closest.Update()
assert closest.GetOutput().GetPointData().GetArray("SkdDistance").GetRange() == (0.0, 0.0)
print("done")
"""


def plain_python():
    own = os.path.join(sys.base_prefix, "bin", "python3")
    return own if os.path.exists(own) else sys.executable


def run(script):
    return subprocess.run([plain_python(), "-c", script], capture_output=True, text=True)


def test_classes():
    result = run(SCRIPT)
    assert result.returncode == 0 and "done" in result.stdout, result.stdout + result.stderr


def test_what_is_missing_is_named():
    for missing, statement, texts in (
            ("vtkmodules", "import vtkskdtree", ("needs VTK", "pip install vtk", "PYTHONPATH")),
            ("numpy", "from vtkskdtree import Tree", ("Tree of vtkskdtree needs numpy", "pip install numpy"))):
        result = run(f"import sys; sys.modules['{missing}'] = None\n{statement}")
        said = result.stderr.strip().splitlines()[-1]
        assert said.startswith("ImportError: ") and all(text in said for text in texts), result.stderr
    result = run("import sys; sys.modules['numpy'] = None\n"
        "from vtkskdtree import *\nvtkSkdTreeCellLocator()\nprint('done')")
    assert "done" in result.stdout, result.stderr


def test_all_names_are_exported():
    result = run("from vtkskdtree import *\nprint(Tree.__name__, Locator.__name__, vtkSkdTreeRays.__name__, union.__name__)")
    assert result.stdout.split() == ["Tree", "Locator", "vtkSkdTreeRays", "union"], result.stderr


USER = """
import numpy
from vtkskdtree import Locator, Tree, collide, compare, split, union, vtkSkdTreeClosestPoint

tree = Tree([numpy.eye(3), [3, 0, 1, 2]])
number: int = 1
number = tree.rays(numpy.eye(3), numpy.eye(3), all_hits=True).query  # numpy.ndarray
number = tree.rays(numpy.eye(3), numpy.eye(3)).distance  # numpy.ndarray
number = vtkSkdTreeClosestPoint().GetEpsilon()  # float
locator: Locator = tree.locator
box = (numpy.eye(3), [[0, 1, 2]])
number = union(box, box, union(box, box)).points  # numpy.ndarray
number = compare(box, tree).a_to_b.rms  # float
number = collide(box, box)
number = tree.collide(box, numpy.eye(4), pairs=True)  # numpy.ndarray
number = split(box, ((0, 0, 0), (0, 0, 1)))  # vtkskdtree.operations.Parts
"""


def test_types_are_known():
    """By mypy, where it is installed: each line with a comment is wrong, and no other."""
    import vtkskdtree
    package = os.path.dirname(vtkskdtree.__file__)
    if not shutil.which("mypy") or not os.path.exists(os.path.join(package, "vtkFiltersSkdTree.pyi")):
        print("not tested: mypy or the stubs are missing")
        return
    with tempfile.TemporaryDirectory() as folder:
        user = os.path.join(folder, "user.py")
        with open(user, "w", encoding="utf-8") as file:
            file.write(USER)
        result = subprocess.run(["mypy", "--strict", "--follow-imports=silent", "--ignore-missing-imports",
            "--cache-dir", folder, user], capture_output=True, text=True,
            env={**os.environ, "MYPYPATH": os.path.dirname(package)})
    said = [line for line in result.stdout.splitlines() if "error:" in line]
    expected = [(number, line.rsplit("# ", 1)[1]) for number, line in enumerate(USER.splitlines(), 1) if "# " in line]
    assert len(said) == len(expected), result.stdout + result.stderr
    for line, (number, kind) in zip(said, expected):
        assert f"user.py:{number}: error: Incompatible types in assignment" in line, line
        assert kind.rsplit(".", 1)[-1] in line, line


for name, test in list(globals().items()):
    if name.startswith("test_"):
        test()
        print(name)
