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

namespace skdtree
{
/// Triangulates polygons without new points: n corners give n - 2 triangles, so no edge is opened.
/// A quad is divided along its interior diagonal, the shorter one if there are two.
/// All surfaces of the filters are triangulated by this class, so that they consist of the same
/// triangles; tests for overlap use skd::EarClipping, which is exact and faster but chooses other
/// diagonals.
class SkdTriangulation
{
public:
  SkdTriangulation();

  /// The corners of the triangles, three a triangle, as indices in the polygon, whose corners are
  /// cornerOf(0), cornerOf(1), ... (skd::Vector3). Valid until the next call.
  template <class CornerOf>
  vtkIdList* Cut(vtkIdType size, const CornerOf& cornerOf)
  {
    if (size > 3)
    {
      this->SetCorners(size, cornerOf);
    }
    return this->CutPolygon(size);
  }

  /// Whether VTK's filters divide a polygon of more than three corners into triangles that have all
  /// its edges. They leave out corners that are too near to each other, and may stop early.
  template <class CornerOf>
  bool IsCutByVtk(vtkIdType size, const CornerOf& cornerOf)
  {
    this->SetCorners(size, cornerOf);
    this->Triangles->Reset();
    return this->ClipEars(size);
  }

private:
  template <class CornerOf>
  void SetCorners(vtkIdType size, const CornerOf& cornerOf)
  {
    this->Polygon->Points->SetNumberOfPoints(size);
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->Polygon->Points->SetPoint(i, skd::Vector3(cornerOf(i)).X);
    }
  }

  vtkIdList* CutPolygon(vtkIdType size);
  void AddFan(vtkIdType size, vtkIdType first);
  vtkIdType GetFirstOfQuad() const;
  bool ClipEars(vtkIdType size);

  vtkNew<vtkIdList> Triangles;
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkPoints> Unused;
};

/// A triangle of a surface: its points' ids.
using SkdTriangleIds = std::array<vtkIdType, 3>;

/// The triangles of a surface that has no other cells, and its points.
std::vector<SkdTriangleIds> SkdSurfaceTriangles(vtkPolyData* surface);
std::vector<skd::Vector3> SkdSurfacePoints(vtkPolyData* surface);
}

#endif
