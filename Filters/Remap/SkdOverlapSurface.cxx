// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdOverlapSurface.h"

#include "Pipeline/SkdJoinedShape.h"
#include "Pipeline/SkdShownElements.h"
#include "Remap/SkdRemapTolerances.h"

#include "Core/Geometry/Box.h"

#include "vtkDataSet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace skdtree
{
namespace
{
using skd::Vector3;

Vector3 PointOf(vtkDataSet* data, vtkIdType id)
{
  Vector3 x;
  data->GetPoint(id, x.X);
  return x;
}

/// Calls visit(x) for each point that is shown.
template <class Visit>
void VisitPoints(vtkDataSet* data, const Visit& visit)
{
  const SkdShown shown(data, vtkDataObject::POINT);
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
  {
    if (shown.Has(id))
    {
      visit(PointOf(data, id));
    }
  }
}

/// Of points that are finite.
void AddPoints(skd::Box3& box, vtkDataSet* data)
{
  VisitPoints(data,
    [&box](const Vector3& x)
    {
      if (IsFinite(x))
      {
        box.Add(x);
      }
    });
}

double FarthestFrom(vtkDataSet* data, const Vector3& origin, const Vector3& normal)
{
  double farthest = 0.0;
  VisitPoints(data,
    [&](const Vector3& x) { farthest = std::max(farthest, std::abs(Dot(x - origin, normal))); });
  return farthest;
}
}

//------------------------------------------------------------------------------
SkdOverlapSurface::SkdOverlapSurface(
  vtkDataSet* donor, vtkDataSet* target, const SkdOverlapSettings& settings)
  : Space(settings.Space)
  , Facets(settings.Facets)
{
  if (this->Space == SkdOverlapSpace::Plane)
  {
    this->FindPlane(donor, target);
  }
  else if (this->Space == SkdOverlapSpace::Sphere)
  {
    this->Radius = settings.Radius > 0.0 ? settings.Radius : MeanRadiusOf(donor);
    this->MeasureScale = this->Radius * this->Radius;
  }
}

//------------------------------------------------------------------------------
// A plane across an axis takes coordinates as they are; others are seen from the middle.
void SkdOverlapSurface::FindPlane(vtkDataSet* donor, vtkDataSet* target)
{
  skd::Box3 box;
  AddPoints(box, donor);
  AddPoints(box, target);
  const double tolerance = remap_tolerances::OutOfPlane * box.Diagonal();
  for (int axis = 2; axis >= 0; --axis)
  {
    if (!box.IsEmpty() && box.Length(axis) == 0.0)
    {
      this->Normal = { { 0.0, 0.0, 0.0 } };
      this->Normal[axis] = 1.0;
      this->Origin[axis] = box.Min[axis];
      this->Axes[0] = { { axis == 0 ? 0.0 : 1.0, axis == 0 ? 1.0 : 0.0, 0.0 } };
      this->Axes[1] = Cross(this->Normal, this->Axes[0]);
      return;
    }
  }
  Vector3 normal = SkdPlaneNormalOf(donor);
  const Vector3 other = SkdPlaneNormalOf(target);
  normal = Norm2(normal) >= Norm2(other) ? normal : other;
  if (!(Norm2(normal) > 0.0))
  {
    this->SetAxes({ { 0.0, 0.0, 1.0 } }); // no cell has an area: none will overlap
    return;
  }
  this->Origin = box.Centroid();
  this->SetAxes((1.0 / Norm(normal)) * normal);
  const double farthest = std::max(FarthestFrom(donor, this->Origin, this->Normal),
    FarthestFrom(target, this->Origin, this->Normal));
  if (!(farthest <= tolerance))
  {
    this->Problem = "The meshes are not in one plane: points are off it by up to " +
      std::to_string(farthest / box.Diagonal()) +
      " of the diagonal. Choose the sphere for cells on a sphere about the origin, the volume for "
      "volume cells, or the curved surface for surfaces that nearly coincide.";
  }
}

//------------------------------------------------------------------------------
void SkdOverlapSurface::SetAxes(const Vector3& normal)
{
  this->Normal = normal;
  int least = 0;
  for (int axis = 1; axis < 3; ++axis)
  {
    least = std::abs(normal[axis]) < std::abs(normal[least]) ? axis : least;
  }
  Vector3 aside{ { 0.0, 0.0, 0.0 } };
  aside[least] = 1.0;
  const Vector3 first = Cross(aside, normal);
  this->Axes[0] = (1.0 / Norm(first)) * first;
  this->Axes[1] = Cross(normal, this->Axes[0]);
}

//------------------------------------------------------------------------------
double SkdOverlapSurface::MeanRadiusOf(vtkDataSet* donor)
{
  const auto whole = SkdJoinedShape::Of(donor);
  double sum = whole ? whole->SumOfRadii : 0.0;
  vtkIdType count = whole ? whole->PointsOffOrigin : 0;
  if (!whole)
  {
    VisitPoints(donor,
      [&](const Vector3& x)
      {
        const double distance = Norm(x);
        const bool isSome = distance > 0.0 && std::isfinite(distance);
        sum += isSome ? distance : 0.0;
        count += isSome;
      });
  }
  const double mean = count > 0 ? sum / static_cast<double>(count) : 1.0;
  // Points of a unit sphere are rounded: their mean is not to scale areas.
  return std::abs(mean - 1.0) < remap_tolerances::UnitRadius ? 1.0 : mean;
}

//------------------------------------------------------------------------------
Vector3 SkdOverlapSurface::Project(const Vector3& x) const
{
  if (this->Space == SkdOverlapSpace::Plane)
  {
    const Vector3 offset = x - this->Origin;
    return { { Dot(offset, this->Axes[0]), Dot(offset, this->Axes[1]), 0.0 } };
  }
  return this->Space == SkdOverlapSpace::Sphere ? (1.0 / Norm(x)) * x : x;
}

//------------------------------------------------------------------------------
Vector3 SkdOverlapSurface::Unproject(const Vector3& projected) const
{
  if (this->Space == SkdOverlapSpace::Plane)
  {
    return this->Origin + (projected[0] * this->Axes[0] + projected[1] * this->Axes[1]);
  }
  return this->Radius * projected;
}

//------------------------------------------------------------------------------
Vector3 SkdOverlapSurface::Moment(const Vector3& projected) const
{
  if (this->Space == SkdOverlapSpace::Plane)
  {
    return projected[0] * this->Axes[0] + projected[1] * this->Axes[1];
  }
  return (this->MeasureScale * this->Radius) * projected;
}
}
