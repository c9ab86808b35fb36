// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdSourceTrees.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skdtree
{
vtkSmartPointer<vtkSkdTreeCellLocator> SkdMakeLocator(vtkDataSet* mesh)
{
  auto locator = vtkSmartPointer<vtkSkdTreeCellLocator>::New();
  locator->SetDataSet(mesh);
  locator->UseExistingSearchStructureOn();
  return locator;
}

bool SkdBuildLocator(vtkSkdTreeCellLocator* locator, double epsilon, bool isNew)
{
  const bool isDue = isNew || locator->GetEpsilon() != epsilon;
  if (isDue)
  {
    locator->SetEpsilon(epsilon);
    locator->ForceBuildLocator();
  }
  return isDue;
}

bool SkdSourceTrees::Tree::Update(vtkDataSet* mesh, double epsilon)
{
  const bool isSame = this->Mesh.IsSameAs(mesh);
  if (!isSame)
  {
    this->Mesh.Keep(mesh);
    this->Locator = SkdMakeLocator(this->Mesh.Get());
    // What is wrong with the mesh the filter has said (SkdValidInput), once for all processes.
    vtkNew<vtkCallbackCommand> unsaid;
    this->Locator->AddObserver(vtkCommand::WarningEvent, unsaid);
  }
  return SkdBuildLocator(this->Locator, epsilon, !isSame);
}

int SkdSourceTrees::Update(const std::vector<SkdBlock>& blocks, double epsilon)
{
  this->Trees.resize(blocks.size());
  int built = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    built += this->Trees[i].Update(blocks[i].Mesh, epsilon);
  }
  return built;
}

std::optional<SkdNearest> SkdSourceTrees::FindNearest(
  const double x[3], double maximumDistance) const
{
  double query[3] = { x[0], x[1], x[2] };
  double radius = maximumDistance;
  std::optional<SkdNearest> best;
  for (std::size_t block = 0; block < this->Trees.size(); ++block)
  {
    SkdNearest next;
    int subId;
    const bool found = this->Trees[block].Locator->FindClosestPointWithinRadius(
      query, radius, next.Point, nullptr, next.CellId, subId, next.Distance2);
    if (found && (!best || next.Distance2 < best->Distance2))
    {
      next.Block = static_cast<int>(block);
      best = next;
      radius = std::min(radius, SkdRadiusIncluding(next.Distance2));
    }
  }
  return best;
}

SkdTreeCounts SkdSourceTrees::GetCounts() const
{
  SkdTreeCounts counts;
  for (const Tree& tree : this->Trees)
  {
    counts.Cells += tree.Locator->GetNumberOfCellsInTree();
    counts.CellsLeftOut += tree.Locator->GetNumberOfCellsLeftOut();
    counts.Tolerance = std::max(counts.Tolerance, tree.Locator->GetAbsoluteEpsilon());
  }
  return counts;
}
}
