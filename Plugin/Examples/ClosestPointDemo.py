# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Closest points on a scanned surface, found by ParaView's server.

The surface is that of a fruit fly's brain, from an electron microscope's scan. Asked are
- the points of a grid around it: the distance field, negative inside;
- the nodes of a neuron: how deep below the brain's surface it runs;
- the same nodes, of a region of the brain (the lateral horn): where it enters, where it leaves.

Run by pvpython, with the plugin SkdTree loaded (by PV_PLUGIN_PATH, say) in client and server:
    pvpython ClosestPointDemo.py --data Data --picture closest_point.png [--server host:port]
"""

import argparse
import os
import sys
import time

from paraview import servermanager, simple

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")

COLUMNS = ("queries", "source", "points", "cells", "build s", "queries s", "us/point", "from", "to")
REACH = 6000  # colours and level lines end at this distance


class ProgressBar:
    """The server's progress, as a bar in the terminal (in a file, its end only)."""

    WIDTH = 40

    def __init__(self, title):
        self.title = title
        self.start = time.perf_counter()
        self.handler = servermanager.ActiveConnection.Session.GetProgressHandler()
        self.tag = self.handler.AddObserver("ProgressEvent", lambda *_: self.show())

    def show(self):
        self.draw(self.handler.GetLastProgress() / 100)

    def draw(self, fraction, end=""):
        if not end and not sys.stdout.isatty():
            return
        full = round(self.WIDTH * min(max(fraction, 0.0), 1.0))
        bar = "#" * full + "." * (self.WIDTH - full)
        seconds = time.perf_counter() - self.start
        start = "\r" if sys.stdout.isatty() else ""
        print(f"{start}{self.title:<44}[{bar}] {100 * fraction:4.0f}%  {seconds:5.2f} s", end=end)
        sys.stdout.flush()

    def __enter__(self):
        self.draw(0)
        return self

    def __exit__(self, kind, *_):
        self.handler.RemoveObserver(self.tag)
        if kind is None:
            self.draw(1, end="\n")


def read(folder, name):
    data = simple.OpenDataFile(os.path.join(folder, name))
    data.UpdatePipeline()
    return data


def grid_around(surface, resolution):
    """A grid of points in the surface's bounds and a tenth more on each side."""
    bounds = surface.GetDataInformation().GetBounds()
    unit = simple.FastUniformGrid(WholeExtent=[0, resolution - 1] * 3, 
                                  GenerateDistanceSquaredScalars=0)
    lengths = [high - low for low, high in zip(bounds[::2], bounds[1::2])]
    grid = simple.Transform(Input=unit)
    grid.Transform.Translate = [low - 0.1 * length for low, length in zip(bounds[::2], lengths)]
    grid.Transform.Scale = [1.2 * length / (resolution - 1) for length in lengths]
    grid.UpdatePipeline()
    return grid


def query(what, points, source_name, source):
    """The filter on points and source, computed under a progress bar, and its row of the table."""
    closest = simple.SkdTreeClosestPoint(Input=points, Source=source, SignedDistance=1)
    with ProgressBar(f"{what} to {source_name}"):
        closest.UpdatePipeline()

    def report(name):
        return closest.FieldData["SkdReport" + name].GetRange()[0]

    low, high = closest.PointData["SkdDistance"].GetRange()
    count, seconds = int(report("Points")), report("QuerySeconds")
    row = (what, source_name, count, int(report("SourceCells")), f"{report('BuildSeconds'):.4f}",
           f"{seconds:.3f}", f"{1e6 * seconds / count:.2f}", f"{low:.1f}", f"{high:.1f}")
    return closest, row


def print_table(rows):
    cells = [[str(cell) for cell in row] for row in (COLUMNS, *rows)]
    widths = [max(len(row[i]) for row in cells) for i in range(len(COLUMNS))]
    for row in cells:
        texts = [cell.ljust(width) if i < 2 else cell.rjust(width)
                 for i, (cell, width) in enumerate(zip(row, widths))]
        print("  ".join(texts))


def show_distance(source, view):
    source.UpdatePipeline()
    display = simple.Show(source, view)
    simple.ColorBy(display, ("POINTS", "SkdDistance"))
    return display


def show_plain(source, view, colour, opacity):
    display = simple.Show(source, view)
    display.ColorArrayName = [None, ""]
    display.DiffuseColor = display.AmbientColor = colour
    display.Opacity = opacity


def show_field(field, origin, view):
    """A slice of the distance field, as far as it is near the surface, with its level lines."""
    cut = simple.Slice(Input=field)
    cut.SliceType.Origin = origin
    cut.SliceType.Normal = [0, 0, 1]
    near = simple.Clip(Input=cut, ClipType="Scalar", Scalars=["POINTS", "SkdDistance"], Value=REACH)
    unlit = show_distance(near, view)
    unlit.Ambient, unlit.Diffuse = 1, 0
    levels = simple.Contour(Input=cut, ContourBy=["POINTS", "SkdDistance"],
                            Isosurfaces=[step * REACH / 6 for step in range(-6, 6) if step])
    show_plain(levels, view, [0.5, 0.5, 0.5], 1)
    outline = simple.Contour(Input=cut, ContourBy=["POINTS", "SkdDistance"], Isosurfaces=[0])
    show_plain(simple.Tube(Input=outline, Radius=90), view, [0.15, 0.15, 0.15], 1)


def show_legend(view):
    table = simple.GetColorTransferFunction("SkdDistance")
    table.ApplyPreset("Cool to Warm", True)
    table.RescaleTransferFunction(-REACH, REACH)
    bar = simple.GetScalarBar(table, view)
    bar.Visibility = 1
    bar.Title, bar.ComponentTitle = "distance to the surface", ""
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.Orientation, bar.WindowLocation = "Horizontal", "Lower Center"
    bar.ScalarBarLength = 0.3
    bar.LabelFormat = bar.RangeLabelFormat = "%.0f"


def draw(picture, surface, region, field, neuron):
    view = simple.CreateView("RenderView")
    view.ViewSize = [1400, 760]
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = view.CenterAxesVisibility = 0

    low = surface.GetDataInformation().GetBounds()[::2]
    high = surface.GetDataInformation().GetBounds()[1::2]
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    show_plain(surface, view, [0.8, 0.75, 0.66], 0.22)
    show_plain(region, view, [0.2, 0.6, 0.35], 0.35)
    show_plain(simple.Tube(Input=neuron, Radius=220), view, [0.45, 0.1, 0.5], 1)
    show_field(field, [middle[0], middle[1], low[2] + 0.55 * (high[2] - low[2])], view)
    show_legend(view)

    view.CameraFocalPoint = middle
    view.CameraPosition = [middle[0] - 25000, middle[1] - 60000, middle[2] - 80000]
    view.CameraViewUp = [0, -1, 0]
    simple.Render(view)
    simple.ResetCamera(view)
    view.CameraViewAngle = 18
    simple.SaveScreenshot(picture, view)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--server", help="host:port of a pvserver; without one, all in this process")
    parser.add_argument("--data", default=DATA, help="the folder Data of the repository")
    parser.add_argument("--picture", default="ClosestPointDemo.png", help="the PNG to write")
    parser.add_argument("--resolution", type=int, default=128, help="points along an edge of the grid")
    options = parser.parse_args()

    if options.server:
        host, port = options.server.rsplit(":", 1)
        if not simple.Connect(host, int(port)):
            sys.exit(f"No server responds at {options.server}")
    surface = read(options.data, "fly_brain_neuropil.vtp")
    region = read(options.data, "fly_brain_lateral_horn.vtp")
    neuron = read(options.data, "fly_brain_neuron.vtp")
    grid = grid_around(surface, options.resolution)

    field, field_row = query("grid", grid, "brain surface", surface)
    depth, depth_row = query("neuron", neuron, "brain surface", surface)
    _, region_row = query("neuron", neuron, "lateral horn", region)

    where = options.server or "this process"
    print(f"\nAnswered by {where}, {servermanager.vtkSMProxyManager.GetVersionMajor()}."
          f"{servermanager.vtkSMProxyManager.GetVersionMinor()} of ParaView; lengths in voxels of 8 nm:")
    print_table([field_row, depth_row, region_row])
    draw(options.picture, surface, region, field, depth)
    print(f"\nPicture: {options.picture}")


main()
