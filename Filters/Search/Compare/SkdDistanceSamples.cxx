// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Compare/SkdDistanceSamples.h"

#include "Search/Compare/SkdSampleSides.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
constexpr double MostTriangles = 1 << 21;

/// Each halves the edges of what makes most of the error, down to the resolution of coordinates.
constexpr int MostRounds = 48;

/// A point and its distance, negative inside.
struct KnownDistance
{
  skd::Vector3 At;
  double Distance;
};

using Corners = std::array<KnownDistance, 3>;

/// The distance of a point, negative inside if this process knows, which that of points nearby
/// limits: it changes no faster than the point moves, and its sign does not change on a way that is
/// shorter.
template <class KnownDistances>
KnownDistance Measure(const SkdComparedSet& to, const skd::Vector3& x, const KnownDistances& nearby)
{
  constexpr double rounding = 1e-9;
  double maxDistance = std::numeric_limits<double>::max();
  const KnownDistance* sameSide = nullptr;
  for (const KnownDistance& sample : nearby)
  {
    const double moved = skd::Norm(x - sample.At);
    maxDistance = std::min(maxDistance, (std::abs(sample.Distance) + moved) * (1.0 + rounding));
    sameSide = moved < std::abs(sample.Distance) * (1.0 - rounding) ? &sample : sameSide;
  }
  auto nearest = to.FindNearest(x, maxDistance);
  if (!nearest)
  {
    nearest = to.FindNearest(x, std::numeric_limits<double>::max());
  }
  const double distance = nearest ? std::sqrt(nearest->Distance2) : 0.0;
  const bool isInside = to.KnowsSides() && (sameSide ? sameSide->Distance < 0.0 : to.IsInside(x));
  return { x, isInside ? -distance : distance };
}

double AreaOf(const Corners& corners)
{
  return 0.5 * skd::Norm(skd::Cross(corners[1].At - corners[0].At, corners[2].At - corners[0].At));
}

skd::Vector3 CentroidOf(const Corners& corners)
{
  return SkdCentroidOf({ corners[0].At, corners[1].At, corners[2].At });
}

/// The squared length of the longest edge, and which it is.
std::pair<double, int> LongestEdgeOf(const Corners& corners)
{
  std::pair<double, int> longest{ -1.0, 0 };
  for (int k = 0; k < 3; ++k)
  {
    const double length2 = skd::Distance2(corners[k].At, corners[(k + 1) % 3].At);
    longest = length2 > longest.first ? std::make_pair(length2, k) : longest;
  }
  return longest;
}

/// The ten samples of a triangle are about a third of its longest edge apart.
constexpr double EdgePerSpacing = 3.0;

/// Whether a triangle is too large for samples so far apart: not if it is long, but so narrow that
/// its neighbours have samples enough.
bool IsTooLarge(const Corners& corners, double spacing)
{
  const double edge = EdgePerSpacing * spacing;
  return edge > 0.0 && LongestEdgeOf(corners).first > edge * edge &&
    AreaOf(corners) > 0.25 * edge * edge;
}

/// Calls visit(piece) of the pieces of a triangle, bisected while they are too large; measure(x,
/// corners) is asked for the distance of middles.
template <class MeasureAt, class Visit>
void Bisect(const Corners& corners, double spacing, const MeasureAt& measure, const Visit& visit)
{
  if (!IsTooLarge(corners, spacing))
  {
    visit(corners);
    return;
  }
  const int k = LongestEdgeOf(corners).second;
  const KnownDistance middle =
    measure(skd::Lerp(corners[k].At, corners[(k + 1) % 3].At, 0.5), corners);
  for (const int replaced : { (k + 1) % 3, k })
  {
    Corners half = corners;
    half[replaced] = middle;
    Bisect(half, spacing, measure, visit);
  }
}

SkdSampledTriangle Sample(
  const SkdComparedSet& to, const Corners& corners, const KnownDistance& centroid)
{
  const std::array<KnownDistance, 4> nearby = { corners[0], corners[1], corners[2], centroid };
  SkdSampledTriangle sampled;
  std::array<KnownDistance, 3> middles;
  for (int k = 0; k < 3; ++k)
  {
    sampled.Corners[k] = corners[k].At;
    sampled.AtCorners[k] = corners[k].Distance;
  }
  for (int k = 0; k < 3; ++k)
  {
    middles[k] = Measure(to, sampled.GetMiddle(k), nearby);
    sampled.AtMiddles[k] = middles[k].Distance;
  }
  for (int k = 0; k < 3; ++k)
  {
    const KnownDistance& a = middles[k];
    const KnownDistance& b = middles[(k + 2) % 3];
    const std::array<KnownDistance, 4> around = { corners[k], a, b, centroid };
    sampled.AtCentroids[k] = Measure(to, sampled.GetCentroid(k), around).Distance;
  }
  sampled.AtCentroids[3] = centroid.Distance;
  sampled.Area = AreaOf(corners);
  return sampled;
}

/// The corners of a part of a triangle, the last one in the middle.
Corners PartOf(const SkdSampledTriangle& whole, int part)
{
  const auto middle = [&](int k) {
    return KnownDistance{ whole.GetMiddle(k % 3), whole.AtMiddles[k % 3] };
  };
  return part == 3 ? Corners{ middle(0), middle(1), middle(2) }
                   : Corners{ KnownDistance{ whole.Corners[part], whole.AtCorners[part] },
                       middle(part), middle(part + 2) };
}

/// The own triangles of a set that have an area, and where their pieces begin.
class FirstPieces
{
public:
  FirstPieces(const SkdComparedSet& set, double spacing, const SkdReduction& all);

  vtkIdType GetNumberOfPieces() const { return this->Firsts.back(); }
  vtkIdType GetFirst(vtkIdType i) const { return this->Firsts[i]; }
  double GetSpacing() const { return this->Spacing; }

  Corners GetCorners(vtkIdType element, const std::vector<double>& distances) const
  {
    const SkdTriangleIds& ids = this->Set.GetElements()[element];
    Corners corners;
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = { this->Set.GetPoints()[ids[k]], distances.empty() ? 0.0 : distances[ids[k]] };
    }
    return corners;
  }

private:
  double Estimate(const SkdReduction& all) const;

  const SkdComparedSet& Set;
  double Spacing;
  std::vector<vtkIdType> Firsts{ 0 };
};

FirstPieces::FirstPieces(const SkdComparedSet& set, double spacing, const SkdReduction& all)
  : Set(set)
  , Spacing(spacing)
{
  while (this->Spacing > 0.0 && this->Estimate(all) > MostTriangles)
  {
    this->Spacing *= 1.5;
  }
  for (vtkIdType i = 0; i < set.GetNumberOfOwn(); ++i)
  {
    const Corners corners = this->GetCorners(set.GetOwn(i), {});
    vtkIdType pieces = 0;
    if (AreaOf(corners) > 0.0)
    {
      Bisect(
        corners, this->Spacing,
        [](const skd::Vector3& x, const Corners&) {
          return KnownDistance{ x, 0.0 };
        },
        [&](const Corners&) { ++pieces; });
    }
    this->Firsts.push_back(this->Firsts.back() + pieces);
  }
}

/// About the number of pieces of all processes, beside one of each triangle.
double FirstPieces::Estimate(const SkdReduction& all) const
{
  SkdCompensatedSum pieces;
  for (vtkIdType i = 0; i < this->Set.GetNumberOfOwn(); ++i)
  {
    const Corners corners = this->GetCorners(this->Set.GetOwn(i), {});
    if (IsTooLarge(corners, this->Spacing))
    {
      const double edge = EdgePerSpacing * this->Spacing;
      pieces.Add(8.0 * AreaOf(corners) / (edge * edge));
    }
  }
  return all.Sum(std::vector<SkdCompensatedSum>{ pieces })[0];
}

/// The distances of the points of a set's own elements; 0 of others.
bool MeasureAll(const SkdComparedSet& from, const SkdComparedSet& to, SkdLoop loop,
  std::vector<double>& distances)
{
  const std::vector<skd::Vector3>& points = from.GetPoints();
  const std::vector<unsigned char> isOwn = from.FindOwnPoints();
  distances.resize(points.size());
  return loop.For(static_cast<vtkIdType>(points.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        distances[i] =
          isOwn[i] ? Measure(to, points[i], std::array<KnownDistance, 0>{}).Distance : 0.0;
      }
    });
}

KnownDistance CentreOf(const SkdComparedSet& to, const Corners& corners)
{
  return Measure(to, CentroidOf(corners), corners);
}

bool SampleAll(const SkdComparedSet& from, const SkdComparedSet& to, const FirstPieces& pieces,
  const std::vector<double>& distances, SkdLoop loop, std::vector<SkdSampledTriangle>& triangles)
{
  triangles.resize(static_cast<std::size_t>(pieces.GetNumberOfPieces()));
  const auto measure = [&to](const skd::Vector3& x, const Corners& nearby)
  { return Measure(to, x, nearby); };
  return loop.For(from.GetNumberOfOwn(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        auto* next = triangles.data() + pieces.GetFirst(i);
        if (pieces.GetFirst(i + 1) > pieces.GetFirst(i))
        {
          Bisect(pieces.GetCorners(from.GetOwn(i), distances), pieces.GetSpacing(), measure,
            [&](const Corners& piece) { *next++ = Sample(to, piece, CentreOf(to, piece)); });
        }
      }
    });
}
}

// Of what was divided the first part takes its place; the others follow all.
bool SkdDistanceSamples::Divide(const std::vector<std::size_t>& chosen, const SkdComparedSet& to,
  const SkdReduction& all, SkdLoop loop)
{
  std::vector<SkdSampledTriangle> parts(4 * chosen.size());
  loop.SetTotal(static_cast<vtkIdType>(chosen.size()) + SkdStepsForSides(to, parts.size()));
  bool isWhole = loop.For(static_cast<vtkIdType>(chosen.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const SkdSampledTriangle& whole = this->Triangles[chosen[i]];
        for (int part = 0; part < 4; ++part)
        {
          const Corners corners = PartOf(whole, part);
          parts[4 * i + part] =
            Sample(to, corners, { CentroidOf(corners), whole.AtCentroids[part] });
        }
      }
    });
  isWhole = !all.IsAny(!isWhole) && SkdFindSides(to, parts, true, loop);
  for (std::size_t i = 0; isWhole && i < chosen.size(); ++i)
  {
    this->Triangles[chosen[i]] = parts[4 * i];
    this->Triangles.insert(this->Triangles.end(), &parts[4 * i + 1], &parts[4 * i] + 4);
  }
  return isWhole;
}

// Each round takes half of the progress that is left, for nobody knows how many there will be.
bool SkdDistanceSamples::Add(const SkdComparedSet& from, const SkdComparedSet& to,
  const SkdSampling& sampling, const SkdReduction& all, vtkAlgorithm* self, double first,
  double last)
{
  const auto loopOf = [&](std::size_t steps)
  {
    const double begin = first;
    first = (first + last) / 2.0;
    return SkdLoop(self, static_cast<vtkIdType>(steps), begin, first);
  };
  std::vector<double> distances;
  bool isGoing = !all.IsAny(!MeasureAll(from, to, loopOf(from.GetPoints().size()), distances));
  if (isGoing && !from.IsSurface())
  {
    for (vtkIdType i = 0; i < from.GetNumberOfOwn(); ++i)
    {
      this->Points.push_back(distances[from.GetElements()[from.GetOwn(i)][0]]);
    }
  }
  else if (isGoing)
  {
    const FirstPieces pieces(from, sampling.Spacing, all);
    isGoing = !all.IsAny(
      !SampleAll(from, to, pieces, distances, loopOf(from.GetElements().size()), this->Triangles));
    const vtkIdType steps = SkdStepsForSides(to, this->Triangles.size());
    SkdLoop loop = loopOf(static_cast<std::size_t>(steps));
    isGoing = isGoing && SkdFindSides(to, this->Triangles, false, loop);
  }
  std::vector<std::size_t> chosen;
  for (int round = 0; isGoing && from.IsSurface() && round < MostRounds &&
       this->FindTrianglesToDivide(sampling.Tolerance, all, chosen);
       ++round)
  {
    isGoing = this->Divide(chosen, to, all, loopOf(0));
  }
  if (isGoing)
  {
    this->Evaluate(true, all);
  }
  return isGoing;
}

// Quantiles, which cost most, wait until the means are known well enough. Returns whether any
// process has some to divide.
bool SkdDistanceSamples::FindTrianglesToDivide(const SkdStatisticsTolerance& tolerance,
  const SkdReduction& all, std::vector<std::size_t>& chosen)
{
  const bool isFull =
    static_cast<double>(all.Sum(static_cast<long long>(this->Triangles.size()))) > MostTriangles;
  for (const bool wantsQuantiles : { false, true })
  {
    if (isFull)
    {
      return false;
    }
    this->Evaluate(wantsQuantiles, all);
    chosen = SkdTrianglesToDivide(this->Triangles, this->Statistics, tolerance, all);
    if (all.IsAny(!chosen.empty()))
    {
      return true;
    }
  }
  return false;
}

void SkdDistanceSamples::Add(const SkdDistanceSamples& other, const SkdReduction& all)
{
  this->Triangles.insert(this->Triangles.end(), other.Triangles.begin(), other.Triangles.end());
  this->Points.insert(this->Points.end(), other.Points.begin(), other.Points.end());
  this->Evaluate(true, all);
}
}
