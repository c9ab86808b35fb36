// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Relations/SkdSpatialSearch.h"

#include <algorithm>
#include <cmath>
#include <tuple>

struct SkdSpatialSearch::Candidate
{
  std::uint32_t Part;
  std::uint32_t Cell;
};

namespace
{
constexpr double Nan = std::numeric_limits<double>::quiet_NaN();

/// By distance, ties to the lowest.
bool IsNearer(const SkdRelatedCell& a, const SkdRelatedCell& b)
{
  const auto key = [](const SkdRelatedCell& cell)
  {
    const double distance = std::isnan(cell.OfCells.Min) ? cell.OfBoxes.Min : cell.OfCells.Min;
    return std::make_tuple(distance, cell.Part, cell.CellId);
  };
  return key(a) < key(b);
}
}

//------------------------------------------------------------------------------
SkdSpatialSearch::SkdSpatialSearch(const SkdParts& mesh, const SkdSearchRules& rules)
  : Mesh(mesh)
  , Rules(rules)
{
  for (std::uint32_t part = 0; part < mesh.GetNumberOfParts(); ++part)
  {
    const SkdCellStore& cells = mesh.GetTree(part).Cells();
    this->Bounds.Add(cells.GetBounds());
    this->NumberOfCells += cells.NumberOfCells();
  }
}

//------------------------------------------------------------------------------
SkdRelatedCell SkdSpatialSearch::MakeCell(
  const SkdQueryShape& shape, const Candidate& candidate) const
{
  const SkdCellTree& tree = this->Mesh.GetTree(candidate.Part);
  const skd::Box3 box = tree.SafetyBoxOf(candidate.Cell);
  return { 0, candidate.Part, tree.Cells().IdOf(candidate.Cell),
    { shape.OptimisticDistance(box), shape.PessimisticDistance(box) }, { Nan, Nan } };
}

//------------------------------------------------------------------------------
std::optional<SkdRelatedCell> SkdSpatialSearch::Ask(
  const SkdQueryShape& shape, const Candidate& candidate) const
{
  const SkdCellTree& tree = this->Mesh.GetTree(candidate.Part);
  const double tolerance = std::max(this->Rules.Tolerance, shape.Rounding(tree));
  const bool isNearest = this->Rules.Relation == SkdRelation::Nearest;
  if (!isNearest && !shape.IsCandidate(this->Rules.Relation, tree, candidate.Cell, tolerance))
  {
    return std::nullopt;
  }
  SkdRelatedCell related = this->MakeCell(shape, candidate);
  if (this->Rules.IsExact)
  {
    const auto distances = SkdCellRelation(shape, this->Rules)
                             .Ask(tree, candidate.Cell, this->Mesh.GetSource(candidate.Part));
    if (!distances)
    {
      return std::nullopt;
    }
    related.OfCells = *distances;
  }
  return related;
}

//------------------------------------------------------------------------------
std::vector<SkdSpatialSearch::Candidate> SkdSpatialSearch::FindCandidates(
  const SkdQueryShape& shape, double reach) const
{
  std::vector<Candidate> candidates;
  for (std::uint32_t part = 0; part < this->Mesh.GetNumberOfParts(); ++part)
  {
    for (const std::uint32_t cell : shape.FindNear(this->Mesh.GetTree(part), reach))
    {
      candidates.push_back({ part, cell });
    }
  }
  return candidates;
}

//------------------------------------------------------------------------------
SkdSpatialSearch::Cells SkdSpatialSearch::FindRelated(const SkdQueryShape& shape) const
{
  Cells found;
  for (const Candidate& candidate : this->FindCandidates(shape, this->Rules.Tolerance))
  {
    if (const auto related = this->Ask(shape, candidate))
    {
      found.push_back(*related);
    }
  }
  return found;
}

//------------------------------------------------------------------------------
// The boxes that come as near as some reach hold all that is as near. The reach grows until what is
// found in it is sure to be nearest; `search` tells how far these are, or that it has too few.
template <class Search>
SkdSpatialSearch::Cells SkdSpatialSearch::FindWidening(
  const SkdQueryShape& shape, const Search& search) const
{
  const std::size_t all = this->NumberOfCells;
  if (all == 0)
  {
    return {};
  }
  const double diagonal = this->Bounds.Diagonal();
  const double size = diagonal > 0.0 ? diagonal : shape.PessimisticDistance(this->Bounds);
  double width = size / std::cbrt(static_cast<double>(all));
  double reach = shape.LowerBound(this->Bounds) + this->Rules.Tolerance;
  while (true)
  {
    std::vector<Candidate> candidates = this->FindCandidates(shape, reach);
    const bool isAll = candidates.size() == all;
    const bool isEnough = candidates.size() >= this->Rules.Number;
    if (isAll || isEnough)
    {
      double farthest = 0.0;
      Cells found = search(candidates, farthest);
      if (isAll || farthest <= reach)
      {
        return found;
      }
      reach = std::nextafter(farthest, std::numeric_limits<double>::infinity());
      continue;
    }
    reach += width;
    width *= 2.0;
  }
}

//------------------------------------------------------------------------------
// In the order of what they may be at best, until none can be nearer than those at hand.
SkdSpatialSearch::Cells SkdSpatialSearch::MeasureNearest(
  const SkdQueryShape& shape, std::vector<Candidate>& candidates) const
{
  using Key = std::tuple<double, std::uint32_t, vtkIdType>;
  std::vector<std::pair<Key, Candidate>> inTurn;
  for (const Candidate& candidate : candidates)
  {
    const SkdCellTree& tree = this->Mesh.GetTree(candidate.Part);
    const double bound = shape.LowerBound(tree.SafetyBoxOf(candidate.Cell));
    const double tolerance = std::max(this->Rules.Tolerance, shape.Rounding(tree));
    inTurn.push_back(
      { Key(std::max(0.0, bound - tolerance), candidate.Part, tree.Cells().IdOf(candidate.Cell)),
        candidate });
  }
  std::sort(
    inTurn.begin(), inTurn.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Cells best;
  for (const auto& [key, candidate] : inTurn)
  {
    if (best.size() == this->Rules.Number &&
      Key(best.back().OfCells.Min, best.back().Part, best.back().CellId) < key)
    {
      break;
    }
    const SkdRelatedCell related = *this->Ask(shape, candidate);
    best.insert(std::upper_bound(best.begin(), best.end(), related, IsNearer), related);
    best.resize(std::min(best.size(), this->Rules.Number));
  }
  return best;
}

//------------------------------------------------------------------------------
SkdSpatialSearch::Cells SkdSpatialSearch::FindNearest(const SkdQueryShape& shape) const
{
  if (shape.GetKind() == SkdQueryShape::Kind::Ball && shape.GetBall().Radius == 0.0)
  {
    return this->FindNearestToPoint(shape);
  }
  return this->FindWidening(shape,
    [&](std::vector<Candidate>& candidates, double& farthest)
    {
      Cells best = this->MeasureNearest(shape, candidates);
      farthest = best.empty() ? 0.0 : best.back().OfCells.Min;
      return best;
    });
}

//------------------------------------------------------------------------------
// The tree's own search, which orders by distances before any is taken for 0.
SkdSpatialSearch::Cells SkdSpatialSearch::FindNearestToPoint(const SkdQueryShape& shape) const
{
  const skd::Vector3& x = shape.GetBall().Centre;
  std::vector<Candidate> candidates;
  for (std::uint32_t part = 0; part < this->Mesh.GetNumberOfParts(); ++part)
  {
    const SkdCellTree& tree = this->Mesh.GetTree(part);
    const SkdCellSource source = this->Mesh.GetSource(part);
    const double zero = std::max(this->Rules.Tolerance, shape.Rounding(tree));
    std::vector<std::pair<double, vtkIdType>> found =
      tree.FindNearestCells(x, this->Rules.Number, std::numeric_limits<double>::infinity(), source);
    if (!found.empty() && found.back().first <= zero * zero)
    {
      found = tree.FindNearestCells(x, tree.Cells().NumberOfCells(), zero * zero, source);
    }
    for (const auto& [dist2, id] : found)
    {
      candidates.push_back({ part, static_cast<std::uint32_t>(tree.Cells().CellOfId(id)) });
    }
  }
  return this->MeasureNearest(shape, candidates);
}

//------------------------------------------------------------------------------
SkdSpatialSearch::Cells SkdSpatialSearch::FindNearestBoxes(const SkdQueryShape& shape) const
{
  return this->FindWidening(shape,
    [&](const std::vector<Candidate>& candidates, double& farthest)
    {
      Cells found;
      std::vector<double> pessimistic;
      for (const Candidate& candidate : candidates)
      {
        found.push_back(this->MakeCell(shape, candidate));
        pessimistic.push_back(found.back().OfBoxes.Max);
      }
      const std::size_t known = std::min(this->Rules.Number, pessimistic.size());
      std::sort(pessimistic.begin(), pessimistic.end());
      farthest = known > 0 ? pessimistic[known - 1] : 0.0;
      const auto isOut = [&](const SkdRelatedCell& cell)
      { return !(cell.OfBoxes.Min <= farthest); };
      found.erase(std::remove_if(found.begin(), found.end(), isOut), found.end());
      std::sort(found.begin(), found.end(), IsNearer);
      return found;
    });
}

//------------------------------------------------------------------------------
SkdSpatialSearch::Cells SkdSpatialSearch::FindOfOne(
  const SkdQueryShape& shape, vtkAlgorithm* owner) const
{
  const std::vector<Candidate> candidates = this->FindCandidates(shape, this->Rules.Tolerance);
  const auto n = static_cast<vtkIdType>(candidates.size());
  std::vector<std::optional<SkdRelatedCell>> slots(candidates.size());
  SkdLoop loop(owner, n, 0.3, 0.9);
  loop.For(n,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        slots[i] = this->Ask(shape, candidates[i]);
      }
    });
  Cells found;
  for (const auto& slot : slots)
  {
    if (slot)
    {
      found.push_back(*slot);
    }
  }
  return found;
}

//------------------------------------------------------------------------------
std::vector<SkdRelatedCell> SkdSpatialSearch::Find(
  vtkIdType n, const MakeShape& make, vtkAlgorithm* owner) const
{
  const bool isNearest = this->Rules.Relation == SkdRelation::Nearest;
  if (isNearest && this->Rules.Number == 0)
  {
    return {};
  }
  if (n == 1 && !isNearest)
  {
    const SkdQueryShape shape = make(0);
    return shape.IsUsable() ? this->FindOfOne(shape, owner) : Cells();
  }
  std::vector<Cells> answers(static_cast<std::size_t>(n));
  SkdLoop loop(owner, n, 0.3, 0.9, 256);
  loop.For(n,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const SkdQueryShape shape = make(i);
        if (shape.IsUsable())
        {
          answers[static_cast<std::size_t>(i)] = !isNearest ? this->FindRelated(shape)
            : this->Rules.IsExact                           ? this->FindNearest(shape)
                                                            : this->FindNearestBoxes(shape);
        }
      }
    });
  Cells found;
  for (vtkIdType i = 0; i < n; ++i)
  {
    for (SkdRelatedCell& cell : answers[static_cast<std::size_t>(i)])
    {
      cell.Query = i;
      found.push_back(cell);
    }
  }
  return found;
}
