// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/SkdCellTree.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace
{
constexpr double Ulps = 8.0 * std::numeric_limits<double>::epsilon();

/// The bounds of all cells, in parallel.
class BoundsOfCells
{
public:
  explicit BoundsOfCells(const std::vector<skd::Box3>& boxes)
    : Boxes(boxes)
  {
  }
  void Initialize() { this->Partial.Local() = skd::Box3(); }
  void operator()(vtkIdType begin, vtkIdType end)
  {
    skd::Box3& bounds = this->Partial.Local();
    for (vtkIdType i = begin; i < end; ++i)
    {
      bounds.Add(this->Boxes[static_cast<std::size_t>(i)]);
    }
  }
  void Reduce()
  {
    for (const skd::Box3& bounds : this->Partial)
    {
      this->Total.Add(bounds);
    }
  }

  skd::Box3 Total;

private:
  const std::vector<skd::Box3>& Boxes;
  vtkSMPThreadLocal<skd::Box3> Partial;
};
}

//------------------------------------------------------------------------------
SkdCellTree::SkdCellTree(vtkDataSet* data, const SkdTreeSettings& settings)
  : Store(data, settings.SkipsGhosts)
  , TheRounding(Ulps * this->Store.LargestCoordinate())
  , TheEpsilon(settings.Epsilon)
{
  if (this->Store.NumberOfCells() == 0)
  {
    return;
  }
  skd::TreeInput<3> input = this->MakeInput(settings.Capacity);
  if (settings.IsLazy)
  {
    this->Lazy = std::make_unique<skd::LazyTree<3>>(std::move(input));
    return;
  }
  const auto parallelLoop = [](std::size_t count, const auto& body)
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(count), 1,
      [&body](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          body(static_cast<std::size_t>(i));
        }
      });
  };
  this->Eager = EagerTree(std::move(input), parallelLoop);
}

//------------------------------------------------------------------------------
skd::TreeInput<3> SkdCellTree::MakeInput(int capacity)
{
  const auto count = static_cast<vtkIdType>(this->Store.NumberOfCells());
  std::vector<skd::Box3> boxes(static_cast<std::size_t>(count));
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const auto cell = static_cast<std::uint32_t>(i);
        boxes[cell] = this->Store.ReachOf(cell);
      }
    });
  BoundsOfCells bounds(boxes);
  vtkSMPTools::For(0, count, bounds);
  this->TheEpsilon = std::max(this->TheEpsilon * bounds.Total.Diagonal(), this->TheRounding);

  skd::TreeInput<3> input;
  input.Capacity = capacity;
  input.Bounds = bounds.Total.Inflated(2.0 * this->TheEpsilon);
  input.Frame = skd::Frame<3>::Of(input.Bounds);
  input.Elements.resize(static_cast<std::size_t>(count));
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const auto cell = static_cast<std::uint32_t>(i);
        const skd::Box3 safetyBox = boxes[cell].Inflated(2.0 * this->TheEpsilon);
        input.Elements[cell] = { input.Frame.Outward(safetyBox), cell };
      }
    });
  return input;
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
  int depth = 0;
  for (std::size_t below = this->NumberOfNodes(); below > 0; below /= skd::Node<3>::Width)
  {
    ++depth;
  }
  return depth;
}

//------------------------------------------------------------------------------
std::size_t SkdCellTree::MemorySize() const
{
  return sizeof(*this) + this->Store.MemorySize() +
    (this->Lazy ? this->Lazy->MemorySize() : this->Eager.MemorySize());
}
