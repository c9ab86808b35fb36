// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdBlockPoints.h
 * @brief The points of one block of a refined mesh: the original ones, with their ids, and new
 * ones, with their interpolation weights.
 */

#ifndef SkdBlockPoints_h
#define SkdBlockPoints_h

#include "Meshing/Refine/SkdMeshReader.h"

#include <vector>

namespace skdtree
{
/// Points of equal coordinates are one node and are separated again here. A new node on a seam
/// gives one point for each pair of points from which it is made.
class SkdBlockPoints
{
public:
  /// The interpolation of new points: original points with weights that sum to 1.
  struct Recipe
  {
    std::vector<vtkIdType> Ids;
    std::vector<double> Weights;
  };

  SkdBlockPoints(const SkdReadMesh& read, const SkdReadMesh::Block& block);

  /// Sets the cell of the nodes requested next, by its original points.
  void SetCell(const std::vector<vtkIdType>& points) { this->CellPoints = &points; }

  /// The point at a node of a part of that cell, created at the first request.
  vtkIdType IdOf(std::uint32_t node);

  vtkIdType GetNumberOfOldPoints() const { return this->OldPoints; }
  vtkIdType GetNumberOfPoints() const
  {
    return this->OldPoints + static_cast<vtkIdType>(this->NewNodes.size());
  }

  ///@{
  /// Of a new point, by its number among these.
  std::uint32_t GetNode(std::size_t i) const { return this->NewNodes[i]; }
  const Recipe& GetRecipe(std::size_t i) const { return this->Recipes[i]; }
  ///@}

private:
  static constexpr vtkIdType Unknown = -1;
  static constexpr vtkIdType Seam = -2;

  vtkIdType IdOnSeam(std::uint32_t node, const std::vector<vtkIdType>& makers);
  vtkIdType AddPoint(std::uint32_t node, const std::vector<vtkIdType>& makers);

  const SkdReadMesh& Read;
  const SkdReadMesh::Block& Block;
  vtkIdType OldPoints;
  const std::vector<vtkIdType>* CellPoints = nullptr;
  std::vector<vtkIdType> IdOfNode; // or Unknown, or Seam: it depends on the cell
  std::vector<std::uint32_t> NewNodes;
  std::vector<Recipe> Recipes;
  skd::TupleNumbers<4> Makers; // of points on seams
  std::vector<vtkIdType> IdOfMakers;
};
}

#endif
