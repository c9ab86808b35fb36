// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdJoinedShape.h"

#include "Cells/Read/SkdCellReader.h"
#include "Core/Geometry/Polygons/PolygonPlane.h"
#include "Pipeline/SkdShownElements.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <vector>

namespace skdtree
{
namespace
{
constexpr const char* Name = "SkdJoinedShape";
constexpr double RadiusSpread = 1e-5; // of the radius: of a sphere, not of a flattened Earth

skd::Vector3 PointOf(vtkDataSet* mesh, vtkIdType id)
{
  skd::Vector3 x;
  mesh->GetPoint(id, x.X);
  return x;
}

bool IsFlat(const skd::Box3& bounds)
{
  return bounds.IsEmpty() || bounds.Length(0) == 0.0 || bounds.Length(1) == 0.0 ||
    bounds.Length(2) == 0.0;
}
}

void SkdJoinedShape::AddPoint(const skd::Vector3& x)
{
  const double radius = Norm(x);
  ++this->Points;
  this->Bounds.Add(x);
  this->LeastRadius = std::min(this->LeastRadius, radius);
  this->GreatestRadius = std::max(this->GreatestRadius, radius);
  if (radius > 0.0 && std::isfinite(radius))
  {
    this->SumOfRadii += radius;
    ++this->PointsOffOrigin;
  }
}

void SkdJoinedShape::AddNormal(const skd::Vector3& normal, vtkIdType id)
{
  const double length2 = Norm2(normal);
  const double known2 = Norm2(this->Normal);
  if (length2 > known2 || (length2 > 0.0 && length2 == known2 && id < this->NormalOf))
  {
    this->Normal = normal;
    this->NormalOf = id;
  }
}

void SkdJoinedShape::Add(const SkdJoinedShape& other)
{
  this->Points += other.Points;
  this->Dimension = std::max(this->Dimension, other.Dimension);
  this->Bounds.Add(other.Bounds);
  this->LeastRadius = std::min(this->LeastRadius, other.LeastRadius);
  this->GreatestRadius = std::max(this->GreatestRadius, other.GreatestRadius);
  this->SumOfRadii += other.SumOfRadii;
  this->PointsOffOrigin += other.PointsOffOrigin;
  this->AddNormal(other.Normal, other.NormalOf);
}

std::optional<double> SkdJoinedShape::GetRadius() const
{
  const bool isSphere = this->Points > 2 && !IsFlat(this->Bounds) &&
    this->GreatestRadius - this->LeastRadius <= RadiusSpread * this->GreatestRadius;
  return isSphere ? std::optional<double>(this->SumOfRadii / static_cast<double>(this->Points))
                  : std::nullopt;
}

void SkdJoinedShape::MoveToSphere(double radius)
{
  const skd::Vector3 corner{ { radius, radius, radius } };
  this->Bounds = { -1.0 * corner, corner };
  this->LeastRadius = this->GreatestRadius = radius;
  this->PointsOffOrigin = this->Points;
  this->SumOfRadii = static_cast<double>(this->Points) * radius;
  this->IsStructured = false;
}

std::optional<SkdJoinedShape> SkdJoinedShape::Of(vtkDataSet* mesh)
{
  static_assert(std::is_trivially_copyable<SkdJoinedShape>::value, "kept as it lies in memory");
  auto* stored = vtkUnsignedCharArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(Name));
  if (!stored)
  {
    return std::nullopt;
  }
  SkdJoinedShape shape;
  std::memcpy(&shape, stored->GetPointer(0), sizeof(shape));
  return shape;
}

void SkdJoinedShape::KeepIn(vtkDataSet* mesh) const
{
  vtkNew<vtkUnsignedCharArray> bytes;
  bytes->SetName(Name);
  bytes->SetNumberOfValues(static_cast<vtkIdType>(sizeof(*this)));
  std::memcpy(bytes->GetPointer(0), this, sizeof(*this));
  mesh->GetFieldData()->AddArray(bytes);
}

std::optional<double> SkdRadiusOf(vtkDataSet* mesh)
{
  if (const auto whole = SkdJoinedShape::Of(mesh))
  {
    return whole->GetRadius();
  }
  double bounds[6];
  mesh->GetBounds(bounds);
  SkdJoinedShape shape;
  const bool isFlat = bounds[0] == bounds[1] || bounds[2] == bounds[3] || bounds[4] == bounds[5];
  const auto isRound = [&shape]()
  { return !(shape.GreatestRadius - shape.LeastRadius > RadiusSpread * shape.GreatestRadius); };
  const SkdShown shown(mesh, vtkDataObject::POINT);
  vtkIdType looked = 0;
  for (; looked < mesh->GetNumberOfPoints() && !isFlat && isRound(); ++looked)
  {
    if (shown.Has(looked))
    {
      shape.AddPoint(PointOf(mesh, looked));
    }
  }
  return looked == mesh->GetNumberOfPoints() ? shape.GetRadius() : std::nullopt;
}

int SkdDimensionOf(vtkDataSet* mesh)
{
  if (const auto whole = SkdJoinedShape::Of(mesh))
  {
    return whole->Dimension;
  }
  int dimension = -1;
  vtkNew<vtkGenericCell> cell;
  const SkdCellReader reader(mesh);
  const SkdShown shown(mesh, vtkDataObject::CELL);
  int known = -1;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells() && dimension < 3; ++i)
  {
    const int type = reader.TypeOf(i);
    if (type != known && type != VTK_EMPTY_CELL && shown.Has(i))
    {
      cell->SetCellType(type);
      dimension = std::max(dimension, cell->GetCellDimension());
      known = type;
    }
  }
  return dimension;
}

skd::Vector3 SkdNormalOfCorners(vtkDataSet* mesh, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(cell, ids);
  std::vector<skd::Vector3> points;
  for (vtkIdType i = 0; i < std::min<vtkIdType>(ids->GetNumberOfIds(), 3); ++i)
  {
    points.push_back(PointOf(mesh, ids->GetId(i)));
  }
  return points.size() == 3 ? skd::PolygonPlane(points, 3).Normal
                            : skd::Vector3{ { 0.0, 0.0, 0.0 } };
}

skd::Vector3 SkdPlaneNormalOf(vtkDataSet* mesh)
{
  if (const auto whole = SkdJoinedShape::Of(mesh))
  {
    return whole->Normal;
  }
  SkdJoinedShape shape;
  const SkdShown shown(mesh, vtkDataObject::CELL);
  for (vtkIdType cell = 0; cell < std::min(mesh->GetNumberOfCells(), SkdCellsForNormal); ++cell)
  {
    if (shown.Has(cell))
    {
      shape.AddNormal(SkdNormalOfCorners(mesh, cell), cell);
    }
  }
  return shape.Normal;
}
}
