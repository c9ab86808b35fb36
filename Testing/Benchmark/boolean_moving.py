# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Unions of a sphere with one that moves, step by step: processor time of the first execution, of the
second and of later ones when the filter moves its Source, and when the Source is new data.

Run by pvpython with the package vtkskdtree:
    boolean_moving.py
"""

import statistics
import time

from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkskdtree import vtkSkdTreeBooleanOperation

RUNS = 5


def sphere(rows, center=(0.0, 0.0, 0.0)):
    source = vtkSphereSource()
    source.SetThetaResolution(362)
    source.SetPhiResolution(rows)
    source.SetCenter(*center)
    source.SetOutputPointsPrecision(1)
    source.Update()
    return source.GetOutput()


def seconds(filter_):
    start = time.process_time()
    filter_.Update()
    return time.process_time() - start


def compare(body, rows):
    tool = sphere(rows)
    first, second, later, new = [], [], [], []
    for run in range(RUNS):
        shifts = [(0.31 + 0.02 * step + 0.003 * run, 0.0137 * step, 0.011) for step in range(5)]
        by_properties, by_data = vtkSkdTreeBooleanOperation(), vtkSkdTreeBooleanOperation()
        for step, shift in enumerate(shifts):
            for filter_ in (by_properties, by_data):
                filter_.SetInputData(body)
            by_properties.SetSourceData(tool)
            by_properties.SetTranslation(*shift)
            by_data.SetSourceData(sphere(rows, shift))
            (first, second, later)[min(step, 2)].append(seconds(by_properties))
            new.append(seconds(by_data))
    middle = statistics.median
    print(f"{body.GetNumberOfCells()} and {tool.GetNumberOfCells()} triangles: first {middle(first):.3f} s, "
        f"as new data {middle(new):.3f} s, moved {middle(later) / middle(new):.2f} of that "
        f"(for the first time {middle(second) / middle(new):.2f})")


if __name__ == "__main__":
    large = sphere(183)
    for rows in (183, 23):
        compare(large, rows)
