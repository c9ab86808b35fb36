// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdContacts.h"

#include "Pipeline/SkdMakeArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

namespace skdtree
{
namespace
{
bool HaveSameEnds(const SkdEndPair& a, const SkdEndPair& b)
{
  return a.A == b.A && a.B == b.B;
}

SkdEndPair MakeEndPair(std::uint32_t a, std::uint32_t b, std::size_t origin)
{
  return { std::min(a, b), std::max(a, b), origin };
}

template <class IsLower>
void SortByEnds(std::vector<SkdEndPair>& segments, const IsLower& isLower)
{
  vtkSMPTools::Sort(segments.begin(), segments.end(),
    [&isLower](const SkdEndPair& a, const SkdEndPair& b)
    { return a.A != b.A ? a.A < b.A : (a.B != b.B ? a.B < b.B : isLower(a.Origin, b.Origin)); });
}
}

//------------------------------------------------------------------------------
SkdContactKind SkdKindOf(const skd::TriangleContact& contact)
{
  switch (contact.Count)
  {
    case 0:
      return SkdContactKind::Near;
    case 1:
      return SkdContactKind::Point;
    case 2:
      return SkdContactKind::Segment;
    default:
      return SkdContactKind::Area;
  }
}

//------------------------------------------------------------------------------
SkdContacts::SkdContacts(
  Side first, Side second, const SkdPlacement& placement, const std::vector<SkdTrianglePair>& pairs)
  : First(std::move(first))
  , Second(std::move(second))
  , FirstIds(SkdJoinedIdsOf(this->First.Blocks))
  , SecondIds(SkdJoinedIdsOf(this->Second.Blocks))
  , Placement(placement)
  , Pairs(pairs)
  , Points(placement, pairs, SkdContactPoints::Directions::ByCoordinates)
{
}

//------------------------------------------------------------------------------
// A segment is there once, of the lowest pair that has it.
void SkdContacts::FindSegments(SkdCurveParts& parts) const
{
  for (std::size_t pair = 0; pair < this->Pairs.size(); ++pair)
  {
    const int count = this->Pairs[pair].Contact.Count;
    const auto side = [&](int i)
    {
      return MakeEndPair(
        this->Points.GetPoint(pair, i), this->Points.GetPoint(pair, (i + 1) % count), pair);
    };
    if (count == 2)
    {
      parts.Segments.push_back(side(0));
    }
    for (int i = 0; count > 2 && i < count; ++i)
    {
      parts.Sides.push_back(side(i));
    }
  }
  SortByEnds(parts.Segments, [this](std::size_t a, std::size_t b) { return this->IsLower(a, b); });
  SortByEnds(parts.Sides, std::less<>());
  parts.Segments.erase(
    std::unique(parts.Segments.begin(), parts.Segments.end(), HaveSameEnds), parts.Segments.end());
}

//------------------------------------------------------------------------------
void SkdContacts::FindLonePoints(SkdCurveParts& parts) const
{
  parts.IsOther.resize(this->Points.GetNumberOfPoints(), false);
  for (std::size_t pair = 0; pair < this->Pairs.size(); ++pair)
  {
    for (int i = 0; this->Pairs[pair].Contact.Count > 1 && i < this->Pairs[pair].Contact.Count; ++i)
    {
      parts.IsOther[this->Points.GetPoint(pair, i)] = true;
    }
  }
  std::vector<bool> isKnown = parts.IsOther;
  for (std::size_t pair = 0; pair < this->Pairs.size(); ++pair)
  {
    const bool isPoint = this->Pairs[pair].Contact.Count == 1;
    const std::uint32_t point = isPoint ? this->Points.GetPoint(pair, 0) : 0;
    if (isPoint && (!isKnown[point] || (this->HasOwnIds() && !parts.IsOther[point])))
    {
      parts.Lone.push_back({ point, point, pair });
      isKnown[point] = true;
    }
  }
  if (this->HasOwnIds())
  {
    this->KeepLowest(parts.Lone);
  }
}

// Of each point one; in the order of pairs.
void SkdContacts::KeepLowest(std::vector<SkdEndPair>& lone) const
{
  SortByEnds(lone, [this](std::size_t a, std::size_t b) { return this->IsLower(a, b); });
  lone.erase(std::unique(lone.begin(), lone.end(), HaveSameEnds), lone.end());
  std::sort(lone.begin(), lone.end(),
    [](const SkdEndPair& a, const SkdEndPair& b) { return a.Origin < b.Origin; });
}

// Pairs are in the order of their cells, but where these have ids of another order.
bool SkdContacts::IsLower(std::size_t a, std::size_t b) const
{
  if (!this->HasOwnIds())
  {
    return a < b;
  }
  const auto tie = [](const SkdContactLabel& label)
  { return std::tie(label.FirstBlock, label.FirstCell, label.SecondBlock, label.SecondCell); };
  const SkdContactLabel first = this->LabelOf(a);
  const SkdContactLabel second = this->LabelOf(b);
  return tie(first) != tie(second) ? tie(first) < tie(second) : a < b;
}

SkdCurveParts SkdContacts::FindParts() const
{
  SkdCurveParts parts;
  this->FindSegments(parts);
  this->FindLonePoints(parts);
  return parts;
}

//------------------------------------------------------------------------------
std::pair<vtkIdType, int> SkdContacts::CellOf(const Side& side,
  const std::vector<SkdJoinedIds>& joined, const SkdMovedTriangles& triangles,
  std::uint32_t triangle)
{
  const SkdTriangleSet& set = triangles.GetSet();
  const SkdTriangleSet::Cell& cell = set.GetCells()[set.GetCellOf(triangle)];
  const auto block = static_cast<std::size_t>(cell.Block);
  const vtkIdType id = side.Ids.empty() ? joined[block].Of(cell.Id)
                                        : side.Ids[block][static_cast<std::size_t>(cell.Id)];
  return { id, side.Blocks[block].BlockIndex };
}

SkdContactLabel SkdContacts::LabelOf(std::size_t pair) const
{
  const auto [first, firstBlock] =
    CellOf(this->First, this->FirstIds, this->Placement.First, this->Pairs[pair].First);
  const auto [second, secondBlock] =
    CellOf(this->Second, this->SecondIds, this->Placement.GetSecond(), this->Pairs[pair].Second);
  return { first, second, firstBlock, secondBlock };
}

void SkdContacts::AddLabels(const std::vector<std::size_t>& pairs, vtkFieldData* to,
  const std::vector<SkdContactLabel>& received) const
{
  const auto n = static_cast<vtkIdType>(pairs.size());
  const auto firsts = SkdMakeArray<vtkIdTypeArray>(FirstCellName, 1, n);
  const auto seconds = SkdMakeArray<vtkIdTypeArray>(SecondCellName, 1, n);
  const auto firstBlocks =
    SkdMakeArray<vtkIntArray>(FirstBlockName, 1, this->First.IsComposite ? n : 0);
  const auto secondBlocks =
    SkdMakeArray<vtkIntArray>(SecondBlockName, 1, this->Second.IsComposite ? n : 0);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const std::size_t pair = pairs[static_cast<std::size_t>(i)];
    const SkdContactLabel label =
      pair < this->Pairs.size() ? this->LabelOf(pair) : received[pair - this->Pairs.size()];
    firsts->SetValue(i, static_cast<vtkIdType>(label.FirstCell));
    seconds->SetValue(i, static_cast<vtkIdType>(label.SecondCell));
    if (this->First.IsComposite)
    {
      firstBlocks->SetValue(i, label.FirstBlock);
    }
    if (this->Second.IsComposite)
    {
      secondBlocks->SetValue(i, label.SecondBlock);
    }
  }
  to->AddArray(firsts);
  if (this->First.IsComposite)
  {
    to->AddArray(firstBlocks);
  }
  to->AddArray(seconds);
  if (this->Second.IsComposite)
  {
    to->AddArray(secondBlocks);
  }
}
}
