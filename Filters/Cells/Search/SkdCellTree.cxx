// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Search/SkdCellTree.h"

#include "Cells/Read/SkdForEach.h"
#include "Cells/Search/SkdBuildTree.h"
#include "Core/Search/Tree/CellElements.h"
#include "Core/Search/Tree/LazyTree.h"
#include "Core/Search/Tree/PaperTree.h"

#include <algorithm>

namespace skdtree
{
namespace
{
constexpr double Ulps = 8.0 * std::numeric_limits<double>::epsilon();

/// Of the mesh that some cells are a part of, with them.
SkdMeshExtent ExtentOfWhole(const SkdCellStore& store, const SkdTreeSettings& settings)
{
  SkdMeshExtent extent = store.GetExtent();
  extent.Add(settings.Whole);
  return extent;
}
}

//------------------------------------------------------------------------------
SkdCellTree::SkdCellTree(vtkDataSet* data, const SkdTreeSettings& settings)
  : SkdCellTree(SkdCellStore(data, settings.SkipsGhosts, settings.Magnitudes), settings)
{
}

SkdCellTree::~SkdCellTree() = default;

//------------------------------------------------------------------------------
void SkdCellTree::FindEqualCells(const SkdTreeSettings& settings)
{
  auto equal = std::make_unique<SkdEqualCells>(this->Store);
  if (equal->GetFirsts().size() < this->Store.NumberOfCells())
  {
    this->Equal = std::move(equal);
    this->Distinct.reset(
      new SkdCellTree(SkdCellStore(this->Store, this->Equal->GetFirsts()), settings));
  }
}

//------------------------------------------------------------------------------
SkdCellTree::SkdCellTree(SkdCellStore&& store, const SkdTreeSettings& settings)
  : Store(std::move(store))
  , Bare(settings.IsBare)
  , TheRounding(Ulps * ExtentOfWhole(this->Store, settings).LargestCoordinate)
  , TheEpsilon(settings.Epsilon)
{
  if (this->Store.NumberOfCells() == 0)
  {
    return;
  }
  this->Runs = SkdPieceRuns(this->Store, this->TheRounding);
  const skd::ReadInput<3> input = this->MakeInput(settings);
  if (settings.IsBare)
  {
    return;
  }
  if (settings.IsLazy)
  {
    this->Lazy = std::make_unique<skd::LazyTree<3>>(SkdBuildLazyTree(input));
    return;
  }
  this->Eager = SkdBuildTree(input);
  if (SkdEqualCells::AreLikely(this->Eager))
  {
    this->FindEqualCells(settings);
  }
  this->LeafFilters = SkdLeafFilters(this->Store, this->Eager, this->TheRounding);
  this->View = { this->Eager.View(), this->LeafFilters.GetCorners(), this->SafetyMargin() };
  this->Packets = this->LeafFilters.GetTriangles();
}

//------------------------------------------------------------------------------
skd::ReadInput<3> SkdCellTree::MakeInput(const SkdTreeSettings& settings)
{
  const skd::Box3& bounds = this->Store.GetBounds();
  this->TheEpsilon = std::max(
    this->TheEpsilon * ExtentOfWhole(this->Store, settings).Bounds.Diagonal(), this->TheRounding);

  skd::ReadInput<3> input;
  input.Capacity = settings.Capacity;
  input.Rule = settings.Rule;
  input.Bounds = bounds.Inflated(2.0 * this->TheEpsilon);
  input.Frame = skd::Frame<3>::Of(input.Bounds);
  input.Count = this->Store.NumberOfCells();
  input.Read = [this, frame = input.Frame](const std::uint32_t* cells, std::size_t count,
                 skd::Element<3>* to) { this->ReadElements(frame, cells, count, to); };
  return input;
}

//------------------------------------------------------------------------------
void SkdCellTree::ReadElements(const skd::Frame<3>& frame, const std::uint32_t* cells,
  std::size_t count, skd::Element<3>* to) const
{
  const double margin = 2.0 * this->TheEpsilon;
  const skd::CellPoints points = this->Store.PointsOfCells();
  if (this->Store.HasCurvedExtents())
  {
    std::transform(cells, cells + count, to,
      [&](std::uint32_t cell) -> skd::Element<3> {
        return { frame.OutwardWithin(this->Store.ExtentOf(cell), margin), cell };
      });
  }
  else if (SkdWideWalks::AreOn())
  {
    SkdWideWalks::ReadElements(&points, &frame, margin, cells, count, to);
  }
  else
  {
    skd::CellElements(points, frame, margin).Read(cells, count, to);
  }
}

//------------------------------------------------------------------------------
skd::PaperTree<3> SkdCellTree::MakePaperTree() const
{
  std::vector<skd::Box3> boxes(this->Store.NumberOfCells());
  for (std::uint32_t cell = 0; cell < this->Store.NumberOfCells(); ++cell)
  {
    boxes[cell] = this->SafetyBoxOf(cell);
  }
  return skd::BuildPaperTree(boxes);
}

//------------------------------------------------------------------------------
std::size_t SkdCellTree::NumberOfNodes() const
{
  return this->Lazy ? this->Lazy->NumberOfNodes() : this->Eager.NumberOfNodes();
}

//------------------------------------------------------------------------------
int SkdCellTree::Depth() const
{
  if (!this->Lazy)
  {
    return this->Eager.Depth();
  }
  int depth = 0;
  for (std::size_t below = this->NumberOfNodes(); below > 0; below /= skd::Node<3>::Width)
  {
    ++depth;
  }
  return depth;
}

//------------------------------------------------------------------------------
skd::SplitRule SkdCellTree::Rule() const
{
  return this->Eager.Rule();
}

//------------------------------------------------------------------------------
std::size_t SkdCellTree::MemorySize() const
{
  return sizeof(*this) + this->Store.MemorySize() + this->LeafFilters.MemorySize() +
    this->Runs.MemorySize() + (this->Equal ? this->Equal->MemorySize() : 0) +
    (this->Distinct ? this->Distinct->MemorySize() : 0) +
    (this->Lazy ? this->Lazy->MemorySize() : this->Eager.MemorySize());
}
}
