// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCellLocations_h
#define SkdCellLocations_h

#include "Search/Probe/SkdCellFinder.h"
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

  vtkIdType GetNumberOfPoints() const { return static_cast<vtkIdType>(this->Blocks.size()); }
  vtkIdType CountValid() const;
  vtkIdType CountOutside() const; // valid ones that no cell holds

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
