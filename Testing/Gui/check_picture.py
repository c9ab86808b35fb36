# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fail unless a picture shows something: many colours, not all of it background."""

import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

reader = vtkPNGReader()
reader.SetFileName(sys.argv[1])
reader.Update()
pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
colours, counts = numpy.unique(pixels, axis=0, return_counts=True)
shown = 1 - counts.max() / counts.sum()
print(f"{sys.argv[1]}: {len(colours)} colours, {100 * shown:.1f}% not background")
assert len(colours) > 200 and 0.05 < shown < 0.95
