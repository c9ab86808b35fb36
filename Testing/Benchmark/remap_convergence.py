# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""How the errors of conservative remapping on the sphere fall as cells get smaller.

From cubed spheres (6 n^2 cells, equal angles) to icosahedral duals (10 n^2 + 2 cells), the analytic
fields of P. W. Jones, Monthly Weather Review 127 (1999) 2204-2210 (cosine hill, Y 2,2, Y 16,32) and a
vortex, as cell averages by Gauss quadrature of order 11. Prints rows of Markdown: the relative errors
L1, L2 and Linf at each level, the order between the last two, and the conservation error; then the
drift of the mass over 100 cycles back and forth. Needs VTK's Python modules and vtkskdtree:
    remap_convergence.py [levels, 1 to 3]
"""

import math
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkskdtree import vtkSkdTreeRemap

from sphere_meshes import cubed_sphere, icosahedral_dual, poly_data, unit, with_field

LEVELS = ((15, 16), (30, 32), (60, 64))[:int(sys.argv[1]) if len(sys.argv) > 1 else 3]


def averages(mesh, function):
    """Over each cell, and the cells' areas: a fan of triangles, 6 x 6 Gauss points each."""
    points, cells = mesh
    nodes, weights = numpy.polynomial.legendre.leggauss(6)
    nodes, weights = (nodes + 1) / 2, weights / 2
    fan = [(i, cell[0], cell[k], cell[k + 1])
        for i, cell in enumerate(cells) for k in range(1, len(cell) - 1)]
    at, a, b, c = numpy.array(fan).T
    a, b, c = points[a], points[b], points[c]
    volume = numpy.einsum("ij,ij->i", a, numpy.cross(b, c))
    sums, areas = numpy.zeros(len(cells)), numpy.zeros(len(cells))
    for u, wu in zip(nodes, weights):
        for w, wv in zip(nodes, weights):
            v = w * (1 - u)
            x = (1 - u - v) * a + u * b + v * c
            length = numpy.linalg.norm(x, axis=1)
            weight = wu * wv * (1 - u) * volume / length ** 3
            sums += numpy.bincount(at, weight * function(x / length[:, None]), len(cells))
            areas += numpy.bincount(at, weight, len(cells))
    return sums / areas, areas


def y22(x):
    return 2 + x[:, 0] ** 2 - x[:, 1] ** 2


def y16_32(x):
    across2 = x[:, 0] ** 2 + x[:, 1] ** 2
    return 2 + (2 * x[:, 2] * numpy.sqrt(across2)) ** 16 * numpy.cos(
        16 * numpy.arctan2(x[:, 1], x[:, 0]))


def hill(x):
    distance = numpy.arccos(numpy.clip(-x[:, 0], -1, 1))
    return 2 - numpy.cos(math.pi * numpy.minimum(1, 3 * distance / math.pi))


def vortex(x):
    """Two of them, about a tilted axis (Nair and Machenhauer, 2002)."""
    axis = unit(numpy.array([math.cos(0.8) * math.sin(0.6), math.sin(0.8) * math.sin(0.6),
        math.cos(0.6)]))
    east = unit(numpy.cross([0, 0, 1], axis))
    north = numpy.cross(axis, east)
    radius = 3 * numpy.sqrt(numpy.clip(1 - (x @ axis) ** 2, 0, 1))
    speed = 1.5 * math.sqrt(3) * numpy.tanh(radius) / numpy.cosh(radius) ** 2
    turned = numpy.arctan2(x @ north, x @ east) - 6 * numpy.where(
        radius > 0, speed / numpy.maximum(radius, 1e-300), 0)
    return 1 - numpy.tanh(radius / 5 * numpy.sin(turned))


def remapped(remap):
    remap.Update()
    output = remap.GetOutputDataObject(0)
    report = output.GetFieldData().GetArray("SkdReportConservationError").GetValue(0)
    return vtk_to_numpy(output.GetCellData().GetArray("f")).copy(), report


def errors(values, exact, areas):
    difference = abs(values - exact)
    return ((areas * difference).sum() / (areas * abs(exact)).sum(),
        math.sqrt((areas * difference ** 2).sum() / (areas * exact ** 2).sum()),
        difference.max() / abs(exact).max())


METHODS = (("first", 3, 0), ("second", 4, 0), ("second, limited", 4, 1))


def table():
    meshes = [(cubed_sphere(n), icosahedral_dual(m)) for n, m in LEVELS]
    kept = {}
    print("| field | order | L1 | L2 | Linf | L2's order | conservation |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for name, field in (("Y 2,2", y22), ("Y 16,32", y16_32), ("hill", hill), ("vortex", vortex)):
        averaged = [(averages(source, field)[0],) + averages(target, field)
            for source, target in meshes]
        for title, method, limiter in METHODS:
            rows, worst = [], 0
            for level, (here, exact, areas) in enumerate(averaged):
                remap = kept.setdefault((level, method, limiter), vtkSkdTreeRemap())
                remap.SetMethod(method)
                remap.SetLimiter(limiter)
                remap.SetInputDataObject(0, poly_data(meshes[level][1]))
                remap.SetInputDataObject(1, with_field(poly_data(meshes[level][0]), here))
                values, error = remapped(remap)
                rows.append(errors(values, exact, areas))
                worst = max(worst, error)
            order = math.log2(rows[-2][1] / rows[-1][1]) if len(rows) > 1 else float("nan")
            cells = [", ".join("%.3e" % row[k] for row in rows) for k in range(3)]
            print("| %s | %s | %s | %.2f | %.0e |" % (name, title, " | ".join(cells), order, worst))


def drift(cycles=100):
    here, there = cubed_sphere(LEVELS[0][0]), icosahedral_dual(LEVELS[0][1])
    values, areas = averages(here, y22)
    back = averages(there, y22)[1]
    mass = math.fsum(values * areas)
    go, come = vtkSkdTreeRemap(), vtkSkdTreeRemap()
    for cycle in range(cycles):
        for remap, source, target in ((go, here, there), (come, there, here)):
            remap.SetMethod(4)
            remap.SetInputDataObject(0, poly_data(target))
            remap.SetInputDataObject(1, with_field(poly_data(source), values))
            values, _ = remapped(remap)
    assert len(back) == len(there[1])
    print("\ndrift of the mass in %d cycles: %.1e" % (cycles, abs(math.fsum(values * areas) / mass - 1)))


table()
drift()
