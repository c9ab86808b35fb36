// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSpreadShells_h
#define SkdSpreadShells_h

#include "Bodies/SkdTriangulation.h"
#include "Core/Geometry/Vector.h"
#include "Exchange/SkdTransport.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <vector>

namespace skdtree
{
/// The shells (SkdShells) of a closed surface whose triangles are on several processes.
struct SkdSpreadShells
{
  /// One value an own triangle: 1 for those that must be reversed for normals to point out of each
  /// single shell. nullptr if there are none.
  vtkSmartPointer<vtkUnsignedCharArray> Reversed;

  /// On all processes the same:
  ///@{
  bool HasOneSided = false; ///< see SkdShells
  bool AreSure = true;      ///< else it is not known which way a shell is outward
  ///@}
};

/// Of triangles among which are all that share an edge with own ones, in the order of the whole.
/// Components of own triangles are found here; where they go on in other processes, these compare
/// the edges, and all processes get a few numbers of each component. `origin` is a point near the
/// surface, on all processes the same. All processes must call it together.
SkdSpreadShells SkdFindSpreadShells(SkdTransport& transport,
  const std::vector<skd::Vector3>& points, const std::vector<SkdTriangleIds>& triangles,
  const std::vector<unsigned char>& isOwn, const skd::Vector3& origin);
}

#endif
