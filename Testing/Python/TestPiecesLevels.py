# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""AMR data and partitioned data sets of volume cells on several processes are one mesh, as on one: no
faces are between blocks, levels, partitions or pieces. Run without an argument this starts the processes;
with the name of a file and partitions it is one of them, and writes there what it has found."""

from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPartitionedDataSet
from vtkmodules.vtkFiltersAMR import vtkAMRGaussianPulseSource

import skdexchange
import skdpieces

RUNS = {3: ("round robin",)}


def levels(partition):
    """Blocks of two levels, every n-th on each process."""
    pulse = vtkAMRGaussianPulseSource()
    pulse.SetDimension(3)
    pulse.Update()
    rank, processes = skdpieces.process()
    amr = pulse.GetOutput()
    own = amr.NewInstance()
    own.CopyStructure(amr)
    number = 0
    for level in range(amr.GetNumberOfLevels()):
        for i in range(amr.GetNumberOfDataSets(level)):
            if number % processes == rank:
                own.SetDataSet(level, i, amr.GetDataSet(level, i))
            number += 1
    return own


def halves(partition):
    """Two partitions of tetrahedra that touch, each in pieces."""
    mesh = skdpieces.tetrahedra()
    is_below = [mesh.GetCell(i).GetBounds()[1] <= 0.0 for i in range(mesh.GetNumberOfCells())]
    parts = vtkPartitionedDataSet()
    for number, wanted in enumerate((True, False)):
        cells = [i for i, below in enumerate(is_below) if below == wanted]
        parts.SetPartition(number, skdpieces.piece(skdpieces.extract(mesh, cells), partition))
    return parts


def images(partition):
    """Images of two cell sizes that touch, every n-th on each process: each counts its own from 0."""
    boxes = ((-2, -2, 2, 4, 1.0), (0, -2, 2, 2, 0.5), (0, 0, 2, 2, 0.5), (2, -2, 2, 4, 1.0))
    rank, processes = skdpieces.process()
    parts = vtkPartitionedDataSet()
    for x, y, width, length, size in boxes[rank::processes]:
        image = vtkImageData()
        image.SetOrigin(x, y, -2.0)
        image.SetSpacing(size, size, size)
        image.SetDimensions(*(int(side / size) + 1 for side in (width, length, 4)))
        parts.SetPartition(parts.GetNumberOfPartitions(), image)
    return parts


MESHES = {"levels": (levels, (-0.7, -0.8, 1.3), 1.6), "halves": (halves, (0.1, 0.2, 0.3), 5.0),
    "images": (images, (0.1, 0.2, 0.3), 2.1)}


def filters(mesh, center, radius, distribution):
    from paraview import simple

    ball = skdpieces.producer(skdpieces.sphere(radius=radius, center=center, has_normals=False))
    line = skdpieces.producer(skdpieces.wire(end=(9.0, 8.0, 7.0)))
    ask = dict(Source=mesh, SourceDistribution=distribution)
    return {
        "itself": (simple.SkdTreeSurfaceIntersection(Input=mesh), 2),
        "pairs": (simple.SkdTreeSurfaceIntersection(Input=ball, **ask), 2),
        "curves": (simple.SkdTreeCurveSurfaceIntersection(Input=line, **ask), 0),
        "signed": (simple.SkdTreeClosestPoint(Input=ball, SignedDistance=1, **ask), "SkdDistance"),
        "compare": (simple.SkdTreeCompareSurfaces(Input=ball, **ask), "SkdDistance"),
        "thickness": (simple.SkdTreeWallThickness(Input=ball, Start="Cell Centers", Reversed=1, **ask),
            "SkdThickness"),
    }


def answer(proxy, wanted):
    """How many rows or points there are in an output, or the sum of an array's numbers."""
    algorithm = proxy.GetClientSideObject()
    algorithm.UpdatePiece(*skdpieces.process(), 0)
    if not isinstance(wanted, str):
        output = algorithm.GetOutputDataObject(wanted)
        return output.GetNumberOfRows() if output.IsA("vtkTable") else output.GetNumberOfPoints()
    total = 0.0
    for values in skdexchange.everything(proxy).items():
        name, array = values
        if name.startswith("output 0,") and name.endswith(wanted):
            total += array[array == array].sum()
    return total


def answers_of(partitions):
    found = {}
    for partition in partitions:
        for name, (make, center, radius) in MESHES.items():
            mesh = skdpieces.producer(make(partition))
            for distribution in ("Replicate", "Exchange"):
                for title, case in filters(mesh, center, radius, distribution).items():
                    found[f"{title}, {name}, {distribution}"] = answer(*case)
    return found


def write(file, partitions):
    skdpieces.tell(file, answers_of(partitions))


def check(file, processes, partitions):
    parts = skdpieces.told(file, processes)
    for title, expected in answers_of(("cuts",)).items():
        assert (expected == 0) == title.startswith("itself"), (title, expected)
        answers = [part[title] for part in parts]
        # All processes have the whole ball, and each outputs its points, or its share of pairs.
        factor = 1 if title.startswith(("itself", "pairs", "curves")) else processes
        assert abs(sum(answers) - factor * expected) <= 1e-9 * abs(factor * expected), (
            title, answers, expected)


skdpieces.run(__file__, RUNS, "levels_%d.pickle", write, check)
