// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// AMR data and partitioned data sets are one mesh in pieces: what is asked of the outer faces of
// their volume cells has the answers of one grid, in which no faces are between the pieces.

#include "Support/AMRMeshes.h"
#include "Support/EventCounter.h"
#include "Support/MakeOf.h"
#include "Support/QuietWindow.h"
#include "Support/SurfaceMeshes.h"
#include "Support/VolumeMeshes.h"

#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkSkdTreeBooleanOperation.h"
#include "vtkSkdTreeClosestPoint.h"
#include "vtkSkdTreeCompareSurfaces.h"
#include "vtkSkdTreeCurveSurfaceIntersection.h"
#include "vtkSkdTreeRays.h"
#include "vtkSkdTreeSurfaceIntersection.h"
#include "vtkSkdTreeWallThickness.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

using namespace skdtest;

namespace
{
const Point Corner{ 0.02, 0.03, 0.01 };
constexpr double Size = 2.4;

/// The cube of MakeAMR() in blocks that touch within each level, too.
vtkSmartPointer<vtkOverlappingAMR> MakeAMRInBlocks()
{
  const double spacing[2] = { 0.6, 0.3 };
  const std::vector<vtkAMRBox> boxes[2] = {
    { vtkAMRBox(0, 0, 0, 1, 3, 3), vtkAMRBox(2, 0, 0, 3, 1, 3), vtkAMRBox(2, 2, 0, 3, 3, 3) },
    { vtkAMRBox(0, 0, 0, 3, 3, 1), vtkAMRBox(0, 0, 2, 3, 3, 3) }
  };
  const int blocks[2] = { 3, 2 };
  auto amr = vtkSmartPointer<vtkOverlappingAMR>::New();
  amr->Initialize(2, blocks);
  amr->SetGridDescription(VTK_XYZ_GRID);
  amr->SetOrigin(Corner.data());
  for (unsigned int level = 0; level < 2; ++level)
  {
    const double h = spacing[level];
    const double cell[3] = { h, h, h };
    amr->SetSpacing(level, cell);
    for (unsigned int i = 0; i < boxes[level].size(); ++i)
    {
      amr->SetAMRBox(level, i, boxes[level][i]);
      const int hidden = level == 0 && i == 0 ? 2 : 0;
      amr->SetDataSet(level, i, MakeAMRBlock(boxes[level][i], Corner, h, hidden));
    }
  }
  return amr;
}

/// The same cube in cells of the finest size.
Mesh Whole(const Mesh& lattice)
{
  Mesh mesh = lattice;
  mesh.Map(
    [](const Point& x) -> Point
    {
      const double h = Size / 8.0;
      return { Corner[0] + h * x[0], Corner[1] + h * x[1], Corner[2] + h * x[2] };
    });
  return mesh;
}

/// The cells whose first points are below the middle along x, or the others.
GridPointer HalfOf(const Mesh& mesh, bool isBelow)
{
  Mesh half;
  half.Points = mesh.Points;
  for (const CellSpec& cell : mesh.Cells)
  {
    double x = 0.0;
    for (const vtkIdType id : cell.Points)
    {
      x += mesh.Points[static_cast<std::size_t>(id)][0] / static_cast<double>(cell.Points.size());
    }
    if ((x < Corner[0] + 0.5 * Size) == isBelow)
    {
      half.Cells.push_back(cell);
    }
  }
  return MakeGrid(half);
}

vtkSmartPointer<vtkPartitionedDataSet> Partitioned(const Mesh& mesh)
{
  auto partitions = vtkSmartPointer<vtkPartitionedDataSet>::New();
  partitions->SetPartition(0, HalfOf(mesh, true));
  partitions->SetPartition(2, HalfOf(mesh, false));
  return partitions;
}

GridPointer FarAway()
{
  Mesh far = Hexahedra(1);
  far.Map([](const Point& x) -> Point { return { x[0] + 100.0, x[1], x[2] }; });
  return MakeGrid(far);
}

/// As the second of a collection, after a mesh far away.
vtkSmartPointer<vtkPartitionedDataSetCollection> InCollection(vtkPartitionedDataSet* partitions)
{
  auto collection = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  collection->SetPartition(0, 0, FarAway());
  collection->SetPartitionedDataSet(1, partitions);
  return collection;
}

/// Voxels of two sizes as one grid, as images of several processes are joined.
vtkSmartPointer<vtkPartitionedDataSet> JoinedLevels()
{
  auto partitions = vtkSmartPointer<vtkPartitionedDataSet>::New();
  partitions->SetPartition(0, ShownCellsOf(MakeAMRInBlocks()));
  return partitions;
}

struct NamedPieces
{
  std::string Name;
  std::function<vtkSmartPointer<vtkDataObject>()> Make;
};

class PiecesOfMeshes : public testing::TestWithParam<NamedPieces>
{
protected:
  const QuietWindow Quiet;
  const vtkSmartPointer<vtkDataObject> Pieces = GetParam().Make();
  const GridPointer Reference = MakeGrid(Whole(Hexahedra(8)));
};

INSTANTIATE_TEST_SUITE_P(All, PiecesOfMeshes,
  testing::Values(NamedPieces{ "Levels", [] { return MakeAMR(); } },
    NamedPieces{ "Blocks", [] { return MakeAMRInBlocks(); } },
    NamedPieces{ "JoinedLevels", [] { return JoinedLevels(); } },
    NamedPieces{ "Hexahedra", [] { return Partitioned(Whole(Hexahedra(8))); } },
    NamedPieces{ "Tetrahedra", [] { return Partitioned(Whole(Tetrahedra(8))); } },
    NamedPieces{ "Collection", [] { return InCollection(Partitioned(Whole(Voxels(8)))); } }),
  [](const auto& info) { return info.param.Name; });

/// A sphere that passes all middle planes, and is within the cube or reaches out of it.
PolyDataPointer Ball(double radius)
{
  return MakePolyData(Transformed(SphereTriangles(12), radius, { 1.27, 1.19, 1.16 }));
}

double LengthOf(vtkDataObject* curves)
{
  auto* mesh = vtkDataSet::SafeDownCast(curves);
  double length = 0.0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    vtkPoints* points = mesh->GetCell(i)->GetPoints();
    for (vtkIdType k = 0; k + 1 < points->GetNumberOfPoints(); ++k)
    {
      double from[3];
      double to[3];
      points->GetPoint(k, from);
      points->GetPoint(k + 1, to);
      length += std::sqrt(vtkMath::Distance2BetweenPoints(from, to));
    }
  }
  return length;
}

void ExpectNear(const std::vector<double>& some, const std::vector<double>& others)
{
  ASSERT_EQ(some.size(), others.size());
  ASSERT_FALSE(some.empty());
  for (std::size_t i = 0; i < some.size(); ++i)
  {
    ASSERT_EQ(std::isnan(some[i]), std::isnan(others[i])) << i;
    if (!std::isnan(some[i]))
    {
      ASSERT_NEAR(some[i], others[i], 1e-9) << i;
    }
  }
}

/// The values at points within the cube, rounded, that are numbers.
std::map<std::array<long, 3>, double> ValuesByPoint(vtkDataObject* output, const char* name)
{
  std::map<std::array<long, 3>, double> values;
  const auto add = [&](vtkDataSet* mesh)
  {
    const std::vector<double> all = ValuesOf(mesh->GetPointData()->GetArray(name));
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      const double* x = mesh->GetPoint(static_cast<vtkIdType>(i));
      if (!std::isnan(all[i]) && x[0] < 50.0)
      {
        values[{ std::lround(1e6 * x[0]), std::lround(1e6 * x[1]), std::lround(1e6 * x[2]) }] =
          all[i];
      }
    }
  };
  if (auto* mesh = vtkDataSet::SafeDownCast(output))
  {
    add(mesh);
    return values;
  }
  vtkSmartPointer<vtkCompositeDataIterator> iterator;
  iterator.TakeReference(vtkCompositeDataSet::SafeDownCast(output)->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    add(vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject()));
  }
  return values;
}

/// What starts at points of pieces is what starts there of the reference, and starts nowhere else.
void ExpectAmong(const std::map<std::array<long, 3>, double>& some,
  const std::map<std::array<long, 3>, double>& reference)
{
  ASSERT_GT(some.size(), 100u);
  for (const auto& [x, value] : some)
  {
    const auto found = reference.find(x);
    ASSERT_NE(found, reference.end()) << x[0] << ' ' << x[1] << ' ' << x[2];
    ASSERT_NEAR(value, found->second, 1e-9) << x[0] << ' ' << x[1] << ' ' << x[2];
  }
}

PolyDataPointer Line()
{
  Mesh mesh;
  mesh.Add(VTK_LINE, { mesh.Add({ -1, 0.9, 0.7 }), mesh.Add({ 4, 1.6, 1.4 }) });
  return MakePolyData(mesh);
}
}

TEST_P(PiecesOfMeshes, DoNotMeetEachOther)
{
  const auto filter = MakeOf<vtkSkdTreeSurfaceIntersection>(this->Pieces, nullptr);
  EventCounter events(filter);
  filter->Update();
  EXPECT_EQ(Reported(filter, "Pairs"), 0.0);
  EXPECT_EQ(Reported(filter, "Curves"), 0.0);
  EXPECT_EQ(Reported(filter, "Overlaps"), 0.0);
  EXPECT_EQ(Reported(filter, "TrianglesWithoutArea"), 0.0);
  EXPECT_GT(Reported(filter, "Triangles"), 200.0);
  EXPECT_EQ(events.Warnings, 0) << events.Warning;
}

TEST_P(PiecesOfMeshes, MeetSurfacesWhereTheMeshDoes)
{
  std::vector<double> lengths;
  for (vtkDataObject* mesh : std::vector<vtkDataObject*>{ this->Pieces, this->Reference })
  {
    for (const double radius : { 1.0, 1.4 })
    {
      const auto filter = MakeOf<vtkSkdTreeSurfaceIntersection>(mesh, Ball(radius));
      filter->Update();
      lengths.push_back(LengthOf(filter->GetOutputDataObject(0)));
    }
  }
  EXPECT_EQ(lengths[0], 0.0);
  EXPECT_GT(lengths[1], 1.0);
  EXPECT_NEAR(lengths[1], lengths[3], 1e-9);
}

TEST_P(PiecesOfMeshes, AreOneBodyForCurves)
{
  const auto filter = MakeOf<vtkSkdTreeCurveSurfaceIntersection>(Line(), this->Pieces);
  filter->CutCurvesOn();
  filter->Update();
  EXPECT_EQ(Reported(filter, "Hits"), 2.0);
  auto* cut = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
  EXPECT_EQ(ValuesOf(cut->GetCellData()->GetArray("SkdPartsInside")),
    (std::vector<double>{ 0.0, 1.0, 0.0 }));
}

TEST_P(PiecesOfMeshes, AreMeasuredAgainstAsOne)
{
  for (const int method : { vtkSkdTreeWallThickness::RAYS, vtkSkdTreeWallThickness::SPHERES })
  {
    std::vector<std::vector<double>> thickness;
    for (vtkDataObject* mesh : std::vector<vtkDataObject*>{ this->Pieces, this->Reference })
    {
      const auto filter = MakeOf<vtkSkdTreeWallThickness>(Ball(1.0), mesh);
      filter->SetMethod(method);
      filter->SetNumberOfRays(3);
      filter->ReversedOn();
      filter->Update();
      thickness.push_back(PointArray(filter->GetOutputDataObject(0), "SkdThickness"));
    }
    ExpectNear(thickness[0], thickness[1]);
  }
}

TEST_P(PiecesOfMeshes, AreAsThickAsTheMesh)
{
  for (const int method : { vtkSkdTreeWallThickness::RAYS, vtkSkdTreeWallThickness::SPHERES })
  {
    std::vector<std::map<std::array<long, 3>, double>> thickness;
    for (vtkDataObject* mesh : std::vector<vtkDataObject*>{ this->Pieces, this->Reference })
    {
      const auto filter = MakeOf<vtkSkdTreeWallThickness>(mesh, nullptr);
      EventCounter events(filter);
      filter->SetMethod(method);
      filter->SetNumberOfRays(1);
      filter->Update();
      EXPECT_EQ(events.Warnings, 0) << events.Warning;
      thickness.push_back(ValuesByPoint(filter->GetOutputDataObject(0), "SkdThickness"));
    }
    ExpectAmong(thickness[0], thickness[1]);
  }
}

TEST_P(PiecesOfMeshes, SendRaysFromWhatIsOuter)
{
  std::vector<std::map<std::array<long, 3>, double>> distances;
  const PolyDataPointer around = Ball(5.0);
  for (vtkDataObject* mesh : std::vector<vtkDataObject*>{ this->Pieces, this->Reference })
  {
    const auto filter = MakeOf<vtkSkdTreeRays>(mesh, around);
    EventCounter events(filter);
    filter->Update();
    EXPECT_EQ(events.Warnings, 0) << events.Warning;
    distances.push_back(ValuesByPoint(filter->GetOutputDataObject(0), "SkdRayDistance"));
  }
  ExpectAmong(distances[0], distances[1]);
}

TEST_P(PiecesOfMeshes, AreComparedAsOne)
{
  std::vector<std::vector<double>> distances;
  for (vtkDataObject* mesh : std::vector<vtkDataObject*>{ this->Pieces, this->Reference })
  {
    const auto filter = MakeOf<vtkSkdTreeCompareSurfaces>(Ball(1.4), mesh);
    filter->Update();
    distances.push_back(PointArray(filter->GetOutputDataObject(0), "SkdDistance"));
  }
  ExpectNear(distances[0], distances[1]);
}

TEST_P(PiecesOfMeshes, HaveTheSignedDistancesOfTheMesh)
{
  std::vector<std::vector<double>> distances;
  for (vtkDataObject* mesh : std::vector<vtkDataObject*>{ this->Pieces, this->Reference })
  {
    const auto queries = MakeQueries(RandomQueries(this->Reference, 300));
    const auto filter = MakeOf<vtkSkdTreeClosestPoint>(queries, mesh);
    filter->SignedDistanceOn();
    filter->Update();
    EXPECT_EQ(Reported(filter, "OpenEdges"), 0.0);
    distances.push_back(PointArray(filter->GetOutputDataObject(0), "SkdDistance"));
  }
  ExpectNear(distances[0], distances[1]);
}

TEST_P(PiecesOfMeshes, AreOneSolid)
{
  std::vector<double> measures;
  for (vtkDataObject* mesh : std::vector<vtkDataObject*>{ this->Pieces, this->Reference })
  {
    const auto filter = MakeOf<vtkSkdTreeBooleanOperation>(Ball(1.0), mesh);
    filter->SetOperation(vtkSkdTreeBooleanOperation::REVERSE_DIFFERENCE);
    filter->Update();
    measures.push_back(Reported(filter, "Volume"));
    measures.push_back(Reported(filter, "Area"));
  }
  const double isThere = GetParam().Name == "Collection" ? 1.0 : 0.0; // the mesh far away
  EXPECT_NEAR(measures[0], measures[2] + isThere, 1e-9);
  EXPECT_NEAR(measures[1], measures[3] + 6.0 * isThere, 1e-9);
}

// The last points of the first image and the first ones of the second differ by rounding.
TEST(PiecesOfImages, LeaveNoGapsInSolids)
{
  constexpr double end = 0.3;
  const double next = std::nextafter(end, 1.0);
  vtkNew<vtkPartitionedDataSet> pieces;
  for (unsigned int i = 0; i < 2; ++i)
  {
    const auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(3, 3, 3);
    image->SetSpacing(end, end, end);
    image->SetOrigin(i == 0 ? -end : next, 0.0, 0.0);
    pieces->SetPartition(i, image);
  }
  ASSERT_NE(vtkDataSet::SafeDownCast(pieces->GetPartition(0))->GetPoint(2)[0], next);
  const auto filter = MakeOf<vtkSkdTreeBooleanOperation>(Ball(5.0), pieces);
  filter->SetOperation(vtkSkdTreeBooleanOperation::INTERSECTION);
  filter->Update();
  EXPECT_NEAR(Reported(filter, "Area"), 40.0 * end * end, 1e-9);
}

// By their definition. They touch as any two bodies do.
TEST(BlocksOfMultiBlockData, AreBodiesOfTheirOwn)
{
  const Mesh mesh = Whole(Hexahedra(8));
  const auto partitions = Partitioned(mesh);
  const auto blocks = MakeBlocks({ partitions->GetPartition(0), partitions->GetPartition(2) });
  const auto hits = MakeOf<vtkSkdTreeCurveSurfaceIntersection>(Line(), blocks);
  hits->Update();
  EXPECT_EQ(Reported(hits, "Hits"), 4.0);
  const auto pairs = MakeOf<vtkSkdTreeSurfaceIntersection>(blocks, nullptr);
  pairs->Update();
  EXPECT_GT(Reported(pairs, "Overlaps"), 0.0);
  // The same data sets, otherwise put together.
  pairs->SetInputDataObject(0, partitions);
  pairs->Update();
  EXPECT_EQ(Reported(pairs, "Overlaps"), 0.0);
}

// A face of a large cell that smaller ones cover in part is outer, and so are theirs.
TEST(PiecesOfImages, HaveClosedSurfacesWhereFacesAreCoveredInPart)
{
  const auto coarse = vtkSmartPointer<vtkImageData>::New();
  coarse->SetDimensions(2, 2, 2);
  const auto fine = vtkSmartPointer<vtkImageData>::New();
  fine->SetDimensions(3, 2, 3);
  fine->SetSpacing(0.5, 0.5, 0.5);
  fine->SetOrigin(1.0, 0.0, 0.0);
  vtkNew<vtkPartitionedDataSet> pieces;
  pieces->SetPartition(0, coarse);
  pieces->SetPartition(1, fine);
  const auto filter = MakeOf<vtkSkdTreeClosestPoint>(
    MakeQueries({ { 0.9, 0.3, 0.4 }, { 1.2, 0.1, 0.4 }, { 1.2, 0.8, 0.4 } }), pieces);
  filter->SignedDistanceOn();
  filter->Update();
  EXPECT_EQ(Reported(filter, "OpenEdges"), 0.0);
  const std::vector<double> distances = PointArray(filter->GetOutputDataObject(0), "SkdDistance");
  EXPECT_LT(distances[0], 0.0);
  EXPECT_LT(distances[1], 0.0);
  EXPECT_NEAR(distances[2], 0.2, 1e-12);
}

// The sides of the large cell have 10^12 steps of the lattice, and the last piece is 10^20 of them
// away.
TEST(PiecesOfImages, MayDifferVeryMuchInSize)
{
  vtkNew<vtkPartitionedDataSet> pieces;
  const std::array<double, 3> sizes = { 1.0, 1e-12, 1.0 };
  const std::array<double, 3> begins = { 0.0, 1.0, 1e8 };
  for (unsigned int i = 0; i < 3; ++i)
  {
    const auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(2, 2, 2);
    image->SetSpacing(sizes[i], sizes[i], sizes[i]);
    image->SetOrigin(begins[i], 0.0, 0.0);
    pieces->SetPartition(i, image);
  }
  Mesh line;
  line.Add(VTK_LINE, { line.Add({ -1, 0.4, 0.3 }), line.Add({ 4, 0.6, 0.5 }) });
  const auto hits = MakeOf<vtkSkdTreeCurveSurfaceIntersection>(MakePolyData(line), pieces);
  hits->Update();
  EXPECT_EQ(Reported(hits, "Hits"), 2.0);
  const auto pairs = MakeOf<vtkSkdTreeSurfaceIntersection>(Ball(0.8), pieces);
  pairs->Update();
  EXPECT_GT(Reported(pairs, "Curves"), 0.0);
}

namespace
{
/// An image of cells of one size, whose axes are those of the matrix: its first point is there,
/// too.
vtkSmartPointer<vtkImageData> MakeImage(const Point& origin, const std::array<int, 3>& cells,
  double size, const std::array<double, 9>& axes = { 1, 0, 0, 0, 1, 0, 0, 0, 1 })
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(cells[0] + 1, cells[1] + 1, cells[2] + 1);
  image->SetSpacing(size, size, size);
  image->SetDirectionMatrix(axes.data());
  Point first{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    first[i] = axes[3 * i] * origin[0] + axes[3 * i + 1] * origin[1] + axes[3 * i + 2] * origin[2];
  }
  image->SetOrigin(first.data());
  return image;
}

vtkSmartPointer<vtkPartitionedDataSet> PartitionsOf(
  const std::vector<vtkSmartPointer<vtkDataSet>>& pieces)
{
  auto partitions = vtkSmartPointer<vtkPartitionedDataSet>::New();
  for (vtkDataSet* piece : pieces)
  {
    partitions->SetPartition(partitions->GetNumberOfPartitions(), piece);
  }
  return partitions;
}

/// Of points, to the surface of the pieces; fails if it has open edges.
std::vector<double> SignedDistances(
  const std::vector<Point>& points, const std::vector<vtkSmartPointer<vtkDataSet>>& pieces)
{
  const auto filter = MakeOf<vtkSkdTreeClosestPoint>(MakeQueries(points), PartitionsOf(pieces));
  filter->SignedDistanceOn();
  filter->Update();
  EXPECT_EQ(Reported(filter, "OpenEdges"), 0.0);
  return PointArray(filter->GetOutputDataObject(0), "SkdDistance");
}
}

// The cube from 0 to 6 in cells of 3 and of 1.5, with something far away that has nothing to do
// with it: before or after it.
TEST(PiecesOfImages, AreOneMeshWhateverOtherPiecesThereAre)
{
  const auto hidden = MakeImage({ 1, 1, 1 }, { 1, 1, 1 }, 1.0);
  MarkGhosts(hidden, { 0 }, vtkDataSetAttributes::HIDDENCELL);
  const std::vector<vtkSmartPointer<vtkDataSet>> others = {
    MakeImage({ 100, 0, 0 }, { 1, 1, 1 }, 1.0), MakeImage({ 100.3, 0, 0 }, { 1, 1, 1 }, 1.5),
    FarAway(), hidden, MakeImage({ 100, 0, 0 }, { 1, 1, 1 }, 1.0, { 0, -1, 0, 1, 0, 0, 0, 0, 1 })
  };
  const auto coarse = MakeImage({ 0, 0, 0 }, { 1, 2, 2 }, 3.0);
  const auto fine = MakeImage({ 3, 0, 0 }, { 2, 4, 4 }, 1.5);
  for (const auto& other : others)
  {
    EXPECT_NEAR(SignedDistances({ { 2.9, 3, 3 } }, { coarse, fine, other })[0], -2.9, 1e-12);
    EXPECT_NEAR(SignedDistances({ { 2.9, 3, 3 } }, { other, coarse, fine })[0], -2.9, 1e-12);
  }
}

// The same cube turned, and mirrored: by the axes of the images.
TEST(PiecesOfImages, AreOneMeshWithAnyAxes)
{
  const double c = std::cos(0.3);
  const double s = std::sin(0.3);
  for (const std::array<double, 9>& axes :
    std::vector<std::array<double, 9>>{ { 0, -1, 0, 1, 0, 0, 0, 0, 1 },
      { c, -s, 0, s, c, 0, 0, 0, 1 }, { c, -s, 0, s, c, 0, 0, 0, -1 } })
  {
    const Point x{ 3.1 * axes[0] + 3 * axes[1] + 3 * axes[2],
      3.1 * axes[3] + 3 * axes[4] + 3 * axes[5], 3.1 * axes[6] + 3 * axes[7] + 3 * axes[8] };
    const auto coarse = MakeImage({ 0, 0, 0 }, { 1, 2, 2 }, 3.0, axes);
    const auto fine = MakeImage({ 3, 0, 0 }, { 2, 4, 4 }, 1.5, axes);
    EXPECT_NEAR(SignedDistances({ x }, { coarse, fine })[0], -2.9, 1e-12);
  }
}

// Two fine images that both cover the same half of a face do not cover it.
TEST(PiecesOfImages, ThatOverlapDoNotCoverMore)
{
  const auto coarse = MakeImage({ 0, 0, 0 }, { 1, 1, 1 }, 2.0);
  const auto half = MakeImage({ 2, 0, 0 }, { 1, 1, 2 }, 1.0);
  const auto longer = MakeImage({ 2, 0, 0 }, { 2, 1, 2 }, 1.0);
  for (const auto& other : { half, longer })
  {
    const std::vector<double> distances =
      SignedDistances({ { 1.9, 1.5, 1 }, { 2.1, 1.5, 1 } }, { coarse, half, other });
    EXPECT_NEAR(distances[0], -0.1, 1e-12);
    EXPECT_NEAR(distances[1], 0.1, 1e-12);
  }
}
