// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/MeshBuilder.h"

namespace skdtest
{

vtkSmartPointer<vtkPoints> MakePoints(const std::vector<Point>& points, int dataType)
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

GridPointer MakeGrid(const Mesh& mesh, int pointType)
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

PolyDataPointer MakePolyData(const Mesh& mesh, int pointType, bool ids32)
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

Mesh Soup(const Mesh& mesh)
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

Mesh Triangulated(const Mesh& mesh)
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

Mesh Welded(const Mesh& mesh)
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

Mesh Transformed(Mesh mesh, double factor, const Point& offset)
{
  return mesh.Map([&](const Point& p) { return factor * p + offset; });
}

void MarkGhosts(vtkDataSet* data, const Ids& cells, unsigned char kind)
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
