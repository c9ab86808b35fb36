// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBooleanSurface_h
#define SkdBooleanSurface_h

#include "Surfaces/SkdBoolean.h"

#include <set>
#include <string>

class vtkPolyData;

/// Arrays of a Boolean combination: of each triangle the input that it comes from (0 or 1), the
/// cell there and, of composite data, its block.
struct SkdBooleanNames
{
  static constexpr const char* Input = "SkdInputId";
  static constexpr const char* Cell = "SkdCellId";
  static constexpr const char* Block = "SkdBlockIndex";
};

/// The data sets of both surfaces.
struct SkdBooleanBlocks
{
  std::array<const std::vector<SkdBlock>*, 2> Of;
  bool IsComposite;
};

/// Fills `output` with a combination, and with the point and cell data that all data sets have: of
/// a triangle those of its cell, of a new point the mean of its triangle's corners. Names of arrays
/// that are already in use are inserted into `refused`.
void SkdFillBooleanSurface(const SkdPlacement& placement,
  const std::array<SkdSplitResult, 2>& split, const SkdBooleanResult& result,
  const SkdBooleanBlocks& blocks, vtkPolyData* output, std::set<std::string>& refused);

#endif
