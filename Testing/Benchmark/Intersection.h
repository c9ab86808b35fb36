// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skdbench_Intersection_h
#define skdbench_Intersection_h

#include "vtkType.h"

#include <functional>
#include <vector>

class vtkPolyData;

/// Intersects two surfaces. Returns how much it found, each in its own measure.
using IntersectionRun = std::function<vtkIdType(vtkPolyData*, vtkPolyData*)>;

/// CGAL's surface_intersection: the number of segments of its curves.
vtkIdType RunCgalCurves(vtkPolyData* first, vtkPolyData* second);

#endif
