// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bodies/SkdParts.h"

#include "Cells/Search/SkdLocatorState.h"
#include "Cells/Search/SkdVisitCandidates.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
bool SkdParts::Part::Update(const SkdBlock& block, double epsilon, const SkdMeshExtent& whole,
  const SkdMagnitudes& magnitudes, SkdTreeWanted wanted)
{
  this->BlockIndex = block.BlockIndex;
  const bool isSame = this->Tree && this->Epsilon == epsilon && this->Whole == whole &&
    this->Mesh.IsSameAs(block.Mesh);
  if (isSame && !this->Tree->IsBare())
  {
    return false;
  }
  this->Mesh.Keep(block.Mesh);
  this->Epsilon = epsilon;
  this->Whole = whole;
  SkdTreeSettings settings;
  settings.Epsilon = epsilon;
  settings.Whole = whole;
  settings.Magnitudes = magnitudes;
  settings.IsBare = !isSame && wanted == SkdTreeWanted::IfUsedBefore;
  this->Tree = std::make_shared<SkdCellTree>(this->Mesh.Get(), settings);
  if (block.Mesh->GetNumberOfCells() > 0)
  {
    this->Mesh.Get()->GetCell(0, SkdScratchCell()); // makes GetCell thread-safe
  }
  return !settings.IsBare;
}

int SkdParts::Update(const std::vector<SkdBlock>& blocks, double epsilon,
  const SkdMagnitudes& magnitudes, SkdTreeWanted wanted, const Wholes& wholes)
{
  const std::vector<SkdBlock> filled = SkdBlocksWithCells(blocks);
  this->Parts.resize(filled.size());
  int built = 0;
  for (std::size_t i = 0; i < filled.size(); ++i)
  {
    const auto whole = wholes.find(filled[i].BlockIndex);
    built += this->Parts[i].Update(filled[i], epsilon,
      whole == wholes.end() ? SkdMeshExtent() : whole->second, magnitudes, wanted);
  }
  return built;
}

std::vector<int> SkdParts::GetBlockIndices() const
{
  std::vector<int> indices;
  for (const Part& part : this->Parts)
  {
    indices.push_back(part.BlockIndex);
  }
  return indices;
}

SkdCellSource SkdParts::GetSource(std::uint32_t part) const
{
  return { this->Parts[part].Mesh.Get(), SkdScratchCell() };
}

skd::Box3 SkdParts::GetBounds() const
{
  skd::Box3 bounds;
  for (const Part& part : this->Parts)
  {
    for (std::uint32_t cell = 0; cell < part.Tree->Cells().NumberOfCells(); ++cell)
    {
      bounds.Add(part.Tree->Cells().ExtentOf(cell));
    }
  }
  return bounds;
}

double SkdParts::FindDistance(const skd::Vector3& x, double limit) const
{
  double best2 = limit * limit;
  bool isFound = false;
  for (std::uint32_t part = 0; part < this->GetNumberOfParts(); ++part)
  {
    const SkdFoundCell found = this->GetTree(part).FindNearest(x, best2, this->GetSource(part));
    if (found.Id >= 0)
    {
      best2 = std::min(best2, found.Dist2);
      isFound = true;
    }
  }
  return isFound ? std::sqrt(best2) : std::numeric_limits<double>::infinity();
}

bool SkdParts::AreWithin(const skd::SimplexSet& set, double maxDistance) const
{
  const skd::CandidateLanes all = skd::AllCandidates().front();
  const double maxDistance2 = maxDistance * maxDistance;
  bool isFound = false;
  for (std::uint32_t part = 0; part < this->GetNumberOfParts() && !isFound; ++part)
  {
    const SkdCellTree& tree = this->GetTree(part);
    const SkdCellSource source = this->GetSource(part);
    tree.VisitCandidates({ &all, &all + 1 }, set.Bounds.Inflated(maxDistance),
      [&](std::uint32_t cell)
      { isFound = isFound || tree.IsWithin(cell, source, set, maxDistance2); });
  }
  return isFound;
}

SkdTreeCounts SkdParts::GetCounts() const
{
  SkdTreeCounts counts;
  for (const Part& part : this->Parts)
  {
    const SkdCellStore& cells = part.Tree->Cells();
    counts.Cells += cells.NumberOfCells();
    counts.CellsLeftOut += cells.LeftOut().NotFinite + cells.LeftOut().Other;
    counts.Tolerance = std::max(counts.Tolerance, part.Tree->AbsoluteEpsilon());
  }
  return counts;
}
}
