// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Closest/SkdRemoteClosest.h"

#include "Exchange/SkdNearestExchange.h"
#include "Pipeline/SkdCoherentSource.h"

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

/// The points of several meshes, one after the other.
class AllPoints
{
public:
  explicit AllPoints(const std::vector<SkdBlock>& meshes)
    : Meshes(meshes)
  {
    for (const SkdBlock& mesh : meshes)
    {
      this->Offsets.push_back(
        this->Offsets.back() + static_cast<std::size_t>(mesh.Mesh->GetNumberOfPoints()));
    }
  }

  std::size_t GetNumber() const { return this->Offsets.back(); }

  /// Calls visit(mesh, point) with the mesh and the id of a point.
  template <class Visit>
  void SetResult(std::size_t i, const Visit& visit) const
  {
    const auto next = std::upper_bound(this->Offsets.begin(), this->Offsets.end(), i);
    const auto mesh = static_cast<std::size_t>(next - this->Offsets.begin()) - 1;
    visit(mesh, static_cast<vtkIdType>(i - this->Offsets[mesh]));
  }

  skd::Vector3 Get(std::size_t i) const
  {
    skd::Vector3 x;
    this->SetResult(
      i, [&](std::size_t mesh, vtkIdType point) { this->Meshes[mesh].Mesh->GetPoint(point, x.X); });
    return x;
  }

private:
  const std::vector<SkdBlock>& Meshes;
  std::vector<std::size_t> Offsets{ 0 };
};

/// Returns whether it was not aborted on any process.
template <class Own>
bool Find(const AllPoints& points, const Own& own, const SkdSpreadSource& spread,
  double maximumDistance, SkdLoop& loop, SkdRemoteClosest& closest)
{
  const Searcher<Own> searcher(own, spread);
  SkdNearestExchange<Searcher<Own>> exchange(spread.GetTransport(), searcher);
  const bool isWhole = exchange.Find(
    points.GetNumber(), maximumDistance, [&](std::size_t i) { return points.Get(i); },
    [&](std::size_t i, const SkdNearest& nearest, int process)
    {
      points.SetResult(i,
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
  Find(AllPoints(meshes), OwnCells(own, spread), spread, maximumDistance, loop, closest);
  return closest;
}

// After an abort points would have distances without signs: then none has any.
std::optional<SkdRemoteClosest> SkdFindRemoteSigned(const std::vector<SkdBlock>& meshes,
  SkdSpreadBody& body, const SkdSpreadSource& spread, double maximumDistance, SkdLoop& loop)
{
  SkdRemoteClosest closest = MakeEmpty(meshes);
  const AllPoints points(meshes);
  if (!Find(points, body, spread, maximumDistance, loop, closest))
  {
    return MakeEmpty(meshes);
  }
  const auto hasNearest = [&](std::size_t i)
  {
    bool has = false;
    points.SetResult(i,
      [&](std::size_t mesh, vtkIdType point) { has = closest.Answers[mesh].GetBlock(point) >= 0; });
    return has;
  };
  const SkdSpreadResult result = body.FindSides(
    points.GetNumber(), [&](std::size_t i) { return points.Get(i); }, hasNearest,
    [&](std::size_t i, bool isInside)
    {
      points.SetResult(i,
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
