// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCutPlane_h
#define SkdCutPlane_h

#include "Core/Geometry/Vector.h"
#include "Pipeline/SkdBlocks.h"
#include "vtkPolyData.h"

namespace skdtree
{
/// A plane as a surface that reaches beyond data sets, so that it cuts them as the plane does: one
/// triangle, which is flat whatever the rounding of its corners. It is the same data set again
/// while nothing changes it.
class SkdCutPlane
{
public:
  /// Of a normal of any length; `isClosed`: as the face of a tetrahedron behind it, which has all
  /// of the data sets that is there. A plane that is normal to an axis is so exactly, and one far
  /// away is put nearby, on the same side. nullptr if the normal is 0, or coordinates are too large
  /// for corners beyond them. O(1) for each data set with finite points.
  vtkPolyData* Update(const std::vector<SkdBlock>& blocks, const skd::Vector3& origin,
    const skd::Vector3& normal, bool isClosed);

private:
  std::vector<skd::Vector3> Corners;
  vtkSmartPointer<vtkPolyData> Surface;
};
}

#endif
