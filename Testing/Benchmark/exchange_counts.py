# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What each of 1 to 8 processes holds and sends where a Source lies in pieces, with a fixed number of
cells and points on each process: a strip of a wavy surface, and points near it. Processes may share
processors: these are counts, no times. Prints a row for each number of processes and way, of the
process that has most.

Run by python3 with the build tree's environment (build/setup.sh): exchange_counts.py [cells]"""

import json
import os
import subprocess
import sys
import tempfile

PROCESSES = (1, 2, 4, 8)
WAYS = ("Replicate", "Exchange")
COLUMNS = ("PointsSent", "RaysSent", "MessagesSent", "BytesSent")


def peak_memory():
    """Of this process so far, in bytes."""
    with open("/proc/self/status", encoding="utf-8") as status:
        return next(1024 * int(line.split()[1]) for line in status if line.startswith("VmHWM"))


def strip(rank, cells, height):
    """Triangles of a wavy surface for x from rank to rank + 1."""
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    side = int((cells / 2) ** 0.5)
    x, y = numpy.meshgrid(rank + numpy.arange(side + 1) / side, numpy.arange(side + 1) / side)
    z = height + 0.05 * numpy.sin(20.0 * x) * numpy.cos(17.0 * y)
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
    return surface


def measure(cells, way, file):
    from paraview import servermanager, simple

    module = servermanager.vtkProcessModule.GetProcessModule()
    rank = module.GetPartitionId()
    inputs = []
    for height in (0.0, 0.02):
        inputs.append(simple.TrivialProducer())
        inputs[-1].GetClientSideObject().SetOutput(strip(rank, cells, height))
    before = peak_memory()
    filters = {
        "closest points": simple.SkdTreeClosestPoint(
            Source=inputs[0], Input=inputs[1], SourceDistribution=way),
        "rays": simple.SkdTreeRays(Source=inputs[0], Input=inputs[1], Along="Direction",
            Direction=[0.1, 0.0, -1.0], SourceDistribution=way),
        "probe": simple.SkdTreeProbe(Source=inputs[0], Input=inputs[1], SourceDistribution=way),
    }
    found = {}
    for name, proxy in filters.items():
        proxy.UpdatePipeline()
        report = proxy.GetClientSideObject().GetOutputDataObject(0).GetFieldData()
        arrays = {column: report.GetArray("SkdReport" + column) for column in COLUMNS}
        found[name] = {column: array.GetValue(0) for column, array in arrays.items() if array}
        found[name]["Memory"] = peak_memory() - before
    with open(file % rank, "w", encoding="utf-8") as output:
        json.dump(found, output)


def run(processes, cells, way, file):
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
        OMPI_MCA_rmaps_base_oversubscribe="1")
    subprocess.run(["mpiexec", "-np", str(processes), "pvbatch", "--symmetric",
        os.path.abspath(__file__), str(cells), way, file], env=environment, check=True)


def main(cells):
    print("| filter | way | processes | memory | points or rays sent | messages | bytes sent |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "counts_%d.json")
        for way in WAYS:
            for processes in PROCESSES:
                run(processes, cells, way, file)
                told = []
                for rank in range(processes):
                    with open(file % rank, encoding="utf-8") as found:
                        told.append(json.load(found))
                for name in told[0]:
                    most = {key: max(one[name].get(key, 0) for one in told)
                        for key in (*COLUMNS, "Memory")}
                    sent = max(most["PointsSent"], most["RaysSent"])
                    print(f"| {name} | {way} | {processes} | {most['Memory'] / 2**20:.0f} MB |"
                        f" {sent} | {most['MessagesSent']} | {most['BytesSent']} |", flush=True)


if len(sys.argv) > 2:
    measure(int(sys.argv[1]), sys.argv[2], sys.argv[3])
else:
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 200000)
