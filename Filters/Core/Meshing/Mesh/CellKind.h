// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The cell types of mesh refinement, their edges and faces. Nodes are in VTK's order.
#ifndef skd_Mesh_CellKind_h
#define skd_Mesh_CellKind_h

#include "../../Geometry/Cells/LinearShapes.h"

#include <array>
#include <cstdint>

namespace skd
{

enum class CellKind : std::uint8_t
{
  Fixed, ///< is never refined, whatever it is
  Line,
  Triangle,
  Polygon, ///< a quadrilateral, too
  Tetrahedron,
  Pyramid,
  Wedge,
  Hexahedron
};

/// Nodes of a face; the fourth of a triangle is None.
using FaceNodes = std::array<std::uint32_t, 4>;

inline int DimensionOf(CellKind kind)
{
  return kind >= CellKind::Tetrahedron ? 3 : (kind >= CellKind::Triangle ? 2 : 1);
}

namespace detail
{

template <class Shape, class Visit>
void VisitFaces(const std::uint32_t* nodes, const Visit& visit)
{
  for (const auto& face : Shape::Faces)
  {
    visit(FaceNodes{
      nodes[face[0]], nodes[face[1]], nodes[face[2]], face[3] < 0 ? 0xffffffffu : nodes[face[3]] });
  }
}

constexpr int EdgesOfTetrahedron[6][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 },
  { 2, 3 } };
constexpr int EdgesOfPyramid[8][2] = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 0, 4 }, { 1, 4 },
  { 2, 4 }, { 3, 4 } };
constexpr int EdgesOfWedge[9][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 }, { 5, 3 },
  { 0, 3 }, { 1, 4 }, { 2, 5 } };
constexpr int EdgesOfHexahedron[12][2] = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 },
  { 5, 6 }, { 6, 7 }, { 7, 4 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };

template <int N, class Visit>
void VisitEdges(const int (&edges)[N][2], const std::uint32_t* nodes, const Visit& visit)
{
  for (const auto& edge : edges)
  {
    visit(nodes[edge[0]], nodes[edge[1]]);
  }
}

}

/// Calls visit(FaceNodes) for the faces of a volume cell, outward; none of others.
template <class Visit>
void ForEachFace(CellKind kind, const std::uint32_t* nodes, const Visit& visit)
{
  switch (kind)
  {
    case CellKind::Tetrahedron:
      return detail::VisitFaces<Tetrahedron>(nodes, visit);
    case CellKind::Pyramid:
      return detail::VisitFaces<Pyramid>(nodes, visit);
    case CellKind::Wedge:
      return detail::VisitFaces<Wedge>(nodes, visit);
    case CellKind::Hexahedron:
      return detail::VisitFaces<Hexahedron>(nodes, visit);
    default:
      return;
  }
}

/// Calls visit(first, second) for the edges of a cell of `size` nodes.
template <class Visit>
void ForEachEdge(CellKind kind, const std::uint32_t* nodes, std::uint32_t size, const Visit& visit)
{
  switch (kind)
  {
    case CellKind::Tetrahedron:
      return detail::VisitEdges(detail::EdgesOfTetrahedron, nodes, visit);
    case CellKind::Pyramid:
      return detail::VisitEdges(detail::EdgesOfPyramid, nodes, visit);
    case CellKind::Wedge:
      return detail::VisitEdges(detail::EdgesOfWedge, nodes, visit);
    case CellKind::Hexahedron:
      return detail::VisitEdges(detail::EdgesOfHexahedron, nodes, visit);
    case CellKind::Line:
      return visit(nodes[0], nodes[1]);
    case CellKind::Triangle:
    case CellKind::Polygon:
      for (std::uint32_t i = 0; i < size; ++i)
      {
        visit(nodes[i], nodes[i + 1 == size ? 0 : i + 1]);
      }
      return;
    case CellKind::Fixed:
      return;
  }
}

}

#endif
