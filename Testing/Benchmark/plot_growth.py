# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws how costs grow with the number of cells, from what skdtree_benchmark, curve_cost.py or
skdtree_intersection_benchmark wrote with --csv.

usage: python3 plot_growth.py growth.csv ... growth.png     (Debian: python3-matplotlib)

The dashed line is what the skD-tree would take at each size if it took log N from the least on.
"""

import collections
import csv
import math
import sys

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

WORKS = {
    "closest point, near": "closest point near a noisy sphere",
    "first hit, across the box": "first hit of a noisy sphere",
    "find cell, random in the box": "find cell among tetrahedra",
    "pieces across": "a straight piece of a curve across a sphere",
    "surfaces that meet": "two spheres that meet, trees and all",
}
OURS = "skD-tree"
SCENES = ("noisy sphere", "structured tetrahedra", "sphere", "two spheres")


def read(paths):
    """{work: {structure: [(cells, nanoseconds)]}}, by ascending cells; {work: unit}."""
    series = collections.defaultdict(lambda: collections.defaultdict(dict))
    units = {}
    for path in paths:
        with open(path, newline="") as file:
            for row in csv.DictReader(file):
                if row["scene"] in SCENES and row["work"] in WORKS and row["value"]:
                    times = series[row["work"]][row["structure"]]
                    times[int(row["cells"])] = float(row["value"])
                    units[row["work"]] = row["unit"]
    return units, {work: {name: sorted(times.items()) for name, times in structures.items()}
            for work, structures in series.items()}


def draw(axes, title, unit, structures, colours):
    for name, points in structures.items():
        style = {"linewidth": 2.5, "zorder": 3} if name == OURS else {}
        axes.plot(*zip(*points), marker="o", markersize=3, label=name, color=colours[name], **style)
    if OURS in structures:
        cells = [n for n, _ in structures[OURS]]
        first, time = structures[OURS][0]
        axes.plot(cells, [time * math.log(n) / math.log(first) for n in cells],
                  linestyle="--", color="grey", label="log N")
    axes.set_title(title, fontsize=10)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("cells")
    axes.set_ylabel(unit + ", one thread")
    axes.grid(True, which="both", alpha=0.2)
    axes.legend(fontsize=7, loc="upper center", bbox_to_anchor=(0.5, -0.16), ncol=2)


def main():
    *sources, picture = sys.argv[1:]
    units, series = read(sources)
    works = [work for work in WORKS if work in series]
    names = sorted({name for structures in series.values() for name in structures} - {OURS})
    colours = {OURS: "black", **{name: f"C{i}" for i, name in enumerate(names)}}
    figure, panels = pyplot.subplots(1, len(works), figsize=(4 * len(works), 4.4), squeeze=False)
    for axes, work in zip(panels[0], works):
        draw(axes, WORKS[work], units[work], series[work], colours)
    figure.tight_layout()
    figure.savefig(picture, dpi=110)


main()
