# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""How vtkSkdTreeMeshAdaptation grows with the number of cells.

Meshes of the unit sphere and the unit square are adapted to the monitors X2, X4 and X16 of H. Weller,
P. Browne, C. Budd, M. Cullen, J. Comput. Phys. 308 (2016) 102-123, eq. 35, whose largest and smallest
values differ by 4, 16 and 256: values at the points of a cubed sphere or of a grid of about as many
points. Prints a Markdown table: the error of equidistribution before, after, and against the field
itself (interpolated between its values), iterations, and processor time. Needs the package vtkskdtree.
"""

import argparse
import math
import time

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkskdtree import vtkSkdTreeMeshAdaptation

from sphere_meshes import cubed_sphere, icosahedral_dual, poly_data


def squares(n):
    x = numpy.linspace(0.0, 1.0, n + 1)
    u, v = (a.ravel() for a in numpy.meshgrid(x, x, indexing="ij"))
    at = (numpy.arange(n)[:, None] * (n + 1) + numpy.arange(n)).ravel()
    return numpy.stack([u, v, 0 * u], -1), numpy.stack([at, at + n + 1, at + n + 2, at + 1], -1)


def longitude_latitude(n):
    """2 n x n cells, triangles at the poles."""
    turn = 2 * math.pi * numpy.arange(2 * n) / (2 * n)
    rise = math.pi * (numpy.arange(1, n) / n - 0.5)
    ring = numpy.stack([numpy.cos(rise)[:, None] * numpy.cos(turn), numpy.cos(rise)[:, None] *
        numpy.sin(turn), numpy.sin(rise)[:, None] + 0 * turn], -1).reshape(-1, 3)
    points = numpy.concatenate([ring, [[0, 0, -1], [0, 0, 1]]])
    south, north = len(ring), len(ring) + 1
    here, beside = numpy.arange(2 * n), (numpy.arange(2 * n) + 1) % (2 * n)
    cells = [[south, b, a] for a, b in zip(here, beside)]
    for row in range(n - 2):
        low, high = row * 2 * n, (row + 1) * 2 * n
        cells += [[low + a, low + b, high + b, high + a] for a, b in zip(here, beside)]
    last = (n - 2) * 2 * n
    return points, cells + [[last + a, last + b, north] for a, b in zip(here, beside)]


MESHES = {
    "squares": lambda cells: squares(round(math.sqrt(cells))),
    "cubed sphere": lambda cells: cubed_sphere(round(math.sqrt(cells / 6))),
    "hexagons": lambda cells: icosahedral_dual(round(math.sqrt(cells / 10))),
    "longitude-latitude": lambda cells: longitude_latitude(round(math.sqrt(cells / 2))),
}


def monitor(points, ratio, is_plane):
    """Weller's, of a disc about a point of no symmetry; its square root has the ratio's square."""
    centre = numpy.array([0.45, 0.55, 0.0] if is_plane else [0.36, 0.48, 0.8])
    apart = numpy.linalg.norm(points - centre, axis=1) if is_plane else numpy.arccos(
        numpy.clip(points @ centre, -1, 1))
    size = 1.0 / math.pi if is_plane else 1.0
    least = ratio ** -4.0
    return numpy.sqrt((1 - least) / 2 * (numpy.tanh(
        (math.pi / 6 * size - apart) / (math.pi / 20 * size)) + 1) + least)


def adapted(name, cells, ratio):
    is_plane = name == "squares"
    mesh = poly_data(MESHES[name](cells))
    field_mesh = squares(round(math.sqrt(cells))) if is_plane else cubed_sphere(
        round(math.sqrt(cells / 6)), 0.3)
    field = poly_data(field_mesh)
    values = numpy_to_vtk(monitor(field_mesh[0], ratio, is_plane), deep=1)
    values.SetName("m")
    field.GetPointData().AddArray(values)
    adaptation = vtkSkdTreeMeshAdaptation()
    adaptation.SetInputData(mesh)
    adaptation.SetSourceData(field)
    adaptation.SetMonitor(vtkSkdTreeMeshAdaptation.VALUE)
    adaptation.SetMaximumRatio(1000.0)
    start = time.process_time()
    adaptation.Update()
    seconds = time.process_time() - start
    data = adaptation.GetOutput().GetFieldData()
    report = lambda what: data.GetArray("SkdReport" + what).GetTuple1(0)
    return [name, "X%d" % ratio, mesh.GetNumberOfCells(), "%.2f" % report("EquidistributionBefore"),
        "%.4f" % report("EquidistributionAfter"), "%.4f" % report("EquidistributionOfField"),
        "%d" % report("Iterations"), "%.2f" % seconds,
        "%.1f" % (1e6 * seconds / mesh.GetNumberOfCells() / max(report("Iterations"), 1))]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("cells", nargs="*", type=float, default=[1e4, 1e5])
    parser.add_argument("--ratios", nargs="+", type=int, default=[2, 4, 16], help="X2, X4, X16")
    options = parser.parse_args()
    print("| mesh | monitor | cells | error before | error | against the field | iterations | s | "
          "us a cell and iteration |")
    print("| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |")
    for name in MESHES:
        for ratio in options.ratios:
            for cells in options.cells:
                print("|", *(" | ".join(str(value) for value in adapted(name, cells, ratio)), "|"),
                    flush=True)


if __name__ == "__main__":
    main()
