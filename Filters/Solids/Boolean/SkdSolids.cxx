// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdSolids.h"

#include "Bodies/SkdEdgeTable.h"
#include "Core/Geometry/DisjointSets.h"
#include "Solids/Boolean/SkdFacets.h"

#include <algorithm>

namespace skdtree
{
namespace
{
template <class NumberOf>
SkdSolids NumberSolids(const SkdTriangleSet& set, const NumberOf& numberOf)
{
  SkdSolids solids;
  solids.Of.resize(set.GetTriangles().size());
  for (std::uint32_t triangle = 0; triangle < solids.Of.size(); ++triangle)
  {
    solids.Of[triangle] = numberOf(triangle);
    solids.Count = std::max(solids.Count, solids.Of[triangle] + 1);
  }
  return solids;
}
}

SkdBooleanBlocks SkdMakeBooleanBlocks(vtkDataObject* input, vtkDataObject* source)
{
  SkdBooleanBlocks blocks{ SkdBlocksOf(input), 0, SkdIsComposite(input) || SkdIsComposite(source) };
  blocks.FirstOfSource = static_cast<int>(blocks.All.size());
  int pieces = 0; // the Source's numbers of them follow those of the Input
  for (SkdBlock& block : blocks.All)
  {
    pieces = std::max(pieces, block.FirstPiece + 1);
    block.FirstPiece = source ? block.FirstPiece : -1; // each block is a solid
  }
  for (SkdBlock& block : SkdBlocksOf(source))
  {
    block.FirstPiece += block.FirstPiece >= 0 ? pieces : 0;
    blocks.All.push_back(block);
  }
  return blocks;
}

std::uint32_t SkdFirstTriangleOf(const SkdTriangleSet& set, int block)
{
  std::uint32_t first = 0;
  auto count = static_cast<std::uint32_t>(set.GetTriangles().size());
  while (count > 0) // triangles are in the order of blocks
  {
    const std::uint32_t half = count / 2;
    const bool isBefore = set.GetCells()[set.GetCellOf(first + half)].Block < block;
    first += isBefore ? half + 1 : 0;
    count = isBefore ? count - half - 1 : half;
  }
  return first;
}

SkdSolids SkdSolidsByInput(const SkdTriangleSet& set, int firstOfSource)
{
  SkdSolids solids;
  solids.Of.assign(SkdFirstTriangleOf(set, firstOfSource), 0);
  solids.Of.resize(set.GetTriangles().size(), 1);
  solids.Count = 2; // also if there are no triangles of one
  return solids;
}

SkdSolids SkdSolidsByBlock(const SkdTriangleSet& set, std::size_t numberOfBlocks)
{
  SkdSolids solids = NumberSolids(set,
    [&](std::uint32_t triangle)
    { return static_cast<std::uint32_t>(set.GetCells()[set.GetCellOf(triangle)].Block); });
  solids.Count = static_cast<std::uint32_t>(numberOfBlocks);
  return solids;
}

SkdSolids SkdSolidsByPiece(const SkdTriangleSet& set)
{
  const std::vector<SkdTriangleSet::Corners> triangles(
    set.GetTriangles().begin(), set.GetTriangles().end());
  skd::DisjointSets<> pieces(triangles.size());
  SkdMakeEdgeTable(triangles, set.GetPoints().size())
    .ForEach(
      [&](std::uint32_t, const SkdEdgeUse* first, const SkdEdgeUse* last)
      {
        for (const SkdEdgeUse* use = first + 1; use < last; ++use)
        {
          pieces.Unite(first->Triangle, use->Triangle);
        }
      });
  const std::vector<std::uint32_t> numbers = pieces.Number();
  return NumberSolids(set, [&](std::uint32_t triangle) { return numbers[triangle]; });
}
}
