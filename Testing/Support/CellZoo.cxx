// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/CellZoo.h"

namespace skdtest
{

bool IsHigherOrder(int type)
{
  return type >= VTK_LAGRANGE_CURVE && type < VTK_NUMBER_OF_CELL_TYPES;
}

int HigherOrderSize(int type, int order)
{
  const int n = order + 1;
  switch ((type - VTK_LAGRANGE_CURVE) % 7)
  {
    case 0: // curve
      return n;
    case 1: // triangle
      return n * (n + 1) / 2;
    case 2: // quadrilateral
      return n * n;
    case 3: // tetrahedron
      return n * (n + 1) * (n + 2) / 6;
    case 4: // hexahedron
      return n * n * n;
    case 5: // wedge
      return n * n * (n + 1) / 2;
    default: // pyramids of higher order do not exist in VTK
      return 0;
  }
}

void SetUniformOrder(vtkCell* cell, vtkIdType points)
{
  if (auto* quad = vtkHigherOrderQuadrilateral::SafeDownCast(cell))
  {
    quad->SetUniformOrderFromNumPoints(points);
  }
  if (auto* hexahedron = vtkHigherOrderHexahedron::SafeDownCast(cell))
  {
    hexahedron->SetUniformOrderFromNumPoints(points);
  }
  if (auto* wedge = vtkHigherOrderWedge::SafeDownCast(cell))
  {
    wedge->SetUniformOrderFromNumPoints(points);
  }
}

std::vector<Point> ReferencePoints(int type, int order)
{
  vtkSmartPointer<vtkCell> cell;
  cell.TakeReference(vtkGenericCell::InstantiateCell(type));
  std::vector<Point> points;
  if (!cell)
  {
    return points;
  }
  if (IsHigherOrder(type))
  {
    cell->Points->SetNumberOfPoints(HigherOrderSize(type, order));
    cell->PointIds->SetNumberOfIds(HigherOrderSize(type, order));
    SetUniformOrder(cell, HigherOrderSize(type, order));
    cell->Initialize();
  }
  const double* where = cell->GetParametricCoords();
  for (int i = 0; where && i < cell->GetNumberOfPoints(); ++i)
  {
    points.push_back({ where[3 * i], where[3 * i + 1], where[3 * i + 2] });
  }
  return points;
}

Mesh FreeFormCell(int type)
{
  Mesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
    { 1, 1, 1 }, { 0, 1, 1 } };
  switch (type)
  {
    case VTK_EMPTY_CELL:
      mesh.Add(type, {});
      break;
    case VTK_POLY_VERTEX:
    case VTK_CONVEX_POINT_SET:
      mesh.Add(type, { 0, 1, 2, 3, 4, 5, 6, 7 });
      break;
    case VTK_POLY_LINE:
      mesh.Add(type, { 0, 1, 2, 6, 7 });
      break;
    case VTK_POLYGON:
      mesh.Add(type, { 0, 1, 2, 3 });
      break;
    case VTK_TRIANGLE_STRIP:
      mesh.Add(type, { 0, 1, 3, 2, 7, 6 });
      break;
    case VTK_POLYHEDRON:
      mesh.Add(type, PolyhedronOf({ 0, 1, 2, 3, 4, 5, 6, 7 }));
      break;
    case VTK_QUADRATIC_POLYGON:
      mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0.5, 0, 0 },
        { 1, 0.5, 0 }, { 0.5, 1, 0 }, { 0, 0.5, 0 } };
      mesh.Add(type, { 0, 1, 2, 3, 4, 5, 6, 7 });
      break;
    default:
      mesh.Points.clear();
      break;
  }
  return mesh;
}

Mesh ReferenceCell(int type, int order)
{
  Mesh mesh = FreeFormCell(type);
  if (!mesh.Cells.empty())
  {
    return mesh;
  }
  mesh.Points = ReferencePoints(type, order);
  Ids ids;
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    ids.push_back(static_cast<vtkIdType>(i));
  }
  if (!ids.empty())
  {
    mesh.Add(type, ids);
  }
  return mesh;
}

Mesh Block(const Mesh& one, const std::function<Point(const Point&)>& where)
{
  Mesh block;
  if (one.Cells.empty())
  {
    return block;
  }
  for (int copy = 0; copy < 8; ++copy)
  {
    const Point shift = { 1.5 * (copy & 1), 1.5 * (copy >> 1 & 1), 1.5 * (copy >> 2) };
    const vtkIdType first = static_cast<vtkIdType>(block.Points.size());
    for (const Point& p : one.Points)
    {
      block.Add(where(p + shift));
    }
    CellSpec cell = one.Cells.front();
    if (cell.Type == VTK_POLYHEDRON)
    {
      cell.Points = PolyhedronOf({ 0, 1, 2, 3, 4, 5, 6, 7 });
      std::size_t at = 1;
      for (vtkIdType face = 0; face < cell.Points[0]; ++face)
      {
        const vtkIdType size = cell.Points[at++];
        for (vtkIdType i = 0; i < size; ++i)
        {
          cell.Points[at++] += first;
        }
      }
    }
    else
    {
      for (vtkIdType& id : cell.Points)
      {
        id += first;
      }
    }
    block.Cells.push_back(cell);
  }
  return block;
}

Point Unmoved(const Point& p)
{
  return p;
}

std::vector<int> AllCellTypes()
{
  std::vector<int> types;
  for (int type = 0; type < VTK_NUMBER_OF_CELL_TYPES; ++type)
  {
    if (!ReferenceCell(type, 2).Cells.empty())
    {
      types.push_back(type);
    }
  }
  return types;
}

int DimensionOf(int type)
{
  vtkSmartPointer<vtkCell> cell;
  cell.TakeReference(vtkGenericCell::InstantiateCell(type));
  return cell ? cell->GetCellDimension() : 0;
}

std::string NameOfType(int type)
{
  vtkSmartPointer<vtkCell> cell;
  cell.TakeReference(vtkGenericCell::InstantiateCell(type));
  const std::string name = cell ? cell->GetClassName() : "Unknown" + std::to_string(type);
  return name.compare(0, 3, "vtk") == 0 ? name.substr(3) : name;
}

}
