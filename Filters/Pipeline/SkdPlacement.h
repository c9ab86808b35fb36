// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPlacement_h
#define SkdPlacement_h

#include "Core/Geometry/RigidMotion.h"
#include "Core/Geometry/TriangleContact.h"
#include "Pipeline/SkdTriangleSet.h"

#include <optional>

/// A set of triangles where it is looked at: its points moved, each rounded once, and scaled by a
/// power of two. What is told of it is exact for these points.
class SkdPlacedTriangles
{
public:
  SkdPlacedTriangles(
    const SkdTriangleSet& set, const std::optional<skd::RigidMotion>& motion, double scale);

  const SkdTriangleSet& GetSet() const { return *this->Set; }
  const std::vector<skd::Vector3>& GetPoints() const { return this->Points; }
  const SkdTriangleSet::Corners& GetCorners(std::uint32_t triangle) const
  {
    return this->Set->GetTriangles()[triangle];
  }

  skd::SeenTriangle Get(std::uint32_t triangle) const
  {
    const SkdTriangleSet::Corners& corners = this->GetCorners(triangle);
    return { { this->Points[corners[0]], this->Points[corners[1]], this->Points[corners[2]] },
      this->Axes[triangle] };
  }

  /// False of a triangle whose corners lie on one line: it is left out.
  bool HasArea(std::uint32_t triangle) const { return this->Axes[triangle] >= 0; }
  vtkIdType CountWithoutArea() const;

private:
  const SkdTriangleSet* Set;
  std::vector<skd::Vector3> Points;
  std::vector<std::int8_t> Axes;
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
