// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdFlatFace_h
#define SkdFlatFace_h

#include "Solids/Boolean/SkdFacets.h"

#include <optional>

namespace skdtree
{
/// The triangles of a flat face with any holes, given by the edges around it and each hole: it is
/// on their left as seen against `normal`. They have these edges and no other border, turn left by
/// exact signs as seen along the largest axis of the normal, and are a constrained Delaunay
/// triangulation there. Edges around which nothing is on the left but a face on the right have
/// triangles that turn right: with the edges of two faces that are laid on each other, what of each
/// is not covered by the other. None if there are none such, as edges cross or points coincide in
/// that view. `positionOf(point)` is a skd::Vector3. O(n log n) for most faces.
class SkdFlatFace
{
public:
  using Corners = SkdTriangleSet::Corners;
  using Edge = std::pair<std::uint32_t, std::uint32_t>; // from, to

  struct Triangles
  {
    std::vector<Corners> Left; ///< that turn left
    std::vector<Corners> Right;
  };

  SkdFlatFace(std::vector<Edge> edges, const skd::Vector3& normal)
    : Edges(std::move(edges))
    , Normal(normal)
  {
  }

  template <class PositionOf>
  std::optional<Triangles> Triangulate(const PositionOf& positionOf)
  {
    if (!this->ListPoints())
    {
      return std::nullopt;
    }
    std::vector<skd::Vector3> positions;
    for (const std::uint32_t point : this->Points)
    {
      positions.push_back(positionOf(point));
    }
    this->SetPositions(positions);
    return this->Triangulate();
  }

private:
  bool ListPoints();
  void SetPositions(const std::vector<skd::Vector3>& positions);
  int NumberOf(std::uint32_t point) const;
  std::vector<std::pair<int, int>> ListEnds() const;
  void Surround(int axis, int sign);
  std::optional<Triangles> Triangulate();
  std::optional<Triangles> TakeInside(const std::vector<std::array<int, 3>>& all) const;

  std::vector<Edge> Edges;             // ascending
  std::vector<std::uint32_t> Points;   // ascending
  std::vector<int> Numbers;            // of each point in the triangulation
  std::vector<std::uint32_t> PointOf;  // by number; of the first three none
  std::vector<skd::Vector3> Positions; // by number
  skd::Vector3 Normal;
};
}

#endif
