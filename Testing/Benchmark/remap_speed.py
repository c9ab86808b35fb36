# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What remapping costs, as a whole filter: cubed spheres turned against each other, on one thread.

Prints a row of Markdown for each number of cells: processor seconds of the first run, of a further
time step (overlaps are kept), and of the first run a target cell. Needs VTK's Python modules and
vtkskdtree:
    remap_speed.py [number of cells...]
"""

import math
import sys
import time

import numpy
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkskdtree import vtkSkdTreeRemap

from sphere_meshes import cubed_sphere, poly_data, with_field

CELLS = [int(float(text)) for text in sys.argv[1:]] or [10**4, 10**5, 10**6]


def seconds(remap):
    start = time.process_time()
    remap.Update()
    return time.process_time() - start


def main():
    vtkSMPTools.Initialize(1)
    print("| cells each | order | first run, s | a further step, s | a target cell, us |")
    print("| ---: | --- | ---: | ---: | ---: |")
    for cells in CELLS:
        n = round(math.sqrt(cells / 6))
        here, there = poly_data(cubed_sphere(n)), poly_data(cubed_sphere(n, 0.4))
        fields = [numpy.cos(numpy.arange(6 * n * n) * 1e-3 + step) for step in (0, 1)]
        for title, method in (("first", 3), ("second", 4)):
            remap = vtkSkdTreeRemap()
            remap.SetMethod(method)
            remap.SetInputDataObject(0, there)
            remap.SetInputDataObject(1, with_field(here, fields[0]))
            first = seconds(remap)
            remap.SetInputDataObject(1, with_field(here, fields[1]))
            print("| %d | %s | %.2f | %.2f | %.2f |" %
                (6 * n * n, title, first, seconds(remap), 1e6 * first / (6 * n * n)))


main()
