# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every filter once or more, with meshes in pieces as Input, as Source and as a third input: what the
tests of meshes in pieces run."""

import collections

import skdpieces

# A filter, and which arrays of which output are compared, of its points or its cells.
Case = collections.namedtuple("Case", "proxy arrays port of_cells", defaults=(0, False))


def cases_of_one_reader():
    """Input and Source come of the same source, which can give any piece."""
    from paraview import simple

    image = simple.Wavelet(WholeExtent=[-6, 6, -6, 6, -6, 6])
    contour = simple.Contour(Input=image, ContourBy=["POINTS", "RTData"], Isosurfaces=[157.0])
    cells = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5]))
    outer = simple.ExtractSurface(Input=cells)
    yield "contour", Case(
        simple.SkdTreeClosestPoint(Input=image, Source=contour), ["SkdDistance"])
    yield "outer surface", Case(
        simple.SkdTreeClosestPoint(Input=cells, Source=outer), ["SkdDistance"])
    # Normals of pieces are not those of the whole at the ends of their ghost cells.
    yield "thickness of a contour", Case(
        simple.SkdTreeWallThickness(Input=contour, Source=image), ["SkdThickness"])
    yield "rays along normals of a contour", Case(
        simple.SkdTreeRays(Input=contour, Source=cells), ["SkdRayDistance"])
    yield "itself", Case(simple.SkdTreeProbe(Input=outer, Source=image), ["SkdDistance"])
    yield "image", Case(
        simple.SkdTreeRemap(Input=cells, Source=image, PassInputData=0), ["RTData"])


def cases(partition):
    """The name and the case of each, by a kind of pieces."""
    from paraview import simple

    if partition == "one reader":
        yield from cases_of_one_reader()
        return
    image = simple.Wavelet(WholeExtent=[-6, 6, -6, 6, -6, 6])
    ball = skdpieces.source("sphere", partition)
    other = skdpieces.source(
        "sphere", partition, radius=3.0, center=(1.234, 0.5, 0.25), theta=20, phi=20)
    cells = skdpieces.source("tetrahedra", partition)
    yield "closest", Case(simple.SkdTreeClosestPoint(Input=image, Source=ball), ["SkdDistance"])
    yield "closest beside a far point", Case(
        simple.SkdTreeClosestPoint(Input=image, Source=skdpieces.source("spike", partition)),
        ["SkdDistance"])
    yield "closest data", Case(
        simple.SkdTreeClosestPoint(Input=image, Source=cells, InterpolateSourceData=1,
            GenerateLines=1), ["SkdDistance", "Field"])
    yield "closest of both", Case(
        simple.SkdTreeClosestPoint(Input=ball, Source=other, SignedDistance=1), ["SkdDistance"])
    yield "closest signed", Case(
        simple.SkdTreeClosestPoint(Input=image, Source=cells, SignedDistance=1), ["SkdDistance"])
    yield "inside", Case(
        simple.SkdTreePointInOut(Input=image, Source=ball), ["SkdInside", "SkdConfidence"])
    yield "inside cells", Case(
        simple.SkdTreePointInOut(Input=image, Source=cells), ["SkdInside", "SkdConfidence"])
    yield "in a mesh", Case(
        simple.SkdTreePointInOut(Input=image, Source=cells, Model="Body Fitted Mesh",
            Ask="Cells Any Point"), ["SkdInside", "SkdPartId"], of_cells=True)
    yield "probe", Case(simple.SkdTreeProbe(Input=image, Source=cells), ["Field"])
    yield "rays", Case(simple.SkdTreeRays(Input=other, Source=ball), ["SkdRayDistance"])
    yield "rays along normals found", Case(
        simple.SkdTreeRays(Input=skdpieces.source("sphere", partition, has_normals=False),
            Source=other), ["SkdRayDistance"])
    yield "rays from outside", Case(
        simple.SkdTreeRays(Input=image, Source=ball, Along="To Point", TargetPoint=[0.3, 0.2, 0.1],
            InterpolateSourceData=1), ["SkdRayDistance", "Elevation"])
    yield "all hits", Case(
        simple.SkdTreeRays(Input=other, Source=cells, Start="Cell Centers", Along="Direction",
            Direction=[0.2, 0.3, 1.0], Hits="All Hits", BothWays=1), ["SkdRayDistance"], 1)
    yield "hits within a length", Case(
        simple.SkdTreeRays(Input=image, Source=ball, Along="To Point", TargetPoint=[0.3, 0.2, 0.1],
            Hits="Counts", MaximumLength=3.0), ["SkdRayHits"])
    yield "thickness", Case(simple.SkdTreeWallThickness(Input=ball), ["SkdThickness"])
    yield "thickness to", Case(
        simple.SkdTreeWallThickness(Input=other, Source=ball), ["SkdThickness"])
    yield "thickness of cells", Case(
        simple.SkdTreeWallThickness(Input=other, Source=ball, Start="Cell Centers",
            NumberOfRays=7, Reversed=1), ["SkdThickness"], of_cells=True)
    yield "boolean", Case(
        simple.SkdTreeBooleanOperation(Input=ball, Source=other), [], of_cells=True)
    yield "compared", Case(simple.SkdTreeCompareSurfaces(Input=ball, Source=other),
        ["HausdorffDistance", "HausdorffUpperBound", "Mean", "MeanError", "RootMeanSquare",
            "Median", "MedianError", "Quantile99", "Area", "Samples"], port=2)
    yield "compared, signed", Case(
        simple.SkdTreeCompareSurfaces(Input=cells, Source=other, SignedDistance=1),
        ["SkdDistance", "SkdClosestPoint"])
    yield "compared points", Case(simple.SkdTreeCompareSurfaces(
        Input=skdpieces.source("scatter", partition), Source=ball), ["SkdDistance"])
    yield "adapted", Case(simple.SkdTreeMeshAdaptation(
        Input=skdpieces.source("tiles", partition), FieldArray="Elevation", MaximumIterations=1,
        Source=skdpieces.source("tiles", partition, count=20)), ["SkdFieldMean", "SkdArea"],
        of_cells=True)
    yield "intersection", Case(
        simple.SkdTreeSurfaceIntersection(Input=ball, Source=other, JoinCurves=0), [],
        of_cells=True)
    # Where pieces meet there are faces that are no outer ones.
    yield "intersection of outer faces", Case(
        simple.SkdTreeSurfaceIntersection(Input=cells, Source=other, JoinCurves=0), [],
        of_cells=True)
    yield "split", Case(
        simple.SkdTreeSurfaceIntersection(Input=ball, Source=other, SplitSurfaces=1), [], port=5,
        of_cells=True)
    yield "remap", Case(simple.SkdTreeRemap(Input=cells, Source=image), ["RTData"])
    yield "remap from pieces", Case(simple.SkdTreeRemap(Input=image, Source=cells), ["Field"])
    yield "remap conservatively", Case(
        simple.SkdTreeRemap(Input=image, Source=cells, Method="Conservative Second Order",
            ResultsOn="Cells"), ["Field"], of_cells=True)
    yield "remap to points", Case(
        simple.SkdTreeRemap(Input=cells, Source=image, Method="Conservative First Order",
            ResultsOn="Points"), ["RTData"])
    blocks = simple.GroupDatasets(Input=[ball, other])
    yield "blocks", Case(
        simple.SkdTreeClosestPoint(Input=image, Source=blocks),
        ["SkdDistance", "SkdClosestBlockIndex"])
    yield "data of blocks", Case(
        simple.SkdTreeClosestPoint(Input=image, InterpolateSourceData=1, MaximumDistance=2.0,
            Source=simple.GroupDatasets(Input=[ball, cells])), ["SkdDistance", "Field"])
    yield "inside of blocks", Case(
        simple.SkdTreePointInOut(Input=cells, Source=blocks, Ask="Cell Centers"),
        ["SkdInside", "SkdPartId", "SkdDepth"], of_cells=True)
    yield "signed, bodies that overlap", Case(
        simple.SkdTreeClosestPoint(Input=image, Source=blocks, SignedDistance=1), ["SkdDistance"])
    half = simple.Threshold(
        Input=ball, Scalars=["POINTS", "Elevation"], LowerThreshold=0.1, UpperThreshold=1.0)
    signed = ["SignedMean", "SignedMeanError", "Mean", "Median", "HausdorffDistance", "Samples"]
    for name, source in (
        ("", ball), (" with bodies that overlap", blocks), (" with an open one", half)):
        yield "compared by sides" + name, Case(simple.SkdTreeCompareSurfaces(
            Input=other, Source=source, SignedDistance=1), signed, port=2)
    yield "signed, open", Case(
        simple.SkdTreeClosestPoint(Input=image, Source=half, SignedDistance=1), ["SkdDistance"])
    yield "inside of open", Case(
        simple.SkdTreePointInOut(Input=other, Source=half), ["SkdInside", "SkdConfidence"])
    yield "nearest cells", Case(
        simple.SkdTreeSpatialQuery(Input=cells, Relation="Nearest", Shape="Sphere",
            SphereCenter=[0.2, 0.3, 0.4], SphereRadius=0, NumberOfNearestCells=50),
        ["SkdDistance"], of_cells=True)
    yield "overlapping cells", Case(
        simple.SkdTreeSpatialQuery(
            Input=cells, Source=ball, Relation="Overlap", Shape="Source Cells"), [],
        of_cells=True)
    yield "grid", Case(
        simple.SkdTreeAMR(Input=ball, Field=cells, FieldArrays=["Field"], ComputeInside=1,
            OutputType="Unstructured Grid", MaximumLevel=3), ["SkdInside"], of_cells=True)
    yield "grid near surfaces", Case(
        simple.SkdTreeAMR(Input=blocks, OutputType="Unstructured Grid", MaximumLevel=3,
            DistanceBands=[0.3, 2], ComputeDistance=1),
        ["SkdLevel", "SkdPartIndex", "SkdCandidates", "SkdDistance"], of_cells=True)
    yield "refined", Case(
        simple.SkdTreeMeshRefinement(Input=cells, Parts=ball, MaximumLevel=2,
            DistanceBands=[0.4, 1]), ["SkdLevel"], of_cells=True)
