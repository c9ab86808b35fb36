// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdGradient.h
 * @brief Gradients of point data within one cell.
 */

#ifndef SkdGradient_h
#define SkdGradient_h

#include "Core/Geometry/Vector.h"
#include "Search/Probe/SkdCellFinder.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkSmartPointer.h"

#include <set>
#include <string>

class vtkDataSetAttributes;

namespace skdtree
{
/// The gradient of a cell's interpolation, as vectors to be multiplied with the values at its
/// points. Exact for linear fields. In curves and surfaces it is the tangential gradient, in
/// polygons and polyhedra that of the best-fitting linear field. One object a thread.
class SkdGradient
{
public:
  /// Sets the vectors, one a point of the cell, in the order of its points.
  void Evaluate(vtkDataSet* mesh, const SkdCellLocation& location);
  const std::vector<skd::Vector3>& GetVectors() const { return this->Vectors; }

private:
  bool FitPiece(const SkdCellLocation& location);
  void Fit(std::size_t first, std::size_t size);
  void Differentiate(const SkdCellLocation& location);

  vtkNew<vtkGenericCell> Cell;
  std::vector<skd::Vector3> Points;
  std::vector<skd::Vector3> Vectors;
  std::vector<double> Derivatives;
};

/// Arrays "<name>_Gradient" of point arrays, filled slot by slot; NaN at first. Of an array of k
/// components 3 k: the derivatives by x, y and z of the first, then of the second ...
class SkdGradientArrays
{
public:
  /// For those of `names` that all blocks have as numeric arrays. The others are inserted into
  /// `missing`.
  SkdGradientArrays(const std::vector<SkdBlock>& blocks, const std::set<std::string>& names,
    vtkIdType n, std::set<std::string>& missing);

  bool IsEmpty() const { return this->Arrays.empty(); }
  void AddTo(vtkDataSetAttributes* attributes) const;

  /// Fills slot i. Thread-safe for distinct slots.
  void Set(vtkIdType i, int block, vtkIdList* ids, const std::vector<skd::Vector3>& vectors);

private:
  struct Array
  {
    std::vector<vtkDataArray*> Sources; // one a block
    vtkSmartPointer<vtkDoubleArray> Result;
  };
  std::vector<Array> Arrays;
};
}

#endif
