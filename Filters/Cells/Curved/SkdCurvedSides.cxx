// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Curved/SkdCurvedSides.h"

#include "Cells/Kernels/SkdParametricCell.h"
#include "Cells/Read/SkdCountedPoints.h"
#include "Cells/Read/SkdTolerances.h"
#include "Core/Geometry/Cells/LinearShapes.h"
#include "Core/Geometry/Distance/ClosestPointOnSegment.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkPoints.h"

#include <algorithm>

namespace skdtree
{
namespace
{
using skd::Vector3;

Vector3 PointOf(vtkCell* cell, vtkIdType i)
{
  Vector3 x;
  cell->GetPoints()->GetPoint(i, x.X);
  return x;
}

Vector3 AsVector(const double (&x)[3])
{
  return { { x[0], x[1], x[2] } };
}

/// At parameters (r, s) of a face the shares of its corners: of a triangle linear, else bilinear.
std::array<double, 4> SharesAt(int size, double r, double s)
{
  return size == 3
    ? std::array<double, 4>{ 1.0 - r - s, r, s, 0.0 }
    : std::array<double, 4>{ (1.0 - r) * (1.0 - s), r * (1.0 - s), r * s, (1.0 - r) * s };
}

/// A pyramid's parameters as those in the cube whose top is drawn together.
Vector3 InCube(const Vector3& p)
{
  const double width = 1.0 - p[2];
  return width > 0.0 ? Vector3{ { 0.5 + (p[0] - 0.5) / width, 0.5 + (p[1] - 0.5) / width, p[2] } }
                     : Vector3{ { 0.5, 0.5, 1.0 } };
}
}

//------------------------------------------------------------------------------
SkdShape SkdCurvedSides::ShapeOf(int cellType)
{
  const skd::ParameterDomain* domain = SkdParametricCell::DomainOf(cellType);
  const bool isPyramid = cellType == VTK_QUADRATIC_PYRAMID || cellType == VTK_TRIQUADRATIC_PYRAMID;
  return isPyramid                    ? SkdShape::Pyramid
    : domain == &skd::UnitTetrahedron ? SkdShape::Tetrahedron
    : domain == &skd::UnitPrism       ? SkdShape::Wedge
    : domain == &skd::UnitCube        ? SkdShape::Hexahedron
                                      : SkdShape::None;
}

//------------------------------------------------------------------------------
void SkdCurvedSides::Read(vtkCell* cell)
{
  this->Type = cell->GetCellType();
  this->Shape = ShapeOf(this->Type);
  this->Points.clear();
  this->Triangles.clear();
  switch (this->Shape)
  {
    case SkdShape::Tetrahedron:
      this->ReadSides<skd::Tetrahedron>(cell);
      break;
    case SkdShape::Wedge:
      this->ReadSides<skd::Wedge>(cell);
      break;
    case SkdShape::Pyramid:
      this->ReadSides<skd::Pyramid>(cell);
      break;
    default:
      this->ReadSides<skd::Hexahedron>(cell);
  }
  this->SetMiddle(cell);
}

//------------------------------------------------------------------------------
template <class Linear>
void SkdCurvedSides::ReadSides(vtkCell* cell)
{
  const SkdCountedPoints counted(cell);
  this->Sides.resize(static_cast<std::size_t>(cell->GetNumberOfFaces()));
  for (std::size_t i = 0; i < this->Sides.size(); ++i)
  {
    Side& side = this->Sides[i];
    this->ReadSide(cell->GetFace(static_cast<int>(i)), side);
    side.IsReversed = IsReversed<Linear>(side);
  }
}

/// By the first edge, which the linear face has in one direction or in the other.
template <class Linear>
bool SkdCurvedSides::IsReversed(const Side& side)
{
  for (const auto& face : Linear::Faces)
  {
    const int size = face[3] < 0 ? 3 : 4;
    const int* at = std::find(face, face + size, side.Corners[0]);
    const bool isThis = size == side.Size && at != face + size &&
      std::all_of(side.Corners, side.Corners + size,
        [&](int corner) { return std::find(face, face + size, corner) != face + size; });
    if (isThis)
    {
      return face[(at - face + 1) % size] != side.Corners[1];
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void SkdCurvedSides::ReadSide(vtkCell* face, Side& side)
{
  side.Size = face->GetNumberOfEdges();
  side.NumberOfPoints = static_cast<int>(face->GetNumberOfPoints());
  for (int k = 0; k < side.Size; ++k)
  {
    side.Corners[k] = static_cast<int>(face->GetPointId(k));
  }
  const Vector3 origin = PointOf(face, 0);
  const SkdParametricCell map(face, origin);
  for (int j = 0; j <= Parts; ++j)
  {
    for (int i = 0; i <= (side.Size == 3 ? Parts - j : Parts); ++i)
    {
      constexpr double part = 1.0 / Parts;
      side.X[i][j] = origin + map.Value({ { part * i, part * j, 0.0 } });
    }
  }
  bool isStraight = true;
  for (int edge = 0; edge < side.Size; ++edge)
  {
    isStraight = this->StraightenEdge(side, edge) && isStraight;
  }
  side.IsStraight = isStraight && this->IsInsideStraight(side);
}

//------------------------------------------------------------------------------
// Its ends are taken in a common order, because rounding depends on it.
bool SkdCurvedSides::StraightenEdge(Side& side, int edge) const
{
  const auto at = [&](int k) -> Vector3&
  {
    const int back = Parts - k;
    const int quad[4][2] = { { k, 0 }, { Parts, k }, { back, Parts }, { 0, back } };
    const int triangle[3][2] = { { k, 0 }, { back, k }, { 0, back } };
    const int* gridPoint = side.Size == 3 ? triangle[edge] : quad[edge];
    return side.X[gridPoint[0]][gridPoint[1]];
  };
  const Vector3 start = at(0);
  const Vector3 end = at(Parts);
  const double tolerance = SkdTolerances::StraightSide * Norm(end - start);
  for (int k = 1; k < Parts; ++k)
  {
    if (!(skd::ClosestPointOnSegment(start, end, at(k)).Dist2 <= tolerance * tolerance))
    {
      return false;
    }
  }
  for (int k = 1; k < Parts; ++k)
  {
    const double t = static_cast<double>(k) / Parts;
    at(k) = start < end ? Lerp(start, end, t) : Lerp(end, start, 1.0 - t);
  }
  return true;
}

//------------------------------------------------------------------------------
bool SkdCurvedSides::IsInsideStraight(const Side& side) const
{
  const Vector3 a = side.X[0][0];
  const Vector3 b = side.X[Parts][0];
  const Vector3 c = side.Size == 3 ? side.X[0][Parts] : side.X[Parts][Parts];
  const Vector3 d = side.X[0][Parts];
  const Vector3 normal = Cross(c - a, d - b);
  const double size = std::sqrt(std::max(Norm2(c - a), Norm2(d - b)));
  const double tolerance = SkdTolerances::StraightSide * size;
  const double length = Norm(normal);
  bool isFlat = std::abs(Dot(b - a, normal)) <= tolerance * length;
  bool isBilinear = true;
  for (int j = 0; j <= Parts; ++j)
  {
    for (int i = 0; i <= (side.Size == 3 ? Parts - j : Parts); ++i)
    {
      const auto w =
        SharesAt(side.Size, static_cast<double>(i) / Parts, static_cast<double>(j) / Parts);
      const Vector3& x = side.X[i][j];
      const Vector3 straight =
        side.Size == 3 ? w[0] * a + w[1] * b + w[2] * c : w[0] * a + w[1] * b + w[2] * c + w[3] * d;
      isBilinear = isBilinear && Norm(x - straight) <= tolerance;
      isFlat = isFlat && length > 0.0 && std::abs(Dot(x - a, normal)) <= tolerance * length;
    }
  }
  return isFlat || isBilinear;
}

//------------------------------------------------------------------------------
bool SkdCurvedSides::AreStraight() const
{
  return std::all_of(
    this->Sides.begin(), this->Sides.end(), [](const Side& side) { return side.IsStraight; });
}

//------------------------------------------------------------------------------
Vector3 SkdCurvedSides::ReferenceOf(int corner) const
{
  switch (this->Shape)
  {
    case SkdShape::Tetrahedron:
      return AsVector(skd::Tetrahedron::Corners[corner]);
    case SkdShape::Wedge:
      return AsVector(skd::Wedge::Corners[corner]);
    case SkdShape::Pyramid:
      return corner < 4 ? AsVector(skd::Pyramid::Corners[corner]) : Vector3{ { 0.5, 0.5, 1.0 } };
    default:
      return AsVector(skd::Hexahedron::Corners[corner]);
  }
}

Vector3 SkdCurvedSides::ReferenceAt(const Side& side, int i, int j) const
{
  const auto w =
    SharesAt(side.Size, static_cast<double>(i) / Parts, static_cast<double>(j) / Parts);
  Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (int k = 0; k < side.Size; ++k)
  {
    sum = sum + w[static_cast<std::size_t>(k)] * this->ReferenceOf(side.Corners[k]);
  }
  return sum;
}

Vector3 SkdCurvedSides::ToVTK(const Vector3& reference) const
{
  return SkdParametricCell::ToVTK(
    this->Type, this->Shape == SkdShape::Pyramid ? InCube(reference) : reference);
}

void SkdCurvedSides::SetMiddle(vtkCell* cell)
{
  const int corners = SkdNumberOfPoints(this->Shape);
  Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (int i = 0; i < corners; ++i)
  {
    sum = sum + this->ReferenceOf(i);
  }
  this->Middle.Reference = (1.0 / corners) * sum;
  const Vector3 origin = PointOf(cell, 0);
  const SkdParametricCell map(cell, origin);
  const bool isPyramid = this->Shape == SkdShape::Pyramid;
  this->Middle.X =
    origin + map.Value(isPyramid ? InCube(this->Middle.Reference) : this->Middle.Reference);
}

//------------------------------------------------------------------------------
void SkdCurvedSides::Cut(bool isFine)
{
  this->Points.clear();
  this->Triangles.clear();
  for (const Side& side : this->Sides)
  {
    if (side.IsStraight)
    {
      const int parts = side.NumberOfPoints <= 9 ? 2 : (side.NumberOfPoints <= 25 ? 4 : Parts);
      this->CutStraight(side, isFine ? parts : 1);
    }
    else
    {
      this->CutCurved(side);
    }
  }
}

//------------------------------------------------------------------------------
void SkdCurvedSides::Add(const Side& side, int a, int b, int c)
{
  this->Triangles.push_back(side.IsReversed ? Triangle{ { a, c, b } } : Triangle{ { a, b, c } });
}

/// A lattice of points at(i, j), i + j up to `parts`.
template <class At>
void SkdCurvedSides::AddTriangle(const Side& side, int parts, const At& at)
{
  const auto first = static_cast<int>(this->Points.size());
  const auto number = [&](int i, int j) { return first + j * (parts + 1) - j * (j - 1) / 2 + i; };
  for (int j = 0; j <= parts; ++j)
  {
    for (int i = 0; i + j <= parts; ++i)
    {
      this->Points.push_back(at(i, j));
      if (i + j < parts)
      {
        this->Add(side, number(i, j), number(i + 1, j), number(i, j + 1));
      }
      if (i + j + 1 < parts)
      {
        this->Add(side, number(i + 1, j), number(i + 1, j + 1), number(i, j + 1));
      }
    }
  }
}

void SkdCurvedSides::CutStraight(const Side& side, int parts)
{
  Point corners[4];
  Point mean{ { { 0.0, 0.0, 0.0 } }, { { 0.0, 0.0, 0.0 } } };
  for (int k = 0; k < side.Size; ++k)
  {
    const int gridPoints[4][2] = { { 0, 0 }, { Parts, 0 }, { Parts, Parts }, { 0, Parts } };
    const int* gridPoint = gridPoints[side.Size == 3 && k == 2 ? 3 : k];
    corners[k] = { side.X[gridPoint[0]][gridPoint[1]], this->ReferenceOf(side.Corners[k]) };
    mean.X = mean.X + (1.0 / side.Size) * (corners[k].X - corners[0].X);
    mean.Reference = mean.Reference + (1.0 / side.Size) * corners[k].Reference;
  }
  mean.X = corners[0].X + mean.X;
  for (int k = 0; k < (side.Size == 3 ? 1 : 4); ++k)
  {
    const Point& a = corners[k];
    const Point& b = corners[(k + 1) % 4];
    const Point& c = side.Size == 3 ? corners[2] : mean;
    this->AddTriangle(side, parts,
      [&](int i, int j)
      {
        const double r = static_cast<double>(i) / parts;
        const double s = static_cast<double>(j) / parts;
        return Point{ a.X + (r * (b.X - a.X) + s * (c.X - a.X)),
          a.Reference + (r * (b.Reference - a.Reference) + s * (c.Reference - a.Reference)) };
      });
  }
}

//------------------------------------------------------------------------------
void SkdCurvedSides::CutCurved(const Side& side)
{
  const auto at = [&](int i, int j) {
    return Point{ side.X[i][j], this->ReferenceAt(side, i, j) };
  };
  if (side.Size == 3)
  {
    this->AddTriangle(side, Parts, at);
    return;
  }
  const auto first = static_cast<int>(this->Points.size());
  const auto number = [&](int i, int j) { return first + j * (Parts + 1) + i; };
  for (int j = 0; j <= Parts; ++j)
  {
    for (int i = 0; i <= Parts; ++i)
    {
      this->Points.push_back(at(i, j));
    }
  }
  for (int j = 0; j < Parts; ++j)
  {
    for (int i = 0; i < Parts; ++i)
    {
      const int p[4] = { number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1) };
      const int from = (2 * i < Parts) == (2 * j < Parts) ? 0 : 1; // of the diagonal
      this->Add(side, p[from], p[from + 1], p[from + 2]);
      this->Add(side, p[from], p[from + 2], p[(from + 3) % 4]);
    }
  }
}
}
