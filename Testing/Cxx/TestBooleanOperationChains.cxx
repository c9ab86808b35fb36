// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeBooleanOperation: chains of fifty operations, each on what the one before has made, are
// closed at each step and have the volume of all solids combined at once.
//
// SKDTREE_FUZZ_PAIRS in the environment sets how many chains are tried (a fortieth of it),
// SKDTREE_FUZZ_FIRST which is the first; a failure names its chain.

#include "Support/ClosedRun.h"
#include "Support/GridBoxes.h"
#include "Support/TestAmount.h"

#include "vtkMultiBlockDataSet.h"

using namespace skdtest;

namespace
{
using Filter = vtkSkdTreeBooleanOperation;
using Surface = vtkSmartPointer<vtkPolyData>;

Surface CombineAtOnce(const std::vector<Surface>& solids, int operation)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < solids.size(); ++i)
  {
    blocks->SetBlock(i, solids[i]);
  }
  vtkNew<Filter> filter;
  filter->SetInputDataObject(0, blocks);
  filter->SetOperation(operation);
  return RunClosed(filter);
}

/// Solids at random in a room of a size; the first is as large as the room if others are taken from
/// it.
std::vector<Surface> MakeSolids(
  Random& random, int count, double size, bool isFirstLarge, std::string& what)
{
  std::vector<Surface> solids;
  for (int i = 0; i < count; ++i)
  {
    what += "; ";
    const bool isLarge = isFirstLarge && i == 0;
    const Mesh solid = MovedAnywhere(random, AnySolid(random, what), what);
    const Point by = random.InBox({ -size, size, -size, size, -size, size });
    solids.push_back(
      MakePolyData(Transformed(solid, isLarge ? size : 1.0, isLarge ? Point{ 0, 0, 0 } : by)));
  }
  return solids;
}

void TryChain(int number)
{
  Random random(4000000u + static_cast<std::uint64_t>(number));
  const int operation = std::array<int, 3>{ Filter::DIFFERENCE, Filter::UNION,
    Filter::SYMMETRIC_DIFFERENCE }[number % 3];
  std::string what;
  const double size = operation == Filter::SYMMETRIC_DIFFERENCE ? 4.0 : 2.0;
  const std::vector<Surface> solids =
    MakeSolids(random, 51, size, operation == Filter::DIFFERENCE, what);
  SCOPED_TRACE("chain " + std::to_string(number) + what);
  Surface made = solids[0];
  double largest = 0.0; // volume on the way
  for (std::size_t step = 1; step < solids.size(); ++step)
  {
    SCOPED_TRACE(step);
    vtkNew<Filter> filter;
    filter->SetInputData(made);
    filter->SetSourceData(solids[step]);
    filter->SetOperation(operation);
    filter->SetMergePieces(number / 3 % 2);
    made = RunClosed(filter);
    largest = std::max({ largest, Reported(made, "Volume"), Reported(made, "InputVolume") });
  }
  const Surface atOnce = CombineAtOnce(solids, operation);
  EXPECT_NEAR(Reported(made, "Volume"), Reported(atOnce, "Volume"), 1e-12 * largest);
}

TEST(BooleanOperationChains, OfFiftyOperations)
{
  const int first = SetInEnvironment("SKDTREE_FUZZ_FIRST", 0);
  const int count = std::max(1, SetInEnvironment("SKDTREE_FUZZ_PAIRS", 40) / 40);
  for (int number = first; number < first + count; ++number)
  {
    TryChain(number);
  }
}

/// How points are stored, how far that may take volumes and areas from what they are to be, and the
/// share of operations in a chain that may leave surplus area between bodies.
struct Stored
{
  int PointType;
  double Error;
  double Surplus;
};

class BooleanOperationTurned : public testing::TestWithParam<Stored>
{
};

INSTANTIATE_TEST_SUITE_P(Points, BooleanOperationTurned,
  testing::Values(Stored{ VTK_DOUBLE, 1e-11, 0.0 }, Stored{ VTK_FLOAT, 3e-5, 0.01 }),
  [](const auto& info) { return info.param.PointType == VTK_FLOAT ? "Floats" : "Doubles"; });

/// Faces that touch are in one plane but for rounding; what that leaves between them must not grow.
/// The same boxes along the axes leave up to 300 triangles.
TEST_P(BooleanOperationTurned, ChainsOfBoxesThatTouch)
{
  const auto [pointType, error, surplus] = this->GetParam();
  constexpr int operations[] = { Filter::UNION, Filter::DIFFERENCE, Filter::SYMMETRIC_DIFFERENCE };
  const int steps = 40;
  int withSurplus = 0;
  for (int number = 0; number < Amount(12); ++number)
  {
    SCOPED_TRACE(number);
    Random random(5000000u + static_cast<std::uint64_t>(number));
    GridCells cells;
    Surface made = Surface::New();
    vtkIdType most = 0;
    for (int step = 0; step < steps; ++step)
    {
      const int operation = step == 0 ? Filter::UNION : operations[random.Index(3)];
      const GridBox box(random);
      cells = CombineCells(cells, box.Cells, operation);
      vtkNew<Filter> filter;
      filter->SetInputData(made);
      filter->SetSourceData(MakePolyData(BoxTriangles(box.Low, box.High).Map(Turned), pointType));
      filter->SetOperation(operation);
      made = RunClosed(filter);
      EXPECT_NEAR(Reported(made, "Volume"), static_cast<double>(cells.count()), error);
      withSurplus += std::abs(Reported(made, "Area") - AreaOf(cells)) > error;
      most = std::max(most, made->GetNumberOfCells());
    }
    EXPECT_LT(most, 300);
  }
  EXPECT_LE(withSurplus, surplus * steps * Amount(12));
}

/// Two boxes with faces in one plane, and what an operation on them has.
struct Touching
{
  const char* Name;
  int Operation;
  Point High; // of the first, from the origin
  Point Low2, High2;
  double Volume, Area;
};

/// Where a face of one box is in that of another but for rounding, it may be off it all around: no
/// edges cross, and no points are shared.
TEST_P(BooleanOperationTurned, BoxesThatTouchLeaveNoGaps)
{
  const int pointType = this->GetParam().PointType;
  const double error = this->GetParam().Error;
  const Touching all[] = {
    { "on the middle of a face", Filter::UNION, { 2, 2, 2 }, { 0.5, 2, 0.5 }, { 1.5, 3, 1.5 }, 9,
      28 },
    { "on a face, flush with its rim", Filter::UNION, { 2, 2, 2 }, { 0.5, 2, 0.5 }, { 1.5, 3, 2 },
      9.5, 29 },
    { "a pocket", Filter::DIFFERENCE, { 2, 2, 2 }, { 0.5, 1, 0.5 }, { 1.5, 2, 1.5 }, 7, 28 },
    { "a notch along an edge", Filter::DIFFERENCE, { 2, 2, 2 }, { 0, 1, 0 }, { 2, 2, 1 }, 6, 22 },
    { "a half", Filter::DIFFERENCE, { 2, 2, 2 }, { 0, 1, 0 }, { 2, 2, 2 }, 4, 16 },
    { "more than an end", Filter::DIFFERENCE, { 2, 3, 2 }, { 0, 0, 0 }, { 3, 1, 2 }, 8, 24 },
  };
  Random random(77);
  for (int turn = 0; turn < Amount(40); ++turn)
  {
    const RandomRotation rotation(random, false);
    for (const Touching& c : all)
    {
      SCOPED_TRACE(std::to_string(turn) + ": " + c.Name);
      vtkNew<Filter> filter;
      filter->SetInputData(
        MakePolyData(BoxTriangles({ 0, 0, 0 }, c.High).Map(rotation), pointType));
      filter->SetSourceData(MakePolyData(BoxTriangles(c.Low2, c.High2).Map(rotation), pointType));
      filter->SetOperation(c.Operation);
      const Surface made = RunClosed(filter);
      EXPECT_NEAR(Reported(made, "Volume"), c.Volume, error);
      EXPECT_NEAR(Reported(made, "Area"), c.Area, error);
    }
  }
}

/// More bodies touch one face than parts are joined in turn.
TEST_P(BooleanOperationTurned, ManyPegsOnABlockLeaveNoGaps)
{
  const int pointType = this->GetParam().PointType;
  const double error = this->GetParam().Error;
  Random random(78);
  for (int turn = 0; turn < 4; ++turn)
  {
    const RandomRotation rotation(random, false);
    Mesh pegs;
    for (int i = 0; i < 64; ++i)
    {
      const Point low = { (i % 8 + 0.25) / 8, (i / 8 + 0.25) / 8, 1.0 };
      Append(pegs, BoxTriangles(low, low + Point{ 1.0 / 16, 1.0 / 16, 0.5 }));
    }
    vtkNew<Filter> filter;
    filter->SetInputData(
      MakePolyData(BoxTriangles({ 0, 0, 0 }, { 1, 1, 1 }).Map(rotation), pointType));
    filter->SetSourceData(MakePolyData(pegs.Map(rotation), pointType));
    const Surface made = RunClosed(filter);
    EXPECT_NEAR(Reported(made, "Volume"), 1.0 + 64 * 0.5 / 256, error);
    EXPECT_NEAR(Reported(made, "Area"), 6.0 + 64 * 4 * 0.5 / 16, error);
  }
}
}
