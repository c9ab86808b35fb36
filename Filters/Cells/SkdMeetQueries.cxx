// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/SkdCellTree.h"

#include "Cells/SkdFaceTriangles.h"
#include "Core/Geometry/BoxOverlap.h"
#include "Core/Geometry/EarClipping.h"

#include <algorithm>

namespace
{
using Pieces = std::vector<skd::Piece>;

void AddQuad(Pieces& pieces, const skd::Vector3* p)
{
  for (const auto& i : SkdQuadSplit(p).Triangles)
  {
    pieces.push_back(skd::Piece::Of(p[i[0]], p[i[1]], p[i[2]]));
  }
}

void AddPieces(Pieces& pieces, const skd::Vector3* p, SkdVertexKernel)
{
  pieces.push_back(skd::Piece::Of(p[0]));
}

void AddPieces(Pieces& pieces, const skd::Vector3* p, SkdLineKernel)
{
  pieces.push_back(skd::Piece::Of(p[0], p[1]));
}

void AddPieces(Pieces& pieces, const skd::Vector3* p, SkdTriangleKernel)
{
  pieces.push_back(skd::Piece::Of(p[0], p[1], p[2]));
}

void AddPieces(Pieces& pieces, const skd::Vector3* p, SkdQuadKernel)
{
  AddQuad(pieces, p);
}

void AddPieces(Pieces& pieces, const skd::Vector3* p, SkdPixelKernel)
{
  const skd::Vector3 quad[4] = { p[0], p[1], p[3], p[2] };
  AddQuad(pieces, quad);
}

template <class Shape>
void AddPieces(Pieces& pieces, const skd::Vector3* p, SkdVolumeKernel<Shape>)
{
  SkdForEachFaceTriangle<Shape>(p,
    [&](const skd::Vector3& a, const skd::Vector3& b, const skd::Vector3& c)
    { pieces.push_back(skd::Piece::Of(a, b, c)); });
}

void AddPieces(Pieces& pieces, const skd::Vector3* p, SkdVoxelKernel)
{
  AddPieces(pieces, p, SkdVolumeKernel<skd::Voxel>());
}

void AddPolygon(Pieces& pieces, const skd::Vector3* p, int size)
{
  skd::EarClipping<const skd::Vector3*>(p, size).ForEachTriangle(
    [&](int a, int b, int c) { pieces.push_back(skd::Piece::Of(p[a], p[b], p[c])); });
}

void AddFaces(Pieces& pieces, const SkdPolyCell& cell)
{
  cell.AsPolyhedron().ForEachFace(
    [&](const skd::PolyhedronFace& face)
    {
      skd::ForEachTriangle(face,
        [&](const skd::FaceTriangle& t)
        { pieces.push_back(skd::Piece::Of(t.Points[0], t.Points[1], t.Points[2])); });
    });
}

/// Strips, polylines and polyvertices: their pieces of `size` points; a strip of two is a line.
void AddRun(Pieces& pieces, const SkdPolyCell& cell, int size)
{
  const int length = std::min(size, cell.Size);
  for (int i = 0; i + length <= cell.Size; ++i)
  {
    const skd::Vector3* p = cell.Points + i;
    pieces.push_back(length == 1 ? skd::Piece::Of(p[0])
        : length == 2            ? skd::Piece::Of(p[0], p[1])
                                 : skd::Piece::Of(p[0], p[1], p[2]));
  }
}

void AddPieces(Pieces& pieces, const SkdPolyCell& cell)
{
  switch (cell.Shape)
  {
    case SkdShape::Polyhedron:
      return AddFaces(pieces, cell);
    case SkdShape::Polygon:
      return cell.Size < 3 ? AddRun(pieces, cell, 2) : AddPolygon(pieces, cell.Points, cell.Size);
    case SkdShape::Strip:
      return AddRun(pieces, cell, 3);
    case SkdShape::PolyLine:
      return AddRun(pieces, cell, 2);
    default:
      return AddRun(pieces, cell, 1);
  }
}

bool IsVolume(SkdShape shape)
{
  return shape == SkdShape::Tetrahedron || shape == SkdShape::Voxel ||
    shape == SkdShape::Hexahedron || shape == SkdShape::Wedge || shape == SkdShape::Pyramid ||
    shape == SkdShape::Polyhedron;
}

/// By the parity of exact crossings on the way out of the bounds.
bool IsEnclosed(const skd::Vector3& x, const skd::Box3& bounds, const Pieces& faces)
{
  const skd::SegmentView view(skd::detail::WayOut(bounds, x));
  bool isInside = false;
  for (const skd::Piece& face : faces)
  {
    const auto hit = bounds.Contains(x) && view.IsValid()
      ? skd::Intersect(view, face.Points[0], face.Points[1], face.Points[2])
      : std::nullopt;
    isInside ^= hit && hit->Passes;
  }
  return isInside;
}
}

//------------------------------------------------------------------------------
const std::vector<skd::Piece>& SkdCellTree::PiecesOf(std::uint32_t cell) const
{
  thread_local Pieces pieces;
  pieces.clear();
  const SkdShape shape = this->Store.ShapeOf(cell);
  const auto add = [&](auto kernel)
  {
    skd::Vector3 points[kernel.Size];
    this->Store.Gather(cell, points);
    AddPieces(pieces, points, kernel);
  };
  if (shape != SkdShape::Generic && !SkdVisitKernel(shape, add))
  {
    AddPieces(pieces, this->Store.GatherPoly(cell));
  }
  return pieces;
}

bool SkdCellTree::Meets(
  std::uint32_t cell, const skd::Box3& box, const std::vector<skd::Piece>& pieces) const
{
  const skd::Box3 bounds = this->Store.ReachOf(cell);
  if (!bounds.Inflated(this->TheRounding).Overlaps(box))
  {
    return false;
  }
  const SkdShape shape = this->Store.ShapeOf(cell);
  if (shape == SkdShape::Generic)
  {
    return std::any_of(pieces.begin(), pieces.end(),
      [&](const skd::Piece& piece)
      { return skd::Overlaps(bounds, piece.Points[0], piece.Points[1], piece.Points[2]); });
  }
  const Pieces& own = this->PiecesOf(cell);
  for (const skd::Piece& piece : pieces)
  {
    for (const skd::Piece& other : own)
    {
      if (skd::Touch(piece, other, this->TheRounding))
      {
        return true;
      }
    }
  }
  return IsVolume(shape) && !pieces.empty() && IsEnclosed(pieces[0].Points[0], bounds, own);
}
