// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Rays/SkdHitCells.h"

#include "Exchange/SkdNearestExchange.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace skdtree
{
namespace
{
/// With what the process of the ray has decided from its own Input.
struct Ray
{
  skd::Vector3 Start;
  skd::Vector3 Direction;
  double Tolerance;
};

/// Rays at the own piece; blocks and ids of hits are those of the whole.
class OwnHits
{
public:
  using Vectors = std::vector<skd::Vector3>;

  OwnHits(const SkdSourceTrees& trees, const SkdSpreadSource& spread, const SkdRayLimits& limits)
    : Trees(trees)
    , Spread(spread)
    , Limits(limits)
  {
  }

  /// Calls cast(caster, starts, directions) with n rays of one process. Unless `isMerged` hits at
  /// one point are not one.
  template <class RayOf, class Cast>
  void ForAll(std::size_t n, const RayOf& rayOf, bool isMerged, const Cast& cast) const
  {
    if (n == 0)
    {
      return;
    }
    Vectors starts(n);
    Vectors directions(n);
    for (std::size_t i = 0; i < n; ++i)
    {
      starts[i] = rayOf(i).Start;
      directions[i] = rayOf(i).Direction;
    }
    SkdRayLimits limits = this->Limits;
    limits.Tolerance = isMerged ? rayOf(0).Tolerance : -1.0;
    limits.Start = std::copysign(rayOf(0).Tolerance, this->Limits.Start);
    const auto blocks = static_cast<int>(this->Spread.GetBlocks().size());
    cast(SkdRayCaster(this->Trees, blocks, limits), starts, directions);
  }

  SkdRayHit Joined(SkdRayHit hit) const
  {
    hit.CellId = this->Spread.IdOf(hit.Block, hit.CellId);
    return hit;
  }

  /// The other processes that have a box on a ray, not farther than a distance.
  void ListNear(const Ray& ray, double distance, std::vector<SkdNearProcess>& near) const
  {
    if (skd::Dot(ray.Direction, ray.Direction) > 0.0)
    {
      const double maxDistance = distance + ray.Tolerance;
      this->Spread.ListAlong(ray.Start, ray.Direction,
        this->Limits.BothWays ? maxDistance : ray.Tolerance, maxDistance, ray.Tolerance, near);
    }
  }

private:
  const SkdSourceTrees& Trees;
  const SkdSpreadSource& Spread;
  SkdRayLimits Limits;
};

/// See SkdNearestExchange.
class FirstHits
{
public:
  using Query = Ray;
  using Answer = SkdRayHit;

  FirstHits(const OwnHits& own, double tolerance)
    : Own(own)
    , Tolerance(tolerance)
  {
  }

  static bool IsBetter(const SkdRayHit& a, const SkdRayHit& b)
  {
    return std::abs(a.Distance) < std::abs(b.Distance);
  }

  /// Distances in different pieces are rounded in different ways.
  double RadiusOf(const SkdRayHit& hit) const { return std::abs(hit.Distance) + this->Tolerance; }

  template <class QuestionOf, class Set>
  void FindHere(std::size_t n, const QuestionOf& questionOf, const Set& set) const
  {
    this->Own.ForAll(
      n, [&](std::size_t i) { return questionOf(i).Request; }, true,
      [&](const SkdRayCaster& caster, const OwnHits::Vectors& starts,
        const OwnHits::Vectors& directions)
      {
        std::vector<SkdRayHit> hits;
        caster.FindFirstOf(starts, directions, 0, static_cast<vtkIdType>(n), hits);
        SkdForEach(n,
          [&](std::size_t i)
          {
            if (hits[i].Block >= 0)
            {
              set(i, this->Own.Joined(hits[i]));
            }
          });
      });
  }

  void ListNear(const Ray& ray, double radius, std::vector<SkdNearProcess>& near) const
  {
    this->Own.ListNear(ray, radius, near);
  }

private:
  const OwnHits& Own;
  double Tolerance;
};

/// All hits, each ray in one round.
class AllHits
{
public:
  AllHits(vtkAlgorithm* algorithm, const OwnHits& own, SkdTransport& transport, double maximum)
    : Algorithm(algorithm)
    , Own(own)
    , Transport(transport)
    , Maximum(maximum)
  {
  }

  void Find(const std::vector<Ray>& rays, SkdLoop& loop, SkdHitCells& cells) const
  {
    const std::size_t share = SkdSizeOfRound(this->Transport.GetNumber(), sizeof(Ray));
    std::size_t begin = 0;
    while (true)
    {
      const int rest = begin < rays.size() ? 1 : 0;
      const int state = SkdMostOf(this->Transport, SkdIsAborted(this->Algorithm) ? 2 : rest);
      if (state != 1)
      {
        cells.IsWhole = state == 0;
        return;
      }
      const std::size_t end = std::min(rays.size(), begin + share);
      const auto rayOf = [&](std::size_t i) { return rays[begin + i]; };
      this->FindHere(end - begin, rayOf, loop,
        [&](std::size_t, const SkdRayHit& hit) {
          cells.Cells.push_back({ this->Transport.GetRank(), hit.Block, hit.CellId });
        });
      cells.RaysSent += this->AskOthers(end - begin, rayOf, cells);
      begin = end;
    }
  }

private:
  template <class RayOf, class Add>
  void FindHere(std::size_t n, const RayOf& rayOf, SkdLoop& loop, const Add& add) const
  {
    this->Own.ForAll(n, rayOf, false,
      [&](const SkdRayCaster& caster, const OwnHits::Vectors& starts,
        const OwnHits::Vectors& directions)
      {
        const SkdRayHitLists lists = caster.FindAll(starts, directions, loop);
        for (std::size_t i = 0; i < n; ++i)
        {
          for (const SkdRayHit& hit : lists[i])
          {
            add(i, this->Own.Joined(hit));
          }
        }
      });
  }

  template <class RayOf>
  std::uint64_t AskOthers(std::size_t n, const RayOf& rayOf, SkdHitCells& cells) const
  {
    return SkdAskOthers<Ray, SkdRayHit>(
      this->Transport, n,
      [&](std::size_t i, std::vector<int>& processes)
      {
        std::vector<SkdNearProcess> near;
        this->Own.ListNear(rayOf(i), this->Maximum, near);
        std::transform(near.begin(), near.end(), std::back_inserter(processes),
          [](const SkdNearProcess& other) { return other.Process; });
      },
      rayOf,
      [this](const std::vector<Ray>& rays, std::vector<SkdNumberedAnswer<SkdRayHit>>& answers)
      {
        SkdLoop silent(this->Algorithm, 1, this->Algorithm->GetProgress(),
          this->Algorithm->GetProgress(), static_cast<vtkIdType>(rays.size()) + 1);
        this->FindHere(
          rays.size(), [&](std::size_t i) { return rays[i]; }, silent,
          [&](std::size_t i, const SkdRayHit& hit) {
            answers.push_back({ static_cast<std::uint32_t>(i), hit });
          });
      },
      [&](std::size_t, const SkdRayHit& hit, int process) {
        cells.Cells.push_back({ process, hit.Block, hit.CellId });
      });
  }

  vtkAlgorithm* Algorithm;
  const OwnHits& Own;
  SkdTransport& Transport;
  double Maximum;
};

void AddRays(const std::vector<skd::Vector3>& starts, const std::vector<skd::Vector3>& directions,
  double tolerance, std::vector<Ray>& rays)
{
  for (std::size_t i = 0; i < starts.size(); ++i)
  {
    rays.push_back({ starts[i], directions[i], tolerance });
  }
}

SkdHitCells FindFirst(const std::vector<Ray>& rays, const OwnHits& own,
  const SkdSpreadSource& spread, const SkdRayLimits& limits, SkdLoop& loop)
{
  SkdHitCells hits;
  const FirstHits first(own, limits.Tolerance);
  SkdNearestExchange<FirstHits> exchange(spread.GetTransport(), first);
  hits.IsWhole = exchange.Find(
    rays.size(), limits.Maximum, [&](std::size_t i) { return rays[i]; },
    [](std::size_t, const SkdRayHit&, int) {},
    [&](const SkdRayHit& hit, int process) {
      hits.Cells.push_back({ process, hit.Block, hit.CellId });
    },
    loop);
  hits.RaysSent = exchange.CountRequests();
  return hits;
}
}

SkdHitCells SkdFindHitCells(vtkAlgorithm* algorithm, const std::vector<SkdCastRays>& casts,
  const SkdSourceTrees& trees, const SkdSpreadSource& spread, const SkdRayLimits& limits, bool all,
  SkdLoop& loop)
{
  std::vector<Ray> rays;
  for (const SkdCastRays& cast : casts)
  {
    AddRays(cast.Starts.Points, cast.Starts.Directions, limits.Tolerance, rays);
  }
  const OwnHits own(trees, spread, limits);
  if (!all)
  {
    return FindFirst(rays, own, spread, limits, loop);
  }
  SkdHitCells hits;
  AllHits(algorithm, own, spread.GetTransport(), limits.Maximum).Find(rays, loop, hits);
  return hits;
}

SkdHitCells SkdFindHitCells(const SkdRayCaster::Vectors& starts,
  const SkdRayCaster::Vectors& directions, const SkdSourceTrees& trees,
  const SkdSpreadSource& spread, const SkdRayLimits& limits, SkdLoop& loop)
{
  std::vector<Ray> rays;
  AddRays(starts, directions, limits.Tolerance, rays);
  return FindFirst(rays, OwnHits(trees, spread, limits), spread, limits, loop);
}
}
