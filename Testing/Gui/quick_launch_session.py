# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by the ParaView that quick_launch.py starts: writes the names of the pipeline's sources, and of
the filters whose inputs a dialog asks for, into $SKDTREE_SOURCES again and again. Once that file is
gone, takes all new sources away."""

import os

from paraview import servermanager, simple

FILE = os.environ["SKDTREE_SOURCES"]


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
    if not os.path.exists(FILE):
        take_away_all_but(ball)
    names = [name for name, _ in simple.GetSources()]
    names += [name for name in FILTERS if asks_for_inputs(name)]
    with open(FILE + ".new", "w") as sources:
        sources.write("\n".join(names))
    os.replace(FILE + ".new", FILE)  # a reader never sees half of it


FILTERS = [name for name in dir(servermanager.filters) if name.startswith("SkdTree")]
ball = simple.Sphere(registrationName="Ball")
simple.Show(ball)
interactor = simple.GetActiveView().SMProxy.GetInteractor()
interactor.AddObserver("TimerEvent", look)
interactor.CreateRepeatingTimer(100)
