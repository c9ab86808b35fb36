// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdOverlapSurface.h"

#include "Remap/SkdRemapTolerances.h"

#include "Core/Geometry/Box.h"
#include "Core/Geometry/Polygons/PlanarPolygon.h"

#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
using skd::Vector3;

Vector3 PointOf(vtkDataSet* data, vtkIdType id)
{
  Vector3 x;
  data->GetPoint(id, x.X);
  return x;
}

/// Of points that are finite.
void AddPoints(skd::Box3& box, vtkDataSet* data)
{
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
  {
    const Vector3 x = PointOf(data, id);
    if (IsFinite(x))
    {
      box.Add(x);
    }
  }
}

/// The normal of the plane through the first three corners of a cell, twice as long as their
/// triangle's area: of those of the first thousand cells the longest, whose direction rounding
/// changes least. Any cell of a mesh in a plane would do; that all points lie in it is tested
/// after.
Vector3 PlaneNormalOf(vtkDataSet* data)
{
  constexpr vtkIdType mostCells = 1000; // enough to meet one that is no sliver
  Vector3 largest{ { 0.0, 0.0, 0.0 } };
  vtkNew<vtkIdList> ids;
  std::vector<Vector3> points;
  const vtkIdType last = std::min(data->GetNumberOfCells(), mostCells);
  for (vtkIdType cell = 0; cell < last; ++cell)
  {
    data->GetCellPoints(cell, ids);
    points.clear();
    for (vtkIdType i = 0; i < std::min<vtkIdType>(ids->GetNumberOfIds(), 3); ++i)
    {
      points.push_back(PointOf(data, ids->GetId(i)));
    }
    if (points.size() == 3)
    {
      const Vector3 normal = skd::PolygonPlane(points, 3).Normal;
      largest = Norm2(normal) > Norm2(largest) ? normal : largest;
    }
  }
  return largest;
}

double FarthestFrom(vtkDataSet* data, const Vector3& origin, const Vector3& normal)
{
  double farthest = 0.0;
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
  {
    farthest = std::max(farthest, std::abs(Dot(PointOf(data, id) - origin, normal)));
  }
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
    this->FindRadius(donor, settings.Radius);
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
  Vector3 normal = PlaneNormalOf(donor);
  const Vector3 other = PlaneNormalOf(target);
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
void SkdOverlapSurface::FindRadius(vtkDataSet* donor, double wanted)
{
  this->Radius = wanted;
  if (!(wanted > 0.0))
  {
    double sum = 0.0;
    vtkIdType count = 0;
    for (vtkIdType id = 0; id < donor->GetNumberOfPoints(); ++id)
    {
      const double distance = Norm(PointOf(donor, id));
      const bool isSome = distance > 0.0 && std::isfinite(distance);
      sum += isSome ? distance : 0.0;
      count += isSome;
    }
    this->Radius = count > 0 ? sum / static_cast<double>(count) : 1.0;
    // Points of a unit sphere are rounded: their mean is not to scale areas.
    this->Radius = std::abs(this->Radius - 1.0) < remap_tolerances::UnitRadius ? 1.0 : this->Radius;
  }
  this->MeasureScale = this->Radius * this->Radius;
}

//------------------------------------------------------------------------------
Vector3 SkdOverlapSurface::Seen(const Vector3& x) const
{
  if (this->Space == SkdOverlapSpace::Plane)
  {
    const Vector3 way = x - this->Origin;
    return { { Dot(way, this->Axes[0]), Dot(way, this->Axes[1]), 0.0 } };
  }
  return this->Space == SkdOverlapSpace::Sphere ? (1.0 / Norm(x)) * x : x;
}

//------------------------------------------------------------------------------
Vector3 SkdOverlapSurface::Place(const Vector3& seen) const
{
  if (this->Space == SkdOverlapSpace::Plane)
  {
    return this->Origin + (seen[0] * this->Axes[0] + seen[1] * this->Axes[1]);
  }
  return this->Radius * seen;
}

//------------------------------------------------------------------------------
Vector3 SkdOverlapSurface::Moment(const Vector3& seen) const
{
  if (this->Space == SkdOverlapSpace::Plane)
  {
    return seen[0] * this->Axes[0] + seen[1] * this->Axes[1];
  }
  return (this->MeasureScale * this->Radius) * seen;
}
