// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeRemap: what it makes of composite, broken and unfitting inputs, and what it keeps.

#include "Support/EventCounter.h"
#include "Support/RemapRun.h"
#include "Support/SphereMeshes.h"
#include "Support/SurfaceMeshes.h"
#include "Support/VolumeMeshes.h"

#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace skdtest;

namespace
{
using Remap = vtkSkdTreeRemap;

/// Unit squares [0, n] x [0, n], moved to the right, with ones.
PolyDataPointer Ones(int n, double right)
{
  const auto mesh = MakePolyData(Transformed(Sheet(n, VTK_QUAD), 1.0, { right, 0, 0 }));
  return WithCellArray(
    mesh, "f", std::vector<double>(static_cast<std::size_t>(mesh->GetNumberOfCells()), 1.0));
}

/// The first warning of a run, or "".
std::string WarningOf(vtkSkdTreeRemap* remap)
{
  const EventCounter events(remap);
  remap->Update();
  EXPECT_EQ(events.Errors, 0) << events.Error;
  return events.Warning;
}
}

TEST(RemapBadInput, WhatHasNothingInCommonIsWarnedOf)
{
  RemapPointer remap =
    MakeRemap(MakePolyData(Sheet(2, VTK_QUAD)), Ones(2, 5.0), Remap::CONSERVATIVE_FIRST_ORDER);
  EXPECT_NE(WarningOf(remap).find("nothing in common"), std::string::npos);
  EXPECT_TRUE(std::isnan(RemappedCells(remap, "f")[0]));
  EXPECT_EQ(Reported(remap, "InputCellsEmpty"), 4);
  remap->Modified(); // weights are kept
  EXPECT_NE(WarningOf(remap).find("nothing in common"), std::string::npos);
}

TEST(RemapBadInput, StringsAndNamesInUseAreLeftOutByName)
{
  const auto source = Ones(2, 0.0);
  vtkNew<vtkStringArray> names;
  names->SetName("labels");
  names->SetNumberOfValues(4);
  source->GetCellData()->AddArray(names);
  RemapPointer remap =
    MakeRemap(MakePolyData(Sheet(2, VTK_QUAD)), source, Remap::CONSERVATIVE_FIRST_ORDER);
  EXPECT_NE(WarningOf(remap).find("labels"), std::string::npos);
  EXPECT_EQ(RemappedCells(remap, "f"), (std::vector<double>(4, 1.0)));
  remap = MakeRemap(Ones(2, 0.0), Ones(2, 0.0), Remap::CONSERVATIVE_FIRST_ORDER);
  remap->RenameTakenArraysOff();
  EXPECT_NE(WarningOf(remap).find("The array f"), std::string::npos);
  remap->PassInputDataOff();
  EXPECT_EQ(WarningOf(remap), "");
  remap->AddExtensiveArray("mass");
  EXPECT_NE(WarningOf(remap).find("no array mass"), std::string::npos);
}

TEST(RemapBadInput, NamesInUseGetASuffix)
{
  for (const int method :
    { Remap::CONTAINED, Remap::INTERPOLATION, Remap::CONSERVATIVE_SECOND_ORDER })
  {
    const auto input = WithCellArray(Ones(2, 0.0), "f", { 7, 7, 7, 7 });
    RemapPointer remap = MakeRemap(input, Ones(2, 0.0), method);
    remap->SetResultsOn(Remap::CELLS);
    EXPECT_EQ(WarningOf(remap), "");
    EXPECT_EQ(RemappedCells(remap, "f"), (std::vector<double>(4, 7.0)));
    EXPECT_EQ(RemappedCells(remap, "f_Remapped"), (std::vector<double>(4, 1.0)));
    WithCellArray(input, "f_Remapped", { 8, 8, 8, 8 });
    input->Modified();
    EXPECT_EQ(RemappedCells(remap, "f_Remapped"), (std::vector<double>(4, 8.0)));
    EXPECT_EQ(RemappedCells(remap, "f_Remapped2"), (std::vector<double>(4, 1.0)));
  }
}

TEST(RemapBadInput, CellsThatOverlapEachOtherAreWarnedOf)
{
  Mesh twice = Sheet(2, VTK_QUAD);
  twice.Cells.push_back(twice.Cells.front());
  const auto source = WithCellArray(MakePolyData(twice), "f", { 1, 1, 1, 1, 1 });
  RemapPointer remap =
    MakeRemap(MakePolyData(Sheet(2, VTK_QUAD)), source, Remap::CONSERVATIVE_FIRST_ORDER);
  EXPECT_NE(WarningOf(remap).find("covered more than once"), std::string::npos);
  EXPECT_NEAR(RemappedCells(remap, "SkdCoverage")[0], 2.0, 1e-14);
  EXPECT_EQ(RemappedCells(remap, "f")[0], 1.0);
}

/// ParaView asks for ghosts, which nobody needs to be told.
TEST(RemapBadInput, GhostsAreNoReasonToWarn)
{
  const auto withGhost = [](const vtkSmartPointer<vtkPolyData>& mesh)
  {
    mesh->AllocateCellGhostArray();
    mesh->GetCellGhostArray()->SetValue(3, vtkDataSetAttributes::DUPLICATECELL);
    return mesh;
  };
  const auto source = withGhost(MakePolyData(Sheet(2, VTK_QUAD)));
  WithCellArray(source, "f", { 1, 2, 3, 4 });
  RemapPointer remap =
    MakeRemap(withGhost(MakePolyData(Sheet(2, VTK_QUAD))), source, Remap::CONSERVATIVE_FIRST_ORDER);
  EXPECT_EQ(WarningOf(remap), "");
  EXPECT_EQ(RemappedCells(remap, "f")[2], 3.0);
  EXPECT_TRUE(std::isnan(RemappedCells(remap, "f")[3]));
}

TEST(RemapBadInput, MixedDimensionsAndDegenerateCellsHaveNoPartInIt)
{
  Mesh mixed = Sheet(2, VTK_QUAD);
  mixed.Add(VTK_LINE, { 0, 1 });
  mixed.Add(VTK_TRIANGLE, { 0, 1, 1 });
  const auto source = MakeGrid(mixed);
  WithCellArray(source, "f", { 1, 2, 3, 4, 100, 100 });
  RemapPointer remap =
    MakeRemap(MakePolyData(Sheet(2, VTK_QUAD)), source, Remap::CONSERVATIVE_FIRST_ORDER);
  EXPECT_NE(WarningOf(remap).find("have no part in it"), std::string::npos);
  EXPECT_EQ(RemappedCells(remap, "f"), (std::vector<double>{ 1, 2, 3, 4 }));
  // A plane through a volume cannot be conservative: interpolated.
  const auto volume = WithData(MakeGrid(Hexahedra(2)));
  remap = MakeRemap(MakePolyData(Sheet(2, VTK_QUAD)), volume, Remap::AUTOMATIC_METHOD);
  EXPECT_EQ(RemappedPoints(remap, "Linear").size(), 9u);
  EXPECT_EQ(RemappedPoints(remap, "Number").size(), 9u);
}

TEST(RemapBadInput, SurfacesInNoCommonPlaneAreInterpolated)
{
  const auto source = WithData(MakePolyData(TorusQuads(12, 8)));
  RemapPointer remap = MakeRemap(MakePolyData(TorusQuads(6, 4)), source, Remap::AUTOMATIC_METHOD);
  EXPECT_NE(WarningOf(remap), "");
  EXPECT_EQ(RemappedPoints(remap, "Number").size(), 24u);
  EXPECT_EQ(RemappedPoints(remap, "Linear").size(), 24u);
}

TEST(RemapBadInput, ConcaveCellsAreCut)
{
  Mesh mesh;
  const Ids l = { mesh.Add({ 0, 0, 0 }), mesh.Add({ 2, 0, 0 }), mesh.Add({ 2, 1, 0 }),
    mesh.Add({ 1, 1, 0 }), mesh.Add({ 1, 2, 0 }), mesh.Add({ 0, 2, 0 }) };
  mesh.Add(VTK_POLYGON, l);
  RemapPointer remap = MakeRemap(MakePolyData(mesh), Ones(2, 0.0), Remap::CONSERVATIVE_FIRST_ORDER);
  EXPECT_NEAR(RemappedCells(remap, "SkdCoverage")[0], 1.0, 1e-15);
  EXPECT_NEAR(Reported(remap, "TargetIntegral"), 3.0, 1e-14);
}

TEST(RemapBadInput, InfiniteValuesAreToldOf)
{
  const double infinite = std::numeric_limits<double>::infinity();
  const auto source = WithCellArray(Ones(2, 0.0), "f", { 1, 1, infinite, 1 });
  for (const int method : { Remap::CONTAINED, Remap::CONSERVATIVE_SECOND_ORDER })
  {
    const RemapPointer remap = MakeRemap(MakePolyData(Sheet(2, VTK_QUAD)), source, method);
    EXPECT_NE(WarningOf(remap).find("f has infinite values"), std::string::npos);
    EXPECT_FALSE(std::isfinite(RemappedCells(remap, "f")[2]));
  }
  const RemapPointer remap =
    MakeRemap(MakePolyData(Sheet(2, VTK_QUAD)), source, Remap::CONSERVATIVE_FIRST_ORDER);
  remap->UseMissingValueOn();
  remap->SetMissingValue(infinite);
  EXPECT_EQ(WarningOf(remap).find("infinite"), std::string::npos);
  EXPECT_EQ(RemappedCells(remap, "f")[0], 1.0);
}

TEST(RemapBadInput, ArraysOfWhichNothingCountsAreNamed)
{
  const auto source = Ones(2, 0.0);
  WithCellArray(source, "mask", { 0, 0, 0, 0 });
  RemapPointer remap =
    MakeRemap(MakePolyData(Sheet(2, VTK_QUAD)), source, Remap::CONSERVATIVE_SECOND_ORDER);
  remap->SetMaskArray("mask");
  EXPECT_NE(WarningOf(remap).find("No value of Source's array f counts"), std::string::npos);
  EXPECT_TRUE(std::isnan(RemappedCells(remap, "f")[3]));
  EXPECT_EQ(RemappedCells(remap, "SkdValid"), std::vector<double>(4, 0.0));
  EXPECT_EQ(Reported(remap, "InputCellsEmpty"), 4);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto blank = WithCellArray(Ones(1, 0.0), "f", { nan });
  for (const int method :
    { Remap::AUTOMATIC_METHOD, Remap::CONTAINED, Remap::CONSERVATIVE_SECOND_ORDER })
  {
    remap = MakeRemap(MakePolyData(Sheet(2, VTK_QUAD)), blank, method);
    const EventCounter events(remap);
    EXPECT_TRUE(std::isnan(RemappedCells(remap, "f")[0]));
    EXPECT_EQ(events.Warnings, 2); // and that 1 value is NaN
  }
  remap = MakeRemap(MakePolyData(Sheet(2, VTK_QUAD)), blank, Remap::INTERPOLATION);
  EXPECT_NE(WarningOf(remap).find("No value of Source's array f counts"), std::string::npos);
}

TEST(RemapBadInput, CellsThatCrossThemselvesAreNamed)
{
  Mesh mesh = Sheet(2, VTK_QUAD);
  std::swap(mesh.Cells[2].Points[1], mesh.Cells[2].Points[2]);
  RemapPointer remap = MakeRemap(MakePolyData(mesh), Ones(2, 0.0), Remap::CONSERVATIVE_FIRST_ORDER);
  const std::string warning = WarningOf(remap);
  EXPECT_NE(warning.find("polygons of Input (the first: cell 2) cross"), std::string::npos)
    << warning;
}

TEST(RemapBadInput, EmptyInputsGiveEmptyOutputs)
{
  for (int method = Remap::AUTOMATIC_METHOD; method <= Remap::CONSERVATIVE_SECOND_ORDER; ++method)
  {
    RemapPointer remap = MakeRemap(PolyDataPointer::New(), Ones(1, 0.0), method);
    remap->Update();
    EXPECT_EQ(Reported(remap, "InputCells"), 0);
    remap = MakeRemap(Ones(1, 0.0), PolyDataPointer::New(), method);
    remap->Update();
    EXPECT_EQ(Reported(remap, "SourceCells"), 0);
  }
}

TEST(RemapBadInput, BlocksAreMappedAsOne)
{
  const auto left = Ones(1, 0.0), right = Ones(1, 1.0);
  WithCellArray(right, "f", { 3.0 });
  const auto source = MakeBlocks({ left, right });
  const auto a = MakePolyData(Transformed(Sheet(1, VTK_QUAD), 1.0, { 0.5, 0, 0 }));
  const auto b = MakePolyData(Transformed(Sheet(1, VTK_QUAD), 0.5, { 1.5, 0, 0 }));
  RemapPointer remap = MakeRemap(MakeBlocks({ a, b }), source, Remap::CONSERVATIVE_FIRST_ORDER);
  remap->GenerateWeightsOn();
  remap->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(remap->GetOutputDataObject(0));
  const auto value = [&](unsigned int block)
  {
    auto* mesh = vtkDataSet::SafeDownCast(blocks->GetBlock(block));
    return mesh->GetCellData()->GetArray("f")->GetTuple1(0);
  };
  EXPECT_EQ(value(0), 2.0);
  EXPECT_EQ(value(1), 3.0);
  EXPECT_EQ(Reported(remap, "TargetIntegral"), 2.75);
  auto* table = vtkTable::SafeDownCast(remap->GetOutputDataObject(1));
  ASSERT_EQ(table->GetNumberOfRows(), 3);
  EXPECT_EQ(table->GetValueByName(0, "Weight").ToDouble(), 0.5);
  EXPECT_EQ(table->GetValueByName(2, "RowBlockIndex").ToInt(), 2);
  EXPECT_EQ(table->GetValueByName(2, "Column").ToInt(), 1);
}

TEST(RemapBadInput, WeightsAreKeptWhileBothMeshesStay)
{
  const auto input = MakePolyData(Sheet(3, VTK_QUAD));
  RemapPointer remap = MakeRemap(input, Ones(3, 0.0), Remap::CONSERVATIVE_SECOND_ORDER);
  remap->Update();
  EXPECT_EQ(Reported(remap, "WeightsFound"), 1);
  auto next = Ones(3, 0.0); // of equal values
  WithCellArray(next, "f", std::vector<double>(9, 7.0));
  remap->SetSourceData(next);
  EXPECT_EQ(RemappedCells(remap, "f")[0], 7.0);
  EXPECT_EQ(Reported(remap, "WeightsFound"), 0);
  remap->SetSourceData(Ones(3, 0.5));
  remap->Update();
  EXPECT_EQ(Reported(remap, "WeightsFound"), 1);
}

TEST(RemapBadInput, AnAbortLeavesNothingWrongAndProgressIsReported)
{
  const auto source = WithData(MakePolyData(CubedSphere(12)));
  const auto input = MakePolyData(IcosahedralDual(8));
  for (int method = Remap::AUTOMATIC_METHOD; method <= Remap::CONSERVATIVE_FIRST_ORDER; ++method)
  {
    RemapPointer remap = MakeRemap(input, source, method);
    EXPECT_FALSE(AbortAt(remap, 0.0).empty()) << method;
    remap->Update();
    EXPECT_EQ(Reported(remap, "InputCells"), input->GetNumberOfCells());
  }
}

TEST(RemapBadInput, LongitudesAndLatitudesAreMovedToTheSphere)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(72, 37, 1);
  image->SetSpacing(5, 5, 1);
  image->SetOrigin(0, -90, 0);
  image->GetPointData()->AddArray(MakeArray("latitude", image->GetNumberOfPoints(),
    [](vtkIdType i) { return -90.0 + 5.0 * static_cast<double>(i / 72); }));
  RemapPointer remap = MakeRemap(MakePolyData(CubedSphere(4)), image, Remap::CONTAINED);
  remap->SetSourceCoordinates(Remap::LONGITUDE_LATITUDE);
  const std::vector<double> weighted = RemappedCells(remap, "latitude");
  remap->SetSampleWeights(Remap::EQUAL);
  const std::vector<double> equal = RemappedCells(remap, "latitude");
  const auto greatest = [](const std::vector<double>& values)
  { return *std::max_element(values.begin(), values.end()); };
  EXPECT_LT(greatest(weighted), greatest(equal)); // equal weights draw to the pole
  EXPECT_EQ(Reported(remap, "InputCellsEmpty"), 0);
}
