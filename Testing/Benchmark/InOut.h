// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skdbench_InOut_h
#define skdbench_InOut_h

#include <vector>

class vtkDataSet;
class vtkPolyData;

/// What a point is, once for each: 1 inside, 0 outside, -1 not known. Empty: not to be had.
using Sides = std::vector<signed char>;

/// CGAL's Side_of_triangle_mesh, of closed surfaces of triangles: -1 on the boundary.
Sides AskCgalSides(vtkDataSet* points, vtkPolyData* surface);

#endif
