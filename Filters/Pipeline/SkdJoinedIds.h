// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdJoinedIds.h
 * @brief The ids that some cells of a mesh have in the whole of it, of which each process has other
 * cells.
 */

#ifndef SkdJoinedIds_h
#define SkdJoinedIds_h

#include "Pipeline/SkdBlocks.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <vector>

namespace skdtree
{
/// A field data array of the mesh. The order of cells is that of these ids, so that ties are
/// decided as in the whole.
constexpr const char* SkdJoinedIdsName = "SkdJoinedCellIds";

/// Another one: 1 for cells of this process's own piece. Each cell of the whole is so on one
/// process.
constexpr const char* SkdOwnCellsName = "SkdOwnCells";

/// Nothing if the mesh is the whole.
inline std::vector<unsigned char> SkdOwnCellsOf(vtkDataSet* mesh)
{
  auto* own =
    vtkUnsignedCharArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(SkdOwnCellsName));
  return own
    ? std::vector<unsigned char>(own->GetPointer(0), own->GetPointer(0) + own->GetNumberOfValues())
    : std::vector<unsigned char>();
}

/// Makes it so; removes it if the list is empty.
inline void SkdSetOwnCells(vtkDataSet* mesh, const std::vector<unsigned char>& own)
{
  mesh->GetFieldData()->RemoveArray(SkdOwnCellsName);
  if (!own.empty())
  {
    vtkNew<vtkUnsignedCharArray> array;
    array->SetName(SkdOwnCellsName);
    array->SetNumberOfValues(static_cast<vtkIdType>(own.size()));
    std::copy(own.begin(), own.end(), array->GetPointer(0));
    mesh->GetFieldData()->AddArray(array);
  }
}

class SkdJoinedIds
{
public:
  explicit SkdJoinedIds(vtkDataSet* mesh)
    : Ids(vtkIdTypeArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(SkdJoinedIdsName)))
  {
  }

  /// The id of a cell in the whole; the same if the mesh is the whole, or -1.
  vtkIdType Of(vtkIdType cell) const
  {
    return this->Ids && cell >= 0 ? this->Ids->GetValue(cell) : cell;
  }

  /// The cell that has an id in the whole, which must be among them. O(log n).
  vtkIdType Find(vtkIdType id) const
  {
    if (!this->Ids)
    {
      return id;
    }
    const vtkIdType* const first = this->Ids->GetPointer(0);
    return std::lower_bound(first, first + this->Ids->GetNumberOfValues(), id) - first;
  }

  /// Whether they differ.
  bool HasOwn() const { return this->Ids != nullptr; }

private:
  vtkIdTypeArray* Ids;
};

/// Of each of some meshes.
inline std::vector<SkdJoinedIds> SkdJoinedIdsOf(const std::vector<SkdBlock>& blocks)
{
  std::vector<SkdJoinedIds> joined;
  for (const SkdBlock& block : blocks)
  {
    joined.emplace_back(block.Mesh);
  }
  return joined;
}

/// Replaces ids of cells of some meshes by those in the whole; `meshes` has the index of each id's
/// mesh in the list, -1: the id stays. O(n) if any of the meshes has joined ids, else O(1).
inline void SkdJoinIds(
  vtkIdTypeArray* ids, const std::vector<int>& meshes, const std::vector<SkdBlock>& blocks)
{
  const std::vector<SkdJoinedIds> joined = SkdJoinedIdsOf(blocks);
  if (std::none_of(
        joined.begin(), joined.end(), [](const SkdJoinedIds& own) { return own.HasOwn(); }))
  {
    return;
  }
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    if (meshes[i] >= 0)
    {
      const auto at = static_cast<vtkIdType>(i);
      ids->SetValue(at, joined[static_cast<std::size_t>(meshes[i])].Of(ids->GetValue(at)));
    }
  }
}
}

#endif
