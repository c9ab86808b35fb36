# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The cells of vtkSkdTreeAMR beside those of OpenFOAM's snappyHexMesh, castellated, not snapped.

Both refine the same base cells around the same surface to the same level. snappyHexMesh refines the
two cells beside a face where the line between their middles meets the surface, and drops what it
cannot reach from outside; the skD-tree refines all cells that the surface meets. Prints how many
cells both have, and how many of the others this difference explains.

Needs OpenFOAM (Debian: openfoam), its environment set (/usr/share/openfoam/etc/bashrc), VTK's Python
modules and vtkskdtree:
    amr_castellation.py surface level folder [picture.png]
The surface must be closed; the folder is made, and kept. The picture, by matplotlib, has the cells
of both in the middle of the base mesh, those that only one of them has in red.
"""

import os
import subprocess
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader, vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkskdtree import vtkSkdTreeAMR, vtkSkdTreeCellLocator

BASE = 12  # cells along the longest side

HEADER = "FoamFile { version 2.0; format ascii; class dictionary; object %s; }\n"

CONTROL = """application snappyHexMesh; startFrom startTime; startTime 0; stopAt endTime; endTime 1;
deltaT 1; writeControl timeStep; writeInterval 1; writeFormat ascii; writePrecision 17;
"""

BLOCK = """scale 1;
vertices ({vertices});
blocks (hex (0 1 2 3 4 5 6 7) ({counts}) simpleGrading (1 1 1));
boundary (around {{ type patch; faces ((3 7 6 2) (0 4 7 3) (2 6 5 1) (1 5 4 0) (0 3 2 1) (4 5 6 7)); }});
"""

SNAPPY = """castellatedMesh true; snap false; addLayers false;
geometry {{ part.stl {{ type triSurfaceMesh; name part; }} }}
castellatedMeshControls
{{
    maxLocalCells 100000000; maxGlobalCells 100000000; minRefinementCells 0;
    maxLoadUnbalance 0.1; nCellsBetweenLevels 1; features ();
    refinementSurfaces {{ part {{ level ({level} {level}); }} }}
    resolveFeatureAngle 180; refinementRegions {{}}; locationInMesh ({inside});
    allowFreeStandingZoneFaces true;
}}
snapControls {{ nSmoothPatch 3; tolerance 2; nSolveIter 1; nRelaxIter 1; }}
addLayersControls {{ layers {{}} relativeSizes true; expansionRatio 1; finalLayerThickness 0.3;
    minThickness 0.1; nGrow 0; featureAngle 60; nRelaxIter 1; nSmoothSurfaceNormals 1;
    nSmoothNormals 1; nSmoothThickness 1; maxFaceThicknessRatio 0.5;
    maxThicknessToMedialRatio 0.3; minMedialAxisAngle 90; nBufferCellsNoExtrude 0; nLayerIter 1; }}
meshQualityControls {{ maxNonOrtho 180; maxBoundarySkewness -1; maxInternalSkewness -1;
    maxConcave 180; minVol -1e30; minTetQuality -1e30; minArea -1; minTwist -2;
    minDeterminant -1; minFaceWeight -1; minVolRatio -1; minTriangleTwist -1;
    nSmoothScale 1; errorReduction 0.75; }}
mergeTolerance 1e-9;
"""


def read(path):
    reader = vtkSTLReader() if path.endswith(".stl") else vtkXMLPolyDataReader()
    reader.SetFileName(path)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(reader.GetOutputPort())
    triangles.Update()
    return triangles.GetOutput()


class Base:
    """Cubes around a surface, in no special place."""

    def __init__(self, surface):
        bounds = numpy.array(surface.GetBounds())
        low, high = bounds[::2], bounds[1::2]
        size = (high - low).max() / (BASE - 2.3)
        self.size = size
        self.counts = numpy.ceil((high - low) / size + 1.1).astype(int)
        self.low = low - size * numpy.array([0.531, 0.617, 0.573])
        self.high = self.low + size * self.counts

    def places(self, centres, levels):
        """A row of whole numbers for each cell: its level and its place there."""
        places = numpy.floor((centres - self.low) / (self.size / 2.0**levels)[:, None])
        return numpy.column_stack([levels, places]).astype(int)

    def keys(self, centres, levels):
        return {tuple(row) for row in self.places(centres, levels)}


def words(numbers):
    return " ".join("%.17g" % number for number in numbers)


def write_case(folder, surface, base, level):
    for name in ("constant/triSurface", "system"):
        os.makedirs(os.path.join(folder, name), exist_ok=True)
    writer = vtkSTLWriter()
    writer.SetFileName(os.path.join(folder, "constant", "triSurface", "part.stl"))
    writer.SetInputData(surface)
    writer.Write()
    low, high = base.low, base.high
    corners = [(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])]
    vertices = " ".join("(%s)" % words([*corner, z]) for z in (low[2], high[2]) for corner in corners)
    texts = {
        "controlDict": CONTROL,
        "fvSchemes": "ddtSchemes {} gradSchemes {} divSchemes {} laplacianSchemes {}\n",
        "fvSolution": "",
        "blockMeshDict": BLOCK.format(vertices=vertices, counts=words(base.counts)),
        "snappyHexMeshDict": SNAPPY.format(
            level=level, inside=words(low + base.size * numpy.array([0.0137, 0.0119, 0.0171]))),
    }
    for name, text in texts.items():
        with open(os.path.join(folder, "system", name), "w") as file:
            file.write(HEADER % name + text)


def run_snappy(folder):
    for command in (["blockMesh"], ["snappyHexMesh", "-overwrite"]):
        with open(os.path.join(folder, command[0] + ".log"), "w") as log:
            subprocess.run(command + ["-case", folder], stdout=log, stderr=log, check=True)
    case = os.path.join(folder, "case.foam")
    open(case, "w").close()
    reader = vtkOpenFOAMReader()
    reader.SetFileName(case)
    reader.DecomposePolyhedraOff()
    reader.SkipZeroTimeOff()
    reader.Update()
    return reader.GetOutput().GetBlock(0)


def boxes_of(grid):
    return numpy.array([grid.GetCell(i).GetBounds() for i in range(grid.GetNumberOfCells())])


def refine(surface, base, level):
    amr = vtkSkdTreeAMR()
    amr.SetInputData(surface)
    amr.AutomaticBoundsOff()
    amr.SetBaseBounds(*numpy.column_stack([base.low, base.high]).ravel())
    amr.SetBaseDimensions(*map(int, base.counts))
    amr.SetMaximumLevel(level)
    amr.SetBalance(vtkSkdTreeAMR.FACE)
    amr.ComputeInsideOn()
    amr.SetOutputType(vtkSkdTreeAMR.UNSTRUCTURED_GRID)
    amr.Update()
    return amr.GetOutputDataObject(0)


def centres_and_levels(boxes, base):
    levels = numpy.round(numpy.log2(base.size / (boxes[:, 1] - boxes[:, 0])))
    return boxes.reshape(-1, 3, 2).mean(axis=2), levels


def crossed(surface, centres, size):
    """Which cells have a face where the line between middles meets the surface."""
    locator = vtkSkdTreeCellLocator()
    locator.SetDataSet(surface)
    locator.BuildLocator()
    result = numpy.zeros(len(centres), bool)
    for axis in range(3):
        for side in (-1, 1):
            ends = centres.copy()
            ends[:, axis] += side * size
            result |= [locator.CountCrossings(a, b) > 0 for a, b in zip(centres, ends)]
    return result


def share(part, whole):
    return "%d of %d (%.2f %%)" % (
        len(part & whole), len(whole), 100.0 * len(part & whole) / max(1, len(whole)))


def ancestors(key):
    level, place = key[0], key[1:]
    return [(upper, *(i >> (level - upper) for i in place)) for upper in range(level)]


def refined_by_lines(keys, surface, base, level):
    """Those of cells of a level whose parent has a line between middles that meets the surface."""
    parents = sorted({ancestors(key)[-1] for key in keys})
    size = base.size / 2.0**(level - 1)
    middles = base.low + size * (numpy.array(parents).reshape(-1, 4)[:, 1:] + 0.5)
    told = dict(zip(parents, crossed(surface, middles, size)))
    return {key for key in keys if told[ancestors(key)[-1]]}


def compare(surface, base, level, theirs, grid):
    arrays = {name: vtk_to_numpy(grid.GetCellData().GetArray("Skd" + name))
              for name in ("Level", "Cut", "Inside")}
    centres, levels = centres_and_levels(boxes_of(grid), base)
    outside, finest = arrays["Inside"] == 0, levels == level
    their_finest = {key for key in theirs if key[0] == level}
    ours, ours_cut, inside = (base.keys(centres[which], levels[which]) for which in (
        finest, finest & outside & (arrays["Cut"] == 1), finest & ~outside))
    print("cells with their middle outside: snappyHexMesh %d, skD-tree %d" %
        (len(theirs), outside.sum()))
    print("cells of the last level, cut and with their middle outside, that snappyHexMesh has, too:",
        share(their_finest, ours_cut))
    missing = ours_cut - their_finest
    coarser = {key for key in missing if theirs.intersection(ancestors(key))}
    print("of the others it has %d coarser, and %d not at all" %
        (len(coarser), len(missing) - len(coarser)))
    print("cells with their middle inside that it has:", len(inside & theirs))
    more = their_finest - ours
    print("its cells of the last level that the skD-tree has, too:", share(ours, their_finest))
    print("of the others those whose parent is beside a face that it takes for cut:",
        share(refined_by_lines(more, surface, base, level), more))


def draw(picture, grids):
    """Cells across the middle of the base mesh; `grids` is of (name, boxes, levels, is shared)."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import collections, pyplot

    figure, rows = pyplot.subplots(1, len(grids), figsize=(12, 5.2), sharey=True)
    for axes, (name, boxes, levels, is_shared) in zip(rows, grids):
        corners = boxes[:, [0, 2, 1, 2, 1, 3, 0, 3]].reshape(-1, 4, 2)
        colours = pyplot.get_cmap("Blues")(0.1 + 0.2 * levels)
        colours[~is_shared] = (0.9, 0.35, 0.25, 1)
        axes.add_collection(collections.PolyCollection(
            corners, facecolors=colours, edgecolors="k", linewidths=0.3))
        axes.autoscale()
        axes.set_aspect("equal")
        axes.set_title(name)
        axes.set_axis_off()
    figure.tight_layout()
    figure.savefig(picture, dpi=80)


def slices(base, grids):
    """What draw() needs of (name, boxes, levels) of the same region."""
    height = 0.5 * (base.low[2] + base.high[2]) + 0.01 * base.size
    keys = [base.keys(boxes.reshape(-1, 3, 2).mean(axis=2), levels) for _, boxes, levels in grids]
    shared = keys[0] & keys[1]
    for name, boxes, levels in grids:
        chosen = (boxes[:, 4] <= height) & (height < boxes[:, 5])
        places = base.places(boxes[chosen].reshape(-1, 3, 2).mean(axis=2), levels[chosen])
        yield name, boxes[chosen], levels[chosen], numpy.array(
            [tuple(row) in shared for row in places])


def main(path, level, folder, picture=None):
    surface = read(path)
    base = Base(surface)
    write_case(folder, surface, base, level)
    foam, grid = run_snappy(folder), refine(surface, base, level)
    boxes = boxes_of(foam)
    levels = centres_and_levels(boxes, base)[1]
    compare(surface, base, level, base.keys(*centres_and_levels(boxes, base)), grid)
    if picture:
        outside = vtk_to_numpy(grid.GetCellData().GetArray("SkdInside")) == 0
        ours = boxes_of(grid)[outside]
        draw(picture, list(slices(base, [("snappyHexMesh, castellated", boxes, levels),
            ("SkdTree AMR, cells with their middle outside", ours,
             centres_and_levels(ours, base)[1])])))


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), *sys.argv[3:])
