// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPlacement_h
#define SkdPlacement_h

#include "Core/Geometry/Intersection/ProjectedTriangle.h"
#include "Core/Geometry/RigidMotion.h"
#include "Solids/Surfaces/SkdTriangleSet.h"

#include <optional>

class vtkObject;

namespace skdtree
{
/// A set of triangles after a placement: its points are moved, rounded once, and scaled by a power
/// of two. Tests are exact for these points.
class SkdMovedTriangles
{
public:
  /// Coordinates that are smaller than `least` (before the scale) become 0.
  SkdMovedTriangles(const SkdTriangleSet& set, const std::optional<skd::RigidMotion>& motion,
    double scale, double least);

  const SkdTriangleSet& GetSet() const { return *this->Set; }
  const SkdTriangleSet::PointList& GetPoints() const
  {
    return this->IsElsewhere ? this->Points : this->Set->GetPoints();
  }
  const SkdTriangleSet::Corners& GetCorners(std::uint32_t triangle) const
  {
    return this->Set->GetTriangles()[triangle];
  }

  std::array<skd::Vector3, 3> GetCornerPoints(std::uint32_t triangle) const
  {
    const SkdTriangleSet::Corners& corners = this->GetCorners(triangle);
    const SkdTriangleSet::PointList& points = this->GetPoints();
    return { points[corners[0]], points[corners[1]], points[corners[2]] };
  }

  skd::ProjectedTriangle Get(std::uint32_t triangle) const
  {
    return skd::ProjectedTriangle(this->GetCornerPoints(triangle));
  }

  skd::TriangleInPlane GetInPlane(std::uint32_t triangle) const
  {
    return skd::TriangleInPlane(this->GetCornerPoints(triangle));
  }

  skd::Box3 GetBox(std::uint32_t triangle) const
  {
    skd::Box3 box;
    for (const skd::Vector3& corner : this->GetCornerPoints(triangle))
    {
      box.Add(corner);
    }
    return box;
  }

  /// False for a degenerate triangle, whose corners are collinear; it is ignored.
  bool HasArea(std::uint32_t triangle) const
  {
    return this->HaveAllArea || this->Get(triangle).Axis >= 0;
  }
  vtkIdType CountWithoutArea() const;

private:
  const SkdTriangleSet* Set;
  bool IsElsewhere;                 // than in the set
  SkdTriangleSet::PointList Points; // there
  bool HaveAllArea;                 // none can have lost it by rounding
};

/// Two surfaces, or one to be intersected with itself.
struct SkdPlacement
{
  SkdMovedTriangles First;
  std::optional<SkdMovedTriangles> Other; ///< none: one alone
  std::optional<skd::RigidMotion> Motion; ///< of the other
  double Scale;                           ///< of both
  bool HasTinyPoints;                     ///< some coordinates of the sets were taken as 0

  bool IsOfOne() const { return !this->Other; }
  const SkdMovedTriangles& GetSecond() const { return this->Other ? *this->Other : this->First; }
  vtkIdType CountWithoutArea() const;
};

/// Places two sets, or with `other` = nullptr one, at a scale at which exact signs are exact.
/// Coordinates for which they would not be, as they are too small beside the largest of both,
/// become 0 (skd::LeastExactCoordinate).
SkdPlacement SkdMakePlacement(const SkdTriangleSet& first, const SkdTriangleSet* other,
  const std::optional<skd::RigidMotion>& motion);

/// Warns of coordinates that were taken as 0.
void SkdWarnAboutTinyPoints(vtkObject* self, const SkdPlacement& placement);
}

#endif
