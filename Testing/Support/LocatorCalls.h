// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LocatorCalls.h
 * @brief the locator's methods with their results as values
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

LocatorPointer MakeLocator(vtkDataSet* data);

Ids ToVector(vtkIdList* list);

/// For queries that promise a set, in the order of the tree.
Ids Sorted(Ids ids);

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

Closest FindClosest(vtkSkdTreeCellLocator* locator, const Point& x);

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

LineHit FindFirstHit(
  vtkSkdTreeCellLocator* locator, const Point& p1, const Point& p2, double tol = 0.0);

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

std::vector<Point> ToVector(vtkPoints* points);

/// All hits of cells, or of their bounds where `cell` is nullptr.
LineHits FindAllHits(vtkSkdTreeCellLocator* locator, const Point& p1, const Point& p2, double tol,
  vtkGenericCell* cell);

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

Crossings FindCrossings(vtkSkdTreeCellLocator* locator, const Point& p1, const Point& p2);

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
Found FindCell(vtkSkdTreeCellLocator* locator, Point x, double tol2 = 0.0);

Ids FindWithinBounds(vtkSkdTreeCellLocator* locator, Bounds box);

Ids FindAlongLine(
  vtkSkdTreeCellLocator* locator, const Point& p1, const Point& p2, double tol = 0.0);

Ids FindAlongPlane(
  vtkSkdTreeCellLocator* locator, const Point& o, const Point& n, double tol = 0.0);

struct Ranked
{
  vtkIdType Number = -2;
  Ids Cells;
  std::vector<double> Distances;
};

std::vector<double> ToVector(vtkDoubleArray* array);

Ranked FindClosestCells(vtkSkdTreeCellLocator* locator, const Point& x, int k);

Ranked FindWithinRadius(vtkSkdTreeCellLocator* locator, const Point& x, double radius);

}

#endif
