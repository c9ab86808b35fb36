// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdTriangulation_h
#define SkdTriangulation_h

#include "Core/Geometry/Vector.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolygon.h"

#include <array>
#include <vector>

class vtkPolyData;

/// Triangulates polygons without new points: n corners give n - 2 triangles, so no edge is opened.
/// A quad is divided along its interior diagonal, the shorter one if there are two.
class SkdTriangulation
{
public:
  explicit SkdTriangulation(vtkPoints* points);

  /// The corners of the triangles, three a triangle. Valid until the next call.
  vtkIdList* Cut(const vtkIdType* corners, int size);

private:
  void AddFan(const vtkIdType* corners, int size, int first);
  int GetFirstOfQuad(const vtkIdType* corners) const;
  bool CutPolygon(const vtkIdType* corners, int size);

  vtkPoints* Points;
  vtkNew<vtkIdList> Triangles;
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkPoints> Unused;
};

/// A triangle of a surface: its points' ids.
using SkdTriangleIds = std::array<vtkIdType, 3>;

/// The triangles of a surface that has no other cells, and its points.
std::vector<SkdTriangleIds> SkdTrianglesOf(vtkPolyData* surface);
std::vector<skd::Vector3> SkdPointsOf(vtkPolyData* surface);

#endif
