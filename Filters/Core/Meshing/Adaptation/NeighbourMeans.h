// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Adaptation_NeighbourMeans_h
#define skd_Adaptation_NeighbourMeans_h

#include "PointGradients.h"

#include <algorithm>

namespace skd
{

/// Smooths vectors at points of a mesh: each takes half from those at the other ends of its edges,
/// by mean value coordinates (M. S. Floater, Comput. Aided Geom. Design 20 (2003) 19-27). So
/// vectors that are linear in the coordinates stay what they are, on irregular meshes, too; and
/// the ends of a short edge come to agree.
class NeighbourMeans
{
public:
  /// For a mesh as it is now. Points that slide along borders take from their neighbours there,
  /// all others that are not Free, and those at a corner of more than 180 degrees, stay. O(N).
  void Build(const SurfaceMesh& mesh, const SurfaceShape& shape);

  /// How often to smooth: not at all unless some points are not amid their neighbours, or much
  /// nearer to some; most often where many are.
  int GetTimes() const
  {
    constexpr std::size_t many = 10; // one of so many points is irregular
    constexpr std::size_t some = 100;
    const std::size_t size = this->Means.size() + 1;
    return many * this->Irregular > size ? 8 : some * this->Irregular > size ? 6 : 0;
  }

  /// Calls finish(point, sum) for each smoothed vector; it returns what is kept of it.
  template <class Finish>
  void Smooth(std::vector<Vector3>& vectors, int times, const Finish& finish) const;

private:
  struct Neighbour
  {
    double Angle;
    double Distance;
    std::uint32_t Point;
  };

  struct Share
  {
    std::uint32_t Point;
    double Weight;
  };
  using Shares = std::vector<Share>;

  static Shares OnCurve(const SurfaceMesh& mesh, std::uint32_t point, const IndexRows::Row& edges);
  static Shares Around(std::vector<Neighbour>& around);
  static bool IsIrregular(const std::vector<Neighbour>& around);

  Rows<Share> Means; // of each point; none of those that stay
  std::size_t Irregular = 0;
};

inline void NeighbourMeans::Build(const SurfaceMesh& mesh, const SurfaceShape& shape)
{
  IndexRows ends;
  for (const MeshEdge& edge : mesh.Edges)
  {
    ends.Add(edge.Points.begin(), edge.Points.end());
  }
  const IndexRows edgesOf = ends.Inverse(mesh.Points.size());
  this->Irregular = 0;
  this->Means = Rows<Share>();
  std::vector<Neighbour> around;
  for (std::uint32_t point = 0; point < mesh.Points.size(); ++point)
  {
    Shares shares;
    const Vector3 normal = NormalAt(mesh, shape, point);
    if (mesh.Freedom[point] == PointFreedom::AlongCurve)
    {
      shares = OnCurve(mesh, point, edgesOf[point]);
    }
    else if (mesh.Freedom[point] == PointFreedom::Free && Norm2(normal) > 0.0)
    {
      Vector3 u, v;
      detail::MakeTangents(normal, u, v);
      around.clear();
      for (const std::uint32_t edge : edgesOf[point])
      {
        const std::array<std::uint32_t, 2>& both = mesh.Edges[edge].Points;
        const std::uint32_t other = both[both[0] == point ? 1 : 0];
        const Vector3 to = mesh.Points[other] - mesh.Points[point];
        const double x = Dot(u, to);
        const double y = Dot(v, to);
        around.push_back({ std::atan2(y, x), std::hypot(x, y), other });
      }
      shares = Around(around);
      this->Irregular += IsIrregular(around);
    }
    this->Means.Add(shares.begin(), shares.end());
  }
}

inline NeighbourMeans::Shares NeighbourMeans::OnCurve(
  const SurfaceMesh& mesh, std::uint32_t point, const IndexRows::Row& edges)
{
  std::vector<std::uint32_t> others;
  for (const std::uint32_t edge : edges)
  {
    const std::array<std::uint32_t, 2>& both = mesh.Edges[edge].Points;
    if (mesh.Edges[edge].Cells[1] == MeshEdge::None)
    {
      others.push_back(both[both[0] == point ? 1 : 0]);
    }
  }
  if (others.size() != 2)
  {
    return {};
  }
  const double a = Norm(mesh.Points[others[0]] - mesh.Points[point]);
  const double b = Norm(mesh.Points[others[1]] - mesh.Points[point]);
  return { { others[0], b / (a + b) }, { others[1], a / (a + b) } };
}

inline bool NeighbourMeans::IsIrregular(const std::vector<Neighbour>& around)
{
  constexpr double amid = 0.2;   // of the mean distance
  constexpr double nearer = 0.3; // than the farthest
  double x = 0.0, y = 0.0, sum = 0.0;
  double least = HUGE_VAL, most = 0.0;
  for (const Neighbour& one : around)
  {
    x += one.Distance * std::cos(one.Angle);
    y += one.Distance * std::sin(one.Angle);
    sum += one.Distance;
    least = std::min(least, one.Distance);
    most = std::max(most, one.Distance);
  }
  return std::hypot(x, y) > amid * sum || least < nearer * most;
}

// With angles a, b beside the direction to a neighbour its weight is (tan(a/2) + tan(b/2)) over its
// distance (Floater's), divided by the sum of all.
inline NeighbourMeans::Shares NeighbourMeans::Around(std::vector<Neighbour>& around)
{
  constexpr double pi = 3.14159265358979323846;
  constexpr double widest = 0.99 * pi; // the weights grow beyond all bounds towards pi
  const auto isBefore = [](const Neighbour& a, const Neighbour& b) { return a.Angle < b.Angle; };
  std::sort(around.begin(), around.end(), isBefore);
  const std::size_t n = around.size();
  std::vector<double> tangents(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const double offset = i + 1 < n ? 0.0 : 2.0 * pi;
    const double angle = around[(i + 1) % n].Angle + offset - around[i].Angle;
    tangents[i] = std::tan(0.5 * angle);
    if (!(angle < widest) || !(around[i].Distance > 0.0))
    {
      return {};
    }
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    sum += (tangents[i] + tangents[(i + n - 1) % n]) / around[i].Distance;
  }
  Shares shares;
  for (std::size_t i = 0; i < n && sum > 0.0; ++i)
  {
    shares.push_back(
      { around[i].Point, (tangents[i] + tangents[(i + n - 1) % n]) / around[i].Distance / sum });
  }
  return shares;
}

template <class Finish>
void NeighbourMeans::Smooth(std::vector<Vector3>& vectors, int times, const Finish& finish) const
{
  std::vector<Vector3> next(vectors);
  for (; times > 0; --times)
  {
    for (std::uint32_t point = 0; point < vectors.size(); ++point)
    {
      Vector3 sum = vectors[point];
      const Rows<Share>::Row shares = this->Means[point];
      for (const Share& share : shares)
      {
        sum = sum + share.Weight * vectors[share.Point];
      }
      next[point] = shares.size() == 0 ? sum : finish(point, 0.5 * sum);
    }
    vectors.swap(next);
  }
}

}

#endif
