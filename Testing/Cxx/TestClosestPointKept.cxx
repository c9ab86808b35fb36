// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeClosestPoint: when trees are kept and when they are built anew.

#include "Support/ClosestPointRun.h"
#include "Support/NamedMeshes.h"
#include "Support/VolumeMeshes.h"

#include "vtkDoubleArray.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

void AddPointData(vtkDataSet* mesh, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("Field");
  array->SetNumberOfTuples(mesh->GetNumberOfPoints());
  array->FillValue(value);
  mesh->GetPointData()->AddArray(array);
}

DataSetPointer Copy(vtkDataSet* mesh, bool deep)
{
  DataSetPointer copy;
  copy.TakeReference(mesh->NewInstance());
  deep ? copy->DeepCopy(mesh) : copy->ShallowCopy(mesh);
  return copy;
}

struct KeptCase
{
  NamedMesh Mesh;
  bool IsSigned;

  friend void PrintTo(const KeptCase& kept, std::ostream* os) { *os << kept.Mesh.Name; }
};

std::vector<KeptCase> KeptCases()
{
  const std::vector<NamedMesh> meshes = { { "Triangles",
                                            [] { return MakePolyData(SphereTriangles(4)); } },
    { "Strips", [] { return MakePolyData(Strips(4)); } },
    { "Hexahedra", [] { return MakeGrid(Hexahedra(3)); } },
    { "Image", [] { return MakeImage(4); } }, { "Rectilinear", [] { return MakeRectilinear(4); } },
    { "Structured", [] { return MakeStructured(4); } },
    { "Uniform", [] { return MakeUniformGrid(4); } },
    { "Explicit", [] { return MakeExplicitStructured(4); } } };
  std::vector<KeptCase> cases;
  for (const NamedMesh& mesh : meshes)
  {
    cases.push_back({ mesh, false });
    cases.push_back({ mesh, true });
  }
  return cases;
}

class KeptTree : public testing::TestWithParam<KeptCase>
{
protected:
  KeptTree()
    : Source(GetParam().Mesh.Make())
    , Queries(MakeQueries(RandomQueries(this->Source, 50)))
    , Filter(MakeFilter(this->Queries, this->Source))
  {
    this->Filter->SetSignedDistance(GetParam().IsSigned);
    EXPECT_EQ(RunTreesBuilt(this->Filter), 1);
    this->Before = RunDistances(this->Filter);
  }

  int BuiltFor(vtkDataSet* source)
  {
    this->Filter->SetSourceData(source);
    return RunTreesBuilt(this->Filter);
  }

  DataSetPointer Source;
  PolyDataPointer Queries;
  FilterPointer Filter;
  std::vector<double> Before;
};

INSTANTIATE_TEST_SUITE_P(All, KeptTree, testing::ValuesIn(KeptCases()),
  [](const testing::TestParamInfo<KeptCase>& info)
  { return std::string(info.param.Mesh.Name) + (info.param.IsSigned ? "Signed" : ""); });

TEST_P(KeptTree, StaysForOtherPointsAndOtherSettings)
{
  this->Filter->SetInputDataObject(0, MakeQueries({ { 1, 2, 3 } }));
  EXPECT_EQ(RunTreesBuilt(this->Filter), 0);
  this->Filter->SetMaximumDistance(0.5);
  EXPECT_EQ(RunTreesBuilt(this->Filter), 0);
  this->Filter->InterpolateSourceDataOn();
  EXPECT_EQ(RunTreesBuilt(this->Filter), 0);
}

TEST_P(KeptTree, StaysForOtherPointDataWhichAreUsed)
{
  this->Filter->InterpolateSourceDataOn();
  for (double value : { 1.0, 2.0 })
  {
    AddPointData(this->Source, value);
    this->Source->Modified();
    EXPECT_EQ(RunTreesBuilt(this->Filter), 0);
    for (double found : RunArray(this->Filter, "Field"))
    {
      EXPECT_DOUBLE_EQ(found, value);
    }
  }
}

TEST_P(KeptTree, StaysForACopyOfTheSourceAsATimeSeriesGives)
{
  for (bool deep : { false, true, false, true })
  {
    DataSetPointer next = Copy(this->Source, deep);
    AddPointData(next, 3.0);
    EXPECT_EQ(this->BuiltFor(next), 0) << (deep ? "deep" : "shallow");
    EXPECT_EQ(RunDistances(this->Filter), this->Before);
  }
}

TEST_P(KeptTree, GoesWhenGhostMarksChange)
{
  DataSetPointer next = Copy(this->Source, true);
  MarkGhosts(next, { 1 }, vtkDataSetAttributes::DUPLICATECELL);
  EXPECT_EQ(this->BuiltFor(next), 1);
}

TEST_P(KeptTree, GoesWhenGhostMarksChangeInPlaceAndOnlyTheMeshIsTold)
{
  DataSetPointer next = Copy(this->Source, true);
  MarkGhosts(next, { 1 }, vtkDataSetAttributes::DUPLICATECELL);
  EXPECT_EQ(this->BuiltFor(next), 1);
  next->GetCellGhostArray()->SetValue(1, 0);
  next->Modified();
  EXPECT_EQ(RunTreesBuilt(this->Filter), 1);
  EXPECT_EQ(RunDistances(this->Filter), this->Before);
}

TEST_P(KeptTree, GoesWhenEpsilonChanges)
{
  this->Filter->SetEpsilon(1e-6);
  EXPECT_EQ(RunTreesBuilt(this->Filter), 1);
}

TEST_P(KeptTree, GoesForAnotherMesh)
{
  EXPECT_EQ(this->BuiltFor(MakePolyData(Octahedron(5))), 1);
  EXPECT_NE(RunDistances(this->Filter), this->Before);
  EXPECT_EQ(this->BuiltFor(this->Source), 1);
  EXPECT_EQ(RunDistances(this->Filter), this->Before);
}

TEST(KeptTrees, GoWhenPointsMoveInPlaceAndOnlyTheMeshIsTold)
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    auto source = MakePolyData(SphereTriangles(4), type);
    FilterPointer filter = MakeFilter(MakeQueries({ { 0, 0, 3 } }), source);
    EXPECT_NEAR(RunDistances(filter)[0], 2.0, 1e-6);
    for (vtkIdType i = 0; i < source->GetNumberOfPoints(); ++i)
    {
      Point p;
      source->GetPoint(i, p.data());
      // What is farthest becomes nearest: nothing else would be found by the boxes of before.
      source->GetPoints()->SetPoint(i, p[0], p[1], p[2] < -0.9 ? 2.5 : p[2]);
    }
    source->Modified();
    EXPECT_NEAR(RunDistances(filter)[0], 0.5, 1e-6);
  }
}

TEST(KeptTrees, GoWhenPointsMoveInTheirOldArrayOrANewOne)
{
  auto source = MakePolyData(SphereTriangles(4));
  FilterPointer filter = MakeFilter(MakeQueries({ { 0, 0, 3 } }), source);
  const double before = RunDistances(filter)[0];
  EXPECT_NEAR(before, 2.0, 1e-12);
  for (vtkIdType i = 0; i < source->GetNumberOfPoints(); ++i)
  {
    Point p;
    source->GetPoint(i, p.data());
    source->GetPoints()->SetPoint(i, (2.0 * p).data());
  }
  source->GetPoints()->Modified();
  EXPECT_NEAR(RunDistances(filter)[0], 1.0, 1e-12);
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 1);

  source->SetPoints(MakePoints(SphereTriangles(4).Points));
  EXPECT_NEAR(RunDistances(filter)[0], 2.0, 1e-12);
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 1);
}

TEST(KeptTrees, GoWhenCellsChange)
{
  auto source = MakePolyData(CubeQuads(2));
  FilterPointer filter = MakeFilter(MakeQueries({ { 1, 1, 3 } }), source);
  EXPECT_EQ(RunTreesBuilt(filter), 1);
  vtkNew<vtkCellArray> fewer;
  fewer->InsertNextCell({ 0, 1, 2, 3 });
  source->SetPolys(fewer);
  EXPECT_EQ(RunTreesBuilt(filter), 1);
  EXPECT_EQ(Reported(filter, "SourceCells"), 1);
}

TEST(KeptTrees, StayForPolyhedraInTheSameArraysAndGoInDoubt)
{
  auto source = MakeGrid(Polyhedra(2));
  FilterPointer filter = MakeFilter(MakeQueries({ { 1, 1, 3 } }), source);
  EXPECT_EQ(RunTreesBuilt(filter), 1);
  filter->SetSourceData(Copy(source, false));
  EXPECT_EQ(RunTreesBuilt(filter), 0);
  filter->SetSourceData(Copy(source, true));
  EXPECT_EQ(RunTreesBuilt(filter), 1);
}

TEST(KeptTrees, OfBlocksOnlyTheOneThatChangedIsBuilt)
{
  auto a = MakePolyData(SphereTriangles(4));
  auto b = MakePolyData(TorusTriangles(12, 8));
  FilterPointer filter = MakeFilter(MakeQueries({ { 0, 0, 3 } }), MakeBlocks({ a, b }));
  EXPECT_EQ(RunTreesBuilt(filter), 2);
  filter->SetSourceData(MakeBlocks({ Copy(a, true), MakePolyData(Octahedron(1)) }));
  EXPECT_EQ(RunTreesBuilt(filter), 1);
}

}
