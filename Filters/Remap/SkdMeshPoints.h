// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdMeshPoints_h
#define SkdMeshPoints_h

#include "Core/Geometry/Vector.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkDataSet;
class vtkPolyData;

namespace skdtree
{
/// The middles of a mesh's cells (their parametric centres), or its points. NaN of empty cells.
std::vector<skd::Vector3> SkdPointsOf(vtkDataSet* mesh);
std::vector<skd::Vector3> SkdMiddlesOf(vtkDataSet* mesh);

/// Makes those NaN that do not count: 0.
void SkdLeaveOut(const std::vector<unsigned char>& counts, std::vector<skd::Vector3>& points);

/// Points and nothing else.
vtkSmartPointer<vtkPolyData> SkdCloudOf(const std::vector<skd::Vector3>& positions);
}

#endif
