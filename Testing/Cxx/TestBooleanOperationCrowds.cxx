// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeBooleanOperation: many solids that overlap deeply, which are combined in pairs, against
// the arrangement of all of them (AT_LEAST 1 is a union that is never found in pairs).

#include "Support/FilterRun.h"
#include "Support/Reported.h"
#include "Support/SolidRun.h"
#include "Support/SurfaceMeshes.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

using namespace skdtest;

namespace
{
using Filter = vtkSkdTreeBooleanOperation;

/// Cubes of one centre, turned by any angles.
std::vector<Mesh> TurnedCubes(int n, std::uint64_t seed)
{
  Random random(seed);
  std::vector<Mesh> cubes;
  for (int i = 0; i < n; ++i)
  {
    cubes.push_back(BoxTriangles({ -1, -1, -1 }, { 1, 1, 1 }).Map(RandomRotation(random, false)));
  }
  return cubes;
}

vtkSmartPointer<vtkMultiBlockDataSet> BlocksOf(const std::vector<Mesh>& solids)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (unsigned int i = 0; i < solids.size(); ++i)
  {
    blocks->SetBlock(i, MakePolyData(solids[i]));
  }
  return blocks;
}

struct Result
{
  Mesh Surface;
  double Volume = 0.0;
  double InputVolume = 0.0;
  double NumberSplit = 0.0;
};

Result RunAndCheck(Filter* filter)
{
  Result result;
  result.Surface = RunSolid(filter);
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  result.Volume = Reported(output, "Volume");
  result.InputVolume = Reported(output, "InputVolume");
  result.NumberSplit = Reported(output, "TrianglesSplit");
  EXPECT_EQ(CountBadEdges(result.Surface), 0);
  EXPECT_NEAR(Measures(result.Surface).Volume, result.Volume, 1e-12 * std::abs(result.Volume));
  return result;
}

Result RunOnBlocks(const std::vector<Mesh>& solids, int operation)
{
  vtkNew<Filter> filter;
  filter->SetInputDataObject(0, BlocksOf(solids));
  filter->SetOperation(operation);
  filter->SetMinimumNumberOfSolids(1);
  return RunAndCheck(filter);
}

/// Of triangles of the inputs.
int CountTriangles(const std::vector<Mesh>& solids)
{
  int count = 0;
  for (const Mesh& solid : solids)
  {
    count += static_cast<int>(solid.Cells.size());
  }
  return count;
}

TEST(BooleanOperationCrowds, UnionIsThatOfTheArrangementOfAll)
{
  const std::vector<Mesh> cubes = TurnedCubes(9, 1);
  const Result atOnce = RunOnBlocks(cubes, Filter::AT_LEAST);
  const Result inPairs = RunOnBlocks(cubes, Filter::UNION);
  // At once no triangle is split twice.
  EXPECT_LE(atOnce.NumberSplit, CountTriangles(cubes));
  EXPECT_GT(inPairs.NumberSplit, 2 * CountTriangles(cubes));
  EXPECT_NEAR(inPairs.Volume, atOnce.Volume, 1e-12 * atOnce.Volume);
  EXPECT_NEAR(inPairs.InputVolume, atOnce.Volume, 1e-12 * atOnce.Volume);
  EXPECT_EQ(inPairs.Surface.Cells.size(), atOnce.Surface.Cells.size());
  EXPECT_EQ(inPairs.Surface.Points.size(), atOnce.Surface.Points.size());
}

/// Where there are many pairs of triangles, but few places where three of them meet.
TEST(BooleanOperationCrowds, ThinSolidsThatCrossAreUnitedAtOnce)
{
  Random random(14);
  const std::vector<Mesh> rods = RandomRods(random, 250, 0.005);
  const Result atLeastOne = RunOnBlocks(rods, Filter::AT_LEAST);
  const Result united = RunOnBlocks(rods, Filter::UNION);
  EXPECT_LE(united.NumberSplit, CountTriangles(rods));
  EXPECT_EQ(united.Volume, atLeastOne.Volume);
  EXPECT_EQ(united.Surface.Points, atLeastOne.Surface.Points);
}

/// The volumes of what is in at least k solids, for each k; all from one arrangement.
std::vector<double> VolumesInAtLeast(const std::vector<Mesh>& solids)
{
  vtkNew<Filter> filter;
  filter->SetInputDataObject(0, BlocksOf(solids));
  filter->SetOperation(Filter::AT_LEAST);
  std::vector<double> volumes{ 0.0 };
  for (std::size_t k = 1; k <= solids.size(); ++k)
  {
    filter->SetMinimumNumberOfSolids(static_cast<int>(k));
    volumes.push_back(RunAndCheck(filter).Volume);
  }
  return volumes;
}

TEST(BooleanOperationCrowds, IntersectionIsThatOfTheArrangementOfAll)
{
  std::vector<Mesh> solids = TurnedCubes(11, 11);
  solids[9] = Together({ solids[9], solids[10] }); // a solid that overlaps itself
  solids.pop_back();
  const std::vector<double> atLeast = VolumesInAtLeast(solids);
  const Result inPairs = RunOnBlocks(solids, Filter::INTERSECTION);
  EXPECT_GT(inPairs.NumberSplit, CountTriangles(solids));
  EXPECT_NEAR(inPairs.Volume, atLeast.back(), 1e-12 * atLeast[1]);
  EXPECT_NEAR(inPairs.InputVolume, atLeast[1], 1e-12 * atLeast[1]);
  solids.insert(solids.begin() + 4, Mesh()); // an empty one
  EXPECT_TRUE(RunOnBlocks(solids, Filter::INTERSECTION).Surface.Cells.empty());
}

/// All facets of the arrangement are in it, each between an even number of solids and an odd one.
TEST(BooleanOperationCrowds, ChainOfSymmetricDifferencesIsAsSmallAsThatOfAllAtOnce)
{
  const std::vector<Mesh> solids = TurnedCubes(9, 12);
  const std::vector<double> atLeast = VolumesInAtLeast(solids);
  double odd = 0.0;
  Mesh chain;
  for (std::size_t i = 0; i < solids.size(); ++i)
  {
    odd += i % 2 == 0 ? atLeast[i + 1] : -atLeast[i + 1];
    chain = Combine(chain, solids[i], Filter::SYMMETRIC_DIFFERENCE);
  }
  const Result atOnce = RunOnBlocks(solids, Filter::SYMMETRIC_DIFFERENCE);
  EXPECT_NEAR(atOnce.Volume, odd, 1e-12 * atLeast[1]);
  EXPECT_NEAR(Measures(chain).Volume, odd, 1e-12 * atLeast[1]);
  EXPECT_EQ(CountBadEdges(chain), 0);
  EXPECT_EQ(chain.Points.size(), atOnce.Surface.Points.size());
}

TEST(BooleanOperationCrowds, FirstWithoutTheOthers)
{
  std::vector<Mesh> cubes = TurnedCubes(10, 2);
  cubes[0] = Transformed(cubes[0], 1.2, { 0.1, 0.2, 0.3 });
  const std::vector<Mesh> others(cubes.begin() + 1, cubes.end());
  const double together = RunOnBlocks(cubes, Filter::UNION).Volume;
  const double rest = RunOnBlocks(others, Filter::UNION).Volume;
  const Result difference = RunOnBlocks(cubes, Filter::DIFFERENCE);
  EXPECT_GT(difference.NumberSplit, 2 * CountTriangles(cubes));
  EXPECT_NEAR(difference.Volume, together - rest, 1e-12 * together);
  EXPECT_NEAR(RunOnBlocks(cubes, Filter::REVERSE_DIFFERENCE).Volume,
    together - Measures(cubes[0]).Volume, 1e-12 * together);
}

/// Pieces of a Source in one mesh are solids as well, if each faces outward.
TEST(BooleanOperationCrowds, PiecesOfTwoInputs)
{
  const Mesh block = BoxTriangles({ -2, -1.5, -0.25 }, { 2, 1.5, 0.25 });
  const std::vector<Mesh> cubes = TurnedCubes(9, 3);
  const double cubesVolume = RunOnBlocks(cubes, Filter::UNION).Volume;
  const double blockVolume = Measures(block).Volume;
  double volume[5];
  for (int operation = 0; operation < 5; ++operation)
  {
    vtkNew<Filter> filter;
    filter->SetInputData(MakePolyData(block));
    filter->SetSourceData(MakePolyData(Together(cubes)));
    filter->SetOperation(operation);
    const Result result = RunAndCheck(filter);
    volume[operation] = result.Volume;
    EXPECT_GT(result.NumberSplit, 2 * CountTriangles(cubes));
    EXPECT_NEAR(result.InputVolume, blockVolume, 1e-12 * blockVolume);
    auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
    EXPECT_NEAR(Reported(output, "SourceVolume"), cubesVolume, 1e-12 * cubesVolume);
  }
  const double bound = 1e-12 * (blockVolume + cubesVolume);
  EXPECT_NEAR(volume[0] + volume[1], blockVolume + cubesVolume, bound);
  EXPECT_NEAR(volume[2] + volume[1], blockVolume, bound);
  EXPECT_NEAR(volume[3] + volume[1], cubesVolume, bound);
  EXPECT_NEAR(volume[4], volume[2] + volume[3], bound);
}

/// A piece that is inside out takes away from the winding number of others: no union of pieces.
TEST(BooleanOperationCrowds, PiecesInsideOutAreNotUnited)
{
  std::vector<Mesh> cubes = TurnedCubes(9, 4);
  cubes[5] = Inverted(cubes[5]);
  const Mesh block = BoxTriangles({ -2, -1.5, -0.25 }, { 2, 1.5, 0.25 });
  vtkNew<Filter> filter;
  filter->SetInputData(MakePolyData(block));
  filter->SetSourceData(MakePolyData(Together(cubes)));
  filter->SetOperation(Filter::DIFFERENCE);
  const Result result = RunAndCheck(filter);
  EXPECT_LE(result.NumberSplit, CountTriangles(cubes) + 12);
  Random random(5);
  const Mesh source = Together(cubes);
  ExpectSolid(random, { &block, &source },
    Combined(Filter::DIFFERENCE, InsideTestOf(block), InsideTestOf(source)), result.Surface);
}

/// What two pieces cover is outside where the number must be odd.
TEST(BooleanOperationCrowds, PiecesAreNotUnitedWhereTheNumberMustBeOdd)
{
  std::vector<Mesh> cubes = TurnedCubes(9, 9);
  cubes.push_back(cubes[0]); // which is then outside
  const Mesh source = Together(cubes);
  const Mesh block = BoxTriangles({ -2, -1.5, -0.25 }, { 2, 1.5, 0.25 });
  const Mesh result = Combine(block, source, Filter::INTERSECTION, Filter::ODD);
  Random random(10);
  ExpectSolid(random, { &block, &source },
    Combined(
      Filter::INTERSECTION, InsideTestOf(block, Filter::ODD), InsideTestOf(source, Filter::ODD)),
    result);
}

/// Each face of the output is of the cell that it says, and has its data; points have what a linear
/// field has there.
TEST(BooleanOperationCrowds, DataAreThoseOfTheInputs)
{
  const std::vector<Mesh> cubes = TurnedCubes(9, 6);
  const auto fieldAt = [](const double* x) { return 3.0 * x[0] - 2.0 * x[1] + 0.5 * x[2] + 7.0; };
  auto blocks = BlocksOf(cubes);
  for (unsigned int i = 0; i < cubes.size(); ++i)
  {
    auto* mesh = vtkPolyData::SafeDownCast(blocks->GetBlock(i));
    vtkNew<vtkDoubleArray> ofCells, ofPoints;
    ofCells->SetName("code");
    ofPoints->SetName("field");
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      ofCells->InsertNextValue(100.0 * i + static_cast<double>(cell));
    }
    for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
    {
      ofPoints->InsertNextValue(fieldAt(mesh->GetPoint(point)));
    }
    mesh->GetCellData()->AddArray(ofCells);
    mesh->GetPointData()->AddArray(ofPoints);
  }
  vtkNew<Filter> filter;
  filter->SetInputDataObject(0, blocks);
  const Result result = RunAndCheck(filter);
  EXPECT_GT(result.NumberSplit, 2 * CountTriangles(cubes));
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  vtkDataArray* field = output->GetPointData()->GetArray("field");
  vtkCellData* data = output->GetCellData();
  ASSERT_TRUE(field && data->GetArray("code") && data->GetArray("SkdSolidId"));
  for (vtkIdType point = 0; point < output->GetNumberOfPoints(); ++point)
  {
    ASSERT_NEAR(field->GetTuple1(point), fieldAt(output->GetPoint(point)), 1e-11);
  }
  for (std::size_t face = 0; face < result.Surface.Cells.size(); ++face)
  {
    const auto i = static_cast<vtkIdType>(face);
    const auto solid = static_cast<std::size_t>(data->GetArray("SkdSolidId")->GetTuple1(i));
    const auto cell = static_cast<std::size_t>(data->GetArray("SkdCellId")->GetTuple1(i));
    ASSERT_EQ(data->GetArray("code")->GetTuple1(i), 100.0 * solid + static_cast<double>(cell));
    const Mesh& of = cubes[solid];
    const Ids& corners = of.Cells[cell].Points;
    const Point& origin = of.Points[corners[0]];
    const Point normal = Cross(of.Points[corners[1]] - origin, of.Points[corners[2]] - origin);
    for (const vtkIdType point : result.Surface.Cells[face].Points)
    {
      ASSERT_NEAR(Dot(normal, result.Surface.Points[point] - origin), 0.0, 1e-13);
    }
  }
}

TEST(BooleanOperationCrowds, SameByAnyNumberOfThreads)
{
  const std::vector<Mesh> cubes = TurnedCubes(9, 7);
  Mesh results[2];
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads },
      [&] { results[threads - 1] = RunOnBlocks(cubes, Filter::UNION).Surface; });
  }
  EXPECT_EQ(results[0].Points, results[1].Points);
}

/// Any solids, many of them touching in faces and edges, so many that they are united in pairs.
TEST(BooleanOperationCrowds, RandomSolids)
{
  const int first = SetInEnvironment("SKDTREE_FUZZ_FIRST", 0);
  const int count = std::max(2, SetInEnvironment("SKDTREE_FUZZ_PAIRS", 40) / 20);
  for (int number = first; number < first + count; ++number)
  {
    SCOPED_TRACE(number);
    Random random(3000000u + static_cast<std::uint64_t>(number));
    std::vector<Mesh> solids;
    std::string what;
    for (int i = 0; i < 16; ++i)
    {
      solids.push_back(MovedAnywhere(random, AnySolid(random, what), what));
    }
    const Result atOnce = RunOnBlocks(solids, Filter::AT_LEAST);
    const Result inPairs = RunOnBlocks(solids, Filter::UNION);
    EXPECT_NEAR(inPairs.Volume, atOnce.Volume, 1e-12 * atOnce.Volume) << what;
    const double rest = RunOnBlocks({ solids.begin() + 1, solids.end() }, Filter::UNION).Volume;
    EXPECT_NEAR(
      RunOnBlocks(solids, Filter::DIFFERENCE).Volume, atOnce.Volume - rest, 1e-12 * atOnce.Volume)
      << what;
  }
}

/// A prism over a bow tie, the smaller half of which is inside out, around a box: there, winding
/// numbers add up to 0. Volume: 2.5 less that of the box, which is 0.03.
Mesh BowTieAroundABox()
{
  Mesh mesh;
  for (const double z : { 0.0, 1.0 })
  {
    for (const Point& p :
      { Point{ -1, -0.5, z }, Point{ -1, 0.5, z }, Point{ 2, -1, z }, Point{ 2, 1, z } })
    {
      mesh.Add(p);
    }
  }
  for (const vtkIdType i : { 0, 1, 2, 3 })
  {
    const vtkIdType next = (i + 1) % 4;
    mesh.Add(VTK_TRIANGLE, { i, next, next + 4 });
    mesh.Add(VTK_TRIANGLE, { i, next + 4, i + 4 });
  }
  mesh.Add(VTK_TRIANGLE, { 0, 2, 1 });
  mesh.Add(VTK_TRIANGLE, { 0, 3, 2 });
  mesh.Add(VTK_TRIANGLE, { 4, 5, 6 });
  mesh.Add(VTK_TRIANGLE, { 4, 6, 7 });
  Append(mesh, BoxTriangles({ -0.9, -0.1, 0.25 }, { -0.6, 0.1, 0.75 }));
  return mesh;
}

/// So many pairs of triangles that only those within one piece are all found.
TEST(BooleanOperationCrowds, PiecesThatIntersectThemselvesStayWithTheirSolid)
{
  std::vector<Mesh> solids = TurnedCubes(30, 5);
  const double cubes = RunOnBlocks(solids, Filter::UNION).Volume;
  solids.push_back(Transformed(BowTieAroundABox(), 1.0, { 10, 0, 0 }));
  EXPECT_NEAR(RunOnBlocks(solids, Filter::UNION).Volume, cubes + 2.47, 1e-12);
}

TEST(BooleanOperationCrowds, BlocksWithoutFacesAreEmptySolids)
{
  const std::vector<Mesh> solids{ BoxTriangles({ 0, 0, 0 }, { 1, 1, 1 }), Mesh(),
    BoxTriangles({ 0.5, 0, 0 }, { 1.5, 1, 1 }) };
  EXPECT_NEAR(RunOnBlocks(solids, Filter::UNION).Volume, 1.5, 1e-14);
  EXPECT_EQ(RunOnBlocks(solids, Filter::INTERSECTION).Surface.Cells.size(), 0u);
  EXPECT_NEAR(RunOnBlocks(solids, Filter::DIFFERENCE).Volume, 0.5, 1e-14);
  EXPECT_NEAR(RunOnBlocks(solids, Filter::SYMMETRIC_DIFFERENCE).Volume, 1.0, 1e-14);
  const std::vector<Mesh> other{ Mesh(), solids[0] };
  EXPECT_EQ(RunOnBlocks(other, Filter::DIFFERENCE).Surface.Cells.size(), 0u);
  EXPECT_NEAR(RunOnBlocks(other, Filter::REVERSE_DIFFERENCE).Volume, 1.0, 1e-14);
  EXPECT_EQ(RunOnBlocks(other, Filter::INTERSECTION).Surface.Cells.size(), 0u);
}

TEST(BooleanOperationCrowds, CanBeAborted)
{
  const std::vector<Mesh> cubes = TurnedCubes(9, 8);
  vtkNew<Filter> filter;
  filter->SetInputDataObject(0, BlocksOf(cubes));
  AbortAt(filter, 0.5);
  EXPECT_GT(RunAndCheck(filter).Volume, 8.0);
}
}
