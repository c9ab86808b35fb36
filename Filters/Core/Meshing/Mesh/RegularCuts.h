// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Refinement cell by cell: each is cut at the middles of all of its edges and faces, into 2 lines,
/// 4 triangles or quadrilaterals, n quadrilaterals (of a polygon of n corners), 8 tetrahedra,
/// hexahedra or wedges, or 6 pyramids and 4 tetrahedra. Cells beside that are not cut have hanging
/// nodes then; how many levels neighbours may differ can be limited. Cells that are not divisible
/// (Divisible.h) are fixed instead.
#ifndef skd_Mesh_RegularCuts_h
#define skd_Mesh_RegularCuts_h

#include "Divisible.h"
#include "MeshBalance.h"
#include "SharedCuts.h"
#include "StarShape.h"
#include "VolumeCuts.h"

#include <vector>

namespace skd
{

class RegularCuts
{
public:
  /// The mesh may have `limit` leaves at most. Over contacts of the kind leaves differ by one level
  /// at most; on a surface a face is an edge, and an edge a corner. `shared` if the mesh is one of
  /// several processes' pieces.
  RegularCuts(RefinedMesh& mesh, std::uint64_t limit, Contact balance, SharedCuts* shared = nullptr)
    : Mesh(mesh)
    , Limit(limit)
    , Balance(balance)
    , Shared(shared)
  {
  }

  /// Cuts each of the cells that is a leaf, and what else must be. Returns false, and leaves the
  /// mesh as it was, if that makes more leaves than may be, here or with another process.
  bool Refine(const std::vector<std::uint32_t>& cells)
  {
    const RefinedMesh::State before = this->Mesh.GetState();
    std::vector<std::uint32_t> wanted = cells;
    do
    {
      const bool fits = this->CutAll(wanted);
      if (this->Shared ? !this->Shared->ShareMiddles(fits) : !fits)
      {
        this->Mesh.GoBackTo(before);
        return false;
      }
      wanted = MeshBalance(this->Mesh, this->Balance)
                 .FindUnbalanced(
                   [this](std::vector<int>& levels)
                   {
                     if (this->Shared)
                     {
                       this->Shared->ShareLevels(levels);
                     }
                   });
    } while (this->Shared ? this->Shared->GetProcesses().IsAny(!wanted.empty()) : !wanted.empty());
    return true;
  }

private:
  static constexpr std::uint32_t None = RefinedMesh::None;

  /// False if it makes too many leaves.
  bool CutAll(const std::vector<std::uint32_t>& cells)
  {
    for (const std::uint32_t cell : cells)
    {
      if (this->Mesh[cell].IsLeaf() && !this->Mesh[cell].IsFixed)
      {
        if (IsDivisible(this->Mesh, cell))
        {
          this->Cut(cell);
        }
        else
        {
          this->Mesh.Fix(cell);
        }
      }
      if (this->Mesh.NumberOfLeaves() > this->Limit)
      {
        return false;
      }
    }
    return true;
  }

  void Cut(std::uint32_t cell)
  {
    const RefinedMesh::Nodes nodes = this->Mesh.NodesOf(cell);
    const std::vector<std::uint32_t> list(nodes.begin(), nodes.end());
    switch (this->Mesh[cell].Kind)
    {
      case CellKind::Line:
        return this->CutLine(cell, list[0], list[1]);
      case CellKind::Triangle:
        return this->CutTriangle(cell, list[0], list[1], list[2]);
      case CellKind::Polygon:
        return this->CutPolygon(cell, list);
      case CellKind::Tetrahedron:
      case CellKind::Pyramid:
      case CellKind::Wedge:
      case CellKind::Hexahedron:
        return VolumeCuts(this->Mesh).Cut(cell, list);
      case CellKind::Fixed:
        return;
    }
  }

  std::uint32_t Middle(std::uint32_t a, std::uint32_t b) { return this->Mesh.MakeMiddle(a, b); }
  std::uint32_t Middle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
  {
    this->Mesh.SetCut({ a, b, c, d });
    return this->Mesh.MakeMiddle({ a, b, c, d });
  }

  void CutLine(std::uint32_t cell, std::uint32_t a, std::uint32_t b)
  {
    const std::uint32_t middle = this->Middle(a, b);
    this->Mesh.BeginCut(cell);
    this->Mesh.AddChild(cell, CellKind::Line, { a, middle }, 1);
    this->Mesh.AddChild(cell, CellKind::Line, { middle, b }, 1);
    this->Mesh.EndCut(cell);
  }

  void CutTriangle(std::uint32_t cell, std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    const std::uint32_t ab = this->Middle(a, b);
    const std::uint32_t bc = this->Middle(b, c);
    const std::uint32_t ca = this->Middle(c, a);
    this->Mesh.BeginCut(cell);
    this->Mesh.AddChild(cell, CellKind::Triangle, { a, ab, ca }, 2);
    this->Mesh.AddChild(cell, CellKind::Triangle, { ab, b, bc }, 2);
    this->Mesh.AddChild(cell, CellKind::Triangle, { ca, bc, c }, 2);
    this->Mesh.AddChild(cell, CellKind::Triangle, { ab, bc, ca }, 2);
    this->Mesh.EndCut(cell);
  }

  void CutPolygon(std::uint32_t cell, const std::vector<std::uint32_t>& p)
  {
    const std::vector<Vector3> points = FlatPointsOf(this->Mesh, cell);
    if (!IsStarShaped(points))
    {
      return this->CutOffEarsOf(cell, p, points);
    }
    const std::size_t n = p.size();
    const std::uint32_t middle =
      n == 4 ? this->Middle(p[0], p[1], p[2], p[3]) : this->Mesh.MakeMiddleOfCell(cell);
    std::vector<std::uint32_t> middles;
    for (std::size_t i = 0; i < n; ++i)
    {
      middles.push_back(this->Middle(p[i], p[(i + 1) % n]));
    }
    this->Mesh.BeginCut(cell);
    for (std::size_t i = 0; i < n; ++i)
    {
      this->Mesh.AddChild(
        cell, CellKind::Polygon, { p[i], middles[i], middle, middles[(i + n - 1) % n] }, 2);
    }
    this->Mesh.EndCut(cell);
  }

  void CutOffEarsOf(
    std::uint32_t cell, const std::vector<std::uint32_t>& p, const std::vector<Vector3>& points)
  {
    const std::vector<std::uint32_t> ears = CutOffEars(points);
    if (ears.empty())
    {
      return this->Mesh.Fix(cell);
    }
    this->Mesh.BeginCut(cell);
    for (std::size_t i = 0; i < ears.size(); i += 3)
    {
      this->Mesh.AddChild(
        cell, CellKind::Triangle, { p[ears[i]], p[ears[i + 1]], p[ears[i + 2]] }, 2);
    }
    this->Mesh.EndCut(cell);
  }

  RefinedMesh& Mesh;
  std::uint64_t Limit;
  Contact Balance;
  SharedCuts* Shared;
};

}

#endif
