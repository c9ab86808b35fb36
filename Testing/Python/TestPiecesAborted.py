# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""A filter that is aborted on one of several processes, while it works on meshes in pieces, ends on all
of them, with empty outputs, and executes again on all of them as if nothing had been: every filter,
aborted at its first report of progress and at one of the others, which is drawn.
Run without an argument this starts the processes; with the name of a file and partitions it is one
of them, and writes there the sizes of its outputs."""

import random

import skdcases
import skdpieces

RUNS = {3: ("cuts",), 4: ("random",)}
ABORTED = 1 # the process that is
DRAW = random.Random(27)


class Abort:
    """Aborts a filter at one of its reports of progress, 0 for none, and counts these. VTK makes the
    first and the last, before and after the filter executes."""

    def __init__(self, algorithm):
        self.reports = self.at = 0
        self.is_done = False
        algorithm.AddObserver("ProgressEvent", self)

    def __call__(self, caller, _event):
        self.reports += 1
        if self.reports == self.at:
            caller.SetAbortExecute(1)
            self.is_done = True

    def prepare(self, at):
        self.reports, self.at, self.is_done = 0, at, False


def size_of(case):
    data = case.proxy.GetClientSideObject().GetOutputDataObject(case.port)
    return data.GetNumberOfRows() if data.IsA("vtkTable") else data.GetNumberOfPoints()


def sizes_of(case, fresh):
    """What a filter has, for each of two aborts: whether there was one, the size after it, and when it
    is taken back; and the size if there had not been any."""
    algorithm = case.proxy.GetClientSideObject()
    abort = Abort(algorithm)
    sizes = []
    for is_first in (True, False):
        at = 1 if is_first else DRAW.randint(2, abort.reports - 1) if abort.reports > 2 else 0
        abort.prepare(at if skdpieces.process()[0] == ABORTED else 0)
        algorithm.Modified()
        algorithm.UpdatePiece(*skdpieces.process(), 0)
        sizes.append([abort.is_done, size_of(case)])
        abort.prepare(0)
        algorithm.SetAbortExecute(0)
        algorithm.UpdatePiece(*skdpieces.process(), 0)
        sizes[-1].append(size_of(case))
    fresh.proxy.GetClientSideObject().UpdatePiece(*skdpieces.process(), 0)
    return sizes, size_of(fresh)


def write(file, partitions):
    sizes = {}
    for partition in partitions:
        for (name, case), (_, fresh) in zip(skdcases.cases(partition), skdcases.cases(partition)):
            for proxy in (case.proxy, fresh.proxy):
                if "SourceDistribution" in proxy.ListProperties():
                    proxy.SourceDistribution = "Exchange"
            sizes[name] = sizes_of(case, fresh)
    skdpieces.tell(file, sizes)


def check(file, processes, partitions):
    sizes = skdpieces.told(file, processes)
    drawn = 0
    for name in sizes[0]:
        aborts, fresh = zip(*(of_process[name] for of_process in sizes))
        assert sum(fresh) > 0, name
        for number, of_processes in enumerate(zip(*aborts)):
            is_done, aborted, again = zip(*of_processes)
            where = f"{name}, {processes} processes, {partitions}, abort {number}: {of_processes} {fresh}"
            assert again == fresh and (number > 0 or any(is_done)), where
            assert aborted == fresh if not any(is_done) else sum(aborted) == 0, where
            drawn += number > 0 and any(is_done)
    assert drawn > len(sizes[0]) // 2, drawn


skdpieces.run(__file__, RUNS, "aborted_%d.pickle", write, check)
