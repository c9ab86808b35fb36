// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdCutPlane.h"

#include "Core/Geometry/Box.h"
#include "Pipeline/SkdShownElements.h"
#include "vtkCellArray.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
/// Of shown points that are finite; empty if there are none.
skd::Box3 BoundsOf(const std::vector<SkdBlock>& blocks)
{
  skd::Box3 bounds;
  for (const SkdBlock& block : blocks)
  {
    bounds.Add(SkdShownBounds(block.Mesh));
  }
  return bounds;
}

/// Of length 1, or 0. Axes stay axes.
skd::Vector3 Normalized(const skd::Vector3& normal)
{
  const double largest =
    std::max({ std::abs(normal[0]), std::abs(normal[1]), std::abs(normal[2]) });
  if (largest == 0.0)
  {
    return {};
  }
  const skd::Vector3 scaled{ { normal[0] / largest, normal[1] / largest, normal[2] / largest } };
  return (1.0 / Norm(scaled)) * scaled;
}

/// The point of a plane that is nearest to `centre`, with the exact coordinate of a plane that is
/// normal to an axis; of one farther than `farthest`, that in a plane there.
skd::Vector3 FindMiddle(const skd::Vector3& centre, double farthest, const skd::Vector3& origin,
  const skd::Vector3& normal)
{
  const double height = Dot(normal, origin - centre);
  if (!(std::abs(height) <= farthest)) // also if it is not finite
  {
    const bool isBehind = height < 0.0 || (std::isnan(height) && Dot(normal, origin) < 0.0);
    return centre + (isBehind ? -farthest : farthest) * normal;
  }
  const skd::Vector3 toCentre = centre - origin;
  return origin + (toCentre - Dot(normal, toCentre) * normal);
}

/// Corners of a triangle that faces along a normal, about a circle.
std::vector<skd::Vector3> MakeCorners(
  const skd::Vector3& middle, const skd::Vector3& normal, double radius)
{
  skd::Vector3 axis{};
  int least = 0;
  for (int i = 1; i < 3; ++i)
  {
    least = std::abs(normal[i]) < std::abs(normal[least]) ? i : least;
  }
  axis[least] = 1.0;
  const skd::Vector3 first = Normalized(Cross(normal, axis));
  const skd::Vector3 second = Cross(normal, first);
  const double half = std::sqrt(0.75);
  return { middle + (2.0 * radius) * first, middle + (2.0 * radius) * (half * second - 0.5 * first),
    middle - (2.0 * radius) * (half * second + 0.5 * first) };
}

vtkSmartPointer<vtkPolyData> MakeSurface(const std::vector<skd::Vector3>& corners)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const skd::Vector3& x : corners)
  {
    points->InsertNextPoint(x.X);
  }
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 2 });
  if (corners.size() > 3)
  {
    triangles->InsertNextCell({ 1, 0, 3 });
    triangles->InsertNextCell({ 2, 1, 3 });
    triangles->InsertNextCell({ 0, 2, 3 });
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  return surface;
}
}

vtkPolyData* SkdCutPlane::Update(const std::vector<SkdBlock>& blocks, const skd::Vector3& origin,
  const skd::Vector3& normal, bool isClosed)
{
  skd::Box3 bounds = BoundsOf(blocks);
  if (bounds.IsEmpty())
  {
    bounds = { origin, origin };
  }
  const skd::Vector3 extent = bounds.Max - bounds.Min;
  const double longest = std::max({ extent[0], extent[1], extent[2] });
  const double size = longest > 0.0 ? 2.0 * longest : 1.0; // more than the diagonal
  const skd::Vector3 unit = Normalized(normal);
  const skd::Vector3 middle = FindMiddle(bounds.Centroid(), size, origin, unit);
  // The circle is twice as large as needed: so far behind the plane as anything can be, 1.5 times
  // the size, three quarters of it are within the tetrahedron.
  std::vector<skd::Vector3> corners = MakeCorners(middle, unit, size);
  if (isClosed)
  {
    corners.push_back(middle - (6.0 * size) * unit);
  }
  if (Norm(unit) == 0.0 || !std::all_of(corners.begin(), corners.end(), skd::IsFinite<3>))
  {
    return nullptr;
  }
  if (!this->Surface || corners != this->Corners)
  {
    this->Corners = corners;
    this->Surface = MakeSurface(corners);
  }
  return this->Surface;
}
}
