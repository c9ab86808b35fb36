// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdFlatFace_h
#define SkdFlatFace_h

#include "Core/Geometry/Polygons/ConstrainedTriangulation.h"
#include "Solids/Boolean/SkdFacets.h"

namespace skdtree
{
/// The triangles of a flat face with any holes, given by the edges around it and each hole: it is
/// on their left as seen against the normal. They have these edges and no other border, turn left
/// by exact signs as seen along the largest axis of the normal, and are a constrained Delaunay
/// triangulation there. Edges around which nothing is on the left but a face on the right have
/// triangles that turn right: with the edges of two faces that are laid on each other, what of each
/// is not covered by the other. O(n log n) for most faces. For one face after the other, in the
/// same memory.
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

  /// Begins with a face that has no edge.
  void Begin()
  {
    this->Edges.clear();
    this->Within.clear();
  }
  void Add(std::uint32_t from, std::uint32_t to) { this->Edges.emplace_back(from, to); }

  /// An edge that the triangles are to have, but that is not around them. It may also be elsewhere.
  void AddWithin(std::uint32_t a, std::uint32_t b) { this->Within.emplace_back(a, b); }
  bool IsEmpty() const { return this->Edges.empty(); }

  /// nullptr if there are none such, as edges cross or points coincide in that view; else until the
  /// next face. `positionOf(point)` is a skd::Vector3.
  template <class PositionOf>
  const Triangles* Triangulate(const skd::Vector3& normal, const PositionOf& positionOf)
  {
    if (!this->ListPoints())
    {
      return nullptr;
    }
    this->Given.clear();
    for (const std::uint32_t point : this->Points)
    {
      this->Given.push_back(positionOf(point));
    }
    this->SetPositions();
    return this->Triangulate(normal) ? &this->Taken : nullptr;
  }

private:
  using Ends = std::pair<int, int>; // of an edge, by number

  bool ListPoints();
  void SetPositions();
  int NumberOf(std::uint32_t point) const;
  void ListEnds();
  void Surround(int axis, int sign);
  bool Triangulate(const skd::Vector3& normal);
  bool FindWindings(const skd::FlipMesh& mesh);
  bool TakeInside(const skd::FlipMesh& mesh);

  std::vector<Edge> Edges;             // ascending
  std::vector<Edge> Within;            // in any order and direction
  std::vector<std::uint32_t> Points;   // ascending
  std::vector<std::uint32_t> Reached;  // points where edges end
  std::vector<skd::Vector3> Given;     // of each point
  std::vector<std::uint32_t> Order;    // of these by their coordinates
  std::vector<int> Numbers;            // of each point in the triangulation
  std::vector<std::uint32_t> PointOf;  // by number; of the first three none
  std::vector<skd::Vector3> Positions; // by number
  std::vector<Ends> ByNumber;          // edges, ascending
  skd::TriangulationMemory Memory;
  std::vector<unsigned char> AreEdges; // sides, three of each triangle
  std::vector<int> Windings;           // of each triangle
  std::vector<int> Open;               // triangles whose windings are known
  Triangles Taken;
};
}

#endif
