// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PaperArrays.h
 * @brief S and L of a locator as the tree that they describe
 */
#ifndef skdtest_PaperArrays_h
#define skdtest_PaperArrays_h

#include "Support/LocatorCalls.h"

namespace skdtest
{

struct PaperArrays
{
  std::vector<Bounds> S;
  Ids L;

  explicit PaperArrays(vtkSkdTreeCellLocator* locator)
  {
    vtkNew<vtkDoubleArray> boxes;
    vtkNew<vtkIdTypeArray> links;
    locator->GetSafetyBoxes(boxes);
    locator->GetLinks(links);
    this->S.resize(boxes->GetNumberOfTuples());
    for (std::size_t i = 0; i < this->S.size(); ++i)
    {
      boxes->GetTypedTuple(static_cast<vtkIdType>(i), this->S[i].data());
    }
    this->L.resize(links->GetNumberOfTuples());
    for (std::size_t i = 0; i < this->L.size(); ++i)
    {
      this->L[i] = links->GetValue(static_cast<vtkIdType>(i));
    }
  }

  bool IsLeaf(vtkIdType node) const { return this->L[node] <= 0; }
  vtkIdType CellOf(vtkIdType leaf) const { return -this->L[leaf]; }

  /// Calls visit(node, depth) for each node below and with `node`.
  void Visit(
    const std::function<void(vtkIdType, int)>& visit, vtkIdType node = 0, int depth = 0) const
  {
    visit(node, depth);
    if (!this->IsLeaf(node))
    {
      this->Visit(visit, this->L[node], depth + 1);
      this->Visit(visit, this->L[node] + 1, depth + 1);
    }
  }

  /// The cells of the leaves below a node, in tree order.
  Ids CellsBelow(vtkIdType node) const
  {
    Ids cells;
    this->Visit(
      [&](vtkIdType n, int)
      {
        if (this->IsLeaf(n))
        {
          cells.push_back(this->CellOf(n));
        }
      },
      node);
    return cells;
  }

  /// By cell id; empty boxes for cells that are not in the tree.
  std::vector<Bounds> BoxesOfCells(vtkIdType numberOfCells) const
  {
    std::vector<Bounds> boxes(numberOfCells, EmptyBounds());
    for (std::size_t i = 0; i < this->L.size(); ++i)
    {
      if (this->IsLeaf(static_cast<vtkIdType>(i)))
      {
        boxes[this->CellOf(static_cast<vtkIdType>(i))] = this->S[i];
      }
    }
    return boxes;
  }
};

}

#endif
