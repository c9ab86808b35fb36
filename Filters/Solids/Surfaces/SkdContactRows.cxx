// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// The pairs of cells that pairs of triangles make: a table, and lines across the gaps.
#include "Cells/Read/SkdForEach.h"
#include "Solids/Surfaces/SkdContacts.h"

#include "Pipeline/SkdMakeArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
template <class Row>
bool AreOfSameCells(const Row& a, const Row& b)
{
  return a.FirstCell == b.FirstCell && a.SecondCell == b.SecondCell;
}

/// By cells; for the same cells by descending contact dimension, then distance, then coordinates.
template <class Row>
bool ComesBefore(const Row& a, const Row& b)
{
  if (!AreOfSameCells(a, b))
  {
    return a.FirstCell != b.FirstCell ? a.FirstCell < b.FirstCell : a.SecondCell < b.SecondCell;
  }
  if (a.Kind != b.Kind)
  {
    return a.Kind > b.Kind;
  }
  if (a.Dist2 != b.Dist2)
  {
    return a.Dist2 < b.Dist2;
  }
  return a.FirstPoint == b.FirstPoint ? a.SecondPoint < b.SecondPoint : a.FirstPoint < b.FirstPoint;
}
}

//------------------------------------------------------------------------------
SkdContacts::Row SkdContacts::MakeRow(std::size_t index) const
{
  const SkdTrianglePair& pair = this->Pairs[index];
  Row row;
  const SkdMovedTriangles& first = this->Placement.First;
  const SkdMovedTriangles& second = this->Placement.GetSecond();
  row.FirstCell = first.GetSet().GetCellOf(pair.First);
  row.SecondCell = second.GetSet().GetCellOf(pair.Second);
  row.Kind = SkdKindOf(pair.Contact);
  row.Pair = index;
  row.Dist2 = 0.0;
  if (row.Kind != SkdContactKind::Near)
  {
    row.FirstPoint = this->Points.GetPosition(this->Points.GetPoint(index, 0));
    for (int i = 1; i < pair.Contact.Count; ++i)
    {
      row.FirstPoint =
        std::min(row.FirstPoint, this->Points.GetPosition(this->Points.GetPoint(index, i)));
    }
    row.SecondPoint = row.FirstPoint;
    return row;
  }
  const SkdGap gap = SkdFindGap(this->Placement, pair);
  row.Dist2 = gap.Dist2;
  row.FirstPoint = gap.First;
  row.SecondPoint = gap.Second;
  return row;
}

//------------------------------------------------------------------------------
std::vector<SkdContacts::Row> SkdContacts::FindRows() const
{
  std::vector<Row> rows(this->Pairs.size());
  SkdForEach(static_cast<vtkIdType>(rows.size()),
    [&](vtkIdType i) { rows[i] = this->MakeRow(static_cast<std::size_t>(i)); });
  vtkSMPTools::Sort(rows.begin(), rows.end(), ComesBefore<Row>);
  rows.erase(std::unique(rows.begin(), rows.end(), AreOfSameCells<Row>), rows.end());
  return rows;
}

//------------------------------------------------------------------------------
void SkdContacts::FillPairs(vtkTable* table, vtkPolyData* gaps) const
{
  const std::vector<Row> rows = this->FindRows();
  const auto n = static_cast<vtkIdType>(rows.size());
  auto kinds = SkdMakeArray<vtkIntArray>(KindName, 1, n);
  auto distances = SkdMakeArray<vtkDoubleArray>(DistanceName, 1, n);
  auto firsts = SkdMakeArray<vtkDoubleArray>(FirstPointName, 3, n);
  auto seconds = SkdMakeArray<vtkDoubleArray>(SecondPointName, 3, n);
  std::vector<std::size_t> origins;
  for (vtkIdType i = 0; i < n; ++i)
  {
    kinds->SetValue(i, static_cast<int>(rows[i].Kind));
    distances->SetValue(i, std::sqrt(rows[i].Dist2));
    firsts->SetTypedTuple(i, rows[i].FirstPoint.X);
    seconds->SetTypedTuple(i, rows[i].SecondPoint.X);
    origins.push_back(rows[i].Pair);
  }
  this->AddLabels(origins, table->GetRowData());
  for (vtkDataArray* column :
    std::initializer_list<vtkDataArray*>{ kinds, distances, firsts, seconds })
  {
    table->AddColumn(column);
  }
  this->FillGaps(rows, gaps);
}

//------------------------------------------------------------------------------
void SkdContacts::FillGaps(const std::vector<Row>& rows, vtkPolyData* gaps) const
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkDoubleArray> distances;
  distances->SetName(DistanceName);
  std::vector<std::size_t> origins;
  for (const Row& row : rows)
  {
    if (row.Kind == SkdContactKind::Near)
    {
      const vtkIdType from = points->InsertNextPoint(row.FirstPoint.X);
      lines->InsertNextCell({ from, points->InsertNextPoint(row.SecondPoint.X) });
      distances->InsertNextValue(std::sqrt(row.Dist2));
      origins.push_back(row.Pair);
    }
  }
  gaps->SetPoints(points);
  gaps->SetLines(lines);
  this->AddLabels(origins, gaps->GetCellData());
  gaps->GetCellData()->AddArray(distances);
  gaps->GetCellData()->SetActiveScalars(DistanceName);
}
}
