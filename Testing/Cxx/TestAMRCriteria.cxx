// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeAMR: the other criteria, and what it reports.

#include "Support/AMRRun.h"
#include "Support/BruteForce.h"
#include "Support/ClosestPointRun.h"
#include "Support/NamedMeshes.h"
#include "Support/WindingReference.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

const Bounds Around = { -1.51, 1.57, -1.53, 1.59, -1.55, 1.61 };

PolyDataPointer MakeBall(double radius, const Point& centre, int n = 12)
{
  return MakePolyData(Transformed(SphereTriangles(n), radius, centre));
}

/// Leaves that touch over `contact` axes at most differ by one level: all pairs are looked at.
void ExpectBalanced(const std::vector<Leaf>& leaves, int contact)
{
  for (const Leaf& a : leaves)
  {
    for (const Leaf& b : leaves)
    {
      int apart = 0;
      for (int axis = 0; axis < 3; ++axis)
      {
        apart += a.Box[2 * axis] == b.Box[2 * axis + 1] || a.Box[2 * axis + 1] == b.Box[2 * axis];
      }
      const bool isNear = apart <= contact && Overlap(a.Box, b.Box);
      ASSERT_TRUE(!isNear || std::abs(a.Level - b.Level) <= 1);
    }
  }
}

TEST(AMRCriteria, LeavesAreBalancedAndKeepWhatTheyWere)
{
  auto ball = MakeBall(0.3, { 0.9, 0.8, 0.7 });
  AMRPointer filter = MakeAMRIn(ball, 5, Around);
  const std::vector<Leaf> before = RunLeaves(filter);
  std::size_t last = before.size();
  for (int contact = 1; contact <= 3; ++contact)
  {
    filter->SetBalance(contact);
    const std::vector<Leaf> leaves = RunLeaves(filter);
    ExpectBalanced(leaves, contact);
    EXPECT_GT(leaves.size(), last);
    last = leaves.size();
    Random random(1);
    for (int i = 0; i < 200; ++i)
    {
      const Point x = random.InBox(Around);
      EXPECT_GE(FindLeaf(leaves, x)->Level, FindLeaf(before, x)->Level);
      EXPECT_TRUE(!FindLeaf(before, x)->IsCut || FindLeaf(leaves, x)->IsCut);
    }
  }
}

TEST(AMRCriteria, PartsHaveLevelsOfTheirOwn)
{
  auto blocks = MakeBlocks({ MakeBall(0.4, { -0.8, -0.8, -0.8 }), MakeBall(0.4, { 0.8, 0.8, 0.8 }),
    MakeBall(0.3, { 0.8, -0.8, 0.0 }) });
  AMRPointer filter = MakeAMRIn(blocks, 5, Around);
  filter->AddPartLevel(1, 3);
  filter->AddPartLevel(3, 9);
  const std::vector<Leaf> leaves = RunLeaves(filter);
  const std::vector<double> parts = CellArray(filter, "SkdPartIndex");
  const int levelOf[4] = { -1, 3, 5, 5 };
  int found[4] = { 0, 0, 0, 0 };
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    if (parts[i] >= 0)
    {
      ++found[static_cast<int>(parts[i])];
      EXPECT_EQ(leaves[i].Level, levelOf[static_cast<int>(parts[i])]);
    }
  }
  EXPECT_TRUE(found[1] > 0 && found[2] > 0 && found[3] > 0);
  EXPECT_EQ(Reported(filter, "Parts"), 3);

  // Balancing refines cells of the coarse part beside the fine one, if they are close.
  filter->RemoveAllPartLevels();
  filter->AddPartLevel(1, 2);
  filter->SetInputDataObject(
    0, MakeBlocks({ MakeBall(0.5, { 0, 0, 0 }), MakeBall(0.2, { 0.55, 0.1, 0.1 }) }));
  filter->SetBalance(vtkSkdTreeAMR::CORNER);
  const std::vector<Leaf> close = RunLeaves(filter);
  ExpectBalanced(close, 3);
  // The arrays are those of a run that refines as deep everywhere.
  const std::vector<double> candidates = CellArray(filter, "SkdCandidates");
  filter->RemoveAllPartLevels();
  filter->SetBalance(vtkSkdTreeAMR::NONE);
  filter->SetMaximumLevel(5);
  const std::vector<Leaf> deep = RunLeaves(filter);
  const std::vector<double> all = CellArray(filter, "SkdCandidates");
  for (std::size_t i = 0; i < close.size(); ++i)
  {
    for (std::size_t k = 0; k < deep.size(); ++k)
    {
      if (close[i].Box == deep[k].Box)
      {
        EXPECT_EQ(close[i].IsCut, deep[k].IsCut);
        EXPECT_EQ(candidates[i], all[k]);
      }
    }
  }
}

TEST(AMRCriteria, DistanceBandsCoverAllThatIsNearer)
{
  auto ball = MakeBall(0.5, { 0, 0, 0 });
  BruteForce reference(ball);
  AMRPointer filter = MakeAMRIn(ball, 6, Around);
  filter->AddDistanceBand(0.1, 5);
  filter->AddDistanceBand(0.4, 3);
  const std::vector<Leaf> leaves = RunLeaves(filter);
  Random random(2);
  int far = 0;
  for (int i = 0; i < 500; ++i)
  {
    const Point x = random.InBox(Around);
    const double distance = reference.FindNearest(x).Distance;
    const int level = FindLeaf(leaves, x)->Level;
    EXPECT_GE(level, distance <= 0.1 ? 5 : distance <= 0.4 ? 3 : 0);
    far += distance > 1.0 && level < 3;
  }
  EXPECT_GT(far, 10);
}

/// Between two boxes, one of them maybe flat.
double BoxDistance(const Bounds& a, const Bounds& b)
{
  Point apart;
  for (int axis = 0; axis < 3; ++axis)
  {
    apart[axis] = std::max({ 0.0, a[2 * axis] - b[2 * axis + 1], b[2 * axis] - a[2 * axis + 1] });
  }
  return Length(apart);
}

TEST(AMRCriteria, DistanceBandsAreExact)
{
  const Bounds sheet{ 0, 2, 0, 2, 0, 0 };
  const Bounds box{ -3.1, 4.9, -2.7, 5.3, -4.2, 3.8 };
  constexpr double maxDistance = 0.7;
  AMRPointer filter = MakeAMRIn(MakePolyData(Sheet(2, VTK_QUAD)), 5, box);
  filter->SetBalance(vtkSkdTreeAMR::NONE);
  filter->AddDistanceBand(maxDistance, 5);
  int between = 0;
  for (const Leaf& leaf : RunLeaves(filter))
  {
    Bounds parent = box;
    double radius = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double size = std::ldexp(8.0, 1 - leaf.Level);
      const double middle = 0.5 * (leaf.Box[2 * axis] + leaf.Box[2 * axis + 1]);
      const double index = std::floor((middle - box[2 * axis]) / size);
      parent[2 * axis] = box[2 * axis] + index * size;
      parent[2 * axis + 1] = parent[2 * axis] + size;
      radius = std::sqrt(3.0) * 0.5 * size;
    }
    EXPECT_TRUE(leaf.Level == 5 || BoxDistance(leaf.Box, sheet) > maxDistance);
    EXPECT_TRUE(leaf.Level == 0 || BoxDistance(parent, sheet) <= maxDistance + 1e-12);
    const Point middle = Center(leaf.Box);
    const Bounds at{ middle[0], middle[0], middle[1], middle[1], middle[2], middle[2] };
    between += leaf.Level < 5 && BoxDistance(at, sheet) < maxDistance + 0.5 * radius;
  }
  EXPECT_GT(between, 50); // that a ball around them would have refined
}

TEST(AMRCriteria, LayersGrowAroundWhatIsRefined)
{
  auto ball = MakeBall(0.5, { 0, 0, 0 });
  std::size_t last = 0;
  for (int layers = 0; layers <= 2; ++layers)
  {
    AMRPointer filter = MakeAMRIn(ball, 5, Around);
    filter->SetGrowingLayers(layers);
    const std::vector<Leaf> leaves = RunLeaves(filter);
    EXPECT_GT(leaves.size(), last);
    last = leaves.size();
    const double cell = (Around[1] - Around[0]) / 32;
    int finest = 0;
    for (const Leaf& leaf : leaves)
    {
      if (leaf.IsCut)
      {
        EXPECT_EQ(leaf.Level, 5);
        // All leaves within two cells a layer, of the finest level, are of that level.
        Random random(4);
        const Point x = random.InBox(Grown(leaf.Box, 2 * layers * cell * 0.99));
        const Leaf* there = FindLeaf(leaves, x);
        EXPECT_TRUE(!there || layers == 0 || there->Level == 5);
      }
      finest += leaf.Level == 5;
    }
    EXPECT_GT(finest, 0);
  }
}

TEST(AMRCriteria, InsideAndDistanceAreThoseOfTheCentres)
{
  const Mesh torus = TorusTriangles(32, 16);
  auto parts = MakePolyData(torus);
  for (const int balance : { vtkSkdTreeAMR::NONE, vtkSkdTreeAMR::FACE })
  {
    AMRPointer filter = MakeAMR(parts, 5);
    filter->SetBalance(balance);
    filter->ComputeInsideOn();
    filter->ComputeDistanceOn();
    const std::vector<Leaf> leaves = RunLeaves(filter);
    const std::vector<double> inside = CellArray(filter, "SkdInside");
    const std::vector<double> distances = CellArray(filter, "SkdDistance");
    std::vector<Point> centres;
    for (const Leaf& leaf : leaves)
    {
      centres.push_back(Center(leaf.Box));
    }
    FilterPointer closest = MakeSignedFilter(MakeQueries(centres), parts);
    const std::vector<double> expected = RunDistances(closest);
    double volume = 0.0;
    for (std::size_t i = 0; i < leaves.size(); ++i)
    {
      EXPECT_NEAR(distances[i], expected[i], 1e-12);
      EXPECT_EQ(inside[i] != 0, expected[i] < 0) << i;
      volume += inside[i] * VolumeOf({ leaves[i] });
    }
    EXPECT_NEAR(volume, 2 * 9.8696 * 0.35 * 0.35, 0.15);
    EXPECT_EQ(Reported(filter, "OpenEdges"), 0);
  }
}

/// Without its cap, and with triangles turned at random.
TEST(AMRCriteria, TheInsideOfAnOpenSurfaceIsByWindingNumber)
{
  const Mesh ball = SphereTriangles(16);
  const Mesh bowl =
    Part(ball, [&](std::size_t cell) { return ball.Points[ball.Cells[cell].Points[1]][2] < 0.5; });
  Mesh rotated = bowl;
  Random random(6);
  for (CellSpec& cell : rotated.Cells)
  {
    if (random.InBox({ 0, 1, 0, 1, 0, 1 })[0] < 0.3)
    {
      std::swap(cell.Points[1], cell.Points[2]);
    }
  }
  for (const Mesh& mesh : { bowl, rotated })
  {
    AMRPointer filter = MakeAMR(MakePolyData(mesh), 4);
    filter->ComputeInsideOn();
    EventCounter events(filter);
    const std::vector<Leaf> leaves = RunLeaves(filter);
    const std::vector<double> inside = CellArray(filter, "SkdInside");
    int found[2] = { 0, 0 };
    for (std::size_t i = 0; i < leaves.size(); ++i)
    {
      const double number = std::abs(WindingNumber(bowl, Center(leaves[i].Box)));
      EXPECT_TRUE(std::abs(number - 0.5) < 1e-9 || inside[i] == (number > 0.5)) << number;
      ++found[inside[i] != 0];
    }
    EXPECT_TRUE(found[0] > 100 && found[1] > 100);
    EXPECT_EQ(events.Warnings, 1);
    EXPECT_NE(events.Warning.find("winding number"), std::string::npos) << events.Warning;
  }
}

TEST(AMRCriteria, AnOpenSurfaceIsSaidToBeOpen)
{
  const Mesh ball = SphereTriangles(12);
  auto open = MakePolyData(Part(ball, [](std::size_t cell) { return cell != 5; }));
  AMRPointer filter = MakeAMR(open, 4);
  EventCounter events(filter);
  filter->ComputeInsideOn();
  const std::vector<Leaf> leaves = RunLeaves(filter);
  EXPECT_EQ(events.Warnings, 1);
  EXPECT_NE(events.Warning.find("3 open edges"), std::string::npos) << events.Warning;
  const std::vector<double> inside = CellArray(filter, "SkdInside");
  int wrong = 0;
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    const double radius = Length(Center(leaves[i].Box));
    wrong += radius < 0.95 ? inside[i] == 0 : radius > 1.05 && inside[i] != 0;
  }
  EXPECT_EQ(wrong, 0);

  filter->SetInputDataObject(0, MakePolyData(Helix(20, VTK_LINE)));
  filter->Update();
  EXPECT_EQ(events.Warnings, 2);
  EXPECT_NE(events.Warning.find("no surface"), std::string::npos) << events.Warning;
}

/// The volume of a closed surface of triangles oriented outward.
double EnclosedVolume(const Mesh& mesh)
{
  double volume = 0.0;
  for (const CellSpec& cell : mesh.Cells)
  {
    const auto& p = mesh.Points;
    volume += Dot(p[cell.Points[0]], Cross(p[cell.Points[1]], p[cell.Points[2]])) / 6.0;
  }
  return std::abs(volume);
}

double SumOfFractions(vtkSkdTreeAMR* filter)
{
  const std::vector<Leaf> leaves = RunLeaves(filter);
  const std::vector<double> fractions = CellArray(filter, "SkdVolumeFraction");
  double volume = 0.0;
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    EXPECT_GE(fractions[i], 0.0);
    EXPECT_LE(fractions[i], 1.0);
    EXPECT_TRUE(leaves[i].IsCut || fractions[i] == 0.0 || fractions[i] == 1.0);
    volume += fractions[i] * VolumeOf({ leaves[i] });
  }
  return volume;
}

TEST(AMRCriteria, VolumeFractionsAddUpToTheVolume)
{
  // The cube [0, 4]^3 has its faces on those of cells, the others are anywhere.
  const Mesh meshes[] = { TorusTriangles(32, 16), SphereTriangles(8).Map(Rotated), CubeTriangles(4),
    Octahedron(1.0) };
  for (const Mesh& mesh : meshes)
  {
    Mesh outward = mesh;
    for (CellSpec& cell : outward.Cells)
    {
      // Those of the octahedron are not oriented alike: its volume is known.
      std::swap(cell.Points[1], cell.Points[2]);
    }
    const double volume = mesh.Cells.size() == 8 ? 4.0 / 3.0 : EnclosedVolume(mesh);
    for (int level = 0; level <= 5; level += level < 2 ? 1 : 3)
    {
      AMRPointer filter = MakeAMR(MakePolyData(level % 2 ? outward : mesh), level);
      if (mesh.Cells.size() == 192)
      {
        filter = MakeAMRIn(MakePolyData(mesh), level, { -4, 12, -4, 12, 0, 16 });
      }
      filter->ComputeVolumeFractionOn();
      EXPECT_NEAR(SumOfFractions(filter), volume, 1e-10 * volume) << level;
      EXPECT_TRUE(CellArray(filter, "SkdInside").empty());
    }
  }
}

TEST(AMRCriteria, VolumeFractionsOfVolumeCellsAndOfAreas)
{
  AMRPointer filter = MakeAMR(MakeGrid(Tetrahedra(3)), 4);
  filter->ComputeVolumeFractionOn();
  EXPECT_NEAR(SumOfFractions(filter), 27.0, 1e-9);

  // A cut through the cube [0, 4]^3 is a square, one along it a length.
  Bounds box = { -1.3, 5.1, -1.7, 4.9, 1.1, 1.1 };
  AMRPointer flat = MakeAMRIn(MakePolyData(CubeTriangles(4)), 4, box);
  flat->ComputeVolumeFractionOn();
  for (int dimension = 2; dimension >= 1; --dimension)
  {
    const std::vector<Leaf> leaves = RunLeaves(flat);
    const std::vector<double> fractions = CellArray(flat, "SkdVolumeFraction");
    double sum = 0.0;
    for (std::size_t i = 0; i < leaves.size(); ++i)
    {
      const Bounds& b = leaves[i].Box;
      sum += fractions[i] * (b[1] - b[0]) * (dimension == 2 ? b[3] - b[2] : 1.0);
    }
    EXPECT_NEAR(sum, dimension == 2 ? 16.0 : 4.0, 1e-10);
    flat->SetBaseBounds(box[0], box[1], 2.2, 2.2, 1.1, 1.1);
  }
}

TEST(AMRCriteria, VolumeFractionsOfAnOpenSurfaceAreSampled)
{
  auto open = MakePolyData(Part(SphereTriangles(12), [](std::size_t cell) { return cell != 5; }));
  AMRPointer filter = MakeAMR(open, 5);
  EventCounter events(filter);
  filter->ComputeVolumeFractionOn();
  EXPECT_NEAR(SumOfFractions(filter), EnclosedVolume(SphereTriangles(12)), 0.02);
  EXPECT_EQ(events.Warnings, 1);
}

TEST(AMRCriteria, TheInsideIsRefinedToALevelOfItsOwn)
{
  auto ball = MakeBall(0.9, { 0, 0, 0 });
  AMRPointer filter = MakeAMRIn(ball, 5, Around);
  filter->SetInsideLevel(3);
  for (const Leaf& leaf : RunLeaves(filter))
  {
    const double radius = Length(Center(leaf.Box));
    EXPECT_TRUE(leaf.Level >= 3 || radius > 0.85);
    EXPECT_TRUE(leaf.Level < 5 || radius > 0.6);
  }
}

/// tanh of the distance to a sphere: steep there, flat elsewhere; NaN in a corner.
vtkSmartPointer<vtkImageData> MakeShock(double radius, bool isOfCells)
{
  auto image = MakeImage(32); // cells of side 1, or what it is: mapped to [-1.6, 1.7]
  image->SetOrigin(-1.6, -1.6, -1.6);
  image->SetSpacing(3.3 / 32, 3.3 / 32, 3.3 / 32);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Shock");
  const vtkIdType n = isOfCells ? image->GetNumberOfCells() : image->GetNumberOfPoints();
  for (vtkIdType i = 0; i < n; ++i)
  {
    Bounds box;
    image->GetCellBounds(isOfCells ? i : 0, box.data());
    Point x = Center(box);
    if (!isOfCells)
    {
      image->GetPoint(i, x.data());
    }
    values->InsertNextValue(
      i == 0 ? std::numeric_limits<double>::quiet_NaN() : std::tanh(10 * (Length(x) - radius)));
  }
  (isOfCells ? static_cast<vtkDataSetAttributes*>(image->GetCellData()) : image->GetPointData())
    ->AddArray(values);
  return image;
}

TEST(AMRCriteria, AFieldIsRefinedWhereItVaries)
{
  Mesh far;
  far.Add(VTK_VERTEX, { far.Add({ 1.55, 1.55, 1.55 }) });
  for (const bool isOfCells : { false, true })
  {
    for (const int test : { vtkSkdTreeAMR::DIFFERENCE, vtkSkdTreeAMR::GRADIENT })
    {
      if (isOfCells && test == vtkSkdTreeAMR::GRADIENT)
      {
        continue; // no such thing
      }
      AMRPointer filter = MakeAMRIn(MakePolyData(far), 4, Around);
      filter->SetFieldData(MakeShock(0.8, isOfCells));
      filter->AddFieldArray("Shock");
      filter->SetFieldTest(test);
      filter->SetFieldThreshold(test == vtkSkdTreeAMR::GRADIENT ? 2.5 : 0.5);
      EventCounter events(filter);
      const std::vector<Leaf> leaves = RunLeaves(filter);
      for (const Leaf& leaf : leaves)
      {
        const double radius = Length(Center(leaf.Box));
        // A cell of level 3, 0.7 across, may just reach what is steep; the point is in a corner.
        EXPECT_TRUE(leaf.Level < 4 || leaf.IsCut || radius < 1.65 || radius > 2.2) << radius;
      }
      Random random(8);
      for (int i = 0; i < 200; ++i)
      {
        EXPECT_EQ(FindLeaf(leaves, 0.8 * random.Direction())->Level, 4) << isOfCells << test;
      }
      EXPECT_EQ(events.Warnings + events.Errors, 0);
    }
  }
}

TEST(AMRCriteria, AFieldIsRefinedWhereItsValuesAreToALevel)
{
  Mesh far;
  far.Add(VTK_VERTEX, { far.Add({ 1.55, 1.55, 1.55 }) });
  AMRPointer filter = MakeAMRIn(MakePolyData(far), 6, Around);
  filter->SetFieldData(MakeBlocks({ MakeShock(0.8, false), nullptr }));
  filter->AddFieldArray("Shock");
  filter->SetFieldTest(vtkSkdTreeAMR::VALUE);
  filter->SetFieldRange(-2.0, -0.9); // well inside of the sphere: radius below 0.65
  filter->SetFieldLevel(4);
  int inside = 0;
  for (const Leaf& leaf : RunLeaves(filter))
  {
    const double radius = Length(Center(leaf.Box));
    EXPECT_TRUE(leaf.Level == 4 || radius > 0.6) << radius;
    EXPECT_TRUE(leaf.Level < 4 || leaf.IsCut || radius < 1.2 || radius > 2.2) << radius;
    inside += radius < 0.6;
  }
  EXPECT_GT(inside, 50);
  filter->AddFieldArray("Nothing");
  EventCounter events(filter);
  filter->Update();
  EXPECT_EQ(events.Warnings, 1);
  EXPECT_NE(events.Warning.find("no array Nothing"), std::string::npos);
}

}
