// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdShownElements.h
 * @brief The cells and points of a mesh that are not hidden: those of blanked grids, and of AMR
 * where it is not refined.
 */

#ifndef SkdShownElements_h
#define SkdShownElements_h

#include "Cells/Read/SkdCellReader.h"
#include "Core/Geometry/Box.h"
#include "Pipeline/SkdBlocks.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <vector>

namespace skdtree
{
/// Calls visit(cell, whether it is shown, its point ids, their number) for each cell of a mesh: it
/// is hidden by its own mark or, in a structured grid, by that of one of its points.
template <class Visit>
void SkdForEachShownOrNot(vtkDataSet* mesh, const Visit& visit)
{
  constexpr int hidden = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;
  vtkUnsignedCharArray* ofCells = mesh->GetCellGhostArray();
  vtkUnsignedCharArray* ofPoints = SkdIsStructured(mesh) ? mesh->GetPointGhostArray() : nullptr;
  const auto isHidden = [ofPoints](auto point)
  {
    const unsigned char mark = ofPoints->GetValue(static_cast<vtkIdType>(point));
    return (mark & vtkDataSetAttributes::HIDDENPOINT) != 0;
  };
  const SkdCellReader reader(mesh);
  vtkNew<vtkIdList> list;
  reader.VisitCells(0, mesh->GetNumberOfCells(), list,
    [&](vtkIdType cell, const auto* ids, std::size_t size)
    {
      const bool isMarked = ofCells && (ofCells->GetValue(cell) & hidden) != 0;
      const bool isShown = !isMarked && reader.TypeOf(cell) != VTK_EMPTY_CELL &&
        !(ofPoints && std::any_of(ids, ids + size, isHidden));
      visit(cell, isShown, ids, size);
    });
}

/// 1 for each cell (vtkDataObject::CELL) or POINT that is shown. Points are hidden by their own
/// mark, or if all cells that use them are hidden; those that no cell uses are shown.
inline std::vector<unsigned char> SkdFindShown(vtkDataSet* mesh, int type)
{
  std::vector<unsigned char> shown(static_cast<std::size_t>(mesh->GetNumberOfElements(type)), 1);
  vtkUnsignedCharArray* ofPoints = mesh->GetPointGhostArray();
  if (!ofPoints && !mesh->GetCellGhostArray())
  {
    return shown;
  }
  if (type == vtkDataObject::CELL)
  {
    SkdForEachShownOrNot(mesh,
      [&](vtkIdType cell, bool isShown, const auto*, std::size_t)
      { shown[static_cast<std::size_t>(cell)] = isShown ? 1 : 0; });
    return shown;
  }
  std::vector<unsigned char> isOfShown(shown.size(), 0);
  SkdForEachShownOrNot(mesh,
    [&](vtkIdType, bool isShown, const auto* ids, std::size_t size)
    {
      for (std::size_t i = 0; i < size; ++i)
      {
        const auto point = static_cast<std::size_t>(ids[i]);
        shown[point] = 0; // unless another cell that uses it is shown
        isOfShown[point] |= static_cast<unsigned char>(isShown ? 1 : 0);
      }
    });
  for (std::size_t i = 0; i < shown.size(); ++i)
  {
    const int mark = ofPoints ? ofPoints->GetValue(static_cast<vtkIdType>(i)) : 0;
    const bool isMarked = (mark & vtkDataSetAttributes::HIDDENPOINT) != 0;
    shown[i] = !isMarked && (shown[i] | isOfShown[i]) != 0 ? 1 : 0;
  }
  return shown;
}

/// Whether cells (vtkDataObject::CELL) or POINTs are shown, without a look at all of a mesh that
/// hides none.
class SkdShown
{
public:
  SkdShown(vtkDataSet* mesh, int type)
  {
    if (mesh->GetCellGhostArray() || mesh->GetPointGhostArray())
    {
      this->Shown = SkdFindShown(mesh, type);
    }
  }

  /// Whether it must be looked at: maybe none is hidden.
  bool MayHide() const { return !this->Shown.empty(); }

  bool Has(vtkIdType id) const
  {
    return this->Shown.empty() || this->Shown[static_cast<std::size_t>(id)] != 0;
  }

private:
  std::vector<unsigned char> Shown; // empty: all are
};

/// The box of the shown points whose coordinates are finite.
inline skd::Box3 SkdShownBounds(vtkDataSet* mesh)
{
  if (!mesh->GetPointGhostArray() && !mesh->GetCellGhostArray())
  {
    double all[6];
    mesh->GetBounds(all);
    const skd::Box3 known({ { all[0], all[2], all[4] } }, { { all[1], all[3], all[5] } });
    if (skd::IsFinite(known.Min) && skd::IsFinite(known.Max))
    {
      return known.IsEmpty() ? skd::Box3() : known;
    }
  }
  const std::vector<unsigned char> shown = SkdFindShown(mesh, vtkDataObject::POINT);
  skd::Box3 box;
  for (std::size_t i = 0; i < shown.size(); ++i)
  {
    skd::Vector3 x;
    mesh->GetPoint(static_cast<vtkIdType>(i), x.X);
    if (shown[i] != 0 && skd::IsFinite(x))
    {
      box.Add(x);
    }
  }
  return box;
}

/// How many elements of a mesh are shown, and of which isOne(i) is true.
template <class IsOne>
vtkIdType SkdCountShown(const std::vector<unsigned char>& shown, const IsOne& isOne)
{
  vtkIdType count = 0;
  for (std::size_t i = 0; i < shown.size(); ++i)
  {
    count += shown[i] != 0 && isOne(static_cast<vtkIdType>(i)) ? 1 : 0;
  }
  return count;
}

/// How many are shown.
inline vtkIdType SkdCountShown(const std::vector<unsigned char>& shown)
{
  return std::count(shown.begin(), shown.end(), 1);
}

/// 1 for each cell that is shown and not another piece's.
inline std::vector<unsigned char> SkdFindCounted(vtkDataSet* mesh)
{
  std::vector<unsigned char> counted = SkdFindShown(mesh, vtkDataObject::CELL);
  vtkUnsignedCharArray* ghosts = mesh->GetCellGhostArray();
  for (std::size_t i = 0; ghosts && i < counted.size(); ++i)
  {
    const unsigned char mark = ghosts->GetValue(static_cast<vtkIdType>(i));
    counted[i] = (mark & vtkDataSetAttributes::DUPLICATECELL) != 0 ? 0 : counted[i];
  }
  return counted;
}
}

#endif
