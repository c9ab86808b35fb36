// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdSolidGroups.h"

#include "Bodies/SkdEdgeTable.h"
#include "Core/Geometry/DisjointSets.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
using Corners = SkdTriangleSet::Corners;
constexpr std::uint32_t None = 0xffffffffu;

/// The pieces that edges connect, of each solid by itself.
class Pieces
{
public:
  Pieces(const SkdTriangleSet& set, const SkdSolids& solids)
    : Set(set)
    , Solids(solids)
    , Sets(set.GetTriangles().size())
  {
    const std::vector<Corners> triangles(set.GetTriangles().begin(), set.GetTriangles().end());
    SkdMakeEdgeTable(triangles, set.GetPoints().size())
      .ForEach([this](std::uint32_t, const SkdEdgeUse* first, const SkdEdgeUse* last)
        { this->Look(first, last); });
    this->Of = this->Sets.Number();
  }

  /// Whether the surface of each solid passes each edge as often in both directions.
  bool AreClosed() const { return this->IsClosed; }

  /// Of each triangle its piece.
  const std::vector<std::uint32_t>& Get() const { return this->Of; }

  /// Each solid by itself, also an empty one.
  std::vector<SkdSolidGroup> TakeWhole() const
  {
    std::vector<SkdSolidGroup> groups(this->Solids.Count, SkdSolidGroup(1));
    for (std::uint32_t triangle = 0; triangle < this->Of.size(); ++triangle)
    {
      groups[this->Solids.Of[triangle]][0].push_back(triangle);
    }
    return groups;
  }

  /// The solids by their pieces where each winds once around what it encloses, else whole. `pairs`
  /// are those of two triangles of one piece that touch, and maybe others.
  std::vector<SkdSolidGroup> Divide(const std::vector<SkdTrianglePair>& pairs) const
  {
    std::vector<bool> isWhole(this->Solids.Count, false);
    for (const std::uint32_t triangle : this->AtOtherEdges)
    {
      isWhole[this->Solids.Of[triangle]] = true;
    }
    for (const SkdTrianglePair& pair : pairs)
    {
      if (this->Of[pair.First] == this->Of[pair.Second])
      {
        isWhole[this->Solids.Of[pair.First]] = true;
      }
    }
    for (const std::uint32_t triangle : this->FindReversed())
    {
      isWhole[this->Solids.Of[triangle]] = true;
    }
    const auto n = static_cast<std::uint32_t>(this->Of.size());
    std::vector<SkdSolidGroup> groups(this->Solids.Count);
    std::vector<std::uint32_t> slots(n, None); // of pieces, or of whole solids behind these
    slots.resize(n + this->Solids.Count, None);
    for (std::uint32_t triangle = 0; triangle < n; ++triangle)
    {
      const std::uint32_t solid = this->Solids.Of[triangle];
      SkdSolidGroup& group = groups[solid];
      std::uint32_t& slot = slots[isWhole[solid] ? n + solid : this->Of[triangle]];
      if (slot == None)
      {
        slot = static_cast<std::uint32_t>(group.size());
        group.emplace_back();
      }
      group[slot].push_back(triangle);
    }
    return groups;
  }

private:
  void Look(const SkdEdgeUse* first, const SkdEdgeUse* last)
  {
    for (const SkdEdgeUse* use = first; use != last; ++use)
    {
      const std::uint32_t solid = this->Solids.Of[use->Triangle];
      int sum = 0;
      int count = 0;
      for (const SkdEdgeUse* other = first; other != last; ++other)
      {
        if (this->Solids.Of[other->Triangle] == solid)
        {
          this->Sets.Unite(use->Triangle, other->Triangle);
          sum += other->IsForward ? 1 : -1;
          ++count;
        }
      }
      this->IsClosed = this->IsClosed && sum == 0;
      if (count != 2)
      {
        this->AtOtherEdges.push_back(use->Triangle);
      }
    }
  }

  /// A triangle of each piece that does not surely face outward: its volume is not positive beyond
  /// rounding.
  std::vector<std::uint32_t> FindReversed() const
  {
    constexpr double rounding = 1e-9; // of a sum of volumes with any signs
    struct Sum
    {
      std::uint32_t First;
      double Volume;
      double Magnitude;
    };
    std::vector<Sum> sums(this->Of.size(), { None, 0.0, 0.0 });
    for (std::uint32_t triangle = 0; triangle < this->Of.size(); ++triangle)
    {
      Sum& sum = sums[this->Of[triangle]];
      sum.First = std::min(sum.First, triangle);
      const auto at = [&](std::uint32_t of, int i)
      { return this->Set.GetPoints()[this->Set.GetTriangles()[of][i]]; };
      const skd::Vector3 origin = at(sum.First, 0);
      const double volume =
        Dot(at(triangle, 0) - origin, Cross(at(triangle, 1) - origin, at(triangle, 2) - origin));
      sum.Volume += volume;
      sum.Magnitude += std::abs(volume);
    }
    std::vector<std::uint32_t> reversed;
    for (const Sum& sum : sums)
    {
      if (sum.First != None && !(sum.Volume > rounding * sum.Magnitude))
      {
        reversed.push_back(sum.First);
      }
    }
    return reversed;
  }

  const SkdTriangleSet& Set;
  const SkdSolids& Solids;
  skd::DisjointSets<> Sets;
  std::vector<std::uint32_t> Of;
  std::vector<std::uint32_t> AtOtherEdges; // triangles at edges of other than two of a solid
  bool IsClosed = true;
};

/// What makes an operand of its solids.
SkdBooleanOperation WithinOperands(SkdBooleanOperation operation, bool areInputs)
{
  const bool isOfAll = operation == SkdBooleanOperation::Intersection && !areInputs;
  return isOfAll ? operation : SkdBooleanOperation::Union;
}

/// Whether what two pieces of a solid cover is inside of it.
bool DividesSolids(const SkdBooleanRule& rule)
{
  return rule.Inside != SkdInsideRule::Odd;
}

void Append(SkdSolidGroup& to, const SkdSolidGroup& group)
{
  to.insert(to.end(), group.begin(), group.end());
}
}

//------------------------------------------------------------------------------
bool SkdCanCombineInPairs(SkdBooleanOperation operation, bool areInputs)
{
  using Operation = SkdBooleanOperation;
  return operation == Operation::Union || operation == Operation::Difference ||
    operation == Operation::ReverseDifference || operation == Operation::Intersection ||
    (operation == Operation::SymmetricDifference && areInputs);
}

//------------------------------------------------------------------------------
std::optional<SkdOperands> SkdFindOperands(const SkdTriangleSet& set, const SkdSolids& solids,
  bool areInputs, const SkdBooleanRule& rule,
  const std::function<std::vector<SkdTrianglePair>(const std::vector<std::uint32_t>&)>& findPairs)
{
  Pieces pieces(set, solids);
  if (!SkdCanCombineInPairs(rule.Operation, areInputs) || !pieces.AreClosed())
  {
    return std::nullopt;
  }
  SkdOperands operands{ {}, WithinOperands(rule.Operation, areInputs) };
  const bool divides = operands.Within == SkdBooleanOperation::Union && DividesSolids(rule);
  const std::vector<SkdSolidGroup> divided =
    divides ? pieces.Divide(findPairs(pieces.Get())) : pieces.TakeWhole();
  for (std::size_t solid = 0; solid < divided.size(); ++solid)
  {
    Append(operands.Groups[solid == 0 ? 0 : 1], divided[solid]);
  }
  constexpr std::size_t fewest = 3; // two are combined at once in any case
  return operands.Groups[0].size() + operands.Groups[1].size() < fewest
    ? std::nullopt
    : std::make_optional(std::move(operands));
}
}
