// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/LocatorCalls.h"

namespace skdtest
{

LocatorPointer MakeLocator(vtkDataSet* data)
{
  auto locator = LocatorPointer::New();
  locator->SetDataSet(data);
  locator->BuildLocator();
  return locator;
}

Ids ToVector(vtkIdList* list)
{
  return Ids(list->GetPointer(0), list->GetPointer(0) + list->GetNumberOfIds());
}

Ids Sorted(Ids ids)
{
  std::sort(ids.begin(), ids.end());
  return ids;
}

Closest FindClosest(vtkSkdTreeCellLocator* locator, const Point& x)
{
  Closest c;
  locator->FindClosestPoint(x.data(), c.X.data(), c.Cell, c.SubId, c.Dist2);
  return c;
}

LineHit FindFirstHit(vtkSkdTreeCellLocator* locator, const Point& p1, const Point& p2, double tol)
{
  LineHit h;
  h.Found = locator->IntersectWithLine(
    p1.data(), p2.data(), tol, h.T, h.X.data(), h.Pcoords.data(), h.SubId, h.Cell);
  return h;
}

std::vector<Point> ToVector(vtkPoints* points)
{
  std::vector<Point> made(points->GetNumberOfPoints());
  for (std::size_t i = 0; i < made.size(); ++i)
  {
    points->GetPoint(static_cast<vtkIdType>(i), made[i].data());
  }
  return made;
}

LineHits FindAllHits(vtkSkdTreeCellLocator* locator, const Point& p1, const Point& p2, double tol,
  vtkGenericCell* cell)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdList> ids;
  LineHits h;
  h.Found = locator->IntersectWithLine(p1.data(), p2.data(), tol, points, ids, cell);
  h.Points = ToVector(points);
  h.Cells = ToVector(ids);
  return h;
}

Crossings FindCrossings(vtkSkdTreeCellLocator* locator, const Point& p1, const Point& p2)
{
  vtkNew<vtkDoubleArray> parameters;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdTypeArray> kinds;
  Crossings c;
  c.Number = locator->FindCrossings(p1.data(), p2.data(), parameters, points, cells, kinds);
  c.Points = ToVector(points);
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    cells->GetCellAtId(i, ids);
    c.Cells.push_back(ToVector(ids));
  }
  for (vtkIdType i = 0; i < kinds->GetNumberOfTuples(); ++i)
  {
    c.Kinds.push_back(kinds->GetValue(i));
  }
  for (vtkIdType i = 0; i < parameters->GetNumberOfTuples(); ++i)
  {
    c.Parameters.push_back(parameters->GetValue(i));
  }
  return c;
}

Found FindCell(vtkSkdTreeCellLocator* locator, Point x, double tol2)
{
  vtkNew<vtkGenericCell> cell;
  Found f;
  f.Weights.resize(locator->GetDataSet()->GetMaxCellSize() + 1);
  f.Cell = locator->FindCell(x.data(), tol2, cell, f.SubId, f.Pcoords.data(), f.Weights.data());
  f.Weights.resize(f.Cell < 0 ? 0 : cell->GetNumberOfPoints());
  return f;
}

Ids FindWithinBounds(vtkSkdTreeCellLocator* locator, Bounds box)
{
  vtkNew<vtkIdList> ids;
  locator->FindCellsWithinBounds(box.data(), ids);
  return Sorted(ToVector(ids));
}

Ids FindAlongLine(vtkSkdTreeCellLocator* locator, const Point& p1, const Point& p2, double tol)
{
  vtkNew<vtkIdList> ids;
  locator->FindCellsAlongLine(p1.data(), p2.data(), tol, ids);
  return ToVector(ids);
}

Ids FindAlongPlane(vtkSkdTreeCellLocator* locator, const Point& o, const Point& n, double tol)
{
  vtkNew<vtkIdList> ids;
  locator->FindCellsAlongPlane(o.data(), n.data(), tol, ids);
  return Sorted(ToVector(ids));
}

std::vector<double> ToVector(vtkDoubleArray* array)
{
  return std::vector<double>(
    array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues());
}

namespace
{

/// `find(ids, distances)` returns their number.
template <class Find>
Ranked FindRanked(const Find& find)
{
  vtkNew<vtkIdList> ids;
  vtkNew<vtkDoubleArray> distances;
  Ranked r;
  r.Number = find(ids, distances);
  r.Cells = ToVector(ids);
  r.Distances = ToVector(distances);
  return r;
}

}

Ranked FindClosestCells(vtkSkdTreeCellLocator* locator, const Point& x, int k)
{
  return FindRanked([&](vtkIdList* ids, vtkDoubleArray* distances)
    { return locator->FindClosestCells(x.data(), k, ids, distances); });
}

Ranked FindWithinRadius(vtkSkdTreeCellLocator* locator, const Point& x, double radius)
{
  return FindRanked([&](vtkIdList* ids, vtkDoubleArray* distances)
    { return locator->FindCellsWithinRadius(x.data(), radius, ids, distances); });
}

}
