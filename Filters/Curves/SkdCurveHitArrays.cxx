// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/SkdCurveHitArrays.h"

#include "Curves/SkdCurveSpans.h"
#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdMakeArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
/// An array of one value an item, added to `to`.
template <class Array, class Item, class Value>
void AddColumn(vtkDataSetAttributes* to, const std::vector<Item>& items, const std::string& name,
  const Value& value)
{
  auto array = SkdMakeArray<Array>(name.c_str(), 1, static_cast<vtkIdType>(items.size()));
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), value(items[i]));
  }
  to->AddArray(array);
}

double AngleOf(const SkdCurveHit& hit)
{
  const skd::Vector3& a = hit.First.Tangent;
  const skd::Vector3& b = hit.Second.Tangent;
  const double angle = std::atan2(skd::Norm(skd::Cross(a, b)), std::abs(skd::Dot(a, b)));
  return vtkMath::DegreesFromRadians(angle);
}

void AddVertices(const std::vector<SkdCurveHit>& hits, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  for (const SkdCurveHit& hit : hits)
  {
    const skd::Vector3 middle = skd::Lerp(hit.First.X, hit.Second.X, 0.5);
    const vtkIdType id = points->InsertNextPoint(middle.X);
    vertices->InsertNextCell(1, &id);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
}

/// The arrays of one side: "SkdCurve..." of the first, "SkdOtherCurve..." of the other.
void AddSide(const std::vector<SkdCurveHit>& hits, const SkdCurveSide& side,
  SkdCurveLocation SkdCurveHit::*location, const std::string& prefix, vtkDataSetAttributes* to)
{
  using Hit = SkdCurveHit;
  const SkdCurveSet& curves = side.Tree.GetCurves();
  const auto curveOf = [&, location](const Hit& hit) -> const SkdCurve&
  { return curves.GetCurves()[(hit.*location).Curve]; };
  AddColumn<vtkIdTypeArray>(to, hits, prefix + "CurveId",
    [=](const Hit& hit) { return static_cast<vtkIdType>((hit.*location).Curve); });
  AddColumn<vtkIdTypeArray>(
    to, hits, prefix + "CurveCellId", [&](const Hit& hit) { return curveOf(hit).CellId; });
  if (side.IsComposite)
  {
    AddColumn<vtkIntArray>(to, hits, prefix + "CurveBlockIndex",
      [&](const Hit& hit)
      { return side.Blocks[static_cast<std::size_t>(curveOf(hit).Block)].BlockIndex; });
  }
  AddColumn<vtkDoubleArray>(to, hits, prefix + "CurveParameter",
    [&, location](const Hit& hit)
    { return curves.GetParameter((hit.*location).Piece, (hit.*location).T); });
  AddColumn<vtkDoubleArray>(to, hits, prefix + "ArcLength",
    [&, location](const Hit& hit)
    { return curves.GetArcLength((hit.*location).Piece, (hit.*location).T); });
}

void AddDataOf(const std::vector<SkdCurveHit>& hits, const SkdCurveSide& side,
  SkdCurveLocation SkdCurveHit::*location, vtkPolyData* output, std::set<std::string>& refused)
{
  const auto n = static_cast<vtkIdType>(hits.size());
  const auto gather = [&](int type)
  { return SkdGatherInto(output->GetPointData(), n, side.Blocks, type, refused); };
  SkdArrayGather points = gather(vtkDataObject::POINT);
  SkdArrayGather cells = gather(vtkDataObject::CELL);
  const SkdCurveSet& curves = side.Tree.GetCurves();
  vtkNew<vtkIdList> ids;
  std::vector<double> weights;
  for (vtkIdType i = 0; i < n; ++i)
  {
    const SkdCurveLocation& at = hits[static_cast<std::size_t>(i)].*location;
    const SkdCurve& curve = curves.GetCurves()[at.Curve];
    curves.GetWeights(at.Piece, at.T, ids, weights);
    points.Interpolate(i, curve.Block, ids, weights.data());
    cells.Take(i, curve.Block, curve.CellId);
  }
}

/// The points of a interval along its first curve.
class IntervalLine
{
public:
  IntervalLine(const SkdCurveSet& curves, double delta, vtkPoints* points)
    : Curves(curves)
    , Delta(delta)
    , Points(points)
  {
  }

  /// A interval that ends before it begins goes on around a closed curve.
  void Insert(const SkdCurveInterval& interval, vtkCellArray* lines)
  {
    const SkdCurveLocation& begin = interval.Begin.First;
    const SkdCurveLocation& end = interval.End.First;
    const SkdCurve& curve = this->Curves.GetCurves()[begin.Curve];
    this->Ids = { this->Points->InsertNextPoint(begin.X.X) };
    std::size_t piece = begin.Piece;
    double from = begin.T;
    const std::size_t count = curve.LastPiece - curve.FirstPiece;
    for (std::size_t i = 0; i <= count; ++i)
    {
      const bool isLast = piece == end.Piece && end.T > from;
      this->AddPart(piece, from, isLast ? end.T : 1.0);
      const bool isAtEnd = isLast || (end.T == 0.0 && this->Next(curve, piece) == end.Piece);
      if (isAtEnd)
      {
        break;
      }
      piece = this->Next(curve, piece);
      from = 0.0;
    }
    lines->InsertNextCell(static_cast<vtkIdType>(this->Ids.size()), this->Ids.data());
  }

private:
  static std::size_t Next(const SkdCurve& curve, std::size_t piece)
  {
    return piece + 1 == curve.LastPiece ? curve.FirstPiece : piece + 1;
  }

  void AddPart(std::size_t piece, double from, double to)
  {
    if (!(to > from))
    {
      return;
    }
    SkdVisitSpans(this->Curves.GetPiece(piece, skd::Vector3{}).Restricted(from, to), this->Delta,
      [&](const skd::BezierCurve& part, const skd::Interval&)
      { this->Ids.push_back(this->Points->InsertNextPoint(part.End().X)); });
  }

  const SkdCurveSet& Curves;
  double Delta;
  vtkPoints* Points;
  std::vector<vtkIdType> Ids;
};
}

//------------------------------------------------------------------------------
void SkdStoreCurveHits(const SkdCurveHitTable& table, vtkPolyData* output)
{
  using Hit = SkdCurveHit;
  const std::vector<Hit>& hits = table.Intersections.Hits;
  vtkPointData* to = output->GetPointData();
  AddVertices(hits, output);
  AddSide(hits, table.First, &Hit::First, "Skd", to);
  AddSide(hits, table.Second, &Hit::Second, "SkdOther", to);
  AddColumn<vtkDoubleArray>(to, hits, "SkdGap", [](const Hit& hit) { return hit.Gap; });
  AddColumn<vtkDoubleArray>(to, hits, "SkdAngle", [](const Hit& hit) { return AngleOf(hit); });
  AddColumn<vtkIntArray>(
    to, hits, "SkdKind", [](const Hit& hit) { return static_cast<int>(hit.Kind); });
  to->SetActiveScalars("SkdKind");
}

//------------------------------------------------------------------------------
std::set<std::string> SkdStoreDataOfCurves(const SkdCurveHitTable& table, vtkPolyData* output)
{
  std::set<std::string> refused;
  AddDataOf(table.Intersections.Hits, table.First, &SkdCurveHit::First, output, refused);
  if (&table.First.Tree != &table.Second.Tree)
  {
    AddDataOf(table.Intersections.Hits, table.Second, &SkdCurveHit::Second, output, refused);
  }
  return refused;
}

//------------------------------------------------------------------------------
void SkdStoreIntervals(const SkdCurveHitTable& table, double delta, vtkPolyData* output)
{
  using Interval = SkdCurveInterval;
  const std::vector<Interval>& intervals = table.Intersections.Intervals;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  IntervalLine line(table.First.Tree.GetCurves(), delta, points);
  for (const Interval& interval : intervals)
  {
    line.Insert(interval, lines);
  }
  output->SetPoints(points);
  output->SetLines(lines);
  const auto addIds = [&](const SkdCurveSide& side, SkdCurveLocation SkdCurveHit::*location,
                        const std::string& prefix)
  {
    vtkCellData* to = output->GetCellData();
    AddColumn<vtkIdTypeArray>(to, intervals, prefix + "CurveId",
      [=](const Interval& one) { return static_cast<vtkIdType>((one.Begin.*location).Curve); });
    AddColumn<vtkIdTypeArray>(to, intervals, prefix + "CurveCellId",
      [&, location](const Interval& one)
      { return side.Tree.GetCurves().GetCurves()[(one.Begin.*location).Curve].CellId; });
  };
  addIds(table.First, &SkdCurveHit::First, "Skd");
  addIds(table.Second, &SkdCurveHit::Second, "SkdOther");
}
}
