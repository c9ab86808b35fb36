// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Rays/SkdThickness.h"

#include "Cells/Read/SkdForEach.h"
#include "Search/Rays/SkdSurfaceNormals.h"
#include "Search/Rays/SkdUnitVector.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
using skd::Vector3;

/// Directions within a cone about the third axis: evenly over the solid angle, rotated by the
/// golden angle from one to the next.
std::vector<Vector3> MakeCone(int rays, double angle)
{
  const double golden = vtkMath::Pi() * (3.0 - std::sqrt(5.0));
  std::vector<Vector3> cone;
  for (int i = 0; i < rays; ++i)
  {
    const double drop = rays > 1 ? (1.0 - std::cos(angle)) * i / (rays - 1) : 0.0;
    const double across = std::sqrt(drop * (2.0 - drop));
    cone.push_back(
      { { across * std::cos(golden * i), across * std::sin(golden * i), 1.0 - drop } });
  }
  return cone;
}

/// A direction about `axis`, given about the third axis: T. Duff et al., "Building an orthonormal
/// basis, revisited", Journal of Computer Graphics Techniques 6 (2017) 1-8.
Vector3 Rotated(const Vector3& direction, const Vector3& axis)
{
  const double sign = std::copysign(1.0, axis[2]);
  const double a = -1.0 / (sign + axis[2]);
  const double b = axis[0] * axis[1] * a;
  const Vector3 first{ { 1.0 + sign * axis[0] * axis[0] * a, sign * b, -sign * axis[0] } };
  const Vector3 second{ { b, sign + axis[1] * axis[1] * a, -axis[1] } };
  return direction[0] * first + direction[1] * second + direction[2] * axis;
}

/// The radius of the sphere that touches a plane at a point, given its normal, and passes through
/// the end of `chord` from there.
double RadiusThrough(const Vector3& chord, const Vector3& normal)
{
  return skd::Norm2(chord) / (2.0 * skd::Dot(chord, normal));
}
}

SkdThicknessMeasure::SkdThicknessMeasure(const SkdTiedNearest& nearest, const SkdRayCaster& caster,
  const SkdBodyExit* exits, const SkdThicknessRule& rule)
  : Nearest(nearest)
  , Caster(caster)
  , Exits(exits)
  , Rule(rule)
  , Cone(MakeCone(rule.AreSpheres ? 1 : rule.Rays, rule.ConeAngle))
{
}

void SkdThicknessMeasure::ListRays(const SkdRayCaster::Vectors& points,
  const SkdRayCaster::Vectors& inward, vtkIdType begin, vtkIdType end,
  SkdRayCaster::Vectors& starts, SkdRayCaster::Vectors& rays) const
{
  const std::size_t each = this->Cone.size();
  const std::size_t number = static_cast<std::size_t>(end - begin) * each;
  starts.resize(number);
  rays.resize(number);
  SkdForEach(number,
    [&](std::size_t i)
    {
      const std::size_t point = static_cast<std::size_t>(begin) + i / each;
      starts[i] = points[point];
      rays[i] = each > 1 ? SkdUnit(Rotated(this->Cone[i % each], inward[point])) : inward[point];
      rays[i] = skd::Norm2(inward[point]) > 0.0 ? rays[i] : inward[point];
    });
}

std::vector<SkdThickness> SkdThicknessMeasure::Measure(
  const SkdRayCaster::Vectors& points, const SkdRayCaster::Vectors& inward, SkdLoop& loop) const
{
  std::vector<SkdThickness> answers(points.size());
  SkdRayCaster::Vectors starts;
  SkdRayCaster::Vectors rays;
  std::vector<SkdRayHit> hits;
  const std::size_t each = this->Cone.size();
  loop.InPieces(static_cast<vtkIdType>(points.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      const auto number = static_cast<std::size_t>(end - begin);
      this->ListRays(points, inward, begin, end, starts, rays);
      this->Caster.FindFirstOf(starts, rays, 0, static_cast<vtkIdType>(starts.size()), hits);
      SkdForEach(
        number,
        [&](std::size_t i)
        {
          const std::size_t first = i * each;
          answers[static_cast<std::size_t>(begin) + i] = this->Rule.AreSpheres
            ? this->Shrink(starts[first], rays[first], hits[first])
            : this->FindMedian(&starts[first], &rays[first], &hits[first]);
        },
        64);
    });
  return answers;
}

/// Rays that begin outside, as those across the edge of a wedge do, have none.
SkdRayHit SkdThicknessMeasure::FindEnd(
  const SkdRayHit& first, const Vector3& start, const Vector3& ray) const
{
  const SkdRayHit end = this->Exits ? this->Exits->Find(start, ray, first) : first;
  return end.Block >= 0 && end.Distance <= this->Rule.Maximum ? end : SkdRayHit{ 0.0, -1, -1 };
}

SkdThickness SkdThicknessMeasure::FindMedian(
  const Vector3* starts, const Vector3* rays, const SkdRayHit* hits) const
{
  thread_local std::vector<std::pair<double, std::size_t>> distances;
  thread_local std::vector<SkdRayHit> ends;
  distances.clear();
  ends.resize(this->Cone.size());
  for (std::size_t i = 0; i < this->Cone.size(); ++i)
  {
    ends[i] = this->FindEnd(hits[i], starts[i], rays[i]);
    if (ends[i].Block >= 0)
    {
      distances.emplace_back(ends[i].Distance, i);
    }
  }
  if (distances.empty())
  {
    return {};
  }
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>((distances.size() - 1) / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  const auto [distance, i] = *middle;
  return { distance, starts[i] + distance * rays[i], ends[i].CellId, ends[i].Block };
}

/// Any point of the surface that is inside a sphere bounds it: the first is where the normal hits.
SkdThickness SkdThicknessMeasure::Shrink(
  const Vector3& point, const Vector3& inward, const SkdRayHit& first) const
{
  constexpr int most = 100; // each step but the last few halves the sphere, or more
  SkdThickness thickness;
  if (!(skd::Norm2(inward) > 0.0) || !skd::IsFinite(point))
  {
    return thickness;
  }
  const bool mayBeOwn = this->Exits && this->Exits->HasOwnHits();
  const SkdRayHit bound = mayBeOwn ? this->FindEnd(first, point, inward) : first;
  double radius = this->Rule.Maximum / 2.0;
  if (bound.Block >= 0)
  {
    radius = bound.Distance / 2.0;
    thickness = { bound.Distance, point + bound.Distance * inward, bound.CellId, bound.Block };
  }
  const bool areTied = bound.Block >= 0 && this->Nearest.AreMany(point + radius * inward, radius);
  for (int i = 0; i < most; ++i)
  {
    const Vector3 centre = point + radius * inward;
    const auto nearest =
      areTied ? this->Nearest.Find(centre, radius) : this->Nearest.FindExact(centre, radius);
    const double slack = std::max(1e-9 * radius, this->Rule.Rounding);
    if (!nearest || std::sqrt(nearest->Distance2) >= radius - slack)
    {
      break;
    }
    const Vector3 contact{ { nearest->Point[0], nearest->Point[1], nearest->Point[2] } };
    const Vector3 chord = contact - point;
    const double next = RadiusThrough(chord, inward);
    const double cosine = 1.0 - skd::Norm2(chord) / (2.0 * next * next);
    if (!(next > 0.0 && next < radius) || cosine > std::cos(this->Rule.Separation))
    {
      break;
    }
    radius = next;
    thickness = { 2.0 * radius, contact, nearest->CellId, nearest->Block };
  }
  return thickness;
}
}
