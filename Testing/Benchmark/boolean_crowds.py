# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Boolean operations on many solids: processor seconds, triangles, open edges, volume and memory.

Memory of the filter is by how much the process's peak has grown since before the solids were made, so the first case
of a run has it alone; Manifold's is its heap, which never shrinks.

Run by pvpython with the package vtkskdtree:
    boolean_crowds.py [--manifold FOLDER] [CASE ...]
A case is a union of dense:N or sparse:N (spheres), cubes:N (turned about one centre), boxes:N (at random), grid:N (boxes
that touch) or pair:FILE (a closed surface, .vtp, and itself turned); or a difference: menger:DEPTH, plate:N (N holes at once) or chain:N (one by one).
FOLDER has node_modules/manifold-3d (npm install manifold-3d): Manifold in WebAssembly combines the same solids.
"""

import json
import os
import resource
import subprocess
import sys
import tempfile
import time

import numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkskdtree import vtkSkdTreeBooleanOperation
from vtkskdtree.meshes import surface

FACES = numpy.array([(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3),
    (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5)])
CORNERS = numpy.array([[2.0 * (i >> k & 1) - 1.0 for k in range(3)] for i in range(8)])
SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "boolean_crowds.mjs")


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


def box(low, high):
    low, high = numpy.asarray(low, float), numpy.asarray(high, float)
    return surface(0.5 * (low + high) + 0.5 * (high - low) * CORNERS, FACES)


def random_box(random):
    center, half = 10.0 * random.random(3), random.random(3) + 0.5
    return surface(center + half * CORNERS, FACES)


def grid(count):
    rows = round(count ** (1 / 3))
    places = numpy.stack(numpy.meshgrid(*3 * [numpy.arange(rows)]), -1).reshape(-1, 3)
    return [box(place, place + 1.0) for place in places]


def cylinder(x, y, radius, sides=32):
    angles = 2.0 * numpy.pi * numpy.arange(sides) / sides
    ring = numpy.stack([x + radius * numpy.cos(angles), y + radius * numpy.sin(angles)], 1)
    points = numpy.concatenate([numpy.c_[ring, numpy.full(sides, z)] for z in (-1.0, 2.0)])
    following = numpy.roll(numpy.arange(sides), -1)
    walls = [(i, k, sides + k) for i, k in enumerate(following)] + \
        [(i, sides + k, sides + i) for i, k in enumerate(following)]
    caps = [(0, k + 1, k) for k in range(1, sides - 1)] + \
        [(sides, sides + k, sides + k + 1) for k in range(1, sides - 1)]
    return surface(points, numpy.array(walls + caps))


def plate(count):
    rows = round(count ** 0.5)
    holes = [cylinder(x + 0.5, y + 0.5, 0.35) for x in range(rows) for y in range(rows)]
    return [box((0, 0, 0), (rows, rows, 1))], holes


def squares(depth):
    """The holes in the face of a sponge: lower corners and sides."""
    result, size = [], 1.0
    for level in range(depth):
        size /= 3.0
        cells = numpy.arange(3 ** level)
        result += [((3 * i + 1) * size, (3 * k + 1) * size, size) for i in cells for k in cells
            if not any(i // 3 ** n % 3 == 1 and k // 3 ** n % 3 == 1 for n in range(level))]
    return result


def menger(depth):
    """A cube, and for each axis the holes along it as one surface."""
    tools = []
    for axis in range(3):
        points, faces = [], []
        for x, y, size in squares(depth):
            low, high = numpy.array([-0.5, x, y]), numpy.array([1.5, x + size, y + size])
            corners = 0.5 * (low + high) + 0.5 * (high - low) * CORNERS
            faces.append(FACES + 8 * len(points))
            points.append(numpy.roll(corners, axis, axis=1))
        tools.append(surface(numpy.concatenate(points), numpy.concatenate(faces)))
    return [box((0, 0, 0), (1, 1, 1))], tools


def pair(file):
    """Coordinates are of single precision, which Manifold has."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(file)
    reader.Update()
    points, cells = triangles(reader.GetOutput())
    center, size = points.mean(axis=0), numpy.ptp(points, axis=0).max()
    c, s = numpy.cos(0.5), numpy.sin(0.5)
    moved = (points - center) @ [(c, s, 0), (-s, c, 0), (0, 0, 1)] + center + size * numpy.array((0.0155, 7e-4, 5e-4))
    return [surface(x.astype(numpy.float32).astype(float), cells) for x in (points, moved)], []


def solids(case):
    """What is united, and what is subtracted from it."""
    kind, number = case.split(":", 1)
    if kind == "pair":
        return pair(number)
    count = int(number)
    random = numpy.random.default_rng(7)
    makers = {
        "dense": lambda: sphere(random.random(3), 0.5),
        "sparse": lambda: sphere(random.random(3) * count ** (1 / 3), 0.4),
        "cubes": lambda: turned(random),
        "boxes": lambda: random_box(random),
    }
    if kind == "grid":
        return grid(count), []
    if kind == "menger":
        return menger(count)
    if kind in ("plate", "chain"):
        return plate(count)
    return [makers[kind]() for _ in range(count)], []


def blocks(parts):
    if len(parts) == 1:
        return parts[0]
    result = vtkMultiBlockDataSet()
    for i, part in enumerate(parts):
        result.SetBlock(i, part)
    return result


def combine(united, subtracted):
    operation = vtkSkdTreeBooleanOperation()
    operation.SetInputData(blocks(united))
    if subtracted:
        operation.SetSourceData(blocks(subtracted))
        operation.SetOperation(operation.DIFFERENCE)
    operation.Update()
    return operation.GetOutput()


def triangles(mesh):
    cut = vtkTriangleFilter()
    cut.SetInputData(mesh)
    cut.Update()
    output = cut.GetOutput()
    cells = vtk_to_numpy(output.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return vtk_to_numpy(output.GetPoints().GetData()).astype(float), cells


def run_manifold(folder, case, united, subtracted):
    packed = [[{"points": points.ravel().tolist(), "faces": cells.ravel().tolist()}
        for points, cells in map(triangles, parts)] for parts in (united, subtracted)]
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump({"united": packed[0], "subtracted": packed[1], "isChain": case.startswith("chain")}, file)
        file.flush()
        print(subprocess.run(["node", SCRIPT, folder, file.name], check=True, text=True,
            stdout=subprocess.PIPE).stdout, end="", flush=True)


def peak():
    """Of the process, in MB."""
    return 1024e-6 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def run(case, manifold):
    before = peak()
    united, subtracted = solids(case)
    start = time.process_time()
    if case.startswith("chain"):
        output = united[0]
        for hole in subtracted:
            output = combine([output], [hole])
    else:
        output = combine(united, subtracted)
    seconds = time.process_time() - start
    grown = peak() - before
    report = lambda name: output.GetFieldData().GetArray("SkdReport" + name).GetValue(0)
    faces = len(triangles(output)[1])
    print(f"{case:12} {seconds:8.3f} s {faces:8} triangles, {report('BadEdges')} open edges, "
        f"volume {report('Volume'):.15g}, {grown:.1f} MB", flush=True)
    if manifold:
        run_manifold(manifold, case, united, subtracted)


arguments = sys.argv[1:]
folder = arguments[1] if arguments[:1] == ["--manifold"] else None
for each in arguments[2 if folder else 0:] or ["cubes:16", "cubes:40", "dense:100", "boxes:200"]:
    run(each, folder)
