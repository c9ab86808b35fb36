// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// When the locator builds its tree, and with which others it shares it.
#include "vtkSkdTreeCellLocator.h"

#include "Cells/Read/SkdRepairedMesh.h"
#include "Cells/Search/SkdLocatorState.h"

#include "vtkTimerLog.h"

#include <algorithm>
#include <stdexcept>

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
// Reads only where nothing is to be done: VTK's filters call it from several threads.
void vtkSkdTreeCellLocator::BuildLocator()
{
  const bool isValid = this->HasValidTree();
  if (!isValid)
  {
    this->BuildLocatorInternal();
  }
  if (!isValid || !this->Impl->HasSnapshot() || !this->IsUpToDate())
  {
    this->Impl->Keep(this->DataSet);
  }
}

//------------------------------------------------------------------------------
// More than queries ask for: whether arrays were modified of which the data set does not know.
bool vtkSkdTreeCellLocator::HasValidTree()
{
  if (!this->Impl->GetTree() || !this->Impl->HasSnapshot())
  {
    return this->Impl->GetTree() && this->IsNewerThanData();
  }
  return (this->UseExistingSearchStructure || this->IsNewerThanData()) &&
    this->Impl->IsBuiltOn(this->DataSet);
}

//------------------------------------------------------------------------------
void vtkSkdTreeCellLocator::ForceBuildLocator()
{
  this->BuildLocatorInternal();
}

//------------------------------------------------------------------------------
void vtkSkdTreeCellLocator::BuildLocatorInternal()
{
  const double start = vtkTimerLog::GetUniversalTime();
  SkdTreeSettings settings;
  settings.Epsilon = this->Epsilon;
  settings.Capacity = std::min(this->NumberOfCellsPerNode, skd::Node<3>::Width);
  settings.IsLazy = this->LazyBuild;
  settings.Rule = static_cast<skd::SplitRule>(this->SplitRule);
  settings.SkipsGhosts = this->SkipGhostCells;
  this->FreeSearchStructure();
  const SkdRepairedMesh repaired = this->DataSet ? SkdRepair(this->DataSet) : SkdRepairedMesh();
  std::shared_ptr<const SkdCellTree> tree;
  try
  {
    tree = std::make_shared<const SkdCellTree>(repaired.Mesh, settings);
  }
  catch (const std::length_error& error)
  {
    vtkErrorMacro("The tree cannot be built: " << error.what() << ".");
    tree = std::make_shared<const SkdCellTree>(nullptr, settings);
  }
  const vtkIdType notFinite = tree->Cells().LeftOut().NotFinite;
  if (notFinite > 0)
  {
    vtkWarningMacro(<< notFinite << " of " << this->DataSet->GetNumberOfCells()
                    << " cells are ignored: " << SkdWhyCellsAreLeftOut());
  }
  if (repaired.Fault.empty())
  {
    this->CacheBounds();
  }
  else
  {
    vtkWarningMacro(<< repaired.Fault); // their bounds must not be computed
  }
  this->Impl->BuildSeconds = vtkTimerLog::GetUniversalTime() - start;
  this->BuildTime.Modified();
  this->Impl->SetTree(tree); // last: from here on other threads use it
}

//------------------------------------------------------------------------------
void vtkSkdTreeCellLocator::CacheBounds()
{
  if (this->CacheCellBounds && this->DataSet && this->DataSet->GetNumberOfCells() > 0)
  {
    this->FreeCellBounds();
    this->StoreCellBounds();
  }
}

//------------------------------------------------------------------------------
void vtkSkdTreeCellLocator::ShallowCopy(vtkAbstractCellLocator* locator)
{
  auto* other = vtkSkdTreeCellLocator::SafeDownCast(locator);
  if (!other || other == this)
  {
    return;
  }
  if (!this->DataSet)
  {
    this->SetDataSet(other->GetDataSet());
  }
  const bool isShared = other->HasTreeOf(this->DataSet);
  this->SetEpsilon(other->Epsilon);
  this->SetLazyBuild(other->LazyBuild);
  this->SetSplitRule(other->SplitRule);
  this->SetSkipGhostCells(other->SkipGhostCells);
  this->SetNumberOfCellsPerNode(other->NumberOfCellsPerNode);
  this->SetCacheCellBounds(other->CacheCellBounds);
  this->SetUseExistingSearchStructure(other->UseExistingSearchStructure);
  this->Impl->Motion = other->Impl->Motion;
  this->Impl->Matrix->DeepCopy(other->Impl->Matrix);
  this->FreeSearchStructure();
  if (isShared)
  {
    this->Impl->KeepAs(*other->Impl);
    this->Impl->BuildSeconds = other->Impl->BuildSeconds;
    this->Impl->SetTree(other->Impl->ShareTree());
    this->BuildTime.Modified();
  }
}

//------------------------------------------------------------------------------
// Of another data set a tree serves if it has the same points and cells. (VTK's own locators share
// what they have in any case, but it is bins or boxes alone: cells are read from their data set.)
bool vtkSkdTreeCellLocator::HasTreeOf(vtkDataSet* data)
{
  return this->HasValidTree() && (data == this->DataSet || this->Impl->IsBuiltOn(data));
}
VTK_ABI_NAMESPACE_END
