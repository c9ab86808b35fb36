# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Leaf cells a second: vtkSkdTreeAMR beside ParaView's Resample To Hyper Tree Grid.

Both make a hyper tree grid of eight base cells that follows a field given on an image: refined are
cells in which it varies. The two measure that differently (by the largest difference, by the standard
deviation), so the thresholds are chosen for about as many leaves. Then vtkSkdTreeAMR around a sphere
of triangles, and Resample on the points of the same sphere, where any point is in a cell. Processor
seconds of all that an update takes, trees too; medians of five, the two in turn.

Of files it prints how many more leaves the blind test makes than the exact one, at levels 5 to 8.

Run by pvpython with the plugins SkdTree and HyperTreeGridADR (by PV_PLUGIN_PATH, say):
    amr_speed.py [surface ...]
"""

import os
import statistics
import sys
import time

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkSMPTools


def resample(source, **properties):
    blocks = simple.GroupDatasets(Input=[source])  # called directly, it needs blocks
    return servermanager.filters.ResampleToHyperTreeGrid(Input=blocks, **properties)


def leaves_of(proxy):
    grid = proxy.GetClientSideObject().GetOutputDataObject(0)
    return grid.GetNumberOfLeaves()


def timed(proxy):
    proxy.GetClientSideObject().Modified()
    start = time.process_time()
    proxy.GetClientSideObject().Update()
    return time.process_time() - start


def compare(what, ours, theirs):
    for proxy in (ours, theirs):
        proxy.UpdatePipeline()
    seconds = [(timed(ours), timed(theirs)) for _ in range(5)]
    rates = [leaves_of(proxy) / statistics.median(column)
             for proxy, column in zip((ours, theirs), zip(*seconds))]
    print("| %s | %d | %.2g | %d | %.2g | %.3g |" % (what, leaves_of(ours), rates[0],
        leaves_of(theirs), rates[1], rates[0] / rates[1]), flush=True)


def field(size):
    image = simple.Wavelet(WholeExtent=[-size, size] * 3)
    corner = simple.PointSource(NumberOfPoints=1, Center=[-size, -size, -size])
    corner = simple.MaskPoints(Input=corner, GenerateVertices=1, OnRatio=1)
    ours = simple.SkdTreeAMR(Input=corner, Field=image, FieldArrays=["RTData"], AutomaticBounds=0,
        BaseBounds=[-size, size] * 3, BaseDimensions=[2, 2, 2], MaximumLevel=5, FieldThreshold=45)
    theirs = resample(image, SubdividingCriterionArray=["POINTS", "RTData"], Dimensions=[3, 3, 3],
        SubdividingCriterion="Standard Deviation", MaxDepth=6, UseMax=0, Min=6)
    return ours, theirs


def surface(triangles):
    count = int((0.5 * triangles)**0.5) + 1
    sphere = simple.Sphere(ThetaResolution=count, PhiResolution=count)
    points = simple.Calculator(Input=sphere, Function="coordsX", ResultArrayName="X")
    ours = simple.SkdTreeAMR(Input=points, AutomaticBounds=0, BaseBounds=[-0.5, 0.5] * 3,
        BaseDimensions=[2, 2, 2], MaximumLevel=6)
    theirs = resample(points, SubdividingCriterionArray=["POINTS", "X"], Dimensions=[3, 3, 3],
        MaxDepth=7, UseMax=0, Min=-1)
    return ours, theirs


def blind_and_exact(path):
    surface = simple.OpenDataFile(path)
    row = [os.path.splitext(os.path.basename(path))[0]]
    for level in range(5, 9):
        leaves = []
        for test in ("Exact", "Blind"):
            amr = simple.SkdTreeAMR(Input=surface, MaximumLevel=level, Test=test)
            amr.UpdatePipeline()
            leaves.append(leaves_of(amr))
            simple.Delete(amr)
        row.append("%d, %.2f x" % (leaves[0], leaves[1] / leaves[0]))
    print("| " + " | ".join(row) + " |", flush=True)


if __name__ == "__main__":
    vtkSMPTools.Initialize(1)
    print("| grid | our leaves | a second | its leaves | a second | ratio |")
    print("| --- | ---: | ---: | ---: | ---: | ---: |")
    compare("where a field varies, 65^3 values", *field(32))
    compare("around 100000 triangles, or their points", *surface(1e5))
    print("\n| leaves, exact; blind | level 5 | level 6 | level 7 | level 8 |")
    print("| --- | ---: | ---: | ---: | ---: |")
    for file in sys.argv[1:]:
        blind_and_exact(file)
