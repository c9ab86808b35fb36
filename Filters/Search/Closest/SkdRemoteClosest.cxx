// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Closest/SkdRemoteClosest.h"

#include "Exchange/SkdNearestExchange.h"
#include "Pipeline/SkdCoherentSource.h"
#include "Pipeline/SkdPointsOfBlocks.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace skdtree
{
namespace
{
/// The cells of the own piece; blocks and ids are those of the whole.
class OwnCells
{
public:
  OwnCells(const SkdSource& own, const SkdSpreadSource& spread)
    : Own(own)
    , Spread(spread)
  {
    for (const SkdBlock& block : own.GetBlocks())
    {
      this->BlockSlots.push_back(spread.BlockSlotOf(block.BlockIndex));
    }
  }

  std::optional<SkdNearest> FindNearest(const double x[3], double radius) const
  {
    auto nearest = this->Own.FindNearest(x, radius);
    if (nearest)
    {
      nearest->Block = this->BlockSlots[static_cast<std::size_t>(nearest->Block)];
      nearest->CellId = this->Spread.IdOf(nearest->Block, nearest->CellId);
    }
    return nearest;
  }

private:
  const SkdSource& Own;
  const SkdSpreadSource& Spread;
  std::vector<int> BlockSlots; // of the own blocks among those of the whole
};

/// See SkdNearestExchange. `Own` has a FindNearest(x, radius) of the own piece.
template <class Own>
class Searcher
{
public:
  using Query = skd::Vector3;
  using Answer = SkdNearest;

  Searcher(const Own& own, const SkdSpreadSource& spread)
    : TheOwn(own)
    , Spread(spread)
  {
  }

  static bool IsBetter(const SkdNearest& a, const SkdNearest& b)
  {
    return std::tie(a.Distance2, a.Block, a.CellId) < std::tie(b.Distance2, b.Block, b.CellId);
  }

  static double RadiusOf(const SkdNearest& nearest)
  {
    return SkdRadiusIncluding(nearest.Distance2);
  }

  template <class QuestionOf, class Set>
  void FindHere(std::size_t n, const QuestionOf& questionOf, const Set& set) const
  {
    constexpr std::size_t block = 256; // of questions that follow each other
    SkdForEach((n + block - 1) / block,
      [&](std::size_t at)
      {
        SkdCoherentSource coherent(this->TheOwn);
        for (std::size_t i = at * block; i < std::min(n, (at + 1) * block); ++i)
        {
          const auto question = questionOf(i);
          if (const auto nearest = coherent.FindNearest(question.Request.X, question.Radius))
          {
            set(i, *nearest);
          }
        }
      },
      n > block ? 1 : 0);
  }

  void ListNear(const skd::Vector3& x, double radius, std::vector<SkdNearProcess>& near) const
  {
    this->Spread.ListNear(x, radius, near);
  }

private:
  const Own& TheOwn;
  const SkdSpreadSource& Spread;
};

/// Returns whether it was not aborted on any process.
template <class Own>
bool Find(const SkdPointsOfBlocks& points, const Own& own, const SkdSpreadSource& spread,
  double maximumDistance, SkdLoop& loop, SkdRemoteClosest& closest)
{
  const Searcher<Own> searcher(own, spread);
  SkdNearestExchange<Searcher<Own>> exchange(spread.GetTransport(), searcher);
  const bool isWhole = exchange.Find(
    points.GetNumber(), maximumDistance, [&](std::size_t i) { return points.Get(i); },
    [&](std::size_t i, const SkdNearest& nearest, int process)
    {
      points.Visit(i,
        [&](std::size_t mesh, vtkIdType point)
        { closest.Answers[mesh].Set(point, nearest, false); });
      closest.Cells.push_back({ process, nearest.Block, nearest.CellId });
    },
    loop);
  closest.PointsSent = exchange.CountRequests();
  return isWhole;
}

SkdRemoteClosest MakeEmpty(const std::vector<SkdBlock>& meshes)
{
  SkdRemoteClosest closest;
  for (const SkdBlock& mesh : meshes)
  {
    closest.Answers.emplace_back(mesh.Mesh->GetNumberOfPoints());
  }
  return closest;
}
}

SkdRemoteClosest SkdFindRemoteClosest(const std::vector<SkdBlock>& meshes, const SkdSource& own,
  const SkdSpreadSource& spread, double maximumDistance, SkdLoop& loop)
{
  SkdRemoteClosest closest = MakeEmpty(meshes);
  Find(SkdPointsOfBlocks(meshes), OwnCells(own, spread), spread, maximumDistance, loop, closest);
  return closest;
}

// After an abort points would have distances without signs: then none has any.
std::optional<SkdRemoteClosest> SkdFindRemoteSigned(const std::vector<SkdBlock>& meshes,
  SkdSpreadBody& body, const SkdSpreadSource& spread, double maximumDistance, SkdLoop& loop)
{
  SkdRemoteClosest closest = MakeEmpty(meshes);
  const SkdPointsOfBlocks points(meshes);
  if (!Find(points, body, spread, maximumDistance, loop, closest))
  {
    return MakeEmpty(meshes);
  }
  const auto hasNearest = [&](std::size_t i)
  {
    bool has = false;
    points.Visit(i,
      [&](std::size_t mesh, vtkIdType point) { has = closest.Answers[mesh].GetBlock(point) >= 0; });
    return has;
  };
  const SkdSpreadResult result = body.FindSides(
    points.GetNumber(), [&](std::size_t i) { return points.Get(i); }, hasNearest,
    [&](std::size_t i, bool isInside)
    {
      points.Visit(i,
        [&](std::size_t mesh, vtkIdType point)
        { closest.Answers[mesh].SetInside(point, isInside); });
    },
    loop);
  closest.PointsSent += body.CountRequests();
  if (result == SkdSpreadResult::Aborted)
  {
    return MakeEmpty(meshes);
  }
  return result == SkdSpreadResult::Done ? std::make_optional(std::move(closest)) : std::nullopt;
}
}
