// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skdbench_Boolean_h
#define skdbench_Boolean_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

/// A combination of two solids, nullptr if it is refused, and processor seconds: of reading and
/// writing VTK's data, and of the rest.
struct BooleanResult
{
  vtkSmartPointer<vtkPolyData> Surface;
  double Seconds = 0.0;
  double Conversion = 0.0;
};

/// CGAL's corefinement, whose points are rounded to double; operations as those of
/// vtkSkdTreeBooleanOperation, the symmetric difference excepted.
BooleanResult RunCgalBoolean(vtkPolyData* first, vtkPolyData* second, int operation);

#endif
