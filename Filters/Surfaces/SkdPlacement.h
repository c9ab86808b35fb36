// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPlacement_h
#define SkdPlacement_h

#include "Core/Geometry/Intersection/TriangleContact.h"
#include "Core/Geometry/RigidMotion.h"
#include "Surfaces/SkdTriangleSet.h"

#include <optional>

/// A set of triangles where it is looked at: its points moved, each rounded once, and scaled by a
/// power of two. What is told of it is exact for these points.
class SkdPlacedTriangles
{
public:
  SkdPlacedTriangles(
    const SkdTriangleSet& set, const std::optional<skd::RigidMotion>& motion, double scale);

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

  skd::SeenTriangle Get(std::uint32_t triangle) const
  {
    return skd::SeenTriangle(this->GetCornerPoints(triangle));
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

  /// False of a triangle whose corners lie on one line: it is left out.
  bool HasArea(std::uint32_t triangle) const { return this->Get(triangle).Axis >= 0; }
  vtkIdType CountWithoutArea() const;

private:
  const SkdTriangleSet* Set;
  bool IsElsewhere;                 // than in the set
  SkdTriangleSet::PointList Points; // there
  bool HaveAllArea;                 // none can have lost it by rounding
};

/// A surface and another, or one alone that is looked at against itself.
struct SkdPlacement
{
  SkdPlacedTriangles First;
  std::optional<SkdPlacedTriangles> Other; ///< none: one alone
  std::optional<skd::RigidMotion> Motion;  ///< of the other
  double Scale;                            ///< of both

  bool IsOfOne() const { return !this->Other; }
  const SkdPlacedTriangles& GetSecond() const { return this->Other ? *this->Other : this->First; }
  vtkIdType CountWithoutArea() const;
};

/// Places two sets, or with `other` = nullptr one, at a scale at which exact signs are exact.
SkdPlacement SkdPlace(const SkdTriangleSet& first, const SkdTriangleSet* other,
  const std::optional<skd::RigidMotion>& motion);

#endif
