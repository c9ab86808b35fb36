# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Composite inputs of each class of VTK in pieces, and one pair of all processes. Run without an argument
this starts two processes; with the name of a file and partitions it is one of them, and writes there what
it has found."""

from vtkmodules.vtkCommonDataModel import (vtkMultiBlockDataSet, vtkPartitionedDataSet,
    vtkPartitionedDataSetCollection)

import skdexchange
import skdpieces
import skdtesting

RUNS = {2: ("cuts",), 3: ("round robin",)}
ARGUMENTS = {"Input": {}, "Source": {"radius": 3.0, "center": (1.234, 0.5, 0.25)}}


def in_blocks(mesh):
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(1, mesh)
    return blocks


def in_partitions(mesh):
    partitions = vtkPartitionedDataSet()
    partitions.SetPartition(0, mesh)
    return partitions


def in_collection(mesh):
    collection = vtkPartitionedDataSetCollection()
    collection.SetPartitionedDataSet(1, in_partitions(mesh))
    return collection


WRAPS = {"mesh": lambda mesh: mesh, "blocks": in_blocks, "partitions": in_partitions, "collection": in_collection}


def filters(inputs, distribution):
    from paraview import simple

    both = dict(inputs, SourceDistribution=distribution)
    return {
        "closest": (simple.SkdTreeClosestPoint(**both), 0),
        "pairs": (simple.SkdTreeSurfaceIntersection(**both), 2),
        "lowest": (simple.SkdTreeSurfaceIntersection(**both, Pairs="Lowest"), 2),
        "any": (simple.SkdTreeSurfaceIntersection(**both, Pairs="Whether Any"), 2),
        "split": (simple.SkdTreeSurfaceIntersection(**both, SplitSurfaces=1), 2),
    }


def answer(name, proxy, port):
    """The distance of each point; or how many pairs there are, in which classes must have a report."""
    algorithm = proxy.GetClientSideObject()
    algorithm.UpdatePiece(*skdpieces.process(), 0)
    output = algorithm.GetOutputDataObject(port)
    if name != "closest":
        report = algorithm.GetOutputDataObject(0).GetFieldData()
        assert report.GetArray("SkdReportPairs"), "no report"
        return output.GetNumberOfRows()
    distances = {}
    for leaf in skdexchange.leaves(output):
        array = leaf.GetPointData().GetArray("SkdDistance") if leaf else None
        for point in range(leaf.GetNumberOfPoints() if array else 0):
            distances[repr(leaf.GetPoint(point))] = array.GetValue(point)
    return distances


def answers_of(partitions):
    found = {}
    for partition in partitions:
        for wrap, function in WRAPS.items():
            for wrapped in ("Input", "Source"):
                inputs = {}
                for port, arguments in ARGUMENTS.items():
                    made = skdpieces.source("sphere", partition, **arguments)
                    made.UpdatePipeline()
                    mesh = made.GetClientSideObject().GetOutputDataObject(0)
                    inputs[port] = skdpieces.producer(function(mesh) if port == wrapped else mesh)
                for distribution in ("Replicate", "Exchange"):
                    for name, case in filters(inputs, distribution).items():
                        found[f"{name}, {wrapped} as {wrap}, {distribution}"] = answer(name, *case)
    return found


def write(file, partitions):
    skdpieces.tell(file, answers_of(partitions))


def check(file, processes, partitions):
    expected = answers_of(("one",))
    parts = skdpieces.told(file, processes)
    for title, answer_of_one in expected.items():
        assert answer_of_one, title
        answers = [part[title] for part in parts]
        if title.startswith("closest"):
            assert {key: value for each in answers for key, value in each.items()} == answer_of_one, title
        else:
            assert sum(answers) == answer_of_one, (title, answers, answer_of_one)


skdpieces.run(__file__, RUNS, "classes_%d.pickle", write, check)
