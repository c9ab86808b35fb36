// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSolidAngles_h
#define SkdSolidAngles_h

#include "Surfaces/SkdPlacement.h"

#include <map>
#include <memory>
#include <vector>

/// Winding numbers around points of which each is not on the triangles, by surface.
class SkdSolidAngles
{
public:
  using Numbers = std::map<std::uint32_t, double>; ///< of each surface

  /// Of some triangles, for about so many points: those of few are sums over all triangles, others
  /// found by a tree for each surface.
  SkdSolidAngles(const SkdPlacedTriangles& set, const std::vector<std::uint32_t>& surfaceOf,
    const std::vector<std::uint32_t>& triangles, std::size_t numberOfPoints);
  ~SkdSolidAngles();

  /// Adds the numbers around a point. Thread-safe.
  void Add(const skd::Vector3& x, Numbers& to) const;

private:
  struct Surface;
  std::map<std::uint32_t, std::unique_ptr<Surface>> Surfaces;
  const SkdPlacedTriangles& Set;
  const std::vector<std::uint32_t>& SurfaceOf;
  const std::vector<std::uint32_t>& Triangles;
};

/// Adds the sums of the solid angles of triangles by 4 pi, without those in `leftOut`.
void SkdAddSolidAngles(const SkdPlacedTriangles& set, const std::vector<std::uint32_t>& surfaceOf,
  const std::vector<std::uint32_t>& triangles, const std::vector<std::uint32_t>& leftOut,
  const skd::Vector3& x, SkdSolidAngles::Numbers& to);

#endif
