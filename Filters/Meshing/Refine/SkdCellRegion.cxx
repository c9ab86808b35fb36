// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdCellRegion.h"

#include "Cells/Kernels/SkdQuadSplit.h"
#include "Core/Geometry/Distance/ClosestPointOnSegment.h"
#include "Core/Geometry/Polygons/EarClipping.h"
#include "Core/Geometry/Polygons/Ears.h"
#include "Core/Geometry/Simplices/SimplexDistance.h"

#include <algorithm>

namespace skdtree
{
SkdCellRegion::SkdCellRegion(const skd::RefinedMesh& mesh, std::uint32_t cell)
  : IsVolume(skd::DimensionOf(mesh[cell].Kind) == 3)
{
  this->Set.Clear(skd::DimensionOf(mesh[cell].Kind));
  this->Middle = { { 0.0, 0.0, 0.0 } };
  for (const std::uint32_t node : mesh.NodesOf(cell))
  {
    this->Set.Add(mesh.Point(node));
  }
  const std::vector<skd::Vector3>& points = this->Set.Points;
  for (const skd::Vector3& point : points)
  {
    this->Middle = this->Middle + (1.0 / static_cast<double>(points.size())) * point;
  }
  for (const skd::Vector3& point : points)
  {
    this->Radius = std::max(this->Radius, skd::Norm(point - this->Middle));
  }
  this->SampleRadius = this->IsVolume ? 0.0 : 0.5 * this->Radius;
  this->Box = this->Set.Bounds.Inflated(this->SampleRadius);
  if (this->IsVolume)
  {
    this->AddFaces(mesh[cell].Kind);
  }
  else
  {
    this->AddSelf();
  }
}

void SkdCellRegion::AddSelf()
{
  const std::vector<skd::Vector3>& points = this->Set.Points;
  if (points.size() == 2)
  {
    this->Set.AddSimplex(0, 1, 1);
    return;
  }
  skd::EarClipping<std::vector<skd::Vector3>>(points, static_cast<int>(points.size()))
    .ForEachTriangle([&](int a, int b, int c) { this->Set.AddSimplex(a, b, c); });
}

void SkdCellRegion::AddFaces(skd::CellKind kind)
{
  static constexpr std::uint32_t own[8] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  skd::ForEachFace(kind, own,
    [&](const skd::FaceNodes& face)
    {
      const auto corner = [&face](int i) { return static_cast<int>(face[i]); };
      if (face[3] == skd::RefinedMesh::None)
      {
        this->Set.AddSimplex(corner(0), corner(1), corner(2));
        return;
      }
      const auto& p = this->Set.Points;
      const skd::Vector3 quad[4] = { p[face[0]], p[face[1]], p[face[2]], p[face[3]] };
      for (const auto& i : SkdQuadSplit(quad).Triangles)
      {
        this->Set.AddSimplex(corner(i[0]), corner(i[1]), corner(i[2]));
      }
    });
}

//------------------------------------------------------------------------------
/// Whether x projects onto the simplex, from not too far.
bool SkdCellRegion::IsBeside(const skd::Vector3& x, const skd::SimplexSet::Simplex& simplex) const
{
  const auto p = this->Set.Corners(simplex);
  if (this->Set.Dimension == 1)
  {
    const auto nearest = skd::ClosestPointOnSegment(p[0], p[1], x);
    return nearest.Dist2 == 0.0 ||
      (nearest.Dist2 <= this->SampleRadius * this->SampleRadius && nearest.R > 0.0 &&
        nearest.R < 1.0);
  }
  const skd::Vector3 normal = skd::DirectionAcross(p.data(), 3);
  const double height = skd::Dot(normal, x - p[0]);
  bool isAbove = height * height <= this->SampleRadius * this->SampleRadius * skd::Norm2(normal);
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
    return skd::Encloses(this->Set, x);
  }
  return this->Box.Contains(x) &&
    std::any_of(this->Set.Simplices.begin(), this->Set.Simplices.end(),
      [&](const skd::SimplexSet::Simplex& simplex) { return this->IsBeside(x, simplex); });
}

bool SkdCellRegion::Meets(const SkdCellTree& tree, std::uint32_t cell, SkdOverlapTest test) const
{
  if (test == SkdOverlapTest::Blind)
  {
    return tree.SafetyBoxOf(cell).Overlaps(this->Set.Bounds);
  }
  return tree.Meets(cell, this->Set);
}
}
