// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// What pairs of triangles have in common, as geometry: curves, lone points and overlaps.
#include "Solids/Surfaces/SkdContacts.h"

#include "Pipeline/SkdMakeArray.h"
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
class TakenPoints
{
public:
  explicit TakenPoints(const SkdContactPoints& all)
    : All(all)
    , Ids(all.GetNumberOfPoints(), -1)
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
    return this->Points->InsertNextPoint(this->All.GetPosition(point).X);
  }

  vtkPoints* Get() { return this->Points; }

private:
  const SkdContactPoints& All;
  std::vector<vtkIdType> Ids;
  vtkNew<vtkPoints> Points;
};

/// What becomes of contacts as cells: the lone points first, then curves that are added.
struct CurveCells
{
  TakenPoints Points;
  std::vector<std::size_t> Origins; ///< pairs, of each cell or point
  vtkNew<vtkCellArray> Vertices;
  vtkNew<vtkCellArray> Lines;

  CurveCells(const SkdContactPoints& all, const std::vector<SkdEndPair>& lone)
    : Points(all)
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
vtkIdType SkdContacts::FillCurves(vtkPolyData* curves, bool isJoined) const
{
  const std::vector<SkdEndPair> segments = this->FindSegments();
  const std::vector<SkdEndPair> lone = this->FindLonePoints(segments);
  const std::vector<SkdPolyline> lines =
    SkdJoinSegments(segments, this->Points.GetNumberOfPoints());
  if (isJoined)
  {
    this->FillJoined(curves, lone, segments, lines);
  }
  else
  {
    this->FillSeparate(curves, lone, segments);
  }
  return static_cast<vtkIdType>(lines.size());
}

//------------------------------------------------------------------------------
void SkdContacts::FillSeparate(vtkPolyData* curves, const std::vector<SkdEndPair>& lone,
  const std::vector<SkdEndPair>& segments) const
{
  CurveCells cells(this->Points, lone);
  for (const SkdEndPair& segment : segments)
  {
    const vtkIdType first = cells.Points.IdOf(segment.A);
    cells.Lines->InsertNextCell({ first, cells.Points.IdOf(segment.B) });
    cells.Origins.push_back(segment.Origin);
  }
  cells.Store(curves);
  this->AddLabels(cells.Origins, curves->GetCellData());
}

//------------------------------------------------------------------------------
void SkdContacts::FillJoined(vtkPolyData* curves, const std::vector<SkdEndPair>& lone,
  const std::vector<SkdEndPair>& segments, const std::vector<SkdPolyline>& lines) const
{
  CurveCells cells(this->Points, lone);
  std::vector<vtkIdType> ids;
  for (const SkdPolyline& line : lines)
  {
    ids.clear();
    for (std::size_t i = 0; i < line.Points.size(); ++i)
    {
      const std::size_t segment = line.Segments[std::min(i, line.Segments.size() - 1)];
      cells.Origins.push_back(segments[segment].Origin);
      ids.push_back(cells.Points.Add(line.Points[i]));
    }
    if (line.IsClosed)
    {
      ids.push_back(ids.front());
    }
    cells.Lines->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  cells.Store(curves);
  this->AddLabels(cells.Origins, curves->GetPointData());
  this->AddMeasures(curves, segments, lines);
}

//------------------------------------------------------------------------------
void SkdContacts::AddMeasures(vtkPolyData* curves, const std::vector<SkdEndPair>& segments,
  const std::vector<SkdPolyline>& lines) const
{
  const vtkIdType n = curves->GetNumberOfCells();
  auto closed = SkdMakeArray<vtkUnsignedCharArray>(ClosedName, 1, n);
  auto lengths = SkdMakeArray<vtkDoubleArray>(LengthName, 1, n);
  closed->Fill(0);
  lengths->Fill(0.0);
  vtkIdType cell = curves->GetNumberOfVerts();
  for (const SkdPolyline& line : lines)
  {
    double length = 0.0;
    for (const std::size_t i : line.Segments)
    {
      length +=
        Norm(this->Points.GetPosition(segments[i].A) - this->Points.GetPosition(segments[i].B));
    }
    closed->SetValue(cell, line.IsClosed);
    lengths->SetValue(cell, length);
    ++cell;
  }
  curves->GetCellData()->AddArray(closed);
  curves->GetCellData()->AddArray(lengths);
}

//------------------------------------------------------------------------------
vtkIdType SkdContacts::FillOverlaps(vtkPolyData* overlaps) const
{
  TakenPoints points(this->Points);
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
