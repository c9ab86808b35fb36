// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdGridArrays.h
 * @brief The values of the cells of an adaptive grid, as VTK arrays.
 */

#ifndef SkdGridArrays_h
#define SkdGridArrays_h

#include "Meshing/Refine/SkdGridExtras.h"
#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

namespace skdtree
{
/// Optional values of all cells by level. Empty: not requested.
class SkdGridArrays
{
public:
  static constexpr const char* LevelName = "SkdLevel";
  static constexpr const char* HangingName = "SkdHanging";

  /// The arrays of the cells in a row; `blockIndices` has that of each part.
  static std::vector<vtkSmartPointer<vtkDataArray>> Make(const SkdGrid& grid,
    const SkdGridExtras& extras, const std::vector<int>& blockIndices,
    const std::vector<SkdGridCell>& cells);
};
}

#endif
