// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LocatorCalls.h
 * @brief the locator's methods with their answers as values
 */
#ifndef skdtest_LocatorCalls_h
#define skdtest_LocatorCalls_h

#include "Support/MeshBuilder.h"

#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkIdTypeArray.h"
#include "vtkSkdTreeCellLocator.h"

namespace skdtest
{

using LocatorPointer = vtkSmartPointer<vtkSkdTreeCellLocator>;

inline LocatorPointer MakeLocator(vtkDataSet* data)
{
  auto locator = LocatorPointer::New();
  locator->SetDataSet(data);
  locator->BuildLocator();
  return locator;
}

inline Ids ToVector(vtkIdList* list)
{
  return Ids(list->GetPointer(0), list->GetPointer(0) + list->GetNumberOfIds());
}

/// For queries that promise a set, in the order of the tree.
inline Ids Sorted(Ids ids)
{
  std::sort(ids.begin(), ids.end());
  return ids;
}

struct Closest
{
  Point X = { 0, 0, 0 };
  vtkIdType Cell = -2;
  int SubId = -2;
  double Dist2 = -2.0;
  bool operator==(const Closest& o) const
  {
    return this->X == o.X && this->Cell == o.Cell && this->SubId == o.SubId &&
      this->Dist2 == o.Dist2;
  }
};

inline Closest FindClosest(vtkSkdTreeCellLocator* locator, const Point& x)
{
  Closest c;
  locator->FindClosestPoint(x.data(), c.X.data(), c.Cell, c.SubId, c.Dist2);
  return c;
}

struct LineHit
{
  int Found = -2;
  double T = -2.0;
  Point X = { 0, 0, 0 };
  Point Pcoords = { 0, 0, 0 };
  int SubId = -2;
  vtkIdType Cell = -2;
  bool operator==(const LineHit& o) const
  {
    return this->Found == o.Found && this->Cell == o.Cell &&
      (!this->Found ||
        (this->T == o.T && this->X == o.X && this->Pcoords == o.Pcoords && this->SubId == o.SubId));
  }
};

inline LineHit FindFirstHit(
  vtkSkdTreeCellLocator* locator, const Point& p1, const Point& p2, double tol = 0.0)
{
  LineHit h;
  h.Found = locator->IntersectWithLine(
    p1.data(), p2.data(), tol, h.T, h.X.data(), h.Pcoords.data(), h.SubId, h.Cell);
  return h;
}

struct LineHits
{
  int Found = -2;
  std::vector<Point> Points;
  Ids Cells;
  bool operator==(const LineHits& o) const
  {
    return this->Found == o.Found && this->Points == o.Points && this->Cells == o.Cells;
  }
};

inline std::vector<Point> ToVector(vtkPoints* points)
{
  std::vector<Point> made(points->GetNumberOfPoints());
  for (std::size_t i = 0; i < made.size(); ++i)
  {
    points->GetPoint(static_cast<vtkIdType>(i), made[i].data());
  }
  return made;
}

/// All hits of cells, or of their bounds where `cell` is nullptr.
inline LineHits FindAllHits(vtkSkdTreeCellLocator* locator, const Point& p1, const Point& p2,
  double tol, vtkGenericCell* cell)
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

struct Crossings
{
  vtkIdType Number = -2;
  std::vector<double> Parameters;
  std::vector<Point> Points;
  std::vector<Ids> Cells;
  Ids Kinds;
  int NumberPassing() const
  {
    return static_cast<int>(std::count(this->Kinds.begin(), this->Kinds.end(), 1));
  }
};

inline Crossings FindCrossings(vtkSkdTreeCellLocator* locator, const Point& p1, const Point& p2)
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

struct Found
{
  vtkIdType Cell = -2;
  int SubId = -2;
  Point Pcoords = { 0, 0, 0 };
  std::vector<double> Weights;
  bool operator==(const Found& o) const
  {
    return this->Cell == o.Cell &&
      (this->Cell < 0 || (this->Pcoords == o.Pcoords && this->Weights == o.Weights));
  }
};

/// FindCell; `Weights` as many as the cell has points.
inline Found FindCell(vtkSkdTreeCellLocator* locator, Point x, double tol2 = 0.0)
{
  vtkNew<vtkGenericCell> cell;
  Found f;
  f.Weights.resize(locator->GetDataSet()->GetMaxCellSize() + 1);
  f.Cell = locator->FindCell(x.data(), tol2, cell, f.SubId, f.Pcoords.data(), f.Weights.data());
  f.Weights.resize(f.Cell < 0 ? 0 : cell->GetNumberOfPoints());
  return f;
}

inline Ids FindWithinBounds(vtkSkdTreeCellLocator* locator, Bounds box)
{
  vtkNew<vtkIdList> ids;
  locator->FindCellsWithinBounds(box.data(), ids);
  return Sorted(ToVector(ids));
}

inline Ids FindAlongLine(
  vtkSkdTreeCellLocator* locator, const Point& p1, const Point& p2, double tol = 0.0)
{
  vtkNew<vtkIdList> ids;
  locator->FindCellsAlongLine(p1.data(), p2.data(), tol, ids);
  return ToVector(ids);
}

inline Ids FindAlongPlane(
  vtkSkdTreeCellLocator* locator, const Point& o, const Point& n, double tol = 0.0)
{
  vtkNew<vtkIdList> ids;
  locator->FindCellsAlongPlane(o.data(), n.data(), tol, ids);
  return Sorted(ToVector(ids));
}

struct Ranked
{
  vtkIdType Number = -2;
  Ids Cells;
  std::vector<double> Distances;
};

inline std::vector<double> ToVector(vtkDoubleArray* array)
{
  return std::vector<double>(
    array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues());
}

inline Ranked FindClosestCells(vtkSkdTreeCellLocator* locator, const Point& x, int k)
{
  vtkNew<vtkIdList> ids;
  vtkNew<vtkDoubleArray> distances;
  Ranked r;
  r.Number = locator->FindClosestCells(x.data(), k, ids, distances);
  r.Cells = ToVector(ids);
  r.Distances = ToVector(distances);
  return r;
}

inline Ranked FindWithinRadius(vtkSkdTreeCellLocator* locator, const Point& x, double radius)
{
  vtkNew<vtkIdList> ids;
  vtkNew<vtkDoubleArray> distances;
  Ranked r;
  r.Number = locator->FindCellsWithinRadius(x.data(), radius, ids, distances);
  r.Cells = ToVector(ids);
  r.Distances = ToVector(distances);
  return r;
}

}

#endif
