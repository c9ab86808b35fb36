// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdTriangulation_h
#define SkdTriangulation_h

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolygon.h"

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

#endif
