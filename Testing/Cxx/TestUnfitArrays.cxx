// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Arrays that are shorter or longer than the points or cells of their mesh: every filter warns of
// them once and answers as without them.

#include "Support/EachFilter.h"
#include "Support/FilterRun.h"
#include "Support/MessageCounter.h"
#include "Support/SurfaceMeshes.h"
#include "Support/VolumeMeshes.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

/// The messages about such arrays.
class ArraysCounter : public MessageCounter
{
public:
  explicit ArraysCounter(vtkObject* watched)
    : MessageCounter(watched, "Arrays that have not one tuple")
  {
  }
};

DataSetPointer MakeMesh(bool isVolume)
{
  return isVolume
    ? DataSetPointer(WithData(MakeGrid(Transformed(Hexahedra(2), 1.1, { 0.02, 0.02, 0.01 }))))
    : DataSetPointer(
        WithData(MakePolyData(Transformed(SphereTriangles(3), 0.7, { 1.2, 1.2, 1.2 }))));
}

/// The active scalars and normals are too short, other arrays too long.
void AddUnfitArrays(vtkDataSet* mesh)
{
  const auto zero = [](vtkIdType) { return 0.0; };
  for (const int type : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataSetAttributes* data = mesh->GetAttributes(type);
    const vtkIdType n = mesh->GetNumberOfElements(type);
    data->AddArray(MakeArray("TooLong", n + 3, zero));
    data->AddArray(MakeArray("TooShort", 1, zero));
    data->SetActiveScalars("TooShort");
    vtkNew<vtkDoubleArray> normals;
    normals->SetName("Few");
    normals->SetNumberOfComponents(3);
    data->SetNormals(normals);
  }
}

class UnfitArrays : public EachFilter
{
};

INSTANTIATE_TEST_SUITE_P(Filters, UnfitArrays,
  testing::Range<std::size_t>(0, AllFilterSetups().size()),
  [](const auto& info) { return AllFilterSetups()[info.param].Name; });

TEST_P(UnfitArrays, AreNamedOnceAndLeftOut)
{
  for (const bool isVolume : { false, true })
  {
    const DataSetPointer mesh = MakeMesh(isVolume);
    mesh->GetPointData()->SetActiveScalars(nullptr);
    mesh->GetCellData()->SetActiveScalars(nullptr);
    const auto expected = this->Setup.Make(mesh);
    expected->Update();
    const DataSetPointer broken = MakeMesh(isVolume);
    AddUnfitArrays(broken);
    const auto filter = this->Setup.Make(broken);
    ArraysCounter counter(filter);
    filter->Update();
    ASSERT_EQ(counter.Messages, 1);
    const std::string number = std::to_string(mesh->GetNumberOfPoints());
    const std::string text = "point array TooShort has 1 tuples for " + number + " points.";
    EXPECT_NE(counter.Last.find(text), std::string::npos) << counter.Last;
    EXPECT_NE(counter.Last.find("cell array Few has 0 tuples"), std::string::npos) << counter.Last;
    EXPECT_TRUE(AreEqual(AnswersOf(filter), AnswersOf(expected)));
  }
}

}
