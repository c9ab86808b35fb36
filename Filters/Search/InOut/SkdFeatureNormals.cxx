// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/InOut/SkdFeatureNormals.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
/// A parametric weight of at most this is none: the point is on an edge or a vertex, to rounding.
constexpr double BorderWeight = 1e-12;

skd::Vector3 UnitNormal(const skd::Vector3& a, const skd::Vector3& b, const skd::Vector3& c)
{
  const skd::Vector3 across = skd::Cross(b - a, c - a);
  const double length = skd::Norm(across);
  return length > 0.0 ? (1.0 / length) * across : skd::Vector3{ { 0.0, 0.0, 0.0 } };
}

double AngleBetween(const skd::Vector3& a, const skd::Vector3& b)
{
  return std::atan2(skd::Norm(skd::Cross(a, b)), skd::Dot(a, b));
}

template <class Edge>
bool IsBefore(const Edge& a, const Edge& b)
{
  return a.Least != b.Least ? a.Least < b.Least : a.Most < b.Most;
}

/// Edges of the same ends, which follow each other, become one.
template <class Edge>
void Merge(std::vector<Edge>& edges)
{
  std::size_t retained = 0;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    if (i == 0 || IsBefore(edges[retained - 1], edges[i]))
    {
      edges[retained++] = edges[i];
      continue;
    }
    edges[retained - 1].Sum = edges[retained - 1].Sum + edges[i].Sum;
    ++edges[retained - 1].Faces;
  }
  edges.resize(retained);
}
}

SkdFeatureNormals::SkdFeatureNormals(vtkPolyData* surface, const std::vector<bool>& isReversed)
  : Triangles(SkdSurfaceTriangles(surface))
  , PointNormals(surface->GetNumberOfPoints(), skd::Vector3{ { 0.0, 0.0, 0.0 } })
{
  const std::vector<skd::Vector3> points = SkdSurfacePoints(surface);
  for (const SkdTriangleIds& ids : this->Triangles)
  {
    const bool reverses = !isReversed.empty() && isReversed[this->FaceNormals.size()];
    const skd::Vector3 normal =
      (reverses ? -1.0 : 1.0) * UnitNormal(points[ids[0]], points[ids[1]], points[ids[2]]);
    this->FaceNormals.push_back(normal);
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType here = ids[i], next = ids[(i + 1) % 3], last = ids[(i + 2) % 3];
      const double angle = AngleBetween(points[next] - points[here], points[last] - points[here]);
      this->PointNormals[here] = this->PointNormals[here] + angle * normal;
      this->Edges.push_back({ std::min(here, next), std::max(here, next), normal, 1 });
    }
  }
  // Stable: a sum is made in the order of the triangles.
  std::stable_sort(this->Edges.begin(), this->Edges.end(), IsBefore<Edge>);
  Merge(this->Edges);
}

const SkdFeatureNormals::Edge& SkdFeatureNormals::EdgeOf(vtkIdType a, vtkIdType b) const
{
  const Edge sought{ std::min(a, b), std::max(a, b), {}, 0 };
  return *std::lower_bound(this->Edges.begin(), this->Edges.end(), sought, IsBefore<Edge>);
}

SkdFeatureNormals::Normal SkdFeatureNormals::At(vtkIdType triangle, const double pcoords[3]) const
{
  const SkdTriangleIds& ids = this->Triangles[triangle];
  const double weights[3] = { 1.0 - pcoords[0] - pcoords[1], pcoords[0], pcoords[1] };
  for (int i = 0; i < 3; ++i)
  {
    if (weights[(i + 1) % 3] <= BorderWeight && weights[(i + 2) % 3] <= BorderWeight)
    {
      return { this->PointNormals[ids[i]], false };
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    if (weights[i] <= BorderWeight)
    {
      const Edge& edge = this->EdgeOf(ids[(i + 1) % 3], ids[(i + 2) % 3]);
      return { edge.Sum, edge.Faces % 2 == 1 };
    }
  }
  return { this->FaceNormals[triangle], false };
}
}
