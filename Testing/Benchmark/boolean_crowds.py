# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Boolean operations on many solids that overlap: processor seconds, faces, open edges and volume.

Run by pvpython with the package vtkskdtree:
    boolean_crowds.py [CASE ...]
A case is dense:N or sparse:N (spheres), cubes:N (turned about one centre) or boxes:N (at random).
"""

import sys
import time

import numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkskdtree import vtkSkdTreeBooleanOperation
from vtkskdtree.meshes import surface

FACES = numpy.array([(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3),
    (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5)])
CORNERS = numpy.array([[2.0 * (i >> k & 1) - 1.0 for k in range(3)] for i in range(8)])


def sphere(center, radius):
    source = vtkSphereSource()
    source.SetThetaResolution(16)
    source.SetPhiResolution(16)
    source.SetCenter(*center)
    source.SetRadius(radius)
    source.SetOutputPointsPrecision(1)
    source.Update()
    return source.GetOutput()


def turned(random):
    rotation, _ = numpy.linalg.qr(random.normal(size=(3, 3)))
    rotation[0] *= numpy.sign(numpy.linalg.det(rotation))
    return surface(CORNERS @ rotation.T, FACES)


def box(random):
    return surface(10.0 * random.random(3) + (random.random(3) + 0.5) * CORNERS, FACES)


def solids(case):
    kind, number = case.split(":")
    count = int(number)
    random = numpy.random.default_rng(7)
    makers = {
        "dense": lambda: sphere(random.random(3), 0.5),
        "sparse": lambda: sphere(random.random(3) * count ** (1 / 3), 0.4),
        "cubes": lambda: turned(random),
        "boxes": lambda: box(random),
    }
    return [makers[kind]() for _ in range(count)]


def run(case):
    blocks = vtkMultiBlockDataSet()
    for i, solid in enumerate(solids(case)):
        blocks.SetBlock(i, solid)
    union = vtkSkdTreeBooleanOperation()
    union.SetInputData(blocks)
    start = time.process_time()
    union.Update()
    seconds = time.process_time() - start
    output = union.GetOutput()
    report = lambda name: output.GetFieldData().GetArray("SkdReport" + name).GetValue(0)
    print(f"{case:12} {seconds:8.3f} s {output.GetNumberOfCells():8} faces {report('BadEdges'):3} open edges, "
        f"volume {report('Volume'):.15g}")


for each in sys.argv[1:] or ["cubes:16", "cubes:40", "dense:100", "boxes:200"]:
    run(each)
