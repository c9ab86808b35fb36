// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Adaptation_FeatureCurves_h
#define skd_Adaptation_FeatureCurves_h

#include "SurfaceShape.h"

namespace skd
{

/// What holds points.
struct FreedomRules
{
  bool DoBordersSlide = true; ///< else all points of borders are fixed
  double CornerAngle = 0.7;   ///< radians: a curve that turns by more has a corner, which is fixed
  double CreaseAngle = 0.7;   ///< radians: cells whose normals differ by more meet in a crease
};

/// Borders and creases of a mesh as it is when this is made, and where points are that slide along.
class FeatureCurves
{
public:
  /// Finds them, and what each point of the mesh may do.
  FeatureCurves(SurfaceMesh& mesh, const SurfaceShape& shape, const FreedomRules& rules);

  /// The point nearest to x of the curve that a point slides along, looked for from where the point
  /// was the last time: it never comes to another curve, however near.
  Vector3 Slide(std::uint32_t point, const Vector3& x);

  /// The direction, of length 1, of the curve where a point is that slides along it.
  Vector3 TangentOf(std::uint32_t point) const
  {
    const Segment& on = this->Segments[this->SegmentOfPoint[point]];
    const Vector3 along = this->Positions[on.Ends[1]] - this->Positions[on.Ends[0]];
    return (1.0 / Norm(along)) * along;
  }

private:
  struct Segment
  {
    std::uint32_t Ends[2];
  };
  struct Nearest
  {
    Vector3 Position;
    double Distance2;
    double Parameter;
  };

  static bool IsCrease(const SurfaceMesh& mesh, const MeshEdge& edge, double cosine);
  bool IsCorner(std::uint32_t point, const IndexRows::Row& segments, double cosine) const;
  Nearest NearestOn(std::uint32_t segment, const Vector3& x) const;
  std::uint32_t NextOf(std::uint32_t segment, std::uint32_t point) const;

  std::vector<Vector3> Positions; // of all points, as they were
  std::vector<Segment> Segments;
  IndexRows SegmentsOfPoint;
  std::vector<std::uint32_t> SegmentOfPoint; // where one that slides is now
  std::vector<PointFreedom> Freedom;
};

inline bool FeatureCurves::IsCrease(const SurfaceMesh& mesh, const MeshEdge& edge, double cosine)
{
  const Vector3 a = VectorArea(mesh, edge.Cells[0]);
  const Vector3 b = VectorArea(mesh, edge.Cells[1]);
  return std::abs(Dot(a, b)) < cosine * Norm(a) * Norm(b);
}

inline bool FeatureCurves::IsCorner(
  std::uint32_t point, const IndexRows::Row& segments, double cosine) const
{
  if (segments.size() != 2)
  {
    return true;
  }
  const auto away = [&](std::uint32_t segment)
  {
    const Segment& on = this->Segments[segment];
    return this->Positions[on.Ends[on.Ends[0] == point ? 1 : 0]] - this->Positions[point];
  };
  const Vector3 a = away(segments[0]);
  const Vector3 b = away(segments[1]);
  return !(-Dot(a, b) > cosine * Norm(a) * Norm(b));
}

inline FeatureCurves::FeatureCurves(
  SurfaceMesh& mesh, const SurfaceShape& shape, const FreedomRules& rules)
  : Positions(mesh.Points)
{
  const bool hasCreases = shape.What == SurfaceShape::Kind::Other;
  const double crease = std::cos(rules.CreaseAngle);
  IndexRows ends;
  for (const MeshEdge& edge : mesh.Edges)
  {
    const bool isBorder = edge.Cells[1] == MeshEdge::None;
    if (isBorder || (hasCreases && IsCrease(mesh, edge, crease)))
    {
      this->Segments.push_back({ { edge.Points[0], edge.Points[1] } });
      ends.Add(edge.Points.begin(), edge.Points.end());
    }
    if (isBorder && !rules.DoBordersSlide)
    {
      mesh.Freedom[edge.Points[0]] = mesh.Freedom[edge.Points[1]] = PointFreedom::Fixed;
    }
  }
  for (const auto& edge : mesh.NonManifoldEdges)
  {
    mesh.Freedom[edge.first] = mesh.Freedom[edge.second] = PointFreedom::Fixed;
  }
  this->SegmentsOfPoint = ends.Inverse(mesh.Points.size());
  this->SegmentOfPoint.assign(mesh.Points.size(), MeshEdge::None);
  for (std::uint32_t point = 0; point < mesh.Points.size(); ++point)
  {
    const IndexRows::Row segments = this->SegmentsOfPoint[point];
    if (segments.size() > 0 && mesh.Freedom[point] == PointFreedom::Free)
    {
      const bool isFixed = this->IsCorner(point, segments, std::cos(rules.CornerAngle));
      mesh.Freedom[point] = isFixed ? PointFreedom::Fixed : PointFreedom::AlongCurve;
      this->SegmentOfPoint[point] = segments[0];
    }
  }
  this->Freedom = mesh.Freedom;
}

inline FeatureCurves::Nearest FeatureCurves::NearestOn(
  std::uint32_t segment, const Vector3& x) const
{
  const Vector3& a = this->Positions[this->Segments[segment].Ends[0]];
  const Vector3 along = this->Positions[this->Segments[segment].Ends[1]] - a;
  const double length2 = Norm2(along);
  const double t = length2 > 0.0 ? Dot(x - a, along) / length2 : 0.0;
  const double clamped = std::min(std::max(t, 0.0), 1.0);
  const Vector3 position = a + clamped * along;
  return { position, Distance2(position, x), clamped };
}

inline std::uint32_t FeatureCurves::NextOf(std::uint32_t segment, std::uint32_t point) const
{
  const IndexRows::Row segments = this->SegmentsOfPoint[point];
  if (this->Freedom[point] != PointFreedom::AlongCurve)
  {
    return MeshEdge::None;
  }
  return segments[segments[0] == segment ? 1 : 0];
}

inline Vector3 FeatureCurves::Slide(std::uint32_t point, const Vector3& x)
{
  std::uint32_t on = this->SegmentOfPoint[point];
  Nearest best = this->NearestOn(on, x);
  while (best.Parameter == 0.0 || best.Parameter == 1.0)
  {
    const std::uint32_t end = this->Segments[on].Ends[best.Parameter == 0.0 ? 0 : 1];
    const std::uint32_t next = this->NextOf(on, end);
    const Nearest there = next == MeshEdge::None ? best : this->NearestOn(next, x);
    if (!(there.Distance2 < best.Distance2))
    {
      break;
    }
    on = next;
    best = there;
  }
  this->SegmentOfPoint[point] = on;
  return best.Position;
}

}

#endif
