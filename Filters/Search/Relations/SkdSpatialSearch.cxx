// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Relations/SkdSpatialSearch.h"

#include "Cells/Read/SkdForEach.h"
#include <algorithm>
#include <cmath>
#include <tuple>

namespace skdtree
{
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

/// What make(i, where to put it) says is to be kept, of each i of n in turn, in parallel. Found in
/// blocks, which are then moved together.
template <class T, class Make>
skd::RawVector<T> Collect(
  vtkAlgorithm* owner, double first, double last, std::size_t n, const Make& make)
{
  constexpr std::size_t size = 256;
  skd::RawVector<T> found(n);
  std::vector<std::size_t> counts((n + size - 1) / size, 0);
  const auto blocks = static_cast<vtkIdType>(counts.size());
  SkdLoop(owner, blocks, first, last, 16)
    .For(blocks,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (auto block = static_cast<std::size_t>(begin); block < static_cast<std::size_t>(end);
             ++block)
        {
          T* to = found.data() + block * size;
          const std::size_t beyond = std::min(n, (block + 1) * size);
          for (std::size_t i = block * size; i < beyond; ++i)
          {
            to += make(i, to);
          }
          counts[block] = static_cast<std::size_t>(to - found.data()) - block * size;
        }
      });
  T* to = found.data();
  for (std::size_t block = 0; block < counts.size(); ++block)
  {
    const T* const from = found.data() + block * size;
    to = to == from ? to + counts[block] : std::copy(from, from + counts[block], to);
  }
  found.resize(static_cast<std::size_t>(to - found.data()));
  return found;
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
bool SkdSpatialSearch::AsksCorners() const
{
  return this->Rules.IsExact &&
    (this->Rules.Relation == SkdRelation::Overlap ||
      this->Rules.Relation == SkdRelation::Containment);
}

//------------------------------------------------------------------------------
// What the corners decide for most cells: a cell that has some in the shape overlaps it, and one
// that has all is in it. Then the nearest points are common points, of the boxes, too.
bool SkdSpatialSearch::AskCorners(const SkdQueryShape& shape, const Candidate& candidate,
  const CornersOfParts& known, SkdRelatedCell& related) const
{
  if (!this->AsksCorners())
  {
    return false;
  }
  const bool isOverlap = this->Rules.Relation == SkdRelation::Overlap;
  const SkdCellTree& tree = this->Mesh.GetTree(candidate.Part);
  const bool isKnown = !known.empty() && !known[candidate.Part].empty();
  const auto corners =
    shape.LookAtCorners(tree, candidate.Cell, isKnown ? known[candidate.Part].data() : nullptr);
  if (!corners || !(isOverlap ? corners->AreSomeIn : corners->AreAllIn))
  {
    return false;
  }
  related = { 0, candidate.Part, tree.Cells().IdOf(candidate.Cell), { 0.0, corners->Pessimistic },
    { 0.0, corners->Farthest } };
  return true;
}

//------------------------------------------------------------------------------
bool SkdSpatialSearch::Ask(const SkdQueryShape& shape, const Candidate& candidate,
  const CornersOfParts& known, SkdRelatedCell& related) const
{
  const SkdCellTree& tree = this->Mesh.GetTree(candidate.Part);
  if (this->Rules.Relation != SkdRelation::Nearest)
  {
    if (this->AskCorners(shape, candidate, known, related))
    {
      return true;
    }
    const double tolerance = std::max(this->Rules.Tolerance, shape.Rounding(tree));
    if (!shape.IsNear(tree, tree.SafetyBoxOf(candidate.Cell), this->Rules.Tolerance) ||
      !shape.IsCandidate(this->Rules.Relation, tree, candidate.Cell, tolerance))
    {
      return false;
    }
  }
  related = this->MakeCell(shape, candidate);
  if (this->Rules.IsExact)
  {
    const auto distances = SkdCellRelation(shape, this->Rules)
                             .Ask(tree, candidate.Cell, this->Mesh.GetSource(candidate.Part));
    if (!distances)
    {
      return false;
    }
    related.OfCells = *distances;
  }
  return true;
}

//------------------------------------------------------------------------------
// Of each part what find(tree) gives.
template <class Finder>
std::vector<SkdSpatialSearch::Candidate> SkdSpatialSearch::FindInParts(const Finder& find) const
{
  std::vector<Candidate> candidates;
  for (std::uint32_t part = 0; part < this->Mesh.GetNumberOfParts(); ++part)
  {
    const auto cells = find(this->Mesh.GetTree(part));
    candidates.reserve(candidates.size() + cells.size());
    for (const std::uint32_t cell : cells)
    {
      candidates.push_back({ part, cell });
    }
  }
  return candidates;
}

//------------------------------------------------------------------------------
std::vector<SkdSpatialSearch::Candidate> SkdSpatialSearch::FindCandidates(
  const SkdQueryShape& shape, double maxDistance) const
{
  return this->FindInParts(
    [&](const SkdCellTree& tree) { return shape.FindNear(tree, maxDistance); });
}

//------------------------------------------------------------------------------
SkdSpatialSearch::Cells SkdSpatialSearch::FindRelated(const SkdQueryShape& shape) const
{
  Cells found;
  const auto candidates = this->FindInParts(
    [&](const SkdCellTree& tree) { return shape.FindMaybeNear(tree, this->Rules.Tolerance); });
  for (const Candidate& candidate : candidates)
  {
    SkdRelatedCell related;
    if (this->Ask(shape, candidate, {}, related))
    {
      found.push_back(related);
    }
  }
  return found;
}

//------------------------------------------------------------------------------
// The boxes within some radius hold all that is as near. The radius grows until what is
// found in it is sure to be nearest; `search` has their distance, or too few of them.
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
  double width =
    std::max(size / std::cbrt(static_cast<double>(all)), std::numeric_limits<double>::min());
  double maxDistance = shape.LowerBound(this->Bounds) + this->Rules.Tolerance;
  while (true)
  {
    std::vector<Candidate> candidates = this->FindCandidates(shape, maxDistance);
    const bool isAll = candidates.size() == all;
    const bool isEnough = candidates.size() >= this->Rules.Number;
    if (isAll || isEnough)
    {
      double farthest = 0.0;
      Cells found = search(candidates, farthest);
      if (isAll || !(farthest > maxDistance))
      {
        return found;
      }
      maxDistance = std::nextafter(farthest, std::numeric_limits<double>::infinity());
      continue;
    }
    maxDistance += width;
    width *= 2.0;
  }
}

//------------------------------------------------------------------------------
// Up to what distance cells are reported if the last one requested is at this one.
double SkdSpatialSearch::FindLimit(const SkdQueryShape& shape, double distance) const
{
  double beyond = this->Rules.Tolerance;
  for (std::uint32_t part = 0; part < this->Mesh.GetNumberOfParts(); ++part)
  {
    beyond = std::max(beyond, shape.Rounding(this->Mesh.GetTree(part)));
  }
  return this->Rules.HasTies ? distance + beyond : distance;
}

//------------------------------------------------------------------------------
// In the order of what they may be at best, until none can be nearer than those at hand.
SkdSpatialSearch::Cells SkdSpatialSearch::MeasureNearest(
  const SkdQueryShape& shape, std::vector<Candidate>& candidates) const
{
  using Key = std::tuple<double, std::uint32_t, vtkIdType>;
  std::vector<std::pair<Key, Candidate>> ordered;
  for (const Candidate& candidate : candidates)
  {
    const SkdCellTree& tree = this->Mesh.GetTree(candidate.Part);
    const double bound = shape.LowerBound(tree.SafetyBoxOf(candidate.Cell));
    const double tolerance = std::max(this->Rules.Tolerance, shape.Rounding(tree));
    ordered.push_back(
      { Key(std::max(0.0, bound - tolerance), candidate.Part, tree.Cells().IdOf(candidate.Cell)),
        candidate });
  }
  std::sort(
    ordered.begin(), ordered.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Cells best; // Number of these, and by choice ties, are wanted
  const std::size_t number = this->Rules.Number;
  for (const auto& [key, candidate] : ordered)
  {
    const bool isEnough = best.size() >= number;
    const SkdRelatedCell* last = isEnough ? &best[number - 1] : nullptr;
    if (isEnough &&
      (this->Rules.HasTies ? this->FindLimit(shape, last->OfCells.Min) < std::get<0>(key)
                           : Key(last->OfCells.Min, last->Part, last->CellId) < key))
    {
      break;
    }
    SkdRelatedCell related;
    this->Ask(shape, candidate, {}, related);
    best.insert(std::upper_bound(best.begin(), best.end(), related, IsNearer), related);
    best.resize(this->Rules.HasTies ? best.size() : std::min(best.size(), number));
  }
  if (best.size() > number)
  {
    const double limit = this->FindLimit(shape, best[number - 1].OfCells.Min);
    best.erase(std::find_if(best.begin() + static_cast<std::ptrdiff_t>(number), best.end(),
                 [&](const SkdRelatedCell& cell) { return cell.OfCells.Min > limit; }),
      best.end());
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
      const std::size_t known = std::min(this->Rules.Number, best.size());
      farthest = known > 0 ? this->FindLimit(shape, best[known - 1].OfCells.Min) : 0.0;
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
    if (!found.empty() && this->Rules.HasTies)
    {
      const double limit = this->FindLimit(shape, std::sqrt(found.back().first)) + zero;
      found = tree.FindNearestCells(x, tree.Cells().NumberOfCells(), limit * limit, source);
    }
    else if (!found.empty() && found.back().first <= zero * zero)
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
// Without a tree: all cells but those whose points are all beyond one side of the shape, which a
// look at each point tells.
skd::RawVector<std::uint32_t> SkdSpatialSearch::LookThrough(
  const SkdCellTree& tree, const SkdQueryShape& shape, vtkAlgorithm* owner) const
{
  const SkdCellStore& cells = tree.Cells();
  const bool hasSides = shape.GetKind() != SkdQueryShape::Kind::Plane && !cells.HasCurvedExtents();
  // Safety boxes are wider than cells, and what they are compared with is rounded.
  const double maxDistance =
    this->Rules.Tolerance + 3.0 * tree.AbsoluteEpsilon() + 2.0 * shape.Rounding(tree);
  skd::RawVector<unsigned char> sides(static_cast<std::size_t>(cells.GetNumberOfPoints()));
  SkdForEach(hasSides ? cells.GetNumberOfPoints() : 0,
    [&](vtkIdType id)
    {
      sides[static_cast<std::size_t>(id)] =
        shape.SidesOf(cells.Point(static_cast<std::uint32_t>(id)), maxDistance);
    });
  return Collect<std::uint32_t>(owner, 0.2, 0.3, cells.NumberOfCells(),
    [&](std::size_t i, std::uint32_t* to)
    {
      *to = static_cast<std::uint32_t>(i);
      const std::uint32_t* const ids = cells.PointIdsOf(*to);
      unsigned common = hasSides ? 63u : 0u;
      for (std::uint32_t k = 0; common != 0 && k < cells.SizeOf(*to); ++k)
      {
        common &= sides[ids[k]];
      }
      return common == 0;
    });
}

//------------------------------------------------------------------------------
// Of parts where there are more candidates than points: a point is a corner of several cells.
SkdSpatialSearch::CornersOfParts SkdSpatialSearch::LookAtPoints(
  const SkdQueryShape& shape, const std::vector<Candidate>& candidates) const
{
  CornersOfParts known(this->Mesh.GetNumberOfParts());
  std::vector<vtkIdType> counts(known.size(), 0);
  for (const Candidate& candidate : candidates)
  {
    ++counts[candidate.Part];
  }
  for (std::uint32_t part = 0; part < known.size(); ++part)
  {
    const SkdCellStore& cells = this->Mesh.GetTree(part).Cells();
    const vtkIdType points = cells.GetNumberOfPoints();
    if (!this->AsksCorners() || !shape.LooksAtCorners() || counts[part] < points)
    {
      continue;
    }
    known[part].resize(static_cast<std::size_t>(points));
    SkdForEach(points,
      [&](vtkIdType id)
      {
        known[part][static_cast<std::size_t>(id)] =
          shape.LookAt(cells.Point(static_cast<std::uint32_t>(id)));
      });
  }
  return known;
}

//------------------------------------------------------------------------------
SkdSpatialSearch::Cells SkdSpatialSearch::FindOfOne(
  const SkdQueryShape& shape, vtkAlgorithm* owner) const
{
  const auto candidates = this->FindInParts(
    [&](const SkdCellTree& tree) -> skd::RawVector<std::uint32_t>
    {
      if (tree.IsBare())
      {
        return this->LookThrough(tree, shape, owner);
      }
      const auto cells = shape.FindMaybeNear(tree, this->Rules.Tolerance);
      return { cells.begin(), cells.end() };
    });
  const CornersOfParts known = this->LookAtPoints(shape, candidates);
  return Collect<SkdRelatedCell>(owner, 0.3, 0.9, candidates.size(),
    [&](std::size_t i, SkdRelatedCell* to) { return this->Ask(shape, candidates[i], known, *to); });
}

//------------------------------------------------------------------------------
SkdRelatedCells SkdSpatialSearch::Find(
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
}
