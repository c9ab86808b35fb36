// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeAbstractCellLocator.h"

#include "Cells/Read/SkdRepairedMesh.h"
#include "Cells/Search/SkdLocatorState.h"
#include "Cells/Search/SkdRepresentation.h"

#include "vtkIdList.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// The mesh without broken cells, of which it has none if they were checked.
SkdRepairedMesh WithoutBroken(vtkDataSet* data, bool isChecked)
{
  return data && !isChecked ? SkdRepair(data) : SkdRepairedMesh{ data, {} };
}
}

//------------------------------------------------------------------------------
vtkSkdTreeAbstractCellLocator::vtkSkdTreeAbstractCellLocator()
  : Impl(std::make_unique<SkdLocatorState>())
{
  this->NumberOfCellsPerNode = skd::Node<3>::Width;
  this->CacheCellBounds = 0;
}

//------------------------------------------------------------------------------
vtkSkdTreeAbstractCellLocator::~vtkSkdTreeAbstractCellLocator()
{
  this->FreeSearchStructure();
}

//------------------------------------------------------------------------------
void vtkSkdTreeAbstractCellLocator::SetTransform(vtkMatrix4x4* motion)
{
  if (!motion)
  {
    this->Impl->Motion.reset();
    return;
  }
  const auto rigid = skd::RigidMotion::FromMatrix(&motion->Element[0][0]);
  if (!rigid)
  {
    vtkErrorMacro("The transform is not rigid and is ignored. "
                  "Use rotations, reflections and translations only.");
    return;
  }
  this->Impl->Motion = rigid;
  this->Impl->Matrix->DeepCopy(motion);
}

//------------------------------------------------------------------------------
vtkMatrix4x4* vtkSkdTreeAbstractCellLocator::GetTransform()
{
  return this->Impl->Motion ? this->Impl->Matrix.Get() : nullptr;
}

//------------------------------------------------------------------------------
// Reads only where nothing is to be done: VTK's filters call it from several threads.
void vtkSkdTreeAbstractCellLocator::BuildLocator()
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
// More than queries ask for: whether any array was modified, also such that the data set does not
// know of.
bool vtkSkdTreeAbstractCellLocator::HasValidTree()
{
  if (this->Impl->AreForeignPointsModified())
  {
    return false;
  }
  const bool isNewer = this->IsNewerThanData(this->BuildTime) &&
    (!this->DataSet || this->BuildTime > this->DataSet->GetMTime());
  if (!this->Impl->GetTree() || !this->Impl->HasSnapshot())
  {
    return this->Impl->GetTree() && isNewer;
  }
  return (this->UseExistingSearchStructure || isNewer) && this->Impl->IsBuiltOn(this->DataSet);
}

//------------------------------------------------------------------------------
// Without a mesh that was kept, as after ForceBuildLocator, an existing structure is used as it is.
bool vtkSkdTreeAbstractCellLocator::IsUpToDate()
{
  if (!this->Impl->GetTree() || this->Impl->AreForeignPointsModified())
  {
    return false;
  }
  if (this->UseExistingSearchStructure)
  {
    const vtkMTimeType checked = this->Impl->GetCheckTime();
    return checked == 0 || !this->DataSet || this->IsNewerThanData(checked);
  }
  return this->IsNewerThanData(this->BuildTime);
}

//------------------------------------------------------------------------------
bool vtkSkdTreeAbstractCellLocator::IsNewerThanData(vtkMTimeType time)
{
  return time > this->MTime && (!this->DataSet || time > this->Impl->TimeOf(this->DataSet));
}

//------------------------------------------------------------------------------
// Threads whose first query finds no tree wait for one of them to build it; so does one whose tree
// was freed for that meanwhile.
const SkdCellTree& vtkSkdTreeAbstractCellLocator::GetTree()
{
  const SkdCellTree* tree = this->IsUpToDate() ? this->Impl->GetTree() : nullptr;
  if (!tree)
  {
    const std::lock_guard<std::mutex> lock(this->Impl->Building);
    this->BuildLocator();
    tree = this->Impl->GetTree();
  }
  return *tree;
}

//------------------------------------------------------------------------------
void vtkSkdTreeAbstractCellLocator::ForceBuildLocator()
{
  this->BuildLocatorInternal();
}

//------------------------------------------------------------------------------
void vtkSkdTreeAbstractCellLocator::BuildLocatorInternal()
{
  const double start = vtkTimerLog::GetUniversalTime();
  SkdTreeSettings settings;
  settings.Epsilon = this->Epsilon;
  settings.Capacity = std::min(this->NumberOfCellsPerNode, skd::Node<3>::Width);
  settings.IsLazy = this->LazyBuild;
  settings.Rule = static_cast<skd::SplitRule>(this->SplitRule);
  settings.SkipsGhosts = this->SkipGhostCells;
  this->FreeSearchStructure();
  SkdUniformCells uniform = SkdReadUniformCells(this->DataSet);
  const SkdRepairedMesh repaired = WithoutBroken(this->DataSet, uniform.AreThere());
  std::shared_ptr<const SkdCellTree> tree;
  try
  {
    tree = std::make_shared<const SkdCellTree>(
      SkdCellStore(repaired.Mesh, std::move(uniform), settings.SkipsGhosts, settings.Magnitudes),
      settings);
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
void vtkSkdTreeAbstractCellLocator::CacheBounds()
{
  if (this->CacheCellBounds && this->DataSet && this->DataSet->GetNumberOfCells() > 0)
  {
    this->FreeCellBounds();
    this->StoreCellBounds();
  }
}

//------------------------------------------------------------------------------
void vtkSkdTreeAbstractCellLocator::FreeSearchStructure()
{
  this->Impl->SetTree(nullptr);
  this->Impl->Forget();
  this->FreeCellBounds();
}

//------------------------------------------------------------------------------
void vtkSkdTreeAbstractCellLocator::ShallowCopy(vtkAbstractCellLocator* locator)
{
  auto* other = vtkSkdTreeAbstractCellLocator::SafeDownCast(locator);
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
    this->Impl->Watch(this->DataSet);
    this->BuildTime.Modified();
  }
}

//------------------------------------------------------------------------------
// Of another data set a tree serves if it has the same points and cells. (VTK's own locators share
// what they have in any case, but it is bins or boxes alone: cells are read from their data set.)
bool vtkSkdTreeAbstractCellLocator::HasTreeOf(vtkDataSet* data)
{
  return this->HasValidTree() && (data == this->DataSet || this->Impl->IsBuiltOn(data));
}

//------------------------------------------------------------------------------
void vtkSkdTreeAbstractCellLocator::FindClosestCandidates(const double x[3], vtkIdList* cellIds)
{
  this->GetTree().FindNearestCandidates(this->Impl->ToTree(x), nullptr, cellIds);
}

//------------------------------------------------------------------------------
void vtkSkdTreeAbstractCellLocator::FindClosestCandidates(
  const double x[3], const double reference[3], vtkIdList* cellIds)
{
  const skd::Vector3 guess = this->Impl->ToTree(reference);
  this->GetTree().FindNearestCandidates(this->Impl->ToTree(x), &guess, cellIds);
}

//------------------------------------------------------------------------------
void vtkSkdTreeAbstractCellLocator::FindCandidatesAlongLine(
  const double p1[3], const double p2[3], vtkIdList* cellIds)
{
  this->GetTree().FindSafetyBoxesAlong(this->Impl->ToTree(p1, p2), cellIds);
}

//------------------------------------------------------------------------------
void vtkSkdTreeAbstractCellLocator::FindCandidatesWithinBounds(
  const double bounds[6], vtkIdList* cellIds)
{
  const skd::Box3 box(
    { { bounds[0], bounds[2], bounds[4] } }, { { bounds[1], bounds[3], bounds[5] } });
  const bool isMoved = this->Impl->Motion && !box.IsEmpty();
  this->GetTree().FindSafetyBoxesWithin(isMoved ? this->Impl->Motion->Back(box) : box, cellIds);
}

//------------------------------------------------------------------------------
void vtkSkdTreeAbstractCellLocator::FindCandidatesWithinRadius(
  const double x[3], double radius, vtkIdList* cellIds)
{
  this->GetTree().FindSafetyBoxesWithin(this->Impl->ToTree(x), radius, cellIds);
}

//------------------------------------------------------------------------------
void vtkSkdTreeAbstractCellLocator::FindCandidatesAlongPlane(
  const double o[3], const double n[3], vtkIdList* cellIds)
{
  skd::Plane<3> plane = SkdPlane(o, n);
  if (this->Impl->Motion)
  {
    plane = { this->Impl->Motion->Back(plane.Origin),
      this->Impl->Motion->RotateBack(plane.Normal) };
  }
  this->GetTree().FindSafetyBoxesAlong(plane, 0.0, cellIds);
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeAbstractCellLocator::FindOverlappingPairs(
  vtkSkdTreeAbstractCellLocator* other, vtkIdList* cellIds, vtkIdList* otherCellIds)
{
  cellIds->Reset();
  otherCellIds->Reset();
  if (!other)
  {
    return 0;
  }
  // The other's world into this one's: forward by its motion, back by ours.
  const skd::RigidMotion motion =
    Compose(Inverse(this->Impl->GetMotionOrNone()), other->Impl->GetMotionOrNone());
  for (const auto& [id, otherId] : this->GetTree().FindOverlappingPairs(other->GetTree(), motion))
  {
    cellIds->InsertNextId(id);
    otherCellIds->InsertNextId(otherId);
  }
  return cellIds->GetNumberOfIds();
}

//------------------------------------------------------------------------------
void vtkSkdTreeAbstractCellLocator::GetSafetyBoxes(vtkDoubleArray* S)
{
  SkdCopySafetyBoxes(this->GetTree(), S);
}

//------------------------------------------------------------------------------
void vtkSkdTreeAbstractCellLocator::GetLinks(vtkIdTypeArray* L)
{
  SkdCopyLinks(this->GetTree(), L);
}

//------------------------------------------------------------------------------
void vtkSkdTreeAbstractCellLocator::GenerateRepresentation(int level, vtkPolyData* pd)
{
  SkdRepresent(this->GetTree(), level, this->Impl->GetMotion(), pd);
}

//------------------------------------------------------------------------------
double vtkSkdTreeAbstractCellLocator::GetAbsoluteEpsilon()
{
  const SkdCellTree* tree = this->Impl->GetTree();
  return tree && tree->Cells().NumberOfCells() > 0 ? tree->AbsoluteEpsilon() : 0.0;
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeAbstractCellLocator::GetNumberOfCellsInTree()
{
  const SkdCellTree* tree = this->Impl->GetTree();
  return tree ? static_cast<vtkIdType>(tree->Cells().NumberOfCells()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeAbstractCellLocator::GetNumberOfCellsLeftOut()
{
  const SkdCellTree* tree = this->Impl->GetTree();
  return tree ? tree->Cells().LeftOut().NotFinite + tree->Cells().LeftOut().Other : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeAbstractCellLocator::GetNumberOfNodes()
{
  const SkdCellTree* tree = this->Impl->GetTree();
  return tree ? static_cast<vtkIdType>(tree->NumberOfNodes()) : 0;
}

//------------------------------------------------------------------------------
int vtkSkdTreeAbstractCellLocator::GetSplitRuleInUse()
{
  const SkdCellTree* tree = this->Impl->GetTree();
  return tree ? static_cast<int>(tree->Rule()) : SPLIT_AUTOMATICALLY;
}

//------------------------------------------------------------------------------
int vtkSkdTreeAbstractCellLocator::GetDepth()
{
  const SkdCellTree* tree = this->Impl->GetTree();
  return tree ? tree->Depth() : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeAbstractCellLocator::GetMemorySize()
{
  const SkdCellTree* tree = this->Impl->GetTree();
  return tree ? static_cast<vtkIdType>(tree->MemorySize()) : 0;
}

//------------------------------------------------------------------------------
double vtkSkdTreeAbstractCellLocator::GetBytesPerCell()
{
  const vtkIdType cells = this->GetNumberOfCellsInTree();
  return cells > 0 ? static_cast<double>(this->GetMemorySize()) / static_cast<double>(cells) : 0.0;
}

//------------------------------------------------------------------------------
double vtkSkdTreeAbstractCellLocator::GetBuildSeconds()
{
  return this->Impl->GetTree() ? this->Impl->BuildSeconds : 0.0;
}

//------------------------------------------------------------------------------
void vtkSkdTreeAbstractCellLocator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Epsilon: " << this->Epsilon << "\n";
  os << indent << "LazyBuild: " << this->LazyBuild << "\n";
  os << indent << "SplitRule: " << this->SplitRule << "\n";
  os << indent << "SkipGhostCells: " << this->SkipGhostCells << "\n";
  os << indent << "Transform: " << (this->Impl->Motion ? "" : "(none)") << "\n";
  if (this->Impl->Motion)
  {
    this->Impl->Matrix->PrintSelf(os, indent.GetNextIndent());
  }
  os << indent << "NumberOfCellsInTree: " << this->GetNumberOfCellsInTree() << "\n";
  os << indent << "SplitRuleInUse: " << this->GetSplitRuleInUse() << "\n";
  os << indent << "NumberOfNodes: " << this->GetNumberOfNodes() << "\n";
  os << indent << "MemorySize: " << this->GetMemorySize() << "\n";
  os << indent << "BytesPerCell: " << this->GetBytesPerCell() << "\n";
}
VTK_ABI_NAMESPACE_END
