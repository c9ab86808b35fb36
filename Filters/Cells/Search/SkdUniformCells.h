// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdUniformCells_h
#define SkdUniformCells_h

#include "Cells/Read/SkdShape.h"
#include "Core/Geometry/Box.h"
#include "Core/Search/Tree/RawVector.h"

#include <cstdint>

class vtkDataSet;

namespace skdtree
{
/// The cells of a mesh that are all of one type with a fixed number of points, as those of most
/// meshes are.
struct SkdUniformCells
{
  bool AreThere() const { return this->Shape != SkdShape::None; }

  SkdShape Shape = SkdShape::None;
  skd::RawVector<std::uint32_t> PointIds; ///< cell after cell
  skd::Box3 Bounds;                       ///< of the cells' points, if these are finite
};

/// Reads all cells of a vtkPolyData or vtkUnstructuredGrid in one parallel pass that also checks
/// them: none of them is broken (SkdCellCheck.h) or marked as a ghost. Nothing if any is, if they
/// differ, or if they or their points are not stored one after the other; also of nullptr.
SkdUniformCells SkdReadUniformCells(vtkDataSet* data);
}

#endif
