// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdOverlapSearch.h
 * @brief Which cells of two meshes may overlap, by their trees walked together (Algorithm 5.4).
 */

#ifndef SkdOverlapSearch_h
#define SkdOverlapSearch_h

#include "Cells/Read/SkdForEach.h"
#include "Core/Search/Queries/OverlappingPairs.h"
#include "Core/Search/Tree/Tree.h"
#include "Core/Search/Tree/WalkPairs.h"
#include "Pipeline/SkdLoop.h"
#include "Remap/SkdOverlapPieces.h"

#include <vector>

namespace skdtree
{
/// The cells of a mesh that have pieces, in a tree of their boxes.
class SkdOverlapTree
{
public:
  explicit SkdOverlapTree(const SkdOverlapPieces& pieces);

  const skd::Tree<3>& Get() const { return this->Tree; }
  std::uint32_t CellOf(std::uint32_t element) const { return this->Cells[element]; }

private:
  std::vector<std::uint32_t> Cells;
  skd::Tree<3> Tree;
};

/// One part of a search: the pairs of cells, and the part that they belong to.
template <class Visit>
struct SkdOverlapPart
{
  const SkdOverlapTree& Target;
  const SkdOverlapTree& Donor;
  const Visit& TheVisit;
  std::size_t Number;

  using Query = skd::OverlappingPairs<3, skd::SameWorld, const SkdOverlapPart>;
  using Walk = skd::PairWalk<skd::Tree<3>, skd::Tree<3>, Query>;

  bool operator()(std::uint32_t a, std::uint32_t b) const
  {
    this->TheVisit(this->Number, this->Target.CellOf(a), this->Donor.CellOf(b));
    return true;
  }

  /// Calls body(walk).
  template <class Body>
  void InWalk(const Body& body) const
  {
    const skd::SameWorld world;
    Query query(this->Target.Get().GetFrame(), this->Donor.Get().GetFrame(), world, *this);
    Walk walk(this->Target.Get(), this->Donor.Get(), query);
    body(walk);
  }
};

/// Calls visit(part, target cell, donor cell) for all pairs whose boxes overlap and some that are
/// near, each once, in parallel by parts: which part has a pair depends on the trees alone. Before,
/// begin(how many parts). False if stopped.
template <class Begin, class Visit>
bool SkdForEachCandidatePair(const SkdOverlapTree& target, const SkdOverlapTree& donor,
  SkdLoop& loop, const Begin& begin, const Visit& visit)
{
  constexpr std::size_t enough = 1024;
  using Part = SkdOverlapPart<Visit>;
  using Walk = typename Part::Walk;
  std::vector<typename Walk::Pair> starts;
  Part{ target, donor, visit, 0 }.InWalk([&](Walk& walk) { starts = walk.Split(enough); });
  begin(starts.size());
  const auto count = static_cast<vtkIdType>(starts.size());
  loop.SetTotal(count);
  return loop.For(count,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        const auto number = static_cast<std::size_t>(i);
        Part{ target, donor, visit, number }.InWalk(
          [&](Walk& walk) { walk.RunFrom(starts[number]); });
      }
    });
}
}

#endif
