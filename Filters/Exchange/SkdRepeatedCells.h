// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdRepeatedCells_h
#define SkdRepeatedCells_h

#include "vtkCellArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

namespace skdtree
{
/// Cells that several pieces have, by a key: if an earlier piece has n of a key, the first n of a
/// later one are these. Pieces are told one after another.
class SkdRepeatedCells
{
public:
  using Key = std::vector<vtkIdType>;

  /// The key of a cell of joined points.
  static Key KeyByPoints(int type, const vtkIdType* points, std::size_t number)
  {
    Key key{ type };
    key.insert(key.end(), points, points + number);
    if (type == VTK_POLYHEDRON) // VTK has its points in the order of their ids
    {
      std::sort(key.begin() + 1, key.end());
    }
    return key;
  }

  /// The key of a cell with a global id.
  static Key KeyById(vtkIdType globalId, const vtkIdType* points, std::size_t number)
  {
    Key key{ globalId };
    key.insert(key.end(), points, points + number);
    std::sort(key.begin() + 1, key.end());
    return key;
  }

  bool IsOfEarlier(int piece, const Key& key)
  {
    Count& count = this->Counts[key];
    if (count.Piece != piece)
    {
      count.Before = std::max(count.Before, count.Here);
      count.Here = 0;
      count.Piece = piece;
    }
    return ++count.Here <= count.Before;
  }

private:
  /// How often a piece has a cell, and any earlier one.
  struct Count
  {
    int Piece = -1;
    int Here = 0;
    int Before = 0;
  };
  std::map<Key, Count> Counts;
};

/// The kinds of cells in the order of vtkPolyData's ids.
constexpr int SkdNumberOfKinds = 4;

/// The kinds of a vtkPolyData's cells; of another mesh, or nullptr, all are the first.
class SkdKinds
{
public:
  explicit SkdKinds(vtkPolyData* mesh)
  {
    this->Ends.fill(std::numeric_limits<vtkIdType>::max());
    if (mesh)
    {
      this->Ends[0] = mesh->GetVerts()->GetNumberOfCells();
      this->Ends[1] = this->Ends[0] + mesh->GetLines()->GetNumberOfCells();
      this->Ends[2] = this->Ends[1] + mesh->GetPolys()->GetNumberOfCells();
    }
  }

  int Of(vtkIdType cell) const
  {
    return (cell >= this->Ends[0] ? 1 : 0) + (cell >= this->Ends[1] ? 1 : 0) +
      (cell >= this->Ends[2] ? 1 : 0);
  }

private:
  std::array<vtkIdType, SkdNumberOfKinds - 1> Ends; // of all kinds but the last
};
}

#endif
