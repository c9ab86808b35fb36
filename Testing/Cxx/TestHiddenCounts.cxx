// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// What filters count in reports and messages is shown: hidden cells and points are none of it.

#include "Support/AMRMeshes.h"
#include "Support/EachFilter.h"
#include "Support/EventCounter.h"
#include "Support/MakeOf.h"
#include "Support/SurfaceMeshes.h"

#include "vtkSkdTreeCellLocator.h"
#include "vtkSkdTreePointInOut.h"
#include "vtkSkdTreeRemap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

using namespace skdtest;

namespace
{
class HiddenCounts : public EachFilter
{
};

INSTANTIATE_TEST_SUITE_P(AllFilters, HiddenCounts,
  testing::Range<std::size_t>(0, AllFilterSetups().size()),
  [](const auto& info) { return AllFilterSetups()[info.param].Name; });

/// A mesh of which every fourth cell, from the first one on, is hidden; the others have "f" and
/// "c".
GridPointer WithHidden(const Mesh& mesh)
{
  GridPointer grid = MakeGrid(mesh);
  const auto value = [](vtkIdType i) { return 1.0 + i % 5; };
  grid->GetPointData()->AddArray(MakeArray("f", grid->GetNumberOfPoints(), value));
  grid->GetCellData()->AddArray(MakeArray("c", grid->GetNumberOfCells(), value));
  Ids hidden;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); cell += 4)
  {
    hidden.push_back(cell);
  }
  MarkGhosts(grid, hidden, vtkDataSetAttributes::HIDDENCELL);
  return grid;
}

/// How much was done, or what was left out.
bool IsOfRun(const std::string& name)
{
  return name.find("Seconds") != std::string::npos || name.find("Bytes") != std::string::npos ||
    name.find("LeftOut") != std::string::npos || name.find("Estimated") != std::string::npos ||
    name.find("Bisections") != std::string::npos;
}

std::map<std::string, std::vector<double>> ReportsOf(vtkAlgorithm* filter)
{
  filter->Update();
  std::map<std::string, std::vector<double>> reports;
  vtkFieldData* data = filter->GetOutputDataObject(0)->GetFieldData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    if (array && !IsOfRun(array->GetName()))
    {
      reports[array->GetName()] = ValuesOf(array);
    }
  }
  return reports;
}

TEST_P(HiddenCounts, AreNoneInReports)
{
  if (this->Setup.Name == "RefinementOf")
  {
    GTEST_SKIP() << "reports the size of the output, which has the hidden cells";
  }
  for (const Mesh& mesh : { Transformed(Hexahedra(3), 0.8, { 0.03, 0.02, 0.01 }),
         Soup(Transformed(SphereTriangles(3), 0.7, { 1.2, 1.1, 1.3 })),
         Transformed(Helix(12, VTK_LINE), 0.8, { 1.0, 1.0, 0.1 }) })
  {
    const GridPointer marked = WithHidden(mesh);
    const GridPointer shown = ShownCellsOf(MakeBlocks({ marked }));
    const auto expected = ReportsOf(this->Setup.Make(shown));
    for (const auto& [name, values] : ReportsOf(this->Setup.Make(marked)))
    {
      SCOPED_TRACE(name);
      const auto other = expected.find(name);
      ASSERT_NE(other, expected.end());
      ASSERT_EQ(values.size(), other->second.size());
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        EXPECT_NEAR(values[i], other->second[i], 1e-6 * std::abs(values[i]));
      }
    }
  }
}

TEST(HiddenCells, AreNotCountedAsBroken)
{
  Mesh mesh = SphereTriangles(3);
  const auto first = static_cast<vtkIdType>(mesh.Cells.size());
  for (int i = 0; i < 3; ++i)
  {
    mesh.Add(VTK_TRIANGLE, { 0, 1, 100000 });
  }
  for (const DataSetPointer& data :
    std::vector<DataSetPointer>{ MakePolyData(mesh), MakeGrid(mesh) })
  {
    MarkGhosts(data, { first, first + 2 }, vtkDataSetAttributes::HIDDENCELL);
    vtkNew<vtkSkdTreeCellLocator> locator;
    EventCounter events(locator);
    locator->SetDataSet(data);
    locator->BuildLocator();
    EXPECT_EQ(events.Warnings, 1);
    EXPECT_NE(events.Warning.find(" cells is broken"), std::string::npos) << events.Warning;
    EXPECT_NE(events.Warning.find("it is cell " + std::to_string(first + 1)), std::string::npos)
      << events.Warning;
    data->GetCellGhostArray()->SetValue(first + 1, vtkDataSetAttributes::HIDDENCELL);
    vtkNew<vtkSkdTreeCellLocator> other;
    EventCounter silence(other);
    other->SetDataSet(data);
    other->BuildLocator();
    EXPECT_EQ(silence.Warnings, 0) << silence.Warning;
  }
}

}

namespace
{
/// With a voxel far away that is hidden.
GridPointer WithHiddenVoxel(Mesh mesh)
{
  const Ids hidden{ static_cast<vtkIdType>(mesh.Cells.size()) };
  Ids corners;
  for (int i = 0; i < 8; ++i)
  {
    corners.push_back(mesh.Add({ 5.0 + i % 2, 0.0 + i / 2 % 2, 0.0 + i / 4 }));
  }
  mesh.Add(VTK_VOXEL, corners);
  GridPointer grid = MakeGrid(mesh);
  MarkGhosts(grid, hidden, vtkDataSetAttributes::HIDDENCELL);
  return grid;
}
}

// What cells are is asked of those that are shown.
TEST(HiddenCells, MakeASurfaceNoVolume)
{
  const GridPointer grid = WithHiddenVoxel(SphereTriangles(4));
  const auto filter = MakeOf<vtkSkdTreePointInOut>(MakeQueries({ { 0.1, 0.0, 0.1 } }), grid);
  filter->UseOuterFacesOff();
  EventCounter events(filter);
  filter->Update();
  EXPECT_EQ(events.Errors, 0) << events.Error;
  EXPECT_EQ(Reported(filter, "OuterFaces"), 0.0);
  EXPECT_EQ(PointArray(filter->GetOutputDataObject(0), "SkdInside"), std::vector<double>{ 1.0 });
}

TEST(HiddenCells, MakeNoOtherSpaceForRemap)
{
  for (const bool isHiddenInInput : { true, false })
  {
    const GridPointer with = WithHiddenVoxel(Sheet(4, VTK_QUAD));
    const GridPointer without = MakeGrid(Sheet(4, VTK_QUAD));
    for (const GridPointer& grid : { with, without })
    {
      grid->GetCellData()->AddArray(
        MakeArray("c", grid->GetNumberOfCells(), [](vtkIdType i) { return 1.0 + i; }));
    }
    const auto filter =
      MakeOf<vtkSkdTreeRemap>(isHiddenInInput ? with : without, isHiddenInInput ? without : with);
    filter->Update();
    auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    vtkDataArray* remapped = output->GetCellData()->GetArray("c_Remapped");
    ASSERT_TRUE(remapped);
    EXPECT_NEAR(remapped->GetTuple1(3), 4.0, 1e-12);
  }
}
