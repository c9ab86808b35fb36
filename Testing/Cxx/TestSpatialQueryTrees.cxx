// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// When vtkSkdTreeSpatialQuery builds trees, and when it keeps them.

#include "Support/SpatialQueryRun.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

/// The tree of the Input that a query has: another question builds none, another mesh one.
void ExpectATreeForANewMeshOnly(vtkSkdTreeSpatialQuery* query)
{
  query->SetRelation(SpatialQuery::NEAREST);
  query->Update();
  EXPECT_EQ(Reported(query, "TreesBuilt"), 0);
  query->SetInputDataObject(0, MakeBricks(1.0));
  query->Update();
  EXPECT_EQ(Reported(query, "TreesBuilt"), 1);
}

TEST(SpatialQuery, TreesAreKeptWhileMeshesAreTheSame)
{
  DataSetPointer input = MakeBricks();
  QueryPointer query = MakeQuery(input);
  query->SetShape(SpatialQuery::SOURCE_CELLS);
  query->SetSourceData(MakeBricks(0.5));
  query->Update();
  EXPECT_EQ(Reported(query, "TreesBuilt"), 2);
  ExpectATreeForANewMeshOnly(query);
}

TEST(SpatialQuery, AMeshThatIsAskedAboutOneShapeGetsItsTreeWhenItIsAskedAgain)
{
  QueryPointer query = MakeQuery(MakeBricks());
  SetBox(query, { 0.5, 1.5, 0.5, 1.5, 0.5, 1.5 });
  query->Update();
  EXPECT_EQ(Reported(query, "TreesBuilt"), 0);
  query->SetRelation(SpatialQuery::CONTAINMENT);
  query->Update();
  EXPECT_EQ(Reported(query, "TreesBuilt"), 1);
  ExpectATreeForANewMeshOnly(query);
}

}
