# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""quick_launch.py <paraview> <work>

Types names of filters into ParaView's quick launch (Ctrl+Space) as people do, with blanks, hyphens
or neither, and expects the filter that they mean in the pipeline."""

import os
import pathlib
import re
import subprocess
import sys
import time

from keyboard import CONTROL, Keyboard

# Typed: the filter that Enter takes, in one window after another. The last of a window may ask for
# its second input, by a dialog that stays open.
WINDOWS = (
    {
        "skd": "SkdTreeAMR",
        "skd tree repr": "SkdTreeRepresentation",
        "skdtree spatial": "SkdTreeSpatialQuery",
        "skd-tree attach": "SkdTreeAttach",
        "boolean": "SkdTreeBooleanOperation",
    },
    {"closest point": "SkdTreeClosestPoint"},
)
FIRST_WITH_HYPHENS = (5, 13)  # this ParaView looks for them in labels, 5.11 ignores them
HERE = pathlib.Path(__file__).parent


def wait_for(what, condition, seconds=120):  # a busy machine takes a minute to start ParaView
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "waited in vain for " + what
        time.sleep(0.05)


class Window:
    """ParaView's main window with a sphere as its active source."""

    def __init__(self, paraview, work):
        self.sources = pathlib.Path(work, "quick_launch_sources.txt")
        self.start = self.sources.with_suffix(".start")
        for file in (self.sources, self.start):
            file.unlink(missing_ok=True)
        self.process = subprocess.Popen(
            [paraview, "--dr", "--script=" + str(HERE / "quick_launch_session.py")],
            env=dict(os.environ, SKDTREE_SOURCES=str(self.sources),
                SKDTREE_START=str(self.start)))
        wait_for("ParaView", lambda: self.pipeline() == ["Ball"])
        self.keyboard = Keyboard()
        time.sleep(2)  # a first start may show its examples
        self.keyboard.press("Escape")
        time.sleep(0.5)
        self.main = self.keyboard.topmost()

    def pipeline(self):
        return self.sources.read_text().split() if self.sources.exists() else []

    def is_on_top(self):
        return self.keyboard.topmost() == self.main

    def launch(self, typed):
        """The name of the filter that is made, or whose inputs a dialog asks for."""
        wait_for("the main window", self.is_on_top)
        self.start.touch()
        wait_for("the pipeline at the start", lambda: not self.start.exists())
        assert self.pipeline() == ["Ball"], self.pipeline()
        self.keyboard.press(" ", CONTROL)
        wait_for("the quick launch", lambda: not self.is_on_top())
        self.keyboard.type(typed)
        self.keyboard.press("\n")
        wait_for("the filter of " + typed, self.made)
        return self.made()

    def made(self):
        return "".join(name.rstrip("0123456789") for name in self.pipeline() if name != "Ball")


def version_of(paraview):
    said = subprocess.run([paraview, "--version"], capture_output=True, text=True).stdout
    return tuple(int(number) for number in re.search(r"(\d+)\.(\d+)", said).groups())


def main():
    has_hyphens = version_of(sys.argv[1]) >= FIRST_WITH_HYPHENS
    for wanted in WINDOWS:
        expected = {
            typed: name for typed, name in wanted.items() if not (has_hyphens and "-" in typed)}
        window = Window(*sys.argv[1:])
        try:
            found = {typed: window.launch(typed) for typed in expected}
        finally:
            window.process.kill()
            window.process.wait()
        print(found)
        assert found == expected


main()
