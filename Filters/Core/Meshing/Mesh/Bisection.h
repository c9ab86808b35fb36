// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Refinement that leaves no hanging node: lines, triangles and tetrahedra are bisected at the
/// middle of their longest edge, and so are, as often as it takes, the cells beside that have the
/// edge (M.-C. Rivara, "Algorithms for refining triangular grids suitable for adaptive and
/// multigrid techniques", Int. J. Numer. Methods Eng. 20 (1984) 745-756). Which edge is the longest
/// is decided by one order of all (EdgeOrder.h), so all triangles of a face agree on how it is cut,
/// and the result depends on neither the order of the marks nor the numbering.
///
/// Other cells become simplices first: polygons from their middle, n triangles of n corners, or by
/// cutting off ears where the middle does not see all edges; hexahedra and wedges from their middle
/// into a pyramid or tetrahedron a face; pyramids along the shorter diagonal of their base into two
/// tetrahedra, which cuts the face for the cell beyond it, too.
///
/// Bound: no angle of a triangle is less than half of the smallest one of the triangles before any
/// was bisected (I. Rosenberg, F. Stenger, "A lower bound on the angles of triangles constructed by
/// bisecting the longest side", Math. Comp. 29 (1975) 390-395). In three dimensions no bound is
/// known; few shapes occur in practice.
///
/// What is not divisible (Divisible.h), simplices along their longest edge, others at all edges, is
/// fixed instead: nodes may hang there.
#ifndef skd_Mesh_Bisection_h
#define skd_Mesh_Bisection_h

#include "Divisible.h"
#include "EdgeOrder.h"
#include "StarShape.h"

#include <utility>
#include <vector>

namespace skd
{

class Bisection
{
public:
  /// The mesh may have `limit` leaves at most.
  Bisection(RefinedMesh& mesh, std::uint64_t limit)
    : Mesh(mesh)
    , Limit(limit)
  {
  }

  /// Cuts each of the cells that is a leaf once, and what else must be. O(cells cut). Returns
  /// false, and leaves the mesh as it was, if that makes more leaves than may be.
  bool Refine(const std::vector<std::uint32_t>& cells)
  {
    const RefinedMesh::State before = this->Mesh.GetState();
    this->Waiting = cells;
    return this->CutWaiting() || this->GoBackTo(before);
  }

  ///@{
  /// Cuts an edge that a cell has, or a face of four nodes, as if a cell beyond it were cut there,
  /// and what else must be. Returns as Refine() does.
  bool RefineAt(std::uint32_t a, std::uint32_t b)
  {
    const RefinedMesh::State before = this->Mesh.GetState();
    this->Waiting.clear();
    this->CutEdge(a, b);
    return this->CutWaiting() || this->GoBackTo(before);
  }
  bool RefineAt(const FaceNodes& face)
  {
    const RefinedMesh::State before = this->Mesh.GetState();
    this->Waiting.clear();
    this->CutFace(face);
    return this->CutWaiting() || this->GoBackTo(before);
  }
  ///@}

  /// The edges and faces that have been cut, in turn. The last node of a face is not None, that of
  /// an edge, and the one before, are.
  std::vector<FaceNodes> TakeCuts() { return std::exchange(this->Cuts, {}); }

private:
  static constexpr std::uint32_t None = RefinedMesh::None;

  /// False if it makes too many leaves.
  bool CutWaiting()
  {
    for (std::size_t next = 0; next < this->Waiting.size(); ++next)
    {
      const std::uint32_t cell = this->Waiting[next];
      if (this->Mesh[cell].IsLeaf() && !this->Mesh[cell].IsFixed)
      {
        this->Cut(cell);
      }
      if (this->Mesh.NumberOfLeaves() > this->Limit)
      {
        return false;
      }
    }
    return true;
  }

  bool GoBackTo(const RefinedMesh::State& before)
  {
    this->Mesh.GoBackTo(before);
    return false;
  }

  void Cut(std::uint32_t cell)
  {
    switch (this->Mesh[cell].Kind)
    {
      case CellKind::Line:
      case CellKind::Triangle:
      case CellKind::Tetrahedron:
        return this->Bisect(cell);
      case CellKind::Fixed:
        return;
      default:
        return IsDivisible(this->Mesh, cell) ? this->CutIntoSimplices(cell) : this->Mesh.Fix(cell);
    }
  }

  void CutIntoSimplices(std::uint32_t cell)
  {
    switch (this->Mesh[cell].Kind)
    {
      case CellKind::Polygon:
        return this->CutPolygon(cell);
      case CellKind::Pyramid:
        return this->CutPyramid(cell);
      default:
        return this->CutFromMiddle(cell);
    }
  }

  /// The children are the cell with one end of its longest edge moved to the middle of it.
  void Bisect(std::uint32_t cell)
  {
    const OrderedEdge edge = LongestEdgeOf(this->Mesh, cell);
    if (!IsResolved(this->Mesh.FlatPoint(edge[0]), this->Mesh.FlatPoint(edge[1])))
    {
      return this->Mesh.Fix(cell);
    }
    const std::uint32_t middle = this->CutEdge(edge[0], edge[1]);
    const CellKind kind = this->Mesh[cell].Kind;
    const std::uint32_t size = this->Mesh.NodesOf(cell).Size;
    std::uint32_t nodes[4];
    this->Mesh.BeginCut(cell);
    for (const int end : { 1, 0 })
    {
      std::copy_n(this->Mesh.NodesOf(cell).First, size, nodes);
      *std::find(nodes, nodes + size, edge[end]) = middle;
      if (size == 2)
      {
        this->Add(cell, kind, { nodes[0], nodes[1] }, 1);
      }
      else if (size == 3)
      {
        this->Add(cell, kind, { nodes[0], nodes[1], nodes[2] }, 1);
      }
      else
      {
        this->Add(cell, kind, { nodes[0], nodes[1], nodes[2], nodes[3] }, 1);
      }
    }
    this->Mesh.EndCut(cell);
  }

  std::uint32_t CutEdge(std::uint32_t a, std::uint32_t b)
  {
    const std::uint32_t known = this->Mesh.MiddleOf(a, b);
    if (known != None)
    {
      return known;
    }
    this->Mesh.ForEachLeafAt(a, b, [&](std::uint32_t cell) { this->Waiting.push_back(cell); });
    this->Cuts.push_back({ a, b, None, None });
    return this->Mesh.MakeMiddle(a, b);
  }

  void CutFace(const FaceNodes& face)
  {
    if (this->Mesh.SetCut(face))
    {
      this->Mesh.ForEachLeafAt(face, [&](std::uint32_t cell) { this->Waiting.push_back(cell); });
      this->Cuts.push_back(face);
    }
  }

  //----------------------------------------------------------------------------
  void CutPolygon(std::uint32_t cell)
  {
    const RefinedMesh::Nodes nodes = this->Mesh.NodesOf(cell);
    if (nodes.Size == 4 && this->Mesh.IsFaceOfVolume({ nodes[0], nodes[1], nodes[2], nodes[3] }))
    {
      return this->CutQuadOfVolume(cell);
    }
    const std::vector<std::uint32_t> list(nodes.begin(), nodes.end());
    const std::vector<Vector3> points = FlatPointsOf(this->Mesh, cell);
    if (IsStarShaped(points))
    {
      const std::uint32_t middle = this->Mesh.MakeMiddleOfCell(cell);
      this->Mesh.BeginCut(cell);
      for (std::size_t i = 0; i < list.size(); ++i)
      {
        this->Add(cell, CellKind::Triangle, { list[i], list[(i + 1) % list.size()], middle }, 2);
      }
      return this->Mesh.EndCut(cell);
    }
    const std::vector<std::uint32_t> ears = CutOffEars(points);
    if (ears.empty())
    {
      return this->Mesh.Fix(cell);
    }
    this->Mesh.BeginCut(cell);
    for (std::size_t i = 0; i < ears.size(); i += 3)
    {
      this->Add(
        cell, CellKind::Triangle, { list[ears[i]], list[ears[i + 1]], list[ears[i + 2]] }, 1);
    }
    this->Mesh.EndCut(cell);
  }

  /// As the volume cell's face is cut.
  void CutQuadOfVolume(std::uint32_t cell)
  {
    const RefinedMesh::Nodes nodes = this->Mesh.NodesOf(cell);
    const FaceNodes face{ nodes[0], nodes[1], nodes[2], nodes[3] };
    const int from = ShorterDiagonalOf(this->Mesh, face);
    this->CutFace(face);
    this->Mesh.BeginCut(cell);
    for (const int first : { from, from + 2 })
    {
      this->Add(
        cell, CellKind::Triangle, { face[first], face[(first + 1) % 4], face[(first + 2) % 4] }, 1);
    }
    this->Mesh.EndCut(cell);
  }

  //----------------------------------------------------------------------------
  void CutPyramid(std::uint32_t cell)
  {
    const RefinedMesh::Nodes nodes = this->Mesh.NodesOf(cell);
    const FaceNodes base{ nodes[0], nodes[1], nodes[2], nodes[3] };
    const std::uint32_t apex = nodes[4];
    const int from = ShorterDiagonalOf(this->Mesh, base);
    this->CutFace(base);
    this->Mesh.BeginCut(cell);
    for (const int first : { from, from + 2 })
    {
      this->Add(cell, CellKind::Tetrahedron,
        { base[first], base[(first + 1) % 4], base[(first + 2) % 4], apex }, 1);
    }
    this->Mesh.EndCut(cell);
  }

  void CutFromMiddle(std::uint32_t cell)
  {
    int side = 0;
    if (!IsStarShaped(this->Mesh, cell, side))
    {
      return this->Mesh.Fix(cell);
    }
    // VTK's wedges may have either orientation; hexahedra keep theirs.
    const bool isReversed = side < 0 && this->Mesh[cell].Kind == CellKind::Wedge;
    const std::uint32_t middle = this->Mesh.MakeMiddleOfCell(cell);
    std::vector<FaceNodes> faces;
    ForEachFace(this->Mesh[cell].Kind, this->Mesh.NodesOf(cell).First,
      [&](const FaceNodes& face)
      {
        const bool isTriangle = face[3] == None;
        const FaceNodes inward = isTriangle ? FaceNodes{ face[0], face[2], face[1], None }
                                            : FaceNodes{ face[0], face[3], face[2], face[1] };
        faces.push_back(isReversed ? face : inward);
      });
    this->Mesh.BeginCut(cell);
    for (const FaceNodes& f : faces)
    {
      if (f[3] == None)
      {
        this->Add(cell, CellKind::Tetrahedron, { f[0], f[1], f[2], middle }, 3);
      }
      else
      {
        this->Add(cell, CellKind::Pyramid, { f[0], f[1], f[2], f[3], middle }, 3);
      }
    }
    this->Mesh.EndCut(cell);
  }

  //----------------------------------------------------------------------------
  /// Adds a child, which must be cut, too, where its border is already.
  void Add(
    std::uint32_t parent, CellKind kind, std::initializer_list<std::uint32_t> nodes, int steps)
  {
    const std::uint32_t child = this->Mesh.AddChild(parent, kind, nodes, steps);
    bool isCut = false;
    ForEachEdge(kind, nodes.begin(), static_cast<std::uint32_t>(nodes.size()),
      [&](std::uint32_t a, std::uint32_t b)
      { isCut = isCut || this->Mesh.MiddleOf(a, b) != None; });
    ForEachFace(kind, nodes.begin(),
      [&](const FaceNodes& face) { isCut = isCut || (face[3] != None && this->Mesh.IsCut(face)); });
    if (isCut)
    {
      this->Waiting.push_back(child);
    }
  }

  RefinedMesh& Mesh;
  std::uint64_t Limit;
  std::vector<std::uint32_t> Waiting;
  std::vector<FaceNodes> Cuts;
};

}

#endif
