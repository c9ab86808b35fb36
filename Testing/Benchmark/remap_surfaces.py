# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""How the errors of conservative remapping between surfaces that nearly coincide fall with the cells.

From tubes of quads to tubes of skewed triangles, and from spheres of triangles to others that are
turned and dented by a part in 500 (so that they are taken as curved surfaces). Prints rows of
Markdown: the L2 errors at the cells' middles at each level, the order between the last two, the
largest distance of facets, and how far the integral over the source is from what was handed out, and
with Normalization Whole from that over the target's own areas. Needs VTK's Python modules and
vtkskdtree:
    remap_surfaces.py [levels, 1 to 4]
"""

import math
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkskdtree import vtkSkdTreeRemap

from sphere_meshes import cubed_sphere, poly_data, unit, with_field

LEVELS = (1, 2, 4, 8)[:int(sys.argv[1]) if len(sys.argv) > 1 else 3]


def triangles(mesh):
    points, cells = mesh
    return points, [t for a, b, c, d in cells for t in ((a, b, c), (a, c, d))]


def tube(around, along, turned=0, skew=0):
    k, i = numpy.divmod(numpy.arange(around * (along + 1)), around)
    angle = 2 * math.pi * (i + turned + skew * k) / around
    points = numpy.column_stack([numpy.cos(angle), numpy.sin(angle), 2 * k / along])
    cells = [(a, b, b + around, a + around) for k in range(along) for i in range(around)
        for a, b in [(k * around + i, k * around + (i + 1) % around)]]
    return points, cells


def dented(mesh):
    points, cells = mesh
    c, s = math.cos(0.4), math.sin(0.4)
    points = points @ numpy.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
    points = points @ numpy.array([[1, 0, 0], [0, c, s], [0, -s, c]])
    return points * (1 + 0.002 * numpy.sin(3 * points[:, :1])), cells


def measured(mesh):
    """Middles and areas of cells, as the triangles of the edges and the middle."""
    points, cells = mesh
    middles = numpy.array([points[list(cell)].mean(axis=0) for cell in cells])
    areas = [sum(numpy.linalg.norm(numpy.cross(points[a] - m, points[b] - m)) / 2
        for a, b in zip(cell, cell[1:] + cell[:1])) for cell, m in zip(cells, middles)]
    return middles, numpy.array(areas)


def field(x, is_sphere):
    """On a sphere of the directions, so that its dents do not count."""
    x = unit(x) if is_sphere else x
    return 2 + x[:, 0] * x[:, 1] + numpy.cos(1.5 * x[:, 2])


def run(source, target, method, normalization, is_sphere):
    """The L2 error, the largest distance, and the relative error of the integral."""
    (here, areas), (there, own) = measured(source), measured(target)
    remap = vtkSkdTreeRemap()
    remap.SetMethod(method)
    remap.SetLimiter(0)
    remap.SetNormalization(normalization)
    remap.SetInputDataObject(0, poly_data(target))
    remap.SetInputDataObject(1, with_field(poly_data(source), field(here, is_sphere)))
    remap.Update()
    output = remap.GetOutputDataObject(0)
    values = vtk_to_numpy(output.GetCellData().GetArray("f"))
    reported = lambda name: output.GetFieldData().GetArray("SkdReport" + name).GetValue(0)
    whole = math.fsum(field(here, is_sphere) * areas)
    handed = math.fsum(values * own) if normalization else reported("TargetIntegral")
    error = math.sqrt((own * (values - field(there, is_sphere)) ** 2).sum() / own.sum())
    return error, reported("SurfaceGap"), abs(handed / whole - 1)


PAIRS = (("tubes", lambda n: (tube(17 * n, 6 * n), triangles(tube(23 * n, 9 * n, 0.3, 0.2)))),
    ("spheres", lambda n: (triangles(cubed_sphere(7 * n)), dented(triangles(cubed_sphere(8 * n))))))

print("| surfaces | order | L2 | L2's order | largest distance | integral | integral, Whole |")
print("| --- | --- | --- | --- | --- | --- | --- |")
for name, pair in PAIRS:
    for title, method in (("first", 3), ("second", 4)):
        is_sphere = name == "spheres"
        rows = [run(*pair(n), method, 0, is_sphere) for n in LEVELS]
        whole = max(run(*pair(n), method, 1, is_sphere)[2] for n in LEVELS)
        order = math.log2(rows[-2][0] / rows[-1][0]) if len(rows) > 1 else float("nan")
        print("| %s | %s | %s | %.2f | %s | %.0e | %.0e |" % (name, title,
            ", ".join("%.2e" % row[0] for row in rows), order,
            ", ".join("%.1e" % row[1] for row in rows), max(row[2] for row in rows), whole))
