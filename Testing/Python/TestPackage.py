# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python package in a Python without ParaView."""

import os
import subprocess
import sys

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


result = subprocess.run([plain_python(), "-c", SCRIPT], capture_output=True, text=True)
assert result.returncode == 0 and "done" in result.stdout, result.stdout + result.stderr
