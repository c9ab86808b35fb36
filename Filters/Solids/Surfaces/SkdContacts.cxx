// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdContacts.h"

#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdMakeArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkSMPTools.h"

#include <algorithm>

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

void SortByEnds(std::vector<SkdEndPair>& segments)
{
  vtkSMPTools::Sort(segments.begin(), segments.end(),
    [](const SkdEndPair& a, const SkdEndPair& b)
    { return a.A != b.A ? a.A < b.A : (a.B != b.B ? a.B < b.B : a.Origin < b.Origin); });
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
SkdContacts::SkdContacts(const Side& first, const Side& second, const SkdPlacement& placement,
  const std::vector<SkdTrianglePair>& pairs)
  : First(first)
  , Second(second)
  , Placement(placement)
  , Pairs(pairs)
  , Points(placement, pairs)
{
}

//------------------------------------------------------------------------------
// A segment is there once, of the lowest pair that has it. One between two polygons of overlap is
// inside of what overlaps, and no curve.
std::vector<SkdEndPair> SkdContacts::FindSegments() const
{
  std::vector<SkdEndPair> segments;
  std::vector<SkdEndPair> sides;
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
      segments.push_back(side(0));
    }
    for (int i = 0; count > 2 && i < count; ++i)
    {
      sides.push_back(side(i));
    }
  }
  SortByEnds(segments);
  SortByEnds(sides);
  segments.erase(std::unique(segments.begin(), segments.end(), HaveSameEnds), segments.end());
  const auto isInside = [&](const SkdEndPair& segment)
  {
    const SkdEndPair least{ segment.A, segment.B, 0 };
    auto at = std::lower_bound(sides.begin(), sides.end(), least,
      [](const SkdEndPair& a, const SkdEndPair& b) { return a.A != b.A ? a.A < b.A : a.B < b.B; });
    return sides.end() - at >= 2 && HaveSameEnds(*at, least) && HaveSameEnds(*++at, least);
  };
  segments.erase(std::remove_if(segments.begin(), segments.end(), isInside), segments.end());
  return segments;
}

//------------------------------------------------------------------------------
std::vector<SkdEndPair> SkdContacts::FindLonePoints(const std::vector<SkdEndPair>& segments) const
{
  std::vector<bool> isOther(this->Points.GetNumberOfPoints(), false);
  for (const SkdEndPair& segment : segments)
  {
    isOther[segment.A] = isOther[segment.B] = true;
  }
  for (std::size_t pair = 0; pair < this->Pairs.size(); ++pair)
  {
    for (int i = 0; this->Pairs[pair].Contact.Count > 1 && i < this->Pairs[pair].Contact.Count; ++i)
    {
      isOther[this->Points.GetPoint(pair, i)] = true;
    }
  }
  std::vector<SkdEndPair> lone;
  for (std::size_t pair = 0; pair < this->Pairs.size(); ++pair)
  {
    const bool isPoint = this->Pairs[pair].Contact.Count == 1;
    const std::uint32_t point = isPoint ? this->Points.GetPoint(pair, 0) : 0;
    if (isPoint && !isOther[point])
    {
      lone.push_back({ point, point, pair });
      isOther[point] = true;
    }
  }
  return lone;
}

//------------------------------------------------------------------------------
void SkdContacts::AddLabels(const std::vector<std::size_t>& pairs, vtkFieldData* to) const
{
  const auto add = [&](const Side& side, const SkdTriangleSet& set,
                     std::uint32_t SkdTrianglePair::*triangle, const char* cellName,
                     const char* blockName)
  {
    const auto n = static_cast<vtkIdType>(pairs.size());
    const auto cellOf = [&](vtkIdType i)
    { return set.GetCells()[set.GetCellOf(this->Pairs[pairs[i]].*triangle)]; };
    const std::vector<SkdJoinedIds> joined = SkdJoinedIdsOf(side.Blocks);
    auto ids = SkdMakeArray<vtkIdTypeArray>(cellName, 1, n);
    auto blockIndices = SkdMakeArray<vtkIntArray>(blockName, 1, side.IsComposite ? n : 0);
    for (vtkIdType i = 0; i < n; ++i)
    {
      ids->SetValue(i, joined[static_cast<std::size_t>(cellOf(i).Block)].Of(cellOf(i).Id));
    }
    to->AddArray(ids);
    for (vtkIdType i = 0; i < blockIndices->GetNumberOfTuples(); ++i)
    {
      blockIndices->SetValue(i, side.Blocks[cellOf(i).Block].BlockIndex);
    }
    if (side.IsComposite)
    {
      to->AddArray(blockIndices);
    }
  };
  add(this->First, this->Placement.First.GetSet(), &SkdTrianglePair::First, FirstCellName,
    FirstBlockName);
  add(this->Second, this->Placement.GetSecond().GetSet(), &SkdTrianglePair::Second, SecondCellName,
    SecondBlockName);
}
}
