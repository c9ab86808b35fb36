// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// The paper's own face of the locator: raw queries, the arrays S and L, pictures and statistics.
#include "vtkSkdTreeCellLocator.h"

#include "Cells/Search/SkdLocatorState.h"
#include "Cells/Search/SkdRepresentation.h"

#include "vtkIdList.h"

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
void vtkSkdTreeCellLocator::FindClosestCandidates(const double x[3], vtkIdList* cellIds)
{
  this->GetTree().FindNearestCandidates(this->Impl->ToTree(x), nullptr, cellIds);
}

//------------------------------------------------------------------------------
void vtkSkdTreeCellLocator::FindClosestCandidates(
  const double x[3], const double reference[3], vtkIdList* cellIds)
{
  const skd::Vector3 guess = this->Impl->ToTree(reference);
  this->GetTree().FindNearestCandidates(this->Impl->ToTree(x), &guess, cellIds);
}

//------------------------------------------------------------------------------
void vtkSkdTreeCellLocator::FindCandidatesAlongLine(
  const double p1[3], const double p2[3], vtkIdList* cellIds)
{
  this->GetTree().FindSafetyBoxesAlong(this->Impl->ToTree(p1, p2), cellIds);
}

//------------------------------------------------------------------------------
void vtkSkdTreeCellLocator::FindCandidatesWithinBounds(const double bounds[6], vtkIdList* cellIds)
{
  const skd::Box3 box(
    { { bounds[0], bounds[2], bounds[4] } }, { { bounds[1], bounds[3], bounds[5] } });
  const bool isMoved = this->Impl->Motion && !box.IsEmpty();
  this->GetTree().FindSafetyBoxesWithin(isMoved ? this->Impl->Motion->Back(box) : box, cellIds);
}

//------------------------------------------------------------------------------
void vtkSkdTreeCellLocator::FindCandidatesWithinRadius(
  const double x[3], double radius, vtkIdList* cellIds)
{
  this->GetTree().FindSafetyBoxesWithin(this->Impl->ToTree(x), radius, cellIds);
}

//------------------------------------------------------------------------------
void vtkSkdTreeCellLocator::FindCandidatesAlongPlane(
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
vtkIdType vtkSkdTreeCellLocator::FindOverlappingPairs(
  vtkSkdTreeCellLocator* other, vtkIdList* cellIds, vtkIdList* otherCellIds)
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
void vtkSkdTreeCellLocator::GetSafetyBoxes(vtkDoubleArray* S)
{
  SkdCopySafetyBoxes(this->GetTree(), S);
}

//------------------------------------------------------------------------------
void vtkSkdTreeCellLocator::GetLinks(vtkIdTypeArray* L)
{
  SkdCopyLinks(this->GetTree(), L);
}

//------------------------------------------------------------------------------
void vtkSkdTreeCellLocator::GenerateRepresentation(int level, vtkPolyData* pd)
{
  SkdRepresent(this->GetTree(), level, this->Impl->GetMotion(), pd);
}

//------------------------------------------------------------------------------
double vtkSkdTreeCellLocator::GetAbsoluteEpsilon()
{
  const SkdCellTree* tree = this->Impl->GetTree();
  return tree && tree->Cells().NumberOfCells() > 0 ? tree->AbsoluteEpsilon() : 0.0;
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::GetNumberOfCellsInTree()
{
  const SkdCellTree* tree = this->Impl->GetTree();
  return tree ? static_cast<vtkIdType>(tree->Cells().NumberOfCells()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::GetNumberOfCellsLeftOut()
{
  const SkdCellTree* tree = this->Impl->GetTree();
  return tree ? tree->Cells().LeftOut().NotFinite + tree->Cells().LeftOut().Other : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::GetNumberOfNodes()
{
  const SkdCellTree* tree = this->Impl->GetTree();
  return tree ? static_cast<vtkIdType>(tree->NumberOfNodes()) : 0;
}

//------------------------------------------------------------------------------
int vtkSkdTreeCellLocator::GetSplitRuleInUse()
{
  const SkdCellTree* tree = this->Impl->GetTree();
  return tree ? static_cast<int>(tree->Rule()) : SPLIT_AUTOMATICALLY;
}

//------------------------------------------------------------------------------
int vtkSkdTreeCellLocator::GetDepth()
{
  const SkdCellTree* tree = this->Impl->GetTree();
  return tree ? tree->Depth() : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::GetMemorySize()
{
  const SkdCellTree* tree = this->Impl->GetTree();
  return tree ? static_cast<vtkIdType>(tree->MemorySize()) : 0;
}

//------------------------------------------------------------------------------
double vtkSkdTreeCellLocator::GetBytesPerCell()
{
  const vtkIdType cells = this->GetNumberOfCellsInTree();
  return cells > 0 ? static_cast<double>(this->GetMemorySize()) / static_cast<double>(cells) : 0.0;
}

//------------------------------------------------------------------------------
double vtkSkdTreeCellLocator::GetBuildSeconds()
{
  return this->Impl->GetTree() ? this->Impl->BuildSeconds : 0.0;
}
VTK_ABI_NAMESPACE_END
