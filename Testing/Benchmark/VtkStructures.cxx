// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LocatorStructure.h"

#include "vtkCellLocator.h"
#include "vtkCellTreeLocator.h"
#include "vtkModifiedBSPTree.h"
#include "vtkOBBTree.h"
#include "vtkSkdTreeVersion.h"
#include "vtkStaticCellLocator.h"
#if __has_include("vtkJumpAndWalkCellLocator.h")
#include "vtkJumpAndWalkCellLocator.h"
#define SKDBENCH_HAS_JUMP_AND_WALK
#endif

#include <type_traits>

// In the VTK of Debian 12's ParaView a line query of vtkModifiedBSPTree reads memory that was never
// written, and corrupts the heap: it cannot stand beside others in one process.
#if VTK_VERSION_NUMBER != VTK_VERSION_CHECK(9, 2, 20230111)
#define SKDBENCH_HAS_SOUND_BSP
#endif

namespace skdbench
{
namespace
{

// Before 9.2 the abstract locator had no form with a tolerance that finds all hits.
template <class Locator>
bool AllHitsOf(
  Locator* tree, const Query& query, double tolerance, vtkPoints* points, vtkIdList* ids)
{
#if VTK_SKD_LOCATOR_92
  tree->IntersectWithLine(query.From.data(), query.To.data(), tolerance, points, ids);
  return true;
#else
  (void)tree, (void)query, (void)tolerance, (void)points, (void)ids;
  return false;
#endif
}

bool AllHitsOf(
  vtkModifiedBSPTree* tree, const Query& query, double tolerance, vtkPoints* points, vtkIdList* ids)
{
  tree->IntersectWithLine(query.From.data(), query.To.data(), tolerance, points, ids);
  return true;
}

bool AllHitsOf(vtkOBBTree* tree, const Query& query, double, vtkPoints* points, vtkIdList* ids)
{
  tree->IntersectWithLine(query.From.data(), query.To.data(), points, ids);
  return true;
}

template <class Locator>
class VtkStructure : public LocatorStructure<Locator>
{
protected:
  void BuildNow() override
  {
#if !VTK_SKD_LOCATOR_92
    this->Tree->LazyEvaluationOff(); // else the first query pays
#endif
    this->Tree->BuildLocator();
  }

  bool HasFindCell() const override
  {
    return !std::is_same<Locator, vtkOBBTree>::value;
  }

  bool AllHits(const Query& query) override
  {
    return AllHitsOf(this->Tree.Get(), query, this->Tolerance, this->Points, this->Ids);
  }
};

template <class Structure>
Kind KindOf(const std::string& name, bool forMillions = false)
{
  return { name, Family::Vtk, [] { return std::make_unique<Structure>(); }, forMillions };
}

}

std::vector<Kind> VtkKinds()
{
  return {
    KindOf<VtkStructure<vtkCellLocator>>("CellLocator"),
    KindOf<VtkStructure<vtkStaticCellLocator>>("StaticCellLocator", true),
    KindOf<VtkStructure<vtkCellTreeLocator>>("CellTreeLocator"),
#ifdef SKDBENCH_HAS_SOUND_BSP
    KindOf<VtkStructure<vtkModifiedBSPTree>>("ModifiedBSPTree"),
#endif
    KindOf<VtkStructure<vtkOBBTree>>("OBBTree"),
#ifdef SKDBENCH_HAS_JUMP_AND_WALK
    KindOf<VtkStructure<vtkJumpAndWalkCellLocator>>("JumpAndWalkCellLocator"),
#endif
  };
}

}
