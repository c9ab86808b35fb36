# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What each of 1 to 32 processes holds and sends where a Source lies in pieces, with a fixed number of
cells and points on each process: a strip of a wavy surface, and another one that crosses it, flat
strips of other sizes for remapping, and for Boolean operations spheres, or two tubes along all
processes that cross each other lengthwise. Processes may share processors: these are counts, no times. Prints a row for each number of processes and way, of the
process that has most; memory is what a filter takes beyond what there is before it runs.

Run by python3 with the build tree's environment (build/setup.sh): exchange_counts.py [cells]"""

import ctypes
import json
import os
import subprocess
import sys
import tempfile

PROCESSES = (1, 2, 4, 8, 16, 32)
WAYS = ("Exchange", "Replicate")
COLUMNS = ("PointsSent", "RaysSent", "SourceCells", "MessagesSent", "BytesSent")


def memory(name):
    """Of this process, in bytes: VmRSS now, VmHWM the most since the last restart_peak()."""
    with open("/proc/self/status", encoding="utf-8") as status:
        return next(1024 * int(line.split()[1]) for line in status if line.startswith(name))


def restart_peak():
    ctypes.CDLL(None).malloc_trim(0)  # what is freed is the system's again
    with open("/proc/self/clear_refs", "w", encoding="utf-8") as file:
        file.write("5")


def strip(rank, cells, height, wave):
    """Triangles for x from rank to rank + 1, of a wavy surface or a flat one, with a field."""
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    side = int((cells / 2) ** 0.5)
    x, y = numpy.meshgrid(rank + numpy.arange(side + 1) / side, numpy.arange(side + 1) / side)
    z = height + wave * numpy.sin(20.0 * x + 50.0 * height) * numpy.cos(17.0 * y)
    corner = (numpy.arange(side)[:, None] * (side + 1) + numpy.arange(side)).ravel()
    triangles = numpy.concatenate([
        numpy.stack([corner, corner + 1, corner + side + 1], axis=1),
        numpy.stack([corner + 1, corner + side + 2, corner + side + 1], axis=1)])
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.stack([x.ravel(), y.ravel(), z.ravel()], axis=1), deep=1))
    faces = vtkCellArray()
    faces.SetData(3, numpy_to_vtkIdTypeArray(triangles.ravel(), deep=1))
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(faces)
    field = numpy_to_vtk(numpy.tile(numpy.sin(x[:-1, :-1].ravel()), 2), deep=1)
    field.SetName("Field")
    surface.GetCellData().AddArray(field)
    return surface


def ball(rank, cells, x):
    """A sphere for each process."""
    from vtkmodules.vtkFiltersSources import vtkSphereSource

    source = vtkSphereSource()
    source.SetCenter(rank + x, 0.0, 0.0)
    source.SetRadius(0.3)
    source.SetThetaResolution(int((cells / 2) ** 0.5))
    source.SetPhiResolution(int((cells / 2) ** 0.5) + 1)
    source.Update()
    return source.GetOutput()


def tube(rank, processes, cells, y):
    """A piece of a closed tube, the same on all processes but for the ends of the first and last."""
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    side = int((cells / 2) ** 0.5)
    x, angle = numpy.meshgrid(rank + numpy.arange(side + 1) / side,
        2.0 * numpy.pi * numpy.arange(side) / side, indexing="ij")
    rings = numpy.stack([x, y + 0.3 * numpy.cos(angle), 0.3 * numpy.sin(angle)], axis=2)
    ends = [[rank, y, 0.0], [rank + 1.0, y, 0.0]]
    i, k = numpy.meshgrid(numpy.arange(side), numpy.arange(side), indexing="ij")
    a, b = (i * side + k).ravel(), (i * side + (k + 1) % side).ravel()
    triangles = [numpy.stack([a, a + side, b], axis=1),
        numpy.stack([b, a + side, b + side], axis=1)]
    ring, center = numpy.arange(side), (side + 1) * side
    if rank == 0:
        triangles.append(numpy.stack([0 * ring + center, ring, (ring + 1) % side], axis=1))
    if rank == processes - 1:
        last = side * side + ring
        triangles.append(numpy.stack(
            [0 * ring + center + 1, side * side + (ring + 1) % side, last], axis=1))
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.vstack([rings.reshape(-1, 3), ends]), deep=1))
    faces = vtkCellArray()
    faces.SetData(3, numpy_to_vtkIdTypeArray(numpy.concatenate(triangles).ravel(), deep=1))
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(faces)
    return surface


def filters(inputs, way):
    """Names, and how each is made."""
    from paraview import simple

    pair = {"Source": inputs[0], "Input": inputs[1], "SourceDistribution": way}
    return {
        "closest points": lambda: simple.SkdTreeClosestPoint(**pair),
        "rays": lambda: simple.SkdTreeRays(**pair, Along="Direction", Direction=[0.1, 0.0, -1.0]),
        "probe": lambda: simple.SkdTreeProbe(**pair, AbsoluteTolerance=0.02),
        "surface intersection": lambda: simple.SkdTreeSurfaceIntersection(**pair),
        "remap": lambda: simple.SkdTreeRemap(Source=inputs[2], Input=inputs[3],
            Method="Conservative First Order", Geometry="Plane", SourceDistribution=way),
        "compare surfaces": lambda: simple.SkdTreeCompareSurfaces(**pair, Tolerance=1e-3),
        "compare surfaces, signed": lambda: simple.SkdTreeCompareSurfaces(Source=inputs[4],
            Input=inputs[5], SourceDistribution=way, SignedDistance=1, Tolerance=1e-3),
        "mesh refinement by a field": lambda: simple.SkdTreeMeshRefinement(Input=inputs[3],
            Field=inputs[2], FieldArrays=["Field"], FieldThreshold=0.01, MaximumLevel=1,
            SourceDistribution=way),
        "boolean": lambda: simple.SkdTreeBooleanOperation(
            Source=inputs[4], Input=inputs[5], SourceDistribution=way),
        "boolean, tubes": lambda: simple.SkdTreeBooleanOperation(
            Source=inputs[6], Input=inputs[7], SourceDistribution=way),
    }


def run_filter(make):
    """What the report says and how much memory it took."""
    from paraview import simple

    proxy = make()
    restart_peak()
    before = memory("VmRSS")
    proxy.UpdatePipeline()
    report = proxy.GetClientSideObject().GetOutputDataObject(0).GetFieldData()
    arrays = {column: report.GetArray("SkdReport" + column) for column in COLUMNS}
    found = {column: array.GetValue(0) for column, array in arrays.items() if array}
    found["Memory"] = memory("VmHWM") - before
    simple.Delete(proxy)
    return found


def measure(cells, file):
    from paraview import servermanager, simple

    module = servermanager.vtkProcessModule.GetProcessModule()
    rank = module.GetPartitionId()
    processes = module.GetNumberOfLocalPartitions()
    inputs = []
    for mesh in (strip(rank, cells, 0.0, 0.05), strip(rank, cells, 0.02, 0.05),
            strip(rank, cells, 0.0, 0.0), strip(rank, 0.8 * cells, 0.0, 0.0),
            ball(rank, cells, 0.0), ball(rank, cells, 0.2),
            tube(rank, processes, cells, 0.0), tube(rank, processes, cells, 0.2)):
        inputs.append(simple.TrivialProducer())
        inputs[-1].GetClientSideObject().SetOutput(mesh)
    found = {way: {name: run_filter(make) for name, make in filters(inputs, way).items()}
        for way in WAYS}
    with open(file % rank, "w", encoding="utf-8") as output:
        json.dump(found, output)


def run(processes, cells, file):
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
        OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_mpi_yield_when_idle="1",
        MALLOC_ARENA_MAX="1")
    subprocess.run(["mpiexec", "-np", str(processes), "pvbatch", "--symmetric",
        os.path.abspath(__file__), str(cells), file], env=environment, check=True)


def print_rows(processes, told):
    for way in WAYS:
        for name in told[0][way]:
            most = {key: max(one[way][name].get(key, 0) for one in told)
                for key in (*COLUMNS, "Memory")}
            sent = max(most["PointsSent"], most["RaysSent"])
            print(f"| {name} | {way} | {processes} | {most['Memory'] / 2**20:.1f} MB |"
                f" {sent} | {most['SourceCells']} | {most['MessagesSent']} |"
                f" {most['BytesSent']} |", flush=True)


def main(cells):
    print("| filter | way | processes | memory | points or rays sent | cells searched | messages |"
        " bytes sent |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "counts_%d.json")
        for processes in PROCESSES:
            run(processes, cells, file)
            told = []
            for rank in range(processes):
                with open(file % rank, encoding="utf-8") as found:
                    told.append(json.load(found))
            print_rows(processes, told)


if len(sys.argv) > 2:
    measure(int(sys.argv[1]), sys.argv[2])
else:
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 8000)
