// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/SkdSurfaceHitArrays.h"

#include "Cells/Kernels/SkdCellWeights.h"
#include "Cells/Kernels/SkdPolyKernels.h"
#include "Cells/Read/SkdMagnitudes.h"
#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdMakeArray.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
/// Adds an array of one value an intersection.
template <class Array, class Value>
void AddColumn(
  const SkdSurfaceHitTable& table, vtkPolyData* output, const char* name, const Value& value)
{
  const auto n = static_cast<vtkIdType>(table.Intersections.size());
  auto array = SkdMakeArray<Array>(name, 1, n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    array->SetValue(i, value(table.Intersections[static_cast<std::size_t>(i)]));
  }
  output->GetPointData()->AddArray(array);
}

template <class Value>
void AddVectors(
  const SkdSurfaceHitTable& table, vtkPolyData* output, const char* name, const Value& value)
{
  const auto n = static_cast<vtkIdType>(table.Intersections.size());
  auto array = SkdMakeArray<vtkDoubleArray>(name, 3, n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    array->SetTuple(i, value(table.Intersections[static_cast<std::size_t>(i)]).X);
  }
  output->GetPointData()->AddArray(array);
}

skd::Vector3 Unit(const skd::Vector3& vector)
{
  const double length = skd::Norm(vector);
  return length > 0.0 ? (1.0 / length) * vector : skd::Vector3{};
}

/// Of the curve against the surface, in degrees. Exact for small angles, too.
double AngleOf(const SkdSurfaceHit& hit)
{
  const double across = std::abs(skd::Dot(hit.Tangent, hit.Normal));
  const double along = skd::Norm(skd::Cross(hit.Tangent, hit.Normal));
  return vtkMath::DegreesFromRadians(std::atan2(across, along));
}

/// The parameters in the cell; of a part of a cell as VTK has them.
skd::Vector3 PCoordsOf(const SkdSurfaceHitTable& table, const SkdSurfaceHit& hit)
{
  const SkdSurfaceElement& element = table.Surfaces.GetElements()[hit.Element];
  if (element.IsWhole)
  {
    return { { hit.R, hit.S, 0.0 } };
  }
  vtkDataSet* mesh = table.SurfaceBlocks[static_cast<std::size_t>(element.Block)].Mesh;
  vtkCell* cell = mesh->GetCell(element.CellId);
  skd::Vector3 nearest;
  skd::Vector3 pcoords{};
  const double* box = cell->GetBounds();
  if (cell->GetCellType() == VTK_CONVEX_POINT_SET) // as the locator has it: see SkdCellWeights
  {
    return SkdPolyKernels::PCoordsInBounds(
      { { { box[0], box[2], box[4] } }, { { box[1], box[3], box[5] } } }, hit.X);
  }
  if (!std::all_of(box, box + 6, [](double x) { return std::abs(x) <= SkdMeasurable.Largest; }))
  {
    return pcoords; // VTK asserts that no product overflows
  }
  std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()));
  int subId = 0;
  double dist2;
  cell->EvaluatePosition(hit.X.X, nearest.X, subId, pcoords.X, dist2, weights.data());
  return pcoords;
}

void AddVertices(const SkdSurfaceHitTable& table, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  for (const SkdSurfaceIntersection& intersection : table.Intersections)
  {
    const vtkIdType id = points->InsertNextPoint(intersection.Hit.X.X);
    vertices->InsertNextCell(1, &id);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
}

int CurveBlockOf(const SkdSurfaceHitTable& table, const SkdSurfaceIntersection& intersection)
{
  return table.Curves.GetCurves()[intersection.Hit.Curve].Block;
}

const SkdSurfaceElement& ElementOf(
  const SkdSurfaceHitTable& table, const SkdSurfaceIntersection& intersection)
{
  return table.Surfaces.GetElements()[intersection.Hit.Element];
}
}

//------------------------------------------------------------------------------
void SkdStoreSurfaceHits(const SkdSurfaceHitTable& table, vtkPolyData* output)
{
  using Intersection = SkdSurfaceIntersection;
  const auto& curves = table.Curves.GetCurves();
  const std::vector<SkdJoinedIds> joined = SkdJoinedIdsOf(table.SurfaceBlocks);
  const std::vector<SkdJoinedIds> ofCurves = SkdJoinedIdsOf(table.CurveBlocks);
  AddVertices(table, output);
  AddColumn<vtkIdTypeArray>(table, output, "SkdCurveId",
    [&](const Intersection& one) { return table.CurveNumbers[one.Hit.Curve]; });
  AddColumn<vtkIdTypeArray>(table, output, "SkdCurveCellId",
    [&](const Intersection& one)
    {
      const SkdCurve& curve = curves[one.Hit.Curve];
      return ofCurves[static_cast<std::size_t>(curve.Block)].Of(curve.CellId);
    });
  AddColumn<vtkDoubleArray>(table, output, "SkdCurveParameter",
    [&](const Intersection& one) { return table.Curves.GetParameter(one.Hit.Piece, one.Hit.T); });
  AddColumn<vtkDoubleArray>(table, output, "SkdArcLength",
    [&](const Intersection& one) { return table.Curves.GetArcLength(one.Hit.Piece, one.Hit.T); });
  AddColumn<vtkIdTypeArray>(table, output, "SkdHitNumber",
    [&](const Intersection& one)
    { return table.Numbers[static_cast<std::size_t>(&one - table.Intersections.data())]; });
  AddColumn<vtkIdTypeArray>(table, output, "SkdCellId",
    [&](const Intersection& one)
    {
      const auto& element = ElementOf(table, one);
      return joined[static_cast<std::size_t>(element.Block)].Of(element.CellId);
    });
  AddColumn<vtkIntArray>(table, output, "SkdPartId",
    [&](const Intersection& one) { return ElementOf(table, one).Part; });
  AddVectors(table, output, "SkdPCoords",
    [&](const Intersection& one) { return PCoordsOf(table, one.Hit); });
  AddVectors(
    table, output, "SkdNormal", [](const Intersection& one) { return Unit(one.Hit.Normal); });
  AddColumn<vtkDoubleArray>(
    table, output, "SkdAngle", [](const Intersection& one) { return AngleOf(one.Hit); });
  AddColumn<vtkIntArray>(
    table, output, "SkdSense", [](const Intersection& one) { return one.Sense; });
  AddColumn<vtkIntArray>(table, output, "SkdKind",
    [](const Intersection& one) { return static_cast<int>(one.Hit.Kind); });
  AddColumn<vtkDoubleArray>(
    table, output, "SkdGap", [](const Intersection& one) { return one.Hit.Gap; });
  output->GetPointData()->SetActiveScalars("SkdSense");
}

//------------------------------------------------------------------------------
void SkdStoreCurveBlocks(const SkdSurfaceHitTable& table, vtkPolyData* output)
{
  AddColumn<vtkIntArray>(table, output, "SkdCurveBlockIndex",
    [&](const SkdSurfaceIntersection& one)
    { return table.CurveBlocks[static_cast<std::size_t>(CurveBlockOf(table, one))].BlockIndex; });
}

//------------------------------------------------------------------------------
void SkdStoreSurfaceBlocks(const SkdSurfaceHitTable& table, vtkPolyData* output)
{
  AddColumn<vtkIntArray>(table, output, "SkdBlockIndex",
    [&](const SkdSurfaceIntersection& one) {
      return table.SurfaceBlocks[static_cast<std::size_t>(ElementOf(table, one).Block)].BlockIndex;
    });
}

//------------------------------------------------------------------------------
std::set<std::string> SkdStoreDataAtHits(const SkdSurfaceHitTable& table, vtkPolyData* output)
{
  std::set<std::string> refused;
  const auto n = static_cast<vtkIdType>(table.Intersections.size());
  const auto gather = [&](const std::vector<SkdBlock>& blocks, int type)
  { return SkdGatherInto(output->GetPointData(), n, blocks, type, refused); };
  SkdArrayGather curvePoints = gather(table.CurveBlocks, vtkDataObject::POINT);
  SkdArrayGather curveCells = gather(table.CurveBlocks, vtkDataObject::CELL);
  SkdArrayGather points = gather(table.SurfaceBlocks, vtkDataObject::POINT);
  SkdArrayGather cells = gather(table.SurfaceBlocks, vtkDataObject::CELL);
  vtkNew<vtkIdList> ids;
  std::vector<double> alongCurve;
  SkdCellWeights onSurface;
  for (vtkIdType i = 0; i < n; ++i)
  {
    const SkdSurfaceIntersection& intersection = table.Intersections[static_cast<std::size_t>(i)];
    const SkdSurfaceHit& hit = intersection.Hit;
    const int curveBlock = CurveBlockOf(table, intersection);
    table.Curves.GetWeights(hit.Piece, hit.T, ids, alongCurve);
    curvePoints.Interpolate(i, curveBlock, ids, alongCurve.data());
    curveCells.Take(i, curveBlock, table.Curves.GetCurves()[hit.Curve].CellId);
    const SkdSurfaceElement& element = ElementOf(table, intersection);
    vtkDataSet* mesh = table.SurfaceBlocks[static_cast<std::size_t>(element.Block)].Mesh;
    onSurface.Evaluate(mesh, element.CellId, hit.X.X);
    points.Interpolate(i, element.Block, onSurface.GetPointIds(), onSurface.GetWeights());
    cells.Take(i, element.Block, element.CellId);
  }
  return refused;
}
}
