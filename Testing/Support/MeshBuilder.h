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

inline vtkSmartPointer<vtkPoints> MakePoints(
  const std::vector<Point>& points, int dataType = VTK_DOUBLE)
{
  auto made = vtkSmartPointer<vtkPoints>::New();
  made->SetDataType(dataType);
  made->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    made->SetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  return made;
}

/// All cells as an unstructured grid.
inline GridPointer MakeGrid(const Mesh& mesh, int pointType = VTK_DOUBLE)
{
  auto grid = GridPointer::New();
  grid->SetPoints(MakePoints(mesh.Points, pointType));
  grid->Allocate(static_cast<vtkIdType>(mesh.Cells.size()) + 1);
  vtkNew<vtkIdList> ids;
  for (const CellSpec& cell : mesh.Cells)
  {
    ids->Reset();
    for (vtkIdType id : cell.Points)
    {
      ids->InsertNextId(id);
    }
    grid->InsertNextCell(cell.Type, ids);
  }
  return grid;
}

/// All cells as polydata, in the order that polydata numbers them: vertices, lines, polygons,
/// strips.
inline PolyDataPointer MakePolyData(
  const Mesh& mesh, int pointType = VTK_DOUBLE, bool ids32 = false)
{
  vtkNew<vtkCellArray> arrays[4];
  for (auto& array : arrays)
  {
    ids32 ? array->Use32BitStorage() : array->Use64BitStorage();
  }
  for (const CellSpec& cell : mesh.Cells)
  {
    const int kind = cell.Type <= VTK_POLY_VERTEX ? 0
      : cell.Type <= VTK_POLY_LINE                ? 1
      : cell.Type == VTK_TRIANGLE_STRIP           ? 3
                                                  : 2;
    arrays[kind]->InsertNextCell(static_cast<vtkIdType>(cell.Points.size()), cell.Points.data());
  }
  auto made = PolyDataPointer::New();
  made->SetPoints(MakePoints(mesh.Points, pointType));
  made->SetVerts(arrays[0]);
  made->SetLines(arrays[1]);
  made->SetPolys(arrays[2]);
  made->SetStrips(arrays[3]);
  return made;
}

/// The same mesh without a point used twice, as STL files store it.
inline Mesh Soup(const Mesh& mesh)
{
  Mesh soup;
  for (const CellSpec& cell : mesh.Cells)
  {
    Ids ids;
    for (vtkIdType id : cell.Points)
    {
      ids.push_back(soup.Add(mesh.Points[id]));
    }
    soup.Add(cell.Type, ids);
  }
  return soup;
}

/// The same mesh with each polygon cut into a fan of triangles.
inline Mesh Triangulated(const Mesh& mesh)
{
  Mesh cut;
  cut.Points = mesh.Points;
  for (const CellSpec& cell : mesh.Cells)
  {
    for (std::size_t i = 1; i + 1 < cell.Points.size(); ++i)
    {
      cut.Add(VTK_TRIANGLE, { cell.Points[0], cell.Points[i], cell.Points[i + 1] });
    }
  }
  return cut;
}

/// The same mesh with points of equal coordinates made one.
inline Mesh Welded(const Mesh& mesh)
{
  Mesh welded;
  std::map<Point, vtkIdType> known;
  Ids where;
  for (const Point& p : mesh.Points)
  {
    const auto found = known.find(p);
    where.push_back(found != known.end() ? found->second : (known[p] = welded.Add(p)));
  }
  for (const CellSpec& cell : mesh.Cells)
  {
    Ids ids;
    for (vtkIdType id : cell.Points)
    {
      ids.push_back(where[id]);
    }
    welded.Add(cell.Type, ids);
  }
  return welded;
}

/// The same mesh times a factor, then moved.
inline Mesh Placed(Mesh mesh, double factor, const Point& offset)
{
  return mesh.Map([&](const Point& p) { return factor * p + offset; });
}

/// Marks cells of a data set as ghosts of a kind (vtkDataSetAttributes::CellGhostTypes).
inline void MarkGhosts(vtkDataSet* data, const Ids& cells, unsigned char kind)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(data->GetNumberOfCells());
  ghosts->FillValue(0);
  for (vtkIdType cell : cells)
  {
    ghosts->SetValue(cell, kind);
  }
  data->GetCellData()->AddArray(ghosts);
}

}

#endif
