// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCellLocations_h
#define SkdCellLocations_h

#include "Search/Probe/SkdCellFinder.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkUnsignedCharArray.h"

namespace skdtree
{
/// The locations of the points of one data set: arrays with one tuple for each point, initially
/// "none".
class SkdCellLocations
{
public:
  static constexpr const char* CellIdName = "SkdSourceCellId";
  static constexpr const char* BlockIndexName = "SkdSourceBlockIndex";

  explicit SkdCellLocations(vtkIdType n);

  /// Sets a tuple. Thread-safe for distinct tuples.
  void Set(vtkIdType i, const SkdCellLocation& location);

  bool IsValid(vtkIdType i) const { return this->Blocks[static_cast<std::size_t>(i)] >= 0; }

  /// Whether it is valid, but no cell holds the point.
  bool IsOutside(vtkIdType i) const { return this->Distances->GetValue(i) > 0.0; }

  /// Adds the arrays, with block indices if the Source is composite.
  void AddTo(
    vtkDataSetAttributes* data, const std::vector<SkdBlock>& source, bool isComposite) const;

private:
  vtkSmartPointer<vtkUnsignedCharArray> Valid;
  vtkSmartPointer<vtkIdTypeArray> CellIds;
  vtkSmartPointer<vtkDoubleArray> PCoords;
  vtkSmartPointer<vtkDoubleArray> Distances;
  std::vector<int> Blocks;
};
}

#endif
