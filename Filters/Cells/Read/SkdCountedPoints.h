// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCountedPoints_h
#define SkdCountedPoints_h

#include "vtkCell.h"
#include "vtkIdList.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace skdtree
{
/// The point ids of a cell are counted from 0 as long as this lives, so that its faces say which of
/// the cell's points they have.
class SkdCountedPoints
{
public:
  explicit SkdCountedPoints(vtkCell* cell)
    : Ids(cell->GetPointIds())
    , Points(this->Ids->begin(), this->Ids->end())
  {
    std::iota(this->Ids->begin(), this->Ids->end(), vtkIdType(0));
  }
  ~SkdCountedPoints() { std::copy(this->Points.begin(), this->Points.end(), this->Ids->begin()); }
  SkdCountedPoints(const SkdCountedPoints&) = delete;
  SkdCountedPoints& operator=(const SkdCountedPoints&) = delete;

private:
  vtkIdList* Ids;
  std::vector<vtkIdType> Points;
};
}

#endif
