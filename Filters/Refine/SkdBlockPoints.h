// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdBlockPoints.h
 * @brief The points of one block of a refined mesh: those that it had, under their ids, and new
 * ones, with what they are made of.
 */

#ifndef SkdBlockPoints_h
#define SkdBlockPoints_h

#include "Refine/SkdMeshReader.h"

#include <vector>

/// Points of equal coordinates are one node; here they come apart again. A new node on a seam is a
/// point for each pair of points that it is made of.
class SkdBlockPoints
{
public:
  /// What they are made of: points that were there before, by weights that sum to 1.
  struct Recipe
  {
    std::vector<vtkIdType> Ids;
    std::vector<double> Weights;
  };

  SkdBlockPoints(const SkdReadMesh& read, const SkdReadMesh::Block& block);

  /// Says of what cell the nodes are that are asked for next, by its points before.
  void SetCell(const std::vector<vtkIdType>& points) { this->CellPoints = &points; }

  /// The point at a node of a part of that cell, a new one when it is asked for first.
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

#endif
