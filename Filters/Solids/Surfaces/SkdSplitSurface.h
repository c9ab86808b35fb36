// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSplitSurface_h
#define SkdSplitSurface_h

#include "Solids/Surfaces/SkdSplitTriangles.h"

#include <set>
#include <string>

class vtkPolyData;

namespace skdtree
{
class SkdLoop;

/// Arrays of a split surface: of each triangle the cell that it comes from, that cell's block (of
/// composite data), and the region that it belongs to.
struct SkdSplitNames
{
  static constexpr const char* Cell = "SkdCellId";
  static constexpr const char* Block = "SkdBlockIndex";
  static constexpr const char* Region = "SkdRegionId";
};

/// Fills `output` with the triangles of a side of a placement, split. Points have the data of the
/// first data set that has them, new ones the mean of their triangle's corners; triangles have the
/// data of their cell. Names of arrays that are already in use are inserted into `refused`. Returns
/// the number of triangles that are split. After an abort the output is empty.
vtkIdType SkdFillSplitSurface(const SkdSplitSegments& segments, int side,
  const std::vector<SkdBlock>& blocks, bool isComposite, double scale, vtkPolyData* output,
  std::set<std::string>& refused, SkdLoop& loop);
}

#endif
