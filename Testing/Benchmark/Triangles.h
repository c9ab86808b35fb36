// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Triangles.h
 * @brief the triangles of a data set, for peers that know nothing of VTK
 */
#ifndef skdbench_Triangles_h
#define skdbench_Triangles_h

#include "Support/Point.h"

#include <optional>
#include <vector>

class vtkDataSet;

namespace skdbench
{

struct Corners
{
  skdtest::Point A, B, C;
};

/// By cell id; none when there is a cell that is no triangle.
std::optional<std::vector<Corners>> TrianglesOf(vtkDataSet* data);

}

#endif
