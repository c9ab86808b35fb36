// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Mesh_VolumeCuts_h
#define skd_Mesh_VolumeCuts_h

#include "EdgeOrder.h"

#include <vector>

namespace skd
{

/// Cuts volume cells at the middles of all of their edges and faces.
class VolumeCuts
{
public:
  explicit VolumeCuts(RefinedMesh& mesh)
    : Mesh(mesh)
  {
  }

  void Cut(std::uint32_t cell, const std::vector<std::uint32_t>& nodes)
  {
    this->SetFacesCut(cell);
    switch (this->Mesh[cell].Kind)
    {
      case CellKind::Tetrahedron:
        return this->CutTetrahedron(cell, nodes);
      case CellKind::Pyramid:
        return this->CutPyramid(cell, nodes);
      case CellKind::Wedge:
        return this->CutWedge(cell, nodes);
      default:
        return this->CutHexahedron(cell, nodes);
    }
  }

private:
  static constexpr std::uint32_t None = RefinedMesh::None;

  std::uint32_t Middle(std::uint32_t a, std::uint32_t b) { return this->Mesh.MakeMiddle(a, b); }
  std::uint32_t Middle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
  {
    return this->Mesh.MakeMiddle({ a, b, c, d });
  }

  void SetFacesCut(std::uint32_t cell)
  {
    std::vector<FaceNodes> faces;
    ForEachFace(this->Mesh[cell].Kind, this->Mesh.NodesOf(cell).First,
      [&](const FaceNodes& face) { faces.push_back(face); });
    for (const FaceNodes& face : faces)
    {
      this->Mesh.SetCut(face);
    }
  }

  /// Four at the corners; what is left is an octahedron, cut along its shortest diagonal (from the
  /// middle of an edge to that of the opposite one) into four around it.
  void CutTetrahedron(std::uint32_t cell, const std::vector<std::uint32_t>& p)
  {
    const std::uint32_t m01 = this->Middle(p[0], p[1]);
    const std::uint32_t m12 = this->Middle(p[1], p[2]);
    const std::uint32_t m02 = this->Middle(p[0], p[2]);
    const std::uint32_t m03 = this->Middle(p[0], p[3]);
    const std::uint32_t m13 = this->Middle(p[1], p[3]);
    const std::uint32_t m23 = this->Middle(p[2], p[3]);
    this->Mesh.BeginCut(cell);
    this->AddTetrahedron(cell, p[0], m01, m02, m03);
    this->AddTetrahedron(cell, m01, p[1], m12, m13);
    this->AddTetrahedron(cell, m02, m12, p[2], m23);
    this->AddTetrahedron(cell, m03, m13, m23, p[3]);
    // The ends of a diagonal, and the other four around it.
    const std::array<std::array<std::uint32_t, 6>, 3> splittings = { {
      { m01, m23, m02, m12, m13, m03 },
      { m02, m13, m03, m23, m12, m01 },
      { m03, m12, m01, m13, m23, m02 },
    } };
    const auto* shortest = &splittings[0];
    for (const auto& splitting : splittings)
    {
      shortest = OrderedEdge(this->Mesh, splitting[0], splitting[1]) <
          OrderedEdge(this->Mesh, (*shortest)[0], (*shortest)[1])
        ? &splitting
        : shortest;
    }
    for (int i = 0; i < 4; ++i)
    {
      const auto& splitting = *shortest;
      this->AddTetrahedron(
        cell, splitting[0], splitting[1], splitting[2 + (i + 1) % 4], splitting[2 + i]);
    }
    this->Mesh.EndCut(cell);
  }

  void AddTetrahedron(
    std::uint32_t cell, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
  {
    this->Mesh.AddChild(cell, CellKind::Tetrahedron, { a, b, c, d }, 3);
  }

  void AddPyramid(std::uint32_t cell, std::uint32_t a, std::uint32_t b, std::uint32_t c,
    std::uint32_t d, std::uint32_t apex)
  {
    this->Mesh.AddChild(cell, CellKind::Pyramid, { a, b, c, d, apex }, 3);
  }

  /// Four at the corners of the base, one at the apex and one upside down below it, and a
  /// tetrahedron within each side.
  void CutPyramid(std::uint32_t cell, const std::vector<std::uint32_t>& p)
  {
    const std::uint32_t base = this->Middle(p[0], p[1], p[2], p[3]);
    std::uint32_t low[4];
    std::uint32_t high[4];
    for (int i = 0; i < 4; ++i)
    {
      low[i] = this->Middle(p[i], p[(i + 1) % 4]);
      high[i] = this->Middle(p[i], p[4]);
    }
    this->Mesh.BeginCut(cell);
    for (int i = 0; i < 4; ++i)
    {
      this->AddPyramid(cell, p[i], low[i], base, low[(i + 3) % 4], high[i]);
      this->AddTetrahedron(cell, low[i], high[(i + 1) % 4], base, high[i]);
    }
    this->AddPyramid(cell, high[0], high[1], high[2], high[3], p[4]);
    this->AddPyramid(cell, high[0], high[3], high[2], high[1], base);
    this->Mesh.EndCut(cell);
  }

  void CutWedge(std::uint32_t cell, const std::vector<std::uint32_t>& p)
  {
    // Three floors of the three corners and, at 3 .. 5, the middles of the edges after them.
    std::uint32_t floors[3][6];
    for (int i = 0; i < 3; ++i)
    {
      const int next = (i + 1) % 3;
      floors[0][i] = p[i];
      floors[1][i] = this->Middle(p[i], p[i + 3]);
      floors[2][i] = p[i + 3];
      floors[0][i + 3] = this->Middle(p[i], p[next]);
      floors[1][i + 3] = this->Middle(p[i], p[next], p[next + 3], p[i + 3]);
      floors[2][i + 3] = this->Middle(p[i + 3], p[next + 3]);
    }
    static constexpr int triangles[4][3] = { { 0, 3, 5 }, { 3, 1, 4 }, { 5, 4, 2 }, { 3, 4, 5 } };
    this->Mesh.BeginCut(cell);
    for (int k = 0; k < 2; ++k)
    {
      const std::uint32_t* a = floors[k];
      const std::uint32_t* b = floors[k + 1];
      for (const auto& t : triangles)
      {
        this->Mesh.AddChild(
          cell, CellKind::Wedge, { a[t[0]], a[t[1]], a[t[2]], b[t[0]], b[t[1]], b[t[2]] }, 3);
      }
    }
    this->Mesh.EndCut(cell);
  }

  void CutHexahedron(std::uint32_t cell, const std::vector<std::uint32_t>& p)
  {
    // The 27 nodes at (i, j, k): a corner, or the middle of what lies between corners.
    std::uint32_t at[3][3][3];
    const auto corner = [&p](int i, int j, int k)
    {
      static constexpr int order[8] = { 0, 1, 3, 2, 4, 5, 7, 6 };
      return p[order[4 * k + 2 * j + i]];
    };
    for (int k = 0; k < 3; ++k)
    {
      for (int j = 0; j < 3; ++j)
      {
        for (int i = 0; i < 3; ++i)
        {
          at[k][j][i] = this->NodeBetween(cell, corner, i, j, k);
        }
      }
    }
    this->Mesh.BeginCut(cell);
    for (int part = 0; part < 8; ++part)
    {
      const int i = part & 1;
      const int j = part >> 1 & 1;
      const int k = part >> 2;
      this->Mesh.AddChild(cell, CellKind::Hexahedron,
        { at[k][j][i], at[k][j][i + 1], at[k][j + 1][i + 1], at[k][j + 1][i], at[k + 1][j][i],
          at[k + 1][j][i + 1], at[k + 1][j + 1][i + 1], at[k + 1][j + 1][i] },
        3);
    }
    this->Mesh.EndCut(cell);
  }

  /// Of a hexahedron: i, j, k are 0 and 2 at its corners, 1 in the middle.
  template <class Corner>
  std::uint32_t NodeBetween(std::uint32_t cell, const Corner& corner, int i, int j, int k)
  {
    const int low[3] = { i / 2, j / 2, k / 2 };
    const bool isMiddle[3] = { i == 1, j == 1, k == 1 };
    const int middles = isMiddle[0] + isMiddle[1] + isMiddle[2];
    if (middles == 3)
    {
      return this->Mesh.MakeMiddleOfCell(cell);
    }
    const auto raised = [&](int first, int second)
    {
      int c[3] = { low[0], low[1], low[2] };
      c[0] += first == 0 || second == 0;
      c[1] += first == 1 || second == 1;
      c[2] += first == 2 || second == 2;
      return corner(c[0], c[1], c[2]);
    };
    const int a = isMiddle[0] ? 0 : (isMiddle[1] ? 1 : 2);
    const int b = isMiddle[2] ? 2 : 1;
    if (middles == 2)
    {
      return this->Middle(raised(-1, -1), raised(a, -1), raised(a, b), raised(b, -1));
    }
    return middles == 1 ? this->Middle(raised(-1, -1), raised(a, -1)) : raised(-1, -1);
  }

  RefinedMesh& Mesh;
};

}

#endif
