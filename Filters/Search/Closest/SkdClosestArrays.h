// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdClosestArrays_h
#define SkdClosestArrays_h

#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdSourceTrees.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPointData;
class vtkPolyData;

namespace skdtree
{
/// Result arrays of one data set, with one tuple for each point, initially "none".
class SkdClosestArrays
{
public:
  /// Whether an array of that name is one of ours.
  static bool IsOurs(const std::string& name);

  explicit SkdClosestArrays(vtkIdType n);

  /// Sets a tuple. Thread-safe for distinct tuples.
  void Set(vtkIdType i, const SkdNearest& nearest, bool isInside);

  /// Sets the sign of a distance. Thread-safe for distinct tuples.
  void SetInside(vtkIdType i, bool isInside);

  /// @{ The values of a tuple. The block is -1 if there is no result.
  int GetBlock(vtkIdType i) const { return this->Blocks[i]; }
  vtkIdType GetCellId(vtkIdType i) const { return this->CellIds->GetValue(i); }
  const double* GetPoint(vtkIdType i) const { return this->Points->GetPointer(3 * i); }
  ///@}

  vtkIdType GetNumberOfPoints() const { return static_cast<vtkIdType>(this->Blocks.size()); }

  /// Adds the arrays, and makes the distance the active scalars. Block indices are added if
  /// `source` is composite.
  void AddTo(vtkPointData* pointData, const std::vector<SkdBlock>& source, bool isComposite) const;

private:
  vtkSmartPointer<vtkDoubleArray> Points;
  vtkSmartPointer<vtkDoubleArray> Distances;
  vtkSmartPointer<vtkIdTypeArray> CellIds;
  std::vector<int> Blocks;
};

/// Fills `lines` with a line from each point of `meshes` that is shown and has a result to its
/// nearest point. Cell data are the point arrays that all meshes have in common, without ghost
/// marks. `listed` says of which points, by mesh (see SkdFilterInputs::FindCounted).
void SkdConnectClosest(const std::vector<SkdBlock>& meshes,
  const std::vector<SkdClosestArrays>& answers,
  const std::vector<std::vector<unsigned char>>& listed, vtkPolyData* lines);
}

#endif
