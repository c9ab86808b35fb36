// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_CellPoints_h
#define skd_Geometry_CellPoints_h

#include "PointArray.h"

#include <cstdint>

namespace skd
{

/// The points of cells. A view.
struct CellPoints
{
  PointArray Points;
  const std::uint32_t* Ids;     ///< of the points, cell after cell
  const std::uint64_t* Offsets; ///< where each cell begins, and one end; nullptr if all have Size
  std::uint32_t Size;
};

}

#endif
