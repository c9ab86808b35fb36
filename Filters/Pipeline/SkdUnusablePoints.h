// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdUnusablePoints_h
#define SkdUnusablePoints_h

#include "vtkType.h"

#include <string>

class vtkDataSet;

namespace skdtree
{
/// The points of a data set that a filter cannot use: NaN, infinite or, in most filters, so large
/// that squares of coordinates overflow (Cells/Read/SkdMagnitudes.h). Cells that have them are
/// ignored, and nothing is found at such points. None of them are hidden points, and those that
/// only hidden cells use: nobody expects an answer there.
struct SkdUnusablePoints
{
  vtkIdType Count = 0;
  vtkIdType First = -1;

  /// "2 of 9 points are NaN, infinite or beyond 1e+152; the first is point 4."
  std::string Tell(vtkDataSet* mesh, bool anyMagnitude) const;
};

/// Looks at each coordinate once, in parallel; of images at the corners, if these can be used.
/// `anyMagnitude`: all finite ones can be used. No cell of the mesh may be broken.
SkdUnusablePoints SkdFindUnusablePoints(vtkDataSet* mesh, bool anyMagnitude);
}

#endif
