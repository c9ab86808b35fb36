# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The adaptive grid filter by ParaView's simple API."""

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import skdtesting


def scene(**properties):
    sphere = simple.Sphere(Radius=0.3, Center=[0.5, 0.5, 0.5], ThetaResolution=64,
        PhiResolution=64)
    return simple.SkdTreeAMR(Input=sphere, AutomaticBounds=0, BaseDimensions=[1, 1, 1],
        **properties)


def cell_array(amr, name):
    amr.UpdatePipeline()
    return vtk_to_numpy(servermanager.Fetch(amr).GetCellData().GetArray(name))


def test_a_hyper_tree_grid_is_the_default():
    amr = scene()
    amr.UpdatePipeline()
    assert amr.GetDataInformation().GetDataClassName() == "vtkHyperTreeGrid"
    assert amr.CellData["SkdLevel"].GetRange() == (0, 5)
    assert skdtesting.report(amr, "AllCells") == servermanager.Fetch(amr).GetNumberOfCells()


def test_the_cells_grow_by_four_a_level():
    counts = []
    for level in (4, 5, 6):
        amr = scene(MaximumLevel=level)
        amr.UpdatePipeline()
        counts.append(skdtesting.report(amr, "CutCells"))
    assert 3.5 < counts[2] / counts[1] < 4.5 and 3.5 < counts[1] / counts[0] < 4.8, counts


def test_an_unstructured_grid_with_hanging_points_and_insides():
    amr = scene(OutputType="Unstructured Grid", ComputeInside=1, ComputeDistance=1, MaximumLevel=6)
    amr.UpdatePipeline()
    assert amr.GetDataInformation().GetDataClassName() == "vtkUnstructuredGrid"
    assert amr.PointData["SkdHanging"].GetRange() == (0, 1)
    volume = (cell_array(amr, "SkdInside") / 8.0**cell_array(amr, "SkdLevel")).sum()
    assert abs(volume - 4 / 3 * numpy.pi * 0.3**3) < 1e-3, volume
    distances = cell_array(amr, "SkdDistance")
    assert -0.3 < distances.min() < -0.15 and 0.3 < distances.max() < 0.57


def test_overlapping_blocks_show_the_same_cells():
    amr = scene(OutputType="Overlapping AMR")
    amr.UpdatePipeline()
    assert amr.GetDataInformation().GetCompositeDataClassName() == "vtkOverlappingAMR"
    assert amr.GetDataInformation().GetNumberOfCells() == skdtesting.report(amr, "AllCells")
    leaves = servermanager.Fetch(simple.Threshold(
        Input=amr, Scalars=["CELLS", "SkdLevel"], LowerThreshold=0, UpperThreshold=5))
    assert leaves.GetNumberOfCells() == skdtesting.report(amr, "Cells"), "refined cells are blank"


def test_volume_fractions_add_up_to_the_volume():
    box = simple.Box(XLength=0.7, YLength=0.6, ZLength=0.3, Center=[0.5, 0.5, 0.5])
    amr = simple.SkdTreeAMR(Input=box, AutomaticBounds=0, ComputeVolumeFraction=1,
        OutputType="Unstructured Grid")
    volume = (cell_array(amr, "SkdVolumeFraction") / 8.0**cell_array(amr, "SkdLevel")).sum()
    assert abs(volume - 0.7 * 0.6 * 0.3) < 1e-7, volume


def test_balance_layers_bands_and_blind_refinement_add_cells():
    plain = scene()
    plain.UpdatePipeline()
    cells = skdtesting.report(plain, "Cells")
    for more in (dict(Balance="Corner"), dict(GrowingLayers=1), dict(DistanceBands=[0.1, 4]),
                 dict(OverlapTest="Blind")):
        amr = scene(**more)
        amr.UpdatePipeline()
        assert skdtesting.report(amr, "Cells") > cells, more


def test_parts_with_levels():
    parts = simple.GroupDatasets(Input=[simple.Sphere(Center=[-3, 0, 0]), simple.Sphere()])
    amr = simple.SkdTreeAMR(Input=parts, PartLevels=[1, 2], OutputType="Unstructured Grid")
    level, part = cell_array(amr, "SkdLevel"), cell_array(amr, "SkdPartIndex")
    assert set(level[part == 1]) == {2} and set(level[part == 2]) == {5}
    assert list(amr.PartLevels) == [1, 2]


def test_a_field_asks_for_cells():
    waves = simple.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5])
    amr = simple.SkdTreeAMR(Input=simple.Sphere(Radius=0.1), Field=waves, FieldArrays=["RTData"],
        AutomaticBounds=0, BaseBounds=[-5, 5] * 3, MaximumLevel=3, FieldThreshold=120,
        OutputType="Unstructured Grid")
    amr.UpdatePipeline()
    some = skdtesting.report(amr, "Cells")
    amr.FieldThreshold = 1e9
    amr.UpdatePipeline()
    assert 8 < skdtesting.report(amr, "Cells") < some < 512, some


def test_a_base_mesh():
    base = simple.Wavelet(WholeExtent=[0, 2, 0, 3, 0, 4])
    amr = simple.SkdTreeAMR(Input=simple.Sphere(Radius=2), BaseMesh=base, MaximumLevel=0,
        OutputType="Unstructured Grid")
    assert len(cell_array(amr, "SkdLevel")) == 24


def test_the_cell_limit_stops_it():
    amr = scene(MaximumLevel=8, CellLimit=5000)
    amr.UpdatePipeline()
    assert 0 < skdtesting.report(amr, "StoppedAtLevel") < 8
    assert skdtesting.report(amr, "AllCells") <= 5000
    assert skdtesting.report(amr, "EstimatedCells") > 100000
    assert skdtesting.report(amr, "EstimatedBytes") > 1e6


def test_no_faces_are_between_overlapping_blocks():
    amr = scene(OutputType="Overlapping AMR")
    surface = simple.SkdTreeSurfaceIntersection(Input=amr)
    surface.UpdatePipeline()
    assert skdtesting.report(surface, "Triangles") > 100, skdtesting.report(surface, "Triangles")
    assert skdtesting.report(surface, "Pairs") == 0


def test_the_tree_is_kept():
    skdtesting.assert_trees_are_kept(scene(), 1, MaximumLevel=4)


skdtesting.run_tests(globals())
