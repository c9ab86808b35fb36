// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Referee.h"

#include "Structure.h"

#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

namespace skdbench
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

using skdtest::Distance;
using skdtest::operator-;

/// How far the points of a flat cell lie from the plane of its first three.
double WarpOf(vtkCell* face)
{
  vtkPoints* points = face->GetPoints();
  if (points->GetNumberOfPoints() < 4)
  {
    return 0.0;
  }
  Point a[4];
  for (int i = 0; i < 3; ++i)
  {
    points->GetPoint(i, a[i].data());
  }
  const Point normal = skdtest::Cross(a[1] - a[0], a[2] - a[0]);
  const double length = skdtest::Length(normal);
  double warp = 0.0;
  for (vtkIdType i = 3; i < points->GetNumberOfPoints() && length > 0.0; ++i)
  {
    points->GetPoint(i, a[3].data());
    warp = std::max(warp, std::abs(skdtest::Dot(normal, a[3] - a[0])) / length);
  }
  return warp;
}

bool Holds(const std::vector<vtkIdType>& sorted, vtkIdType id)
{
  return std::binary_search(sorted.begin(), sorted.end(), id);
}

}

Record::Record(const Answer& answer, double precision)
  : Cell(answer.Cell)
  , Value(answer.Value)
  , Where(answer.Where)
  , Cells(answer.Cells, answer.Cells + answer.NumberOfCells)
  , Precision(precision)
{
  std::sort(this->Cells.begin(), this->Cells.end());
  this->Cells.erase(std::unique(this->Cells.begin(), this->Cells.end()), this->Cells.end());
}

Referee::Referee(vtkDataSet* data)
  : Data(data)
  , Weights(std::max(data->GetMaxCellSize(), 8))
  , Size(data->GetLength())
  , LineTolerance(skdbench::LineTolerance(data))
{
}

std::vector<bool> Referee::Judge(
  QueryKind queryKind, const Query& query, const std::vector<Record>& records)
{
  switch (queryKind)
  {
    case QueryKind::ClosestPoint:
      return this->JudgeClosest(query, records, Infinity);
    case QueryKind::ClosestPointWithinRadius:
      return this->JudgeClosest(query, records, query.Radius);
    case QueryKind::FirstHit:
      return this->JudgeFirstHit(query, records);
    case QueryKind::FindCell:
    case QueryKind::FindCellWithHint:
      return this->JudgeFindCell(query, records);
    case QueryKind::AllHits:
    case QueryKind::CellsInBox:
      break;
  }
  return this->JudgeLists(queryKind, query, records);
}

std::vector<bool> Referee::JudgeClosest(
  const Query& query, const std::vector<Record>& records, double radius)
{
  // Far points: a distance carries the rounding of its own magnitude.
  // Warped faces: VTK splits some into triangles and iterates on others.
  const auto slack = [&](const Record& record)
  {
    return this->Slack(record) + record.Precision * Distance(query.From, record.Where) +
      this->Warp(record.Cell);
  };
  std::vector<double> distances;
  double best = Infinity;
  for (const Record& record : records)
  {
    const double distance = record.Cell < 0 ? Infinity : Distance(query.From, record.Where);
    const bool found = record.Cell >= 0 &&
      this->DistanceToCell(record.Where, record.Cell) <= slack(record) &&
      std::abs(std::sqrt(record.Value) - distance) <= slack(record);
    distances.push_back(found ? distance : record.Cell < 0 ? Infinity : std::nan(""));
    best = found ? std::min(best, distance + slack(record)) : best;
  }
  std::vector<bool> wrong;
  for (std::size_t i = 0; i < records.size(); ++i)
  {
    const bool isNearest = distances[i] <= best + slack(records[i]);
    const bool missesRightly = distances[i] == Infinity && !(best < radius - slack(records[i]));
    const bool tooFar = distances[i] != Infinity && distances[i] > radius + slack(records[i]);
    wrong.push_back(tooFar || !(isNearest || missesRightly));
  }
  return wrong;
}

std::vector<bool> Referee::JudgeFirstHit(const Query& query, const std::vector<Record>& records)
{
  const double length = Distance(query.From, query.To);
  double best = Infinity;
  double warp = 0.0;
  for (const Record& record : records)
  {
    if (record.Cell >= 0 && this->IsHit(query, record.Cell, 0.1 * this->LineTolerance))
    {
      best = std::min(best, record.Value * length + this->Slack(record));
    }
    warp = std::max(warp, this->Warp(record.Cell));
  }
  std::vector<bool> wrong;
  for (const Record& record : records)
  {
    const double slack = 100 * this->LineTolerance + 10 * warp + this->Slack(record);
    const bool misses = record.Cell < 0;
    const bool onCell =
      misses || this->DistanceToCell(record.Where, record.Cell) <= 10 * this->LineTolerance + slack;
    const double reached = misses ? Infinity : record.Value * length;
    wrong.push_back(!onCell || reached > best + slack);
  }
  return wrong;
}

std::vector<bool> Referee::JudgeFindCell(const Query& query, const std::vector<Record>& records)
{
  const bool anyInside = std::any_of(records.begin(), records.end(),
    [&](const Record& record) { return this->IsInside(query.From, record.Cell); });
  std::vector<bool> wrong;
  for (const Record& record : records)
  {
    const bool right = record.Cell < 0
      ? !anyInside
      : this->DistanceToCell(query.From, record.Cell) <= this->Slack(record);
    wrong.push_back(!right);
  }
  return wrong;
}

std::vector<bool> Referee::JudgeLists(
  QueryKind queryKind, const Query& query, const std::vector<Record>& records)
{
  std::vector<vtkIdType> all;
  for (const Record& record : records)
  {
    all.insert(all.end(), record.Cells.begin(), record.Cells.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  std::vector<bool> wrong(records.size(), false);
  for (vtkIdType cell : all)
  {
    const bool must = this->MustBeListed(queryKind, query, cell);
    const bool may = must || this->MayBeListed(queryKind, query, cell);
    for (std::size_t i = 0; i < records.size(); ++i)
    {
      const bool listed = Holds(records[i].Cells, cell);
      wrong[i] = wrong[i] || (listed && !may) || (!listed && must);
    }
  }
  return wrong;
}

bool Referee::MustBeListed(QueryKind queryKind, const Query& query, vtkIdType cell)
{
  return queryKind == QueryKind::CellsInBox ? this->IsInBox(query, cell)
                                            : this->IsHit(query, cell, 0.1 * this->LineTolerance);
}

bool Referee::MayBeListed(QueryKind queryKind, const Query& query, vtkIdType cell)
{
  return queryKind == QueryKind::CellsInBox ? false
                                            : this->IsHit(query, cell, 10 * this->LineTolerance);
}

bool Referee::Has(vtkIdType cell) const
{
  return cell >= 0 && cell < this->Data->GetNumberOfCells();
}

// A cell of its own each time: a generic cell gives its polyhedron again, and one of VTK 9.1 that
// is used again may find no nearest point.
bool Referee::LookAt(vtkIdType cell)
{
  if (!this->Has(cell))
  {
    return false;
  }
  this->Cell = vtkSmartPointer<vtkGenericCell>::New();
  this->Data->GetCell(cell, this->Cell);
  return true;
}

bool Referee::IsHit(const Query& query, vtkIdType cell, double tolerance)
{
  if (!this->LookAt(cell))
  {
    return false;
  }
  double t;
  Point x;
  Point pcoords;
  int subId;
  return this->Cell->IntersectWithLine(
           query.From.data(), query.To.data(), tolerance, t, x.data(), pcoords.data(), subId) != 0;
}

bool Referee::IsInBox(const Query& query, vtkIdType cell)
{
  if (!this->Has(cell))
  {
    return false;
  }
  Bounds bounds;
  this->Data->GetCellBounds(cell, bounds.data());
  return skdtest::Overlap(bounds, query.Box);
}

bool Referee::IsInside(const Point& x, vtkIdType cell)
{
  return this->DistanceToCell(x, cell) == 0.0;
}

double Referee::DistanceToCell(const Point& x, vtkIdType cell)
{
  if (!this->LookAt(cell))
  {
    return Infinity;
  }
  Point closest;
  Point pcoords;
  int subId;
  double dist2 = Infinity;
  const int status = this->Cell->EvaluatePosition(
    x.data(), closest.data(), subId, pcoords.data(), dist2, this->Weights.data());
  if (status < 0)
  {
    return Infinity;
  }
  // VTK's Newton may come to rest outside the cell, and its test for inside has a tolerance: the
  // cell's bounds and the signs of its shape functions know better.
  Bounds bounds;
  this->Cell->GetBounds(bounds.data());
  const double distance = std::max(std::sqrt(dist2), skdtest::Distance(bounds, x));
  return status == 1 ? std::max(distance, this->Outside()) : distance;
}

double Referee::Outside() const
{
  if (this->Cell->GetCellDimension() != 3 || !this->Cell->IsLinear())
  {
    return 0.0;
  }
  const auto end = this->Weights.begin() + this->Cell->GetNumberOfPoints();
  const double least = *std::min_element(this->Weights.begin(), end);
  return std::max(0.0, -least) * std::sqrt(this->Cell->GetLength2());
}

double Referee::Warp(vtkIdType cell)
{
  if (!this->LookAt(cell))
  {
    return 0.0;
  }
  if (this->Cell->GetCellDimension() < 3)
  {
    return WarpOf(this->Cell);
  }
  double warp = 0.0;
  for (int i = 0; i < this->Cell->GetNumberOfFaces(); ++i)
  {
    warp = std::max(warp, WarpOf(this->Cell->GetFace(i)));
  }
  return warp;
}

}
