// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeProbe at random points of every cell of real meshes and made ones, inverted and warped
// cells among them: each is found in a cell that holds it by the cell's own evaluation.

#include "Support/FetchCell.h"
#include "Support/LocatorCalls.h"
#include "Support/NamedMeshes.h"
#include "Support/OnFile.h"
#include "Support/ProbeRun.h"

#include "vtkProbeFilter.h"
#include "vtkResampleWithDataSet.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{
/// A random point of the triangle or tetrahedron of some points.
Point InSimplex(const std::vector<Point>& corners, Random& random)
{
  Point x = { 0, 0, 0 };
  double sum = 0.0;
  std::vector<double> shares;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    shares.push_back(-std::log(1.0 - random.InBox({ 0, 1, 0, 1, 0, 1 })[0]));
    sum += shares.back();
  }
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    x = x + shares[i] / sum * corners[i];
  }
  return x;
}

Point Mean(const std::vector<Point>& points)
{
  Point mean = { 0, 0, 0 };
  for (const Point& p : points)
  {
    mean = mean + 1.0 / double(points.size()) * p;
  }
  return mean;
}

/// The faces of a polyhedron as fans around the means of their points.
std::vector<std::array<Point, 3>> FansOf(vtkCell* cell)
{
  std::vector<std::array<Point, 3>> fans;
  for (int face = 0; face < cell->GetNumberOfFaces(); ++face)
  {
    const std::vector<Point> points = ToVector(cell->GetFace(face)->GetPoints());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      fans.push_back({ Mean(points), points[i], points[(i + 1) % points.size()] });
    }
  }
  return fans;
}

bool IsWithin(const std::vector<std::array<Point, 3>>& fans, const Point& x, double far)
{
  int crossings = 0;
  for (const auto& triangle : fans)
  {
    crossings += HitTriangle(x, x + far * Point{ 0.5377, 0.6231, 0.5681 }, triangle).has_value();
  }
  return crossings % 2 == 1;
}

/// Parametric coordinates in the domain of a linear cell.
Point RandomPCoords(int type, Random& random)
{
  const Point inCube = random.InBox({ 0, 1, 0, 1, 0, 1 });
  switch (type)
  {
    case VTK_TRIANGLE:
      return InSimplex({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, random);
    case VTK_WEDGE:
    {
      const Point inTriangle = InSimplex({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, random);
      return { inTriangle[0], inTriangle[1], inCube[2] };
    }
    case VTK_TETRA:
      return InSimplex({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, random);
    default:
      return inCube;
  }
}

/// Points of a polyhedron, between its middle and its faces.
std::vector<Point> PointsOfPolyhedron(vtkCell* cell, int count, Random& random)
{
  std::vector<Point> points;
  const std::vector<std::array<Point, 3>> fans = FansOf(cell);
  const Point middle = Mean(ToVector(cell->GetPoints()));
  for (int i = 0; i < count; ++i)
  {
    const auto& fan = fans[random.Index(static_cast<int>(fans.size()))];
    const Point x = InSimplex({ middle, fan[0], fan[1], fan[2] }, random);
    if (IsWithin(fans, x, 10 * std::sqrt(cell->GetLength2())))
    {
      points.push_back(x);
    }
  }
  return points;
}

std::vector<Point> PointsOf(vtkCell* cell, int count, Random& random)
{
  if (cell->GetCellType() == VTK_POLYHEDRON)
  {
    return PointsOfPolyhedron(cell, count, random);
  }
  std::vector<Point> points(count);
  std::vector<double> weights(cell->GetNumberOfPoints());
  for (Point& x : points)
  {
    int subId = 0;
    const Point pcoords = RandomPCoords(cell->GetCellType(), random);
    cell->EvaluateLocation(subId, pcoords.data(), x.data(), weights.data());
  }
  return points;
}

/// The cells whose data are interpolated linearly: those of VTK's linear types.
bool IsTried(vtkCell* cell)
{
  switch (cell->GetCellType())
  {
    case VTK_TRIANGLE:
    case VTK_QUAD:
    case VTK_TETRA:
    case VTK_HEXAHEDRON:
    case VTK_VOXEL:
    case VTK_WEDGE:
    case VTK_PYRAMID:
    case VTK_POLYHEDRON:
      return true;
    default:
      return false;
  }
}

std::vector<Point> PointsOfEveryCell(vtkDataSet* mesh, int each)
{
  Random random(77);
  std::vector<Point> all;
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
  {
    FetchCell(mesh, id, cell);
    if (IsTried(cell))
    {
      const std::vector<Point> some = PointsOf(cell->GetRepresentativeCell(), each, random);
      all.insert(all.end(), some.begin(), some.end());
    }
  }
  return all;
}

/// Each coordinate as a field: what is interpolated at x is x.
void AddCoordinates(vtkDataSet* mesh)
{
  vtkNew<vtkDoubleArray> where;
  where->SetName("Where");
  where->SetNumberOfComponents(3);
  where->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    where->SetTuple(i, mesh->GetPoint(i));
  }
  mesh->GetPointData()->Initialize();
  mesh->GetCellData()->Initialize();
  mesh->GetPointData()->AddArray(where);
}

/// Which points have an answer of a filter of VTK's.
template <class Filter>
std::vector<double> ValidByVtk(vtkDataSet* points, vtkDataSet* mesh)
{
  vtkNew<Filter> filter;
  filter->SetInputData(points);
  filter->SetSourceData(mesh);
  filter->Update();
  return PointArray(filter->GetOutputDataObject(0), "vtkValidPointMask");
}

/// Of how many points they have an answer and we have none.
int CountMissed(const std::vector<double>& ours, const std::vector<double>& theirs)
{
  int missed = 0;
  for (std::size_t i = 0; i < ours.size(); ++i)
  {
    missed += theirs[i] == 1 && ours[i] != 1;
  }
  return missed;
}

class EveryCell
{
public:
  EveryCell(vtkDataSet* mesh, int each)
    : Mesh(mesh)
    , Points(PointsOfEveryCell(mesh, each))
  {
    AddCoordinates(mesh);
    Bounds box;
    mesh->GetBounds(box.data());
    this->Size = Scale(box);
  }

  void Check()
  {
    if (this->Points.empty())
    {
      return;
    }
    skdtest::Mesh queries;
    queries.Points = this->Points;
    const GridPointer input = MakeGrid(queries);
    ProbePointer probe = MakeProbe(input, this->Mesh);
    probe->SetRelativeTolerance(0.0);
    const std::vector<double> isValid = ProbeArray(probe, "SkdValid");
    ASSERT_EQ(isValid.size(), this->Points.size());
    EXPECT_EQ(std::count(isValid.begin(), isValid.end(), 0), 0);
    this->CheckPositions(probe);
  }

  /// VTK's filters take their time: not all points are compared. Some are near the mesh, not in it;
  /// but not near polyhedra, as vtkPolyhedron takes many points for its own that are outside.
  void CompareWithVtk()
  {
    const double away = this->HasPolyhedra() ? 0.0 : 1e-3 * this->Size;
    Random random(78);
    skdtest::Mesh queries;
    for (std::size_t i = 0; i < this->Points.size(); i += 1 + this->Points.size() / 4000)
    {
      queries.Points.push_back(this->Points[i] + (i % 3) * away * random.Direction());
    }
    const GridPointer input = MakeGrid(queries);
    const std::vector<double> ours = ProbeArray(MakeProbe(input, this->Mesh), "SkdValid");
    EXPECT_EQ(CountMissed(ours, ValidByVtk<vtkProbeFilter>(input, this->Mesh)), 0);
    EXPECT_EQ(CountMissed(ours, ValidByVtk<vtkResampleWithDataSet>(input, this->Mesh)), 0);
  }

private:
  bool HasPolyhedra() const
  {
    for (vtkIdType cell = 0; cell < this->Mesh->GetNumberOfCells(); ++cell)
    {
      if (this->Mesh->GetCellType(cell) == VTK_POLYHEDRON)
      {
        return true;
      }
    }
    return false;
  }

  void CheckPositions(vtkSkdTreeProbe* probe)
  {
    const std::vector<double> isValid = ProbeArray(probe, "SkdValid");
    const std::vector<double> where = ProbeArray(probe, "Where");
    const std::vector<double> cells = ProbeArray(probe, "SkdSourceCellId");
    const std::vector<double> pcoords = ProbeArray(probe, "SkdParametricCoordinates");
    double worst = 0.0;
    double worstByVtk = 0.0;
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      if (isValid[i] == 1)
      {
        const Point found = { where[3 * i], where[3 * i + 1], where[3 * i + 2] };
        const Point p = { pcoords[3 * i], pcoords[3 * i + 1], pcoords[3 * i + 2] };
        worst = std::max(worst, Distance(found, this->Points[i]));
        worstByVtk = std::max(
          worstByVtk, this->DistanceByVtk(static_cast<vtkIdType>(cells[i]), p, this->Points[i]));
      }
    }
    EXPECT_LE(worst, 1e-12 * this->Size);
    EXPECT_LE(worstByVtk, 1e-12 * this->Size);
  }

  /// Of x from where VTK's cell has these parametric coordinates, which must be in its domain; of a
  /// polyhedron, which has its bounds' instead, none.
  double DistanceByVtk(vtkIdType id, Point pcoords, const Point& x)
  {
    FetchCell(this->Mesh, id, this->Cell);
    if (this->Cell->GetCellType() == VTK_POLYHEDRON)
    {
      return 0.0;
    }
    EXPECT_LE(this->Cell->GetParametricDistance(pcoords.data()), 1e-12);
    int subId = 0;
    Point found;
    std::vector<double> weights(this->Cell->GetNumberOfPoints());
    this->Cell->EvaluateLocation(subId, pcoords.data(), found.data(), weights.data());
    return Distance(found, x);
  }

  vtkDataSet* Mesh;
  std::vector<Point> Points;
  double Size;
  vtkNew<vtkGenericCell> Cell;
};

class ProbeEveryCellOfFile : public OnFile
{
};

INSTANTIATE_TEST_SUITE_P(
  Shipped, ProbeEveryCellOfFile, testing::ValuesIn(VolumeFiles(DataFolder())), NameOfFile());
INSTANTIATE_TEST_SUITE_P(
  Extra, ProbeEveryCellOfFile, testing::ValuesIn(VolumeFiles(ExtraDataFolder())), NameOfFile());

TEST_P(ProbeEveryCellOfFile, IsFound)
{
  const DataSetPointer mesh = ReadMesh(GetParam());
  ASSERT_NE(mesh, nullptr);
  EveryCell test(mesh, 4);
  test.Check();
  test.CompareWithVtk();
}

class ProbeEveryCellOfMesh : public testing::TestWithParam<NamedMesh>
{
};

INSTANTIATE_TEST_SUITE_P(
  All, ProbeEveryCellOfMesh, testing::ValuesIn(VolumeMeshes()), NameOfMesh());

TEST_P(ProbeEveryCellOfMesh, IsFound)
{
  EveryCell(GetParam().Make(), 20).Check();
}

}
