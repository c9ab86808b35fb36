// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Inputs that filters cannot do without, or not with: one message and empty outputs.

#include "Support/EachFilter.h"
#include "Support/EventCounter.h"
#include "Support/FilterRun.h"
#include "Support/SurfaceMeshes.h"

#include "vtkDataSet.h"
#include "vtkExecutive.h"
#include "vtkHyperTreeGrid.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkSkdTreeAMR.h"
#include "vtkSkdTreeClosestPoint.h"
#include "vtkSkdTreeCompareSurfaces.h"
#include "vtkSkdTreeCurveSurfaceIntersection.h"
#include "vtkSkdTreeMeshAdaptation.h"
#include "vtkSkdTreePointInOut.h"
#include "vtkSkdTreeProbe.h"
#include "vtkSkdTreeRays.h"
#include "vtkSkdTreeRemap.h"
#include "vtkTable.h"
#include "vtkUniformHyperTreeGrid.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

template <class Filter>
class UnsetSource : public testing::Test
{
};

using Filters = testing::Types<vtkSkdTreeClosestPoint, vtkSkdTreeCompareSurfaces,
  vtkSkdTreeCurveSurfaceIntersection, vtkSkdTreeMeshAdaptation, vtkSkdTreePointInOut,
  vtkSkdTreeProbe, vtkSkdTreeRays, vtkSkdTreeRemap>;
TYPED_TEST_SUITE(UnsetSource, Filters);

TYPED_TEST(UnsetSource, IsOneMessage)
{
  const auto mesh = MakePolyData(SphereTriangles(4));
  vtkNew<TypeParam> filter;
  filter->SetInputDataObject(0, mesh);
  EventCounter events(filter);
  EventCounter pipeline(filter->GetExecutive());
  filter->Update();
  EXPECT_EQ(events.Errors, 1);
  EXPECT_NE(events.Error.find("Source is not set"), std::string::npos) << events.Error;
  EXPECT_EQ(pipeline.Errors, 0) << pipeline.Error;
  ASSERT_NE(filter->GetOutputDataObject(0), nullptr);
  EXPECT_EQ(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);

  events.Error.clear();
  filter->SetSourceData(mesh);
  filter->Update(); // the adaptation misses an array to adapt to
  EXPECT_EQ(events.Error.find("Source is not set"), std::string::npos) << events.Error;
  EXPECT_EQ(pipeline.Errors, 0) << pipeline.Error;
}

class InputsOfOtherTypes : public EachFilter
{
};

INSTANTIATE_TEST_SUITE_P(AllFilters, InputsOfOtherTypes,
  testing::Range<std::size_t>(0, AllFilterSetups().size()),
  [](const auto& info) { return AllFilterSetups()[info.param].Name; });

/// The error names the class, and what to do with trees.
void ExpectOneError(vtkAlgorithm* filter, const std::string& name)
{
  SCOPED_TRACE(name);
  EventCounter events(filter);
  EventCounter pipeline(filter->GetExecutive());
  filter->Update();
  EXPECT_EQ(pipeline.Errors, 0) << pipeline.Error;
  EXPECT_EQ(events.Errors, 1);
  EXPECT_EQ(events.Warnings, 0) << events.Warning;
  EXPECT_NE(events.Error.find(name), std::string::npos) << events.Error;
  EXPECT_EQ(events.Error.find("vtkHyperTreeGridToUnstructuredGrid") != std::string::npos,
    name.find("HyperTree") != std::string::npos)
    << events.Error;
  vtkDataObject* output = filter->GetOutputDataObject(0);
  ASSERT_NE(output, nullptr);
  EXPECT_EQ(output->GetNumberOfElements(vtkDataObject::CELL), 0);
  EXPECT_EQ(output->GetNumberOfElements(vtkDataObject::POINT), 0);
}

TEST_P(InputsOfOtherTypes, AreOneError)
{
  const vtkNew<vtkHyperTreeGrid> trees;
  const vtkNew<vtkUniformHyperTreeGrid> uniform;
  const vtkNew<vtkTable> table;
  for (vtkDataObject* other : std::vector<vtkDataObject*>{ trees, uniform, table })
  {
    ExpectOneError(this->Setup.Make(other), other->GetClassName());
  }
}

TEST_P(InputsOfOtherTypes, AreOneErrorAsAllBlocks)
{
  const vtkNew<vtkTable> table;
  const vtkNew<vtkUniformHyperTreeGrid> trees;
  const auto blocks = MakeBlocks({ nullptr, MakeBlocks({ table, trees }) });
  const vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(0, trees);
  const vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartition(1, 0, table);
  ExpectOneError(this->Setup.Make(blocks), "vtkTable");
  ExpectOneError(this->Setup.Make(partitions), "vtkUniformHyperTreeGrid");
  ExpectOneError(this->Setup.Make(collection), "vtkTable");
}

// Nor is there an error if one of the blocks is a mesh.
TEST_P(InputsOfOtherTypes, AreNoErrorWhereThereAreNoBlocks)
{
  const vtkNew<vtkTable> table;
  const auto mesh = WithData(MakePolyData(SphereTriangles(4)));
  const vtkNew<vtkPartitionedDataSet> partitions;
  const vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetNumberOfPartitionedDataSets(2);
  const std::vector<vtkSmartPointer<vtkDataObject>> all{ MakeBlocks({ nullptr }), partitions,
    collection, MakeBlocks({ table, mesh }) };
  for (vtkDataObject* other : all)
  {
    const auto filter = this->Setup.Make(other);
    EventCounter events(filter);
    filter->Update();
    EXPECT_EQ(events.Error.find("Input port"), std::string::npos) << events.Error;
  }
}

TEST(InputsOfOtherTypesOfAMR, AreOneErrorAsBaseMesh)
{
  const auto mesh = MakePolyData(SphereTriangles(4));
  const vtkNew<vtkTable> table;
  vtkNew<vtkSkdTreeAMR> filter;
  filter->SetInputDataObject(0, mesh);
  filter->SetBaseMeshData(table);
  ExpectOneError(filter, "vtkTable");
  filter->SetBaseMeshData(mesh);
  ExpectOneError(filter, "BaseMesh must be an image or rectilinear grid");
  filter->SetBaseMeshData(MakeBlocks({ mesh }));
  ExpectOneError(filter, "BaseMesh must be an image or rectilinear grid");
}

}
