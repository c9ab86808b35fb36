// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdFaceList_h
#define SkdFaceList_h

#include "Core/Geometry/Rows.h"
#include "vtkType.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace skdtree
{
/// A face of a cell.
struct SkdCellFace
{
  vtkIdType CellId;
  int Face; ///< -1: the cell itself

  bool operator<(const SkdCellFace& other) const
  {
    return this->CellId != other.CellId ? this->CellId < other.CellId : this->Face < other.Face;
  }
};

/// The faces of many volume cells, to find the outer ones. Faces are equal if they have the same
/// points, wherever they start and whichever way they go around.
class SkdFaceList
{
public:
  /// A ghost is not outer, but removes the face that it is equal to.
  template <class Iterator>
  void Add(const SkdCellFace& face, Iterator firstPoint, Iterator lastPoint, bool isGhost = false)
  {
    this->Name.assign(firstPoint, lastPoint);
    std::sort(this->Name.begin(), this->Name.end());
    this->Entries.push_back({ this->HashOfName(), this->Names.size(), face, isGhost });
    this->Names.Add(this->Name.begin(), this->Name.end());
  }

  /// The faces that an odd number of cells has, ascending: of each the last. O(n log n); empties
  /// the list.
  std::vector<SkdCellFace> TakeOuter();

private:
  struct Entry
  {
    std::uint64_t Hash; // of the name
    std::size_t Name;
    SkdCellFace Face;
    bool IsGhost;
  };

  std::uint64_t HashOfName() const;
  int CompareNames(const Entry& a, const Entry& b) const;

  std::vector<Entry> Entries;
  skd::Rows<vtkIdType> Names; // the points of each face, ascending
  std::vector<vtkIdType> Name;
};
}

#endif
