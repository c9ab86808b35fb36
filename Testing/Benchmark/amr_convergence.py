# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""How volume fractions of an adaptive grid add up to the volume, as its cells get smaller.

Of closed surfaces of triangles (files), against the volume that these enclose: clipping is exact, so
the error is rounding at every level. Of a sphere and a torus, whose triangles are about as large as
the cells, against the volume of the true shape: the error is that of the triangles, of second order.
Of the same sphere with a triangle left out, whose fractions are sampled, and of cells counted whole
where their middle is inside, for comparison.

Prints a row of Markdown for each series: the relative errors by level, and the order between the
first and the last. Needs matplotlib (Debian: python3-matplotlib), VTK's Python modules and
vtkskdtree:
    amr_convergence.py picture.png [surface ...]
"""

import math
import os
import sys

import matplotlib
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource, vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkskdtree import vtkSkdTreeAMR

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

LEVELS = range(2, 8)


def cleaned(source):
    """Triangles, points merged."""
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    clean = vtkCleanPolyData()
    clean.SetInputConnection(triangles.GetOutputPort())
    clean.ToleranceIsAbsoluteOn()
    clean.SetAbsoluteTolerance(1e-9)
    clean.Update()
    return clean.GetOutput()


def sphere(count):
    """As many triangles around it, in double precision."""
    source = vtkSphereSource()
    source.SetThetaResolution(count)
    source.SetPhiResolution(count // 2 + 1)
    source.SetRadius(1)
    source.SetOutputPointsPrecision(1)
    return cleaned(source)


def torus(count):
    shape = vtkParametricTorus()
    shape.SetRingRadius(1)
    shape.SetCrossSectionRadius(0.4)
    source = vtkParametricFunctionSource()
    source.SetParametricFunction(shape)
    source.SetUResolution(count)
    source.SetVResolution(count * 2 // 5)
    source.SetOutputPointsPrecision(1)
    return cleaned(source)


def opened(surface):
    """Without its first triangle."""
    result = vtkPolyData()
    result.DeepCopy(surface)
    result.BuildCells()
    result.DeleteCell(0)
    result.RemoveDeletedCells()
    return result


def read(path):
    reader = vtkSTLReader() if path.endswith(".stl") else vtkXMLPolyDataReader()
    reader.SetFileName(path)
    return cleaned(reader)


def enclosed_volume(surface):
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(numpy.longdouble)
    corners = points[vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
    corners = corners - points.mean(axis=0)
    return abs(float((corners[:, 0] * numpy.cross(corners[:, 1], corners[:, 2])).sum() / 6))


def volumes(surface, level):
    """The sum of volume fractions, and of the cells whose middle is inside; and a cell's size."""
    amr = vtkSkdTreeAMR()
    amr.SetInputData(surface)
    amr.SetBaseDimensions(1, 1, 1)
    amr.SetMaximumLevel(level)
    amr.SetOutputType(vtkSkdTreeAMR.UNSTRUCTURED_GRID)
    amr.ComputeInsideOn()
    amr.ComputeVolumeFractionOn()
    amr.Update()
    grid = amr.GetOutputDataObject(0)
    low, high = (numpy.array(grid.GetBounds()[side::2]) for side in (0, 1))
    base = float(numpy.prod(high - low))
    cells = {name: vtk_to_numpy(grid.GetCellData().GetArray("Skd" + name)).astype(float)
             for name in ("Level", "VolumeFraction", "Inside")}
    size = base / 8.0**cells["Level"]
    return ((size * cells["VolumeFraction"]).sum(), (size * cells["Inside"]).sum(),
            base**(1 / 3) / 2**level)


def series_of_files(paths):
    for path in paths:
        surface = read(path)
        exact = enclosed_volume(surface)
        found = [volumes(surface, level) for level in LEVELS]
        name = os.path.splitext(os.path.basename(path))[0]
        yield "%s, its triangles" % name, [(h, abs(v / exact - 1)) for v, _, h in found]
        if path == paths[0]:
            yield "%s, whole cells" % name, [(h, abs(w / exact - 1)) for _, w, h in found]


def series_of_shapes():
    shapes = {
        "sphere, true": (sphere, 4 / 3 * math.pi, 2 * math.pi),
        "torus, true": (torus, 2 * math.pi**2 * 0.4**2, 2 * math.pi * 1.4),
        "sphere, open: samples": (lambda n: opened(sphere(n)), 4 / 3 * math.pi, 2 * math.pi),
    }
    for name, (make, exact, around) in shapes.items():
        errors = []
        for level in LEVELS:
            h = volumes(make(32), level)[2]
            v, _, h = volumes(make(max(6, round(around / h))), level)
            errors.append((h, abs(v / exact - 1)))
        yield name, errors


def main(picture, paths):
    figure, axes = pyplot.subplots(figsize=(7.2, 5.2))
    print("| error of the volume | " + " | ".join("level %d" % n for n in LEVELS) + " | order |")
    print("| --- |" + " ---: |" * (len(LEVELS) + 1))
    for name, errors in list(series_of_files(paths)) + list(series_of_shapes()):
        (h0, first), (h1, last) = errors[0], errors[-1]
        order = math.log(first / last) / math.log(h0 / h1) if last > 1e-12 else math.nan
        print("| %s | %s | %s |" % (name, " | ".join("%.1e" % error for _, error in errors),
            "rounding" if math.isnan(order) else "%.2f" % order), flush=True)
        axes.loglog([h / errors[0][0] for h, _ in errors],
            [max(error, 1e-17) for _, error in errors], marker="o", markersize=4, label=name)
    sizes = numpy.array([1, 0.5**(len(LEVELS) - 1)])
    axes.loglog(sizes, 0.3 * sizes**2, "k--", linewidth=1, label="second order")
    axes.set_xlabel("size of the smallest cells, of those of level %d" % LEVELS[0])
    axes.set_ylabel("relative error of the sum of volume fractions")
    axes.legend(fontsize=8, loc="center left", bbox_to_anchor=(0.0, 0.45))
    axes.grid(True, which="major", alpha=0.3)
    figure.tight_layout()
    figure.savefig(picture, dpi=100)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
