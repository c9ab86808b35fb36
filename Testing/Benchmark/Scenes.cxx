// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes.h"

#include "Support/SurfaceMeshes.h"
#include "Support/VolumeMeshes.h"

#include "vtkGenericCell.h"

namespace skdbench
{
namespace
{

using namespace skdtest;

/// Numbers the lattice points on the surface of the cube [0, n]^3, layer by layer.
class CubeSurface
{
public:
  explicit CubeSurface(int n)
    : N(n)
  {
  }

  vtkIdType Id(int i, int j, int k) const
  {
    const vtkIdType lid = vtkIdType(this->N + 1) * (this->N + 1);
    if (k == 0)
    {
      return vtkIdType(j) * (this->N + 1) + i;
    }
    const vtkIdType below = lid + vtkIdType(4) * this->N * (k - 1);
    return k == this->N ? below + vtkIdType(j) * (this->N + 1) + i : below + this->Ring(i, j);
  }

  vtkIdType NumberOfPoints() const { return vtkIdType(6) * this->N * this->N + 2; }

private:
  int Ring(int i, int j) const
  {
    const int n = this->N;
    return j == 0 ? i : i == n ? n + j : j == n ? 3 * n - i : 4 * n - j;
  }

  int N;
};

/// From the cube [0, n]^3 to a sphere with bumps, and noise of a third of an edge.
Point Bumpy(const std::array<int, 3>& at, int n, Random& random)
{
  const double quarter = 0.7853981633974483;
  Point out;
  for (int axis = 0; axis < 3; ++axis)
  {
    out[axis] = std::tan(quarter * (2.0 * at[axis] / n - 1.0)); // even angles
  }
  out = (1.0 / Length(out)) * out;
  const double bumps = 0.1 * std::sin(7 * out[0] + 1) * std::cos(5 * out[1]) * std::sin(6 * out[2]);
  return (1.0 + bumps + random.Between(-0.5, 0.5) / n) * out;
}

/// [0, n] onto [0, n], the last step a thousand times the first.
double Graded(double s, double n)
{
  const double rate = std::log(1000.0);
  return n * std::expm1(rate * s / n) / std::expm1(rate);
}

Point GradedPoint(const Point& p, double n)
{
  return { Graded(p[0], n), Graded(p[1], n), Graded(p[2], n) };
}

DataSetPointer GradedSurface(int n)
{
  Mesh sheet = Sheet(n, VTK_TRIANGLE);
  sheet.Map(
    [n](const Point& p)
    {
      const double x = Graded(p[0], n) / n;
      const double y = Graded(p[1], n) / n;
      return Point{ x, y, 0.1 * std::sin(9 * x) * std::cos(7 * y) };
    });
  return MakePolyData(sheet);
}

Scene GridScene(const std::string& name, Mesh (*fill)(int), int n, bool graded)
{
  return { name,
    [=]() -> DataSetPointer
    {
      Mesh mesh = fill(n);
      mesh.Map([=](const Point& p) { return graded ? GradedPoint(p, n) : Rotated(p); });
      return MakeGrid(mesh);
    } };
}

}

vtkSmartPointer<vtkDataSet> NoisySphere(int n)
{
  Random random(3);
  const CubeSurface surface(n);
  Mesh mesh;
  mesh.Points.resize(surface.NumberOfPoints());
  const auto add = [&](const std::array<int, 3>& at)
  {
    const vtkIdType id = surface.Id(at[0], at[1], at[2]);
    if (mesh.Points[id] == Point{})
    {
      mesh.Points[id] = Bumpy(at, n, random);
    }
    return id;
  };
  mesh.Cells.reserve(std::size_t(12) * n * n);
  for (int square = 0; square < 6 * n * n; ++square)
  {
    const int axis = square / (2 * n * n);
    const int side = square / (n * n) % 2;
    const int i = square % n;
    const int j = square / n % n;
    const auto corner = [&](int a, int b)
    {
      std::array<int, 3> at;
      at[axis] = side * n;
      at[(axis + 1) % 3] = i + (side ? a : b);
      at[(axis + 2) % 3] = j + (side ? b : a);
      return add(at);
    };
    const vtkIdType ids[4] = { corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1) };
    mesh.Add(VTK_TRIANGLE, { ids[0], ids[1], ids[2] });
    mesh.Add(VTK_TRIANGLE, { ids[0], ids[2], ids[3] });
  }
  return MakePolyData(mesh);
}

vtkSmartPointer<vtkDataSet> TurnedTetrahedra(int n)
{
  return GridScene("", Tetrahedra, n, false).Make();
}

std::vector<Scene> MadeScenes(Size size)
{
  const auto pick = [size](int tiny, int usual, int large) {
    return size == Size::Tiny ? tiny : size == Size::Usual ? usual : large;
  };
  const int sphere = pick(9, 76, 289);
  const int sheet = pick(20, 190, 708);
  const int points = pick(150, 12000, 150000);
  std::vector<Scene> scenes = {
    { "noisy sphere", [=] { return NoisySphere(sphere); } },
    { "graded surface", [=] { return GradedSurface(sheet); } },
    { "Delaunay tetrahedra", [=] { return DelaunayTetrahedra(points); } },
    GridScene("structured tetrahedra", Tetrahedra, pick(5, 23, 55), false),
    GridScene("graded tetrahedra", Tetrahedra, pick(5, 23, 55), true),
    GridScene("hexahedra", Hexahedra, pick(6, 40, 100), false),
    GridScene("graded mixed cells", MixedCells, pick(5, 25, 60), true),
  };
  if (size == Size::Usual)
  {
    scenes.insert(
      scenes.begin() + 1, { "noisy sphere, out of cache", [] { return NoisySphere(289); } });
  }
  return scenes;
}

void Touch(vtkDataSet* data)
{
  data->ComputeBounds();
  vtkNew<vtkGenericCell> cell;
  double bounds[6];
  for (vtkIdType id = 0; id < data->GetNumberOfCells(); ++id)
  {
    data->GetCell(id, cell);
    data->GetCellBounds(id, bounds);
  }
}

}
