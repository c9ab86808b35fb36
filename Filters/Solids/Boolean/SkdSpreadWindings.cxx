// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdSpreadWindings.h"

#include "Exchange/SkdAskOthers.h"
#include "Exchange/SkdCut.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace skdtree
{
/// What a process's triangles before a position cause there.
struct SkdSpreadWindings::Counts
{
  std::array<int, 2> Numbers{ { 0, 0 } };
  bool IsSure = true;
};

SkdSpreadWindings::SkdSpreadWindings(SkdTransport& transport, const SkdMovedTriangles& set,
  const std::vector<std::uint32_t>& surfaceOf)
  : Transport(transport)
  , Set(set)
  , SurfaceOf(surfaceOf)
  , Triangles(surfaceOf.size())
{
  std::iota(this->Triangles.begin(), this->Triangles.end(), 0u);
  std::vector<skd::Box3> boxes;
  for (const std::uint32_t triangle : this->Triangles)
  {
    boxes.push_back(set.GetBox(triangle));
  }
  this->Lines.emplace(set, this->Triangles, std::numeric_limits<std::size_t>::max());
  this->Cut = std::make_unique<SkdCut>(transport, std::move(boxes));
  for (const skd::Box3& box : this->Cut->GetBoxes())
  {
    this->Bounds.Add(box);
  }
}

SkdSpreadWindings::~SkdSpreadWindings() = default;

SkdSpreadWindings::Counts SkdSpreadWindings::CountBefore(const SkdPositionOnLine& position) const
{
  Counts counts;
  const auto crossings = this->Lines->Find(position.Line);
  counts.IsSure = crossings.has_value();
  for (std::size_t i = 0; counts.IsSure && i < crossings->size(); ++i)
  {
    const SkdLineCrossing& crossing = (*crossings)[i];
    const int order = SkdCompareCrossings(
      this->Set.GetCornerPoints(crossing.Triangle), position.Corners, position.Line);
    counts.IsSure = order != 0;
    counts.Numbers[this->SurfaceOf[crossing.Triangle]] -= order < 0 ? crossing.Sign : 0;
  }
  return counts;
}

std::optional<std::vector<std::optional<SkdRegionWindings>>> SkdSpreadWindings::Ask(
  const std::vector<SkdPositionOnLine>& positions, bool isOpen)
{
  if (SkdMostOf(this->Transport, isOpen ? 1 : 0) == 0)
  {
    return std::nullopt;
  }
  std::vector<Counts> all(positions.size());
  const int rank = this->Transport.GetRank();
  const std::size_t share = SkdSizeOfRound(this->Transport.GetNumber(), sizeof(SkdPositionOnLine));
  const auto list = [&](const SkdPositionOnLine& position, std::vector<int>& processes)
  {
    skd::Box3 along(position.Line.Point, position.Line.Point);
    along.Min[position.Line.Axis] = this->Bounds.Min[position.Line.Axis];
    along.Max[position.Line.Axis] = this->Bounds.Max[position.Line.Axis];
    this->Cut->FindOverlapping(along, processes);
    processes.erase(std::remove(processes.begin(), processes.end(), rank), processes.end());
  };
  const auto reply = [this](const std::vector<SkdPositionOnLine>& asked, auto& answers)
  {
    for (std::uint32_t i = 0; i < asked.size(); ++i)
    {
      answers.push_back({ i, this->CountBefore(asked[i]) });
    }
  };
  for (std::size_t begin = 0; SkdMostOf(this->Transport, begin < positions.size() ? 1 : 0) > 0;
       begin = std::min(begin + share, positions.size()))
  {
    SkdAskOthers<SkdPositionOnLine, Counts>(
      this->Transport, std::min(share, positions.size() - begin),
      [&](std::size_t i, std::vector<int>& processes) { list(positions[begin + i], processes); },
      [&](std::size_t i) { return positions[begin + i]; }, reply,
      [&](std::size_t i, const Counts& counts, int)
      {
        Counts& sum = all[begin + i];
        sum.IsSure = sum.IsSure && counts.IsSure;
        sum.Numbers[0] += counts.Numbers[0];
        sum.Numbers[1] += counts.Numbers[1];
      });
  }
  std::vector<std::optional<SkdRegionWindings>> found;
  for (const Counts& counts : all)
  {
    SkdRegionWindings windings;
    for (std::uint32_t surface = 0; surface < 2; ++surface)
    {
      if (counts.Numbers[surface] != 0)
      {
        windings.push_back({ surface, counts.Numbers[surface] });
      }
    }
    found.push_back(counts.IsSure ? std::make_optional(windings) : std::nullopt);
  }
  return found;
}
}
