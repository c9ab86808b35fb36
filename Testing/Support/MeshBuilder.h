// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshBuilder.h
 * @brief from lists of points and cells to VTK's data sets
 */
#ifndef skdtest_MeshBuilder_h
#define skdtest_MeshBuilder_h

#include "Support/Point.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <functional>
#include <map>
#include <vector>

namespace skdtest
{

using Ids = std::vector<vtkIdType>;
using PolyDataPointer = vtkSmartPointer<vtkPolyData>;
using GridPointer = vtkSmartPointer<vtkUnstructuredGrid>;
using DataSetPointer = vtkSmartPointer<vtkDataSet>;

struct CellSpec
{
  int Type;
  Ids Points; // of a polyhedron the face stream
};

/// Points and cells, before they become a data set.
struct Mesh
{
  std::vector<Point> Points;
  std::vector<CellSpec> Cells;

  vtkIdType Add(const Point& p)
  {
    this->Points.push_back(p);
    return static_cast<vtkIdType>(this->Points.size()) - 1;
  }

  void Add(int type, Ids ids) { this->Cells.push_back({ type, std::move(ids) }); }

  /// Moves every point.
  Mesh& Map(const std::function<Point(const Point&)>& where)
  {
    for (Point& p : this->Points)
    {
      p = where(p);
    }
    return *this;
  }
};

vtkSmartPointer<vtkPoints> MakePoints(const std::vector<Point>& points, int dataType = VTK_DOUBLE);

/// All cells as an unstructured grid.
GridPointer MakeGrid(const Mesh& mesh, int pointType = VTK_DOUBLE);

/// All cells as polydata, in the order that polydata numbers them: vertices, lines, polygons,
/// strips.
PolyDataPointer MakePolyData(const Mesh& mesh, int pointType = VTK_DOUBLE, bool ids32 = false);

/// The same mesh without a point used twice, as STL files store it.
Mesh Soup(const Mesh& mesh);

/// The same mesh with each polygon cut into a fan of triangles.
Mesh Triangulated(const Mesh& mesh);

/// The same mesh with points of equal coordinates made one.
Mesh Welded(const Mesh& mesh);

/// The same mesh times a factor, then moved.
Mesh Transformed(Mesh mesh, double factor, const Point& offset);

/// Marks cells of a data set as ghosts of a kind (vtkDataSetAttributes::CellGhostTypes).
void MarkGhosts(vtkDataSet* data, const Ids& cells, unsigned char kind);

}

#endif
