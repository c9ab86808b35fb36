# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Use the plugin: the file that is named, or without one the plugin that ParaView found itself."""

import sys

from paraview import simple

if len(sys.argv) > 1:
    simple.LoadPlugin(sys.argv[1], remote=False, ns=vars(simple))

points = simple.Wavelet(WholeExtent=[-2, 2, -2, 2, -2, 2])
sphere = simple.Sphere(Radius=1, ThetaResolution=32, PhiResolution=32)
closest = simple.SkdTreeClosestPoint(Input=points, Source=sphere)
closest.UpdatePipeline()
low, high = closest.PointData["SkdDistance"].GetRange()
assert 0 <= low < high, (low, high)

resampled = simple.ResampleWithDataset(SourceDataArrays=points, DestinationMesh=sphere)
resampled.CellLocator = "SkdTreeCellLocator"
resampled.UpdatePipeline()
assert resampled.PointData["vtkValidPointMask"].GetRange() == (1, 1)
print("SkdTree: distances from", low, "to", high)
