// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSubset_h
#define SkdSubset_h

#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <vector>

class vtkUnsignedCharArray;

namespace skdtree
{
class SkdCellReader;

/// A subset of the cells or points of a mesh as a grid, with only the points in use, in the order
/// of their first use.
class SkdSubset
{
public:
  explicit SkdSubset(vtkDataSet* mesh);

  ///@{
  /// The grid becomes these cells, or these points as cells of type VTK_VERTEX. Once a subset.
  void SetCells(const std::vector<vtkIdType>& cells);
  void SetPoints(const std::vector<vtkIdType>& points);
  ///@}

  /// Copies the rational weights and degrees of curved cells, if any.
  void CopyShaping();

  /// Gives the grid the mesh's point data, and cell data if it has cells of the mesh.
  void CopyData();

  vtkUnstructuredGrid* Get() const { return this->Grid; }

  /// The mesh's point that each point of the grid is.
  const std::vector<vtkIdType>& GetPointIds() const { return this->PointIds; }

private:
  void CopyCells(const SkdCellReader& reader, vtkUnsignedCharArray* types);
  void InsertCells(const SkdCellReader& reader);
  template <class Visit>
  void VisitCells(const SkdCellReader& reader, vtkIdList* list, const Visit& visit) const;
  void CopyPoints();
  vtkIdType NewPoint(vtkIdType point)
  {
    vtkIdType& id = this->NewIds[static_cast<std::size_t>(point)];
    if (id < 0)
    {
      id = static_cast<vtkIdType>(this->PointIds.size());
      this->PointIds.push_back(point);
    }
    return id;
  }

  vtkDataSet* Mesh;
  vtkNew<vtkUnstructuredGrid> Grid;
  std::vector<vtkIdType> NewIds;   // of each point of the mesh, -1: not used
  std::vector<vtkIdType> PointIds; // of the mesh
  std::vector<vtkIdType> CellIds;
};
}

#endif
