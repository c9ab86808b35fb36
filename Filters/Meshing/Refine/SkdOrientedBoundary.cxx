// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdOrientedBoundary.h"

#include "Bodies/SkdOrientation.h"
#include "Bodies/SkdSignedSource.h"
#include "Core/Geometry/Distance/ClosestPointOnTriangle.h"
#include "Core/Geometry/Measures/MeasureInBox.h"
#include "vtkIdList.h"

#include <algorithm>

namespace skdtree
{
namespace
{
/// A corner of a box that is farther than this from all triangles, relative to the diagonal, is far
/// enough to decide.
constexpr double DistantCorner = 1e-6;
}

//------------------------------------------------------------------------------
SkdOrientedBoundary::SkdOrientedBoundary(const SkdSignedSource& boundary, double epsilon)
  : Boundary(boundary)
  , Surface(boundary.GetSurface())
  , Tree(this->Surface,
      [epsilon]
      {
        SkdTreeSettings settings;
        settings.Epsilon = epsilon;
        return settings;
      }())
  , Reversed(SkdFindReversed(SkdSurfacePoints(this->Surface), SkdSurfaceTriangles(this->Surface),
      [&boundary](const skd::Vector3& x) { return boundary.IsInside(x.X); }))
{
  if (!this->Reversed.empty())
  {
    this->Surface->BuildCells();
  }
}

std::array<skd::Vector3, 3> SkdOrientedBoundary::GetTriangle(vtkIdType triangle) const
{
  vtkIdType size;
  const vtkIdType* ids;
  this->Surface->GetCellPoints(triangle, size, ids);
  std::array<skd::Vector3, 3> corners;
  for (int i = 0; i < 3; ++i)
  {
    this->Surface->GetPoint(ids[i], corners[static_cast<std::size_t>(i)].X);
  }
  return corners;
}

//------------------------------------------------------------------------------
/// Finds a corner of the box that is not on a triangle, or is farthest from them; false if even
/// that is within rounding of one.
bool SkdOrientedBoundary::PutCornerAway(
  const skd::Box3& box, vtkIdList* triangles, unsigned& corner) const
{
  const double enough = DistantCorner * box.Diagonal();
  double farthest2 = -1.0;
  for (unsigned i = 0; i < 8 && farthest2 <= enough * enough; ++i)
  {
    const skd::Vector3 at{ { i & 1u ? box.Max[0] : box.Min[0], i & 2u ? box.Max[1] : box.Min[1],
      i & 4u ? box.Max[2] : box.Min[2] } };
    double nearest2 = std::numeric_limits<double>::max();
    for (vtkIdType k = 0; k < triangles->GetNumberOfIds(); ++k)
    {
      const auto p = this->GetTriangle(triangles->GetId(k));
      nearest2 = std::min(nearest2, skd::ClosestPointOnTriangle(p[0], p[1], p[2], at).Dist2);
    }
    if (nearest2 > farthest2)
    {
      farthest2 = nearest2;
      corner = i;
    }
  }
  return farthest2 > 0.0;
}

double SkdOrientedBoundary::GetFraction(const skd::Box3& box) const
{
  thread_local vtkNew<vtkIdList> triangles;
  this->Tree.FindSafetyBoxesWithin(box, triangles);
  unsigned corner = 0;
  if (triangles->GetNumberOfIds() == 0 || !this->PutCornerAway(box, triangles, corner))
  {
    return this->Boundary.IsInside(box.Centroid().X) ? 1.0 : 0.0;
  }
  skd::MeasureInBox measure(box, corner);
  for (vtkIdType k = 0; k < triangles->GetNumberOfIds(); ++k)
  {
    const vtkIdType triangle = triangles->GetId(k);
    const auto p = this->GetTriangle(triangle);
    const bool isReversed = this->Reversed[static_cast<std::size_t>(triangle)];
    measure.Add(p[0], isReversed ? p[2] : p[1], isReversed ? p[1] : p[2]);
  }
  const skd::Vector3 at{ { corner & 1u ? box.Max[0] : box.Min[0],
    corner & 2u ? box.Max[1] : box.Min[1], corner & 4u ? box.Max[2] : box.Min[2] } };
  double whole = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    whole *= box.Length(axis) > 0.0 ? box.Length(axis) : 1.0;
  }
  return std::clamp(measure.Measure(this->Boundary.IsInside(at.X)) / whole, 0.0, 1.0);
}
}
