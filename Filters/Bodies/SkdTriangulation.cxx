// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bodies/SkdTriangulation.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace skdtree
{
namespace
{
/// Coordinates whose products of four would overflow or underflow are scaled by a power of two,
/// which changes no angle.
void ScaleIntoRange(vtkPoints* points)
{
  constexpr double least = 1e-60;
  constexpr double largest = 1e60;
  double extent = 0.0;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double x[3];
    points->GetPoint(i, x);
    extent = std::max({ extent, std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) });
  }
  if ((extent < least || extent > largest) && extent > 0.0)
  {
    int exponent = 0;
    std::frexp(extent, &exponent);
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      double x[3];
      points->GetPoint(i, x);
      points->SetPoint(
        i, std::ldexp(x[0], -exponent), std::ldexp(x[1], -exponent), std::ldexp(x[2], -exponent));
    }
  }
}
}

SkdTriangulation::SkdTriangulation()
{
  this->Polygon->Points->SetDataTypeToDouble();
}

vtkIdList* SkdTriangulation::CutPolygon(vtkIdType size)
{
  this->Triangles->Reset();
  if (size > 3)
  {
    ScaleIntoRange(this->Polygon->Points);
  }
  if (size == 4)
  {
    this->AddFan(size, this->GetFirstOfQuad());
  }
  else if (size < 4 || !this->ClipEars(size))
  {
    this->AddFan(size, 0); // also of a polygon that crosses itself, say
  }
  return this->Triangles;
}

void SkdTriangulation::AddFan(vtkIdType size, vtkIdType first)
{
  for (vtkIdType i = 1; i + 1 < size; ++i)
  {
    for (const vtkIdType corner : { vtkIdType(0), i, i + 1 })
    {
      this->Triangles->InsertNextId((first + corner) % size);
    }
  }
}

// The corner 0 or 1 that the cut starts from. A diagonal lies within when the triangles on its
// sides turn the same way.
vtkIdType SkdTriangulation::GetFirstOfQuad() const
{
  double p[4][3];
  for (int i = 0; i < 4; ++i)
  {
    this->Polygon->Points->GetPoint(i, p[i]);
  }
  const auto isWithin = [&](int a, int b, int c, int d)
  {
    double ab[3], ac[3], ad[3], left[3], right[3];
    vtkMath::Subtract(p[b], p[a], ab);
    vtkMath::Subtract(p[c], p[a], ac);
    vtkMath::Subtract(p[d], p[a], ad);
    vtkMath::Cross(ab, ac, left);
    vtkMath::Cross(ac, ad, right);
    return vtkMath::Dot(left, right) > 0.0;
  };
  const bool is02 = isWithin(0, 1, 2, 3);
  const bool is13 = isWithin(1, 2, 3, 0);
  if (is02 != is13)
  {
    return is02 ? 0 : 1;
  }
  const double diagonal02 = vtkMath::Distance2BetweenPoints(p[0], p[2]);
  return diagonal02 <= vtkMath::Distance2BetweenPoints(p[1], p[3]) ? 0 : 1;
}

bool SkdTriangulation::ClipEars(vtkIdType size)
{
  this->Polygon->PointIds->SetNumberOfIds(size);
  std::iota(this->Polygon->PointIds->begin(), this->Polygon->PointIds->end(), 0);
  const bool isCut = this->Polygon->Triangulate(0, this->Triangles, this->Unused) &&
    this->Triangles->GetNumberOfIds() == 3 * (size - 2);
  if (!isCut)
  {
    this->Triangles->Reset();
  }
  return isCut;
}

std::vector<SkdTriangleIds> SkdSurfaceTriangles(vtkPolyData* surface)
{
  std::vector<SkdTriangleIds> triangles(surface->GetNumberOfCells());
  vtkNew<vtkIdList> ids;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    surface->GetPolys()->GetCellAtId(static_cast<vtkIdType>(i), ids);
    std::copy_n(ids->GetPointer(0), 3, triangles[i].begin());
  }
  return triangles;
}

std::vector<skd::Vector3> SkdSurfacePoints(vtkPolyData* surface)
{
  std::vector<skd::Vector3> points(surface->GetNumberOfPoints());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    surface->GetPoint(static_cast<vtkIdType>(i), points[i].X);
  }
  return points;
}
}
