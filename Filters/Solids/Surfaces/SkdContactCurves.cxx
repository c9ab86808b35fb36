// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// What pairs of triangles have in common, as geometry: curves, lone points and overlaps.
#include "Solids/Surfaces/SkdContacts.h"

#include "Cells/Read/SkdForEach.h"
#include "Pipeline/SkdMakeArray.h"
#include "Solids/Surfaces/SkdSpreadCurves.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace skdtree
{
namespace
{
/// The points of a data set that are those of contacts, each taken over when it is first used.
/// `positionOf` gives that of each of `number` points.
template <class PositionOf>
class TakenPoints
{
public:
  TakenPoints(std::size_t number, const PositionOf& positionOf)
    : Positions(positionOf)
    , Ids(number, -1)
  {
    this->Points->SetDataTypeToDouble();
  }

  /// Its only position.
  vtkIdType IdOf(std::uint32_t point)
  {
    vtkIdType& id = this->Ids[point];
    id = id < 0 ? this->Add(point) : id;
    return id;
  }

  /// A further position for it.
  vtkIdType Add(std::uint32_t point)
  {
    return this->Points->InsertNextPoint(this->Positions(point).X);
  }

  vtkPoints* Get() { return this->Points; }

private:
  PositionOf Positions;
  std::vector<vtkIdType> Ids;
  vtkNew<vtkPoints> Points;
};

/// What becomes of contacts as cells: the lone points first, then curves that are added.
template <class PositionOf>
struct CurveCells
{
  TakenPoints<PositionOf> Points;
  std::vector<std::size_t> Origins; ///< pairs, of each cell or point
  vtkNew<vtkCellArray> Vertices;
  vtkNew<vtkCellArray> Lines;

  CurveCells(std::size_t number, const PositionOf& positionOf, const std::vector<SkdEndPair>& lone)
    : Points(number, positionOf)
  {
    for (const SkdEndPair& point : lone)
    {
      this->Vertices->InsertNextCell({ this->Points.IdOf(point.A) });
      this->Origins.push_back(point.Origin);
    }
  }

  void Store(vtkPolyData* curves)
  {
    curves->SetPoints(this->Points.Get());
    curves->SetVerts(this->Vertices);
    curves->SetLines(this->Lines);
  }
};
}

//------------------------------------------------------------------------------
SkdContactKey SkdContacts::KeyOf(const SkdContactPoints::Location& location) const
{
  SkdContactKey key;
  key.Add(static_cast<std::uint64_t>(location.Number));
  const double unscaled = 1.0 / this->Placement.Scale;
  for (int i = 0; i < location.Number; ++i)
  {
    key.Add(unscaled * location.Corners[static_cast<std::size_t>(i)]);
  }
  if (location.Number == 5) // triangles with the same corners are several
  {
    const auto [cell, block] = location.IsTriangleOfSecond
      ? CellOf(this->Second, this->SecondIds, this->Placement.GetSecond(), location.Triangle)
      : CellOf(this->First, this->FirstIds, this->Placement.First, location.Triangle);
    key.Add(static_cast<std::uint64_t>(cell));
    key.Add(static_cast<std::uint64_t>(block));
  }
  return key;
}

bool SkdContacts::IsBefore(std::uint32_t a, std::uint32_t b) const
{
  const skd::Vector3& x = this->Points.GetPosition(a);
  const skd::Vector3& y = this->Points.GetPosition(b);
  if (x == y)
  {
    return a != b && this->KeyOf(this->Points.Locate(a)) < this->KeyOf(this->Points.Locate(b));
  }
  return x < y;
}

SkdCurves SkdContacts::JoinAlone(SkdCurveParts parts) const
{
  parts.LeaveOutInside();
  SkdCurves curves;
  curves.Segments = std::move(parts.Segments);
  curves.Lone = std::move(parts.Lone);
  curves.Lines = SkdJoinSegments(curves.Segments,
    { this->Points.GetNumberOfPoints(),
      [this](std::uint32_t a, std::uint32_t b) { return this->IsBefore(a, b); }, {} });
  curves.Number = static_cast<vtkIdType>(curves.Lines.size());
  return curves;
}

SkdCurves SkdContacts::JoinSpread(SkdCurveParts parts, bool isJoined, SkdTransport& transport) const
{
  const std::uint32_t number = this->Points.GetNumberOfPoints();
  SkdSpreadPoints points{ this->Points.GetPositions(), std::vector<SkdContactKey>(number),
    std::vector<skd::Box3>(number) };
  const double unscaled = 1.0 / this->Placement.Scale;
  SkdForEach(number,
    [&](std::uint32_t point)
    {
      const SkdContactPoints::Location location = this->Points.Locate(point);
      points.Keys[point] = this->KeyOf(location);
      const bool isInside = location.Number == 5 && !location.IsTriangleOfSecond;
      const std::size_t corners = isInside ? 0 : (location.Number == 1 ? 1 : 2);
      for (std::size_t i = 0; i < corners; ++i)
      {
        points.Around[point].Add(unscaled * location.Corners[i]);
      }
    });
  std::vector<skd::Box3> triangles;
  for (const std::uint32_t triangle : SkdTrianglesInPairs(this->Pairs, &SkdTrianglePair::First))
  {
    triangles.emplace_back();
    for (const skd::Vector3& corner : this->Placement.First.GetCornerPoints(triangle))
    {
      triangles.back().Add(unscaled * corner);
    }
  }
  return SkdSpreadCurves(transport, points, std::move(triangles))
    .Find(
      std::move(parts), this->Pairs.size(),
      [this](std::size_t pair) { return this->LabelOf(pair); }, isJoined);
}

//------------------------------------------------------------------------------
vtkIdType SkdContacts::FillCurves(vtkPolyData* output, bool isJoined, SkdTransport* transport) const
{
  SkdCurveParts parts = this->FindParts();
  const SkdCurves curves = transport ? this->JoinSpread(std::move(parts), isJoined, *transport)
                                     : this->JoinAlone(std::move(parts));
  if (isJoined)
  {
    this->FillJoined(output, curves);
  }
  else
  {
    this->FillSeparate(output, curves);
  }
  return curves.Number;
}

const skd::Vector3& SkdContacts::PositionOf(std::uint32_t point, const SkdCurves& curves) const
{
  const std::uint32_t own = this->Points.GetNumberOfPoints();
  return point < own ? this->Points.GetPosition(point) : curves.ReceivedPoints[point - own];
}

//------------------------------------------------------------------------------
void SkdContacts::FillSeparate(vtkPolyData* output, const SkdCurves& curves) const
{
  CurveCells cells(
    this->Points.GetNumberOfPoints(),
    [this](std::uint32_t point) { return this->Points.GetPosition(point); }, curves.Lone);
  for (const SkdEndPair& segment : curves.Segments)
  {
    const bool isBefore = this->IsBefore(segment.A, segment.B);
    const vtkIdType first = cells.Points.IdOf(isBefore ? segment.A : segment.B);
    cells.Lines->InsertNextCell({ first, cells.Points.IdOf(isBefore ? segment.B : segment.A) });
    cells.Origins.push_back(segment.Origin);
  }
  cells.Store(output);
  this->AddLabels(cells.Origins, output->GetCellData());
}

//------------------------------------------------------------------------------
void SkdContacts::FillJoined(vtkPolyData* output, const SkdCurves& curves) const
{
  CurveCells cells(
    this->Points.GetNumberOfPoints(),
    [&](std::uint32_t point) { return this->PositionOf(point, curves); }, curves.Lone);
  std::vector<vtkIdType> ids;
  for (const SkdPolyline& line : curves.Lines)
  {
    ids.clear();
    for (std::size_t i = 0; i < line.Points.size(); ++i)
    {
      const std::size_t segment = line.Segments[std::min(i, line.Segments.size() - 1)];
      cells.Origins.push_back(curves.Segments[segment].Origin);
      ids.push_back(cells.Points.Add(line.Points[i]));
    }
    if (line.IsClosed)
    {
      ids.push_back(ids.front());
    }
    cells.Lines->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  cells.Store(output);
  this->AddLabels(cells.Origins, output->GetPointData(), curves.ReceivedLabels);
  this->AddMeasures(output, curves);
}

//------------------------------------------------------------------------------
void SkdContacts::AddMeasures(vtkPolyData* output, const SkdCurves& curves) const
{
  const vtkIdType n = output->GetNumberOfCells();
  auto closed = SkdMakeArray<vtkUnsignedCharArray>(ClosedName, 1, n);
  auto lengths = SkdMakeArray<vtkDoubleArray>(LengthName, 1, n);
  closed->Fill(0);
  lengths->Fill(0.0);
  vtkIdType cell = output->GetNumberOfVerts();
  for (const SkdPolyline& line : curves.Lines)
  {
    double length = 0.0;
    for (const std::size_t i : line.Segments)
    {
      const SkdEndPair& segment = curves.Segments[i];
      length += Norm(this->PositionOf(segment.A, curves) - this->PositionOf(segment.B, curves));
    }
    closed->SetValue(cell, line.IsClosed);
    lengths->SetValue(cell, length);
    ++cell;
  }
  output->GetCellData()->AddArray(closed);
  output->GetCellData()->AddArray(lengths);
}

//------------------------------------------------------------------------------
vtkIdType SkdContacts::FillOverlaps(vtkPolyData* overlaps) const
{
  TakenPoints points(this->Points.GetNumberOfPoints(),
    [this](std::uint32_t point) { return this->Points.GetPosition(point); });
  std::vector<std::size_t> origins;
  vtkNew<vtkCellArray> cells;
  for (std::size_t pair = 0; pair < this->Pairs.size(); ++pair)
  {
    const int count = this->Pairs[pair].Contact.Count;
    if (SkdKindOf(this->Pairs[pair].Contact) == SkdContactKind::Area)
    {
      vtkIdType corners[6];
      for (int i = 0; i < count; ++i)
      {
        corners[i] = points.IdOf(this->Points.GetPoint(pair, i));
      }
      cells->InsertNextCell(count, corners);
      origins.push_back(pair);
    }
  }
  overlaps->SetPoints(points.Get());
  overlaps->SetPolys(cells);
  this->AddLabels(origins, overlaps->GetCellData());
  return cells->GetNumberOfCells();
}
}
