# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the pvpython tests share."""

import os
import subprocess
import sys
import xml.etree.ElementTree

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

SOURCE_DIR = os.environ["SKDTREE_SOURCE_DIR"]
DATA_DIR = os.environ["SKDTREE_DATA_DIR"]
TEMPORARY_DIR = os.environ["SKDTREE_TEMPORARY_DIR"]


def skip(why):
    """Ends the test as one that was not run."""
    print("skipped:", why)
    sys.exit(77)


def run_tests(names):
    """Runs the functions of a module whose names begin with test_."""
    for name, function in list(names.items()):
        if name.startswith("test_"):
            print(name, flush=True)
            function()


def temporary(name):
    return os.path.join(TEMPORARY_DIR, name)


def point_array(proxy, name, port=0):
    """A point array of a proxy's output, which must be no composite data set."""
    from paraview import servermanager, simple

    simple.UpdatePipeline(proxy=proxy)
    data = servermanager.Fetch(proxy, idx=port)
    array = data.GetPointData().GetArray(name)
    assert array is not None, (name, data)
    return vtk_to_numpy(array)


def report(proxy, name):
    """A number of the filter's report."""
    return proxy.FieldData["SkdReport" + name].GetRange()[0]


def assert_trees_are_kept(proxy, trees, **change):
    """A first update builds so many trees, and another property then none."""
    proxy.UpdatePipeline()
    assert report(proxy, "TreesBuilt") == trees
    for name, value in change.items():
        setattr(proxy, name, value)
    proxy.UpdatePipeline()
    assert report(proxy, "TreesBuilt") == 0


def sphere_source(resolution, radius=0.5):
    """A source of VTK, with so many triangles along the equator and from pole to pole."""
    from vtkmodules.vtkFiltersSources import vtkSphereSource

    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.Update()
    return source


def sphere_mesh(resolution, radius=0.5):
    return sphere_source(resolution, radius).GetOutput()


def assert_same(first, second):
    """The same values, bit by bit."""
    numpy.testing.assert_array_equal(first, second)


def process_id():
    """Which of the processes this is."""
    from paraview import servermanager

    module = servermanager.vtkProcessModule.GetProcessModule()
    assert module.GetNumberOfLocalPartitions() > 1
    return module.GetPartitionId()


def run_in_parallel(script, argument, processes=2, listens=False):
    """Runs a script in several processes of pvbatch. If it `listens`, what they say is returned."""
    # MPI's variables of this process are not for others.
    environment = {
        name: value
        for name, value in os.environ.items() if not name.startswith(("OMPI_", "PMIX_"))
    }
    environment.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
        OMPI_MCA_rmaps_base_oversubscribe="1",                    # Open MPI 4
        OMPI_MCA_mpi_yield_when_idle="1", # two processes that wait would keep both cores
        PRTE_MCA_rmaps_default_mapping_policy=":oversubscribe",   # Open MPI 5
        PRTE_MCA_mapby=":oversubscribe",                          # Open MPI 6
        LD_PRELOAD=os.environ.get("SKDTREE_SLEEP_WHEN_IDLE", os.environ.get("LD_PRELOAD", "")))
    heard = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True} if listens else {}
    run = subprocess.run(
        ["mpiexec", "-np", str(processes), "pvbatch", "--symmetric", script, argument],
        env=environment, check=not listens, timeout=900, **heard)
    if run.returncode != 0:
        raise RuntimeError(run.stdout)
    return run.stdout


def our_proxies():
    """The XML elements of the proxies of our classes, as (group, element)."""
    folder = os.path.join(SOURCE_DIR, "Plugin", "XML")
    for file in sorted(os.listdir(folder)):
        root = xml.etree.ElementTree.parse(os.path.join(folder, file)).getroot()
        for group in root.iter("ProxyGroup"):
            if group.get("name") != "representations":
                for proxy in group:
                    yield group.get("name"), proxy


def properties_of(proxy):
    """The XML elements of a proxy's own properties, but those that only inform."""
    return [element for element in proxy
        if element.tag.endswith("Property") and element.get("information_only") != "1"]
