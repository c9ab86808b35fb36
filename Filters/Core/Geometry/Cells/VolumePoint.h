// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_VolumePoint_h
#define skd_Geometry_Cells_VolumePoint_h

#include "../Vector.h"

#include <limits>

namespace skd
{

/// The point of a volume cell nearest to x: Point is the cell's at PCoords, or x itself when that
/// is inside (Dist2 = 0).
struct VolumePoint
{
  Vector3 Point;
  Vector3 PCoords;
  double Dist2;

  static VolumePoint Nowhere(const Vector3& x)
  {
    return { x, { { 0.0, 0.0, 0.0 } }, std::numeric_limits<double>::infinity() };
  }
};

}

#endif
