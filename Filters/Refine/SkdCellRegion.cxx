// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Refine/SkdCellRegion.h"

#include "Core/Geometry/EarClipping.h"
#include "Core/Geometry/Ears.h"

#include <algorithm>

SkdCellRegion::SkdCellRegion(const skd::RefinedMesh& mesh, std::uint32_t cell)
  : IsVolume(skd::DimensionOf(mesh[cell].Kind) == 3)
{
  this->Middle = { { 0.0, 0.0, 0.0 } };
  for (const std::uint32_t node : mesh.NodesOf(cell))
  {
    this->Points.push_back(mesh.Point(node));
    this->Tight.Add(this->Points.back());
  }
  for (const skd::Vector3& point : this->Points)
  {
    this->Middle = this->Middle + (1.0 / static_cast<double>(this->Points.size())) * point;
  }
  for (const skd::Vector3& point : this->Points)
  {
    this->Radius = std::max(this->Radius, skd::Norm(point - this->Middle));
  }
  this->SampleReach = this->IsVolume ? 0.0 : 0.5 * this->Radius;
  this->Box = this->Tight.Inflated(this->SampleReach);
  this->AddPieces(mesh, cell);
}

void SkdCellRegion::AddPieces(const skd::RefinedMesh& mesh, std::uint32_t cell)
{
  const std::vector<skd::Vector3>& p = this->Points;
  const auto addQuad = [this](const skd::Vector3* quad)
  {
    for (const auto& i : SkdQuadSplit(quad).Triangles)
    {
      this->Pieces.push_back(skd::Piece::Of(quad[i[0]], quad[i[1]], quad[i[2]]));
    }
  };
  if (p.size() == 2)
  {
    this->Pieces.push_back(skd::Piece::Of(p[0], p[1]));
  }
  else if (!this->IsVolume)
  {
    skd::EarClipping<std::vector<skd::Vector3>>(p, static_cast<int>(p.size()))
      .ForEachTriangle(
        [&](int a, int b, int c) { this->Pieces.push_back(skd::Piece::Of(p[a], p[b], p[c])); });
  }
  skd::ForEachFace(mesh[cell].Kind, mesh.NodesOf(cell).First,
    [&](const skd::FaceNodes& f)
    {
      const bool isQuad = f[3] != skd::RefinedMesh::None;
      const skd::Vector3 corners[4] = { mesh.Point(f[0]), mesh.Point(f[1]), mesh.Point(f[2]),
        mesh.Point(isQuad ? f[3] : f[0]) };
      isQuad ? addQuad(corners)
             : this->Pieces.push_back(skd::Piece::Of(corners[0], corners[1], corners[2]));
    });
}

//------------------------------------------------------------------------------
/// By the parity of exact crossings on the way out; points on the border count.
bool SkdCellRegion::IsEnclosed(const skd::Vector3& x) const
{
  if (!this->Tight.Contains(x))
  {
    return false;
  }
  const skd::SegmentView view(skd::detail::WayOut(this->Tight, x));
  bool isInside = false;
  for (const skd::Piece& face : this->Pieces)
  {
    const auto hit = view.IsValid()
      ? skd::Intersect(view, face.Points[0], face.Points[1], face.Points[2])
      : std::nullopt;
    if (hit && hit->T == 0.0)
    {
      return true;
    }
    isInside ^= hit && hit->Passes;
  }
  return isInside;
}

/// Whether x projects onto the piece, from not too far.
bool SkdCellRegion::IsBeside(const skd::Vector3& x, const skd::Piece& piece) const
{
  const auto& p = piece.Points;
  if (piece.Size == 2)
  {
    const auto nearest = skd::ClosestPointOnSegment(p[0], p[1], x);
    return nearest.Dist2 == 0.0 ||
      (nearest.Dist2 <= this->SampleReach * this->SampleReach && nearest.R > 0.0 &&
        nearest.R < 1.0);
  }
  const skd::Vector3 normal = skd::DirectionAcross(p.data(), 3);
  const double height = skd::Dot(normal, x - p[0]);
  bool isAbove = height * height <= this->SampleReach * this->SampleReach * skd::Norm2(normal);
  for (int i = 0; i < 3; ++i)
  {
    const skd::Vector3& from = p[i];
    isAbove = isAbove && skd::Dot(skd::Cross(normal, p[(i + 1) % 3] - from), x - from) >= 0.0;
  }
  return isAbove;
}

bool SkdCellRegion::Contains(const skd::Vector3& x) const
{
  if (this->IsVolume)
  {
    return this->IsEnclosed(x);
  }
  return this->Box.Contains(x) &&
    std::any_of(this->Pieces.begin(), this->Pieces.end(),
      [&](const skd::Piece& piece) { return this->IsBeside(x, piece); });
}

bool SkdCellRegion::Meets(const SkdCellTree& tree, std::uint32_t cell, SkdOverlapTest test) const
{
  if (test == SkdOverlapTest::Blind)
  {
    return tree.SafetyBoxOf(cell).Overlaps(this->Tight);
  }
  const SkdCellStore& cells = tree.Cells();
  return tree.Meets(cell, this->Tight, this->Pieces) ||
    (this->IsVolume && this->IsEnclosed(cells.Point(*cells.PointIdsOf(cell))));
}
