// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// The regions in which two curves may meet: the paper's R(x, y, z) of section 6.1.
#include "Curves/SkdCurveHitArrays.h"

#include "Core/Geometry/Distance/ClosestSegments.h"
#include "Pipeline/SkdMakeArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace skdtree
{
namespace
{
/// A box around the part of a cylinder that is near the other. It contains all common points: the
/// nearest ones of the chords are no farther apart than both radii together.
skd::Box3 BoxOf(
  const skd::Segment<3>& chord, const skd::Segment<3>& other, double maxDistance, double radius)
{
  const skd::Interval interval = skd::IntervalWithin(chord, other, maxDistance);
  skd::Box3 box;
  box.Add(chord.At(interval.Min));
  box.Add(chord.At(interval.Max));
  return box.Inflated(radius);
}

/// Of a candidate: what is not of one cylinder's deviation is shared between both.
skd::Box3 RegionOf(const SkdCurveSpan& first, const SkdCurveSpan& second, double maxDistance)
{
  const double share = 0.5 * (maxDistance - first.Deviation - second.Deviation);
  skd::Box3 region = BoxOf(first.Chord, second.Chord, maxDistance, first.Deviation + share);
  const skd::Box3 other = BoxOf(second.Chord, first.Chord, maxDistance, second.Deviation + share);
  for (int axis = 0; axis < 3; ++axis)
  {
    region.Min[axis] = std::max(region.Min[axis], other.Min[axis]);
    region.Max[axis] = std::min(region.Max[axis], other.Max[axis]);
  }
  return region;
}

void AddBox(const skd::Box3& box, vtkPoints* points, vtkCellArray* cells)
{
  constexpr bool isHigh[8][3] = { { false, false, false }, { true, false, false },
    { true, true, false }, { false, true, false }, { false, false, true }, { true, false, true },
    { true, true, true }, { false, true, true } };
  vtkIdType ids[8];
  for (int corner = 0; corner < 8; ++corner)
  {
    double x[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] = isHigh[corner][axis] ? box.Max[axis] : box.Min[axis];
    }
    ids[corner] = points->InsertNextPoint(x);
  }
  cells->InsertNextCell(8, ids);
}

/// The curve of each candidate, its cell, and the range of its parameters.
void AddSide(const std::vector<SkdCurveCandidate>& candidates, const SkdCurveSide& side,
  std::size_t SkdCurveCandidate::*span, const std::string& prefix, vtkDataSetAttributes* to)
{
  const auto n = static_cast<vtkIdType>(candidates.size());
  const SkdCurveSet& curves = side.Tree.GetCurves();
  auto numbers = SkdMakeArray<vtkIdTypeArray>((prefix + "CurveId").c_str(), 1, n);
  auto cells = SkdMakeArray<vtkIdTypeArray>((prefix + "CurveCellId").c_str(), 1, n);
  auto ranges = SkdMakeArray<vtkDoubleArray>((prefix + "CurveParameterRange").c_str(), 2, n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const SkdCurveSpan& part = side.Tree.GetSpans()[candidates[i].*span];
    const std::size_t curve = curves.GetCurveOf(part.Piece);
    numbers->SetValue(i, static_cast<vtkIdType>(curve));
    cells->SetValue(i, curves.GetCurves()[curve].CellId);
    ranges->SetTypedComponent(i, 0, curves.GetParameter(part.Piece, part.Range.Min));
    ranges->SetTypedComponent(i, 1, curves.GetParameter(part.Piece, part.Range.Max));
  }
  to->AddArray(numbers);
  to->AddArray(cells);
  to->AddArray(ranges);
}
}

void SkdStoreCandidates(const SkdCurveHitTable& table, vtkUnstructuredGrid* output)
{
  const std::vector<SkdCurveCandidate>& candidates = table.Intersections.Candidates;
  const auto n = static_cast<vtkIdType>(candidates.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  auto hits = SkdMakeArray<vtkIntArray>("SkdNumberOfHits", 1, n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const SkdCurveCandidate& one = candidates[i];
    AddBox(RegionOf(table.First.Tree.GetSpans()[one.First],
             table.Second.Tree.GetSpans()[one.Second], one.Extent),
      points, cells);
    hits->SetValue(i, one.NumberOfHits);
  }
  output->SetPoints(points);
  output->SetCells(VTK_HEXAHEDRON, cells);
  AddSide(candidates, table.First, &SkdCurveCandidate::First, "Skd", output->GetCellData());
  AddSide(candidates, table.Second, &SkdCurveCandidate::Second, "SkdOther", output->GetCellData());
  output->GetCellData()->AddArray(hits);
  output->GetCellData()->SetActiveScalars("SkdNumberOfHits");
}
}
