# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by the ParaView that quick_launch.py starts: writes the names of the pipeline's sources, and of
the filters whose inputs a dialog asks for, into $SKDTREE_SOURCES again and again. Where there is a
file $SKDTREE_START, takes all new sources away, writes that, and removes it."""

import os

from paraview import servermanager, simple

FILE = os.environ["SKDTREE_SOURCES"]
START = os.environ["SKDTREE_START"]


def take_away_all_but(ball):
    for source in list(simple.GetSources().values()):
        if source != ball:
            simple.Delete(source)
    simple.SetActiveSource(ball)


def asks_for_inputs(name):
    """The dialog holds them in the prototype of the filter."""
    prototype = servermanager.ProxyManager().GetPrototypeProxy("filters", name)
    return prototype and prototype.GetProperty("Input").GetNumberOfProxies() > 0


def look(*_):
    goes_to_start = os.path.exists(START)
    if goes_to_start:
        take_away_all_but(ball)
    names = [name for name, _ in simple.GetSources()]
    names += [name for name in FILTERS if asks_for_inputs(name)]
    with open(FILE + ".new", "w") as sources:
        sources.write("\n".join(names))
    os.replace(FILE + ".new", FILE)  # a reader never sees half of it
    if goes_to_start:
        os.remove(START)


FILTERS = [name for name in dir(servermanager.filters) if name.startswith("SkdTree")]
ball = simple.Sphere(registrationName="Ball")
simple.Show(ball)
interactor = simple.GetActiveView().SMProxy.GetInteractor()
interactor.AddObserver("TimerEvent", look)
interactor.CreateRepeatingTimer(100)
