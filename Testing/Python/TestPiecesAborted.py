# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""A filter that is aborted on one of several processes, while it works on meshes in pieces, ends on all
of them, with empty outputs, and executes again on all of them as if nothing had been: every filter.
Run without an argument this starts the processes; with the name of a file and partitions it is one
of them, and writes there the sizes of its outputs."""

import json

import skdcases
import skdpieces

RUNS = {3: ("cuts",), 4: ("random",)}
ABORTED = 1 # the process that is


def size_of(case):
    data = case.proxy.GetClientSideObject().GetOutputDataObject(case.port)
    return data.GetNumberOfRows() if data.IsA("vtkTable") else data.GetNumberOfPoints()


def sizes_of(case, fresh):
    """What a filter has after an abort at its first report of progress; when that is taken back; and
    if there had not been any."""
    from paraview import simple

    algorithm = case.proxy.GetClientSideObject()
    is_aborted = skdpieces.process()[0] == ABORTED

    def abort(caller, _event):
        if caller.GetProgress() < 1.0:
            caller.SetAbortExecute(1)

    tag = algorithm.AddObserver("ProgressEvent", abort) if is_aborted else None
    simple.UpdatePipeline(proxy=case.proxy)
    sizes = [size_of(case)]
    if is_aborted:
        algorithm.RemoveObserver(tag)
        algorithm.SetAbortExecute(0)
    algorithm.UpdatePiece(*skdpieces.process(), 0)
    simple.UpdatePipeline(proxy=fresh.proxy)
    return sizes + [size_of(case), size_of(fresh)]


def write(file, partitions):
    sizes = {}
    for partition in partitions:
        for (name, case), (_, fresh) in zip(skdcases.cases(partition), skdcases.cases(partition)):
            for proxy in (case.proxy, fresh.proxy):
                if "SourceDistribution" in proxy.ListProperties():
                    proxy.SourceDistribution = "Exchange"
            sizes[name] = sizes_of(case, fresh)
    with open(file, "w", encoding="utf-8") as stream:
        json.dump(sizes, stream)


def check(file, processes, partitions):
    sizes = []
    for rank in range(processes):
        with open(file % rank, encoding="utf-8") as stream:
            sizes.append(json.load(stream))
    for name in sizes[0]:
        aborted, again, fresh = zip(*(of_process[name] for of_process in sizes))
        where = f"{name}, {processes} processes, {partitions}: {aborted} {again} {fresh}"
        assert again == fresh and sum(fresh) > 0 and sum(aborted) == 0, where


skdpieces.run(__file__, RUNS, "aborted_%d.json", write, check)
