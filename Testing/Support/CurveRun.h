// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurveRun.h
 * @brief curves and curved surfaces of known shape, and a filter's points by value
 */
#ifndef skdtest_CurveRun_h
#define skdtest_CurveRun_h

#include "Support/MakeOf.h"
#include "Support/MeshBuilder.h"
#include "Support/Reported.h"
#include "Support/ValuesOf.h"

#include "vtkAlgorithm.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"

#include <cmath>
#include <string>

namespace skdtest
{

/// One cell of all the points.
inline Mesh OneCell(int type, const std::vector<Point>& points)
{
  Mesh mesh;
  Ids ids;
  for (const Point& point : points)
  {
    ids.push_back(mesh.Add(point));
  }
  mesh.Add(type, ids);
  return mesh;
}

inline PolyDataPointer MakePolyline(const std::vector<Point>& points)
{
  return MakePolyData(OneCell(VTK_POLY_LINE, points));
}

/// The points f(t) at n + 1 places from t0 to t1.
template <class Function>
std::vector<Point> Sampled(const Function& f, double t0, double t1, int n)
{
  std::vector<Point> points;
  for (int i = 0; i <= n; ++i)
  {
    points.push_back(f(t0 + (t1 - t0) * i / n));
  }
  return points;
}

/// The curve as one Lagrange cell a piece, of order 10: short pieces are off by rounding only.
template <class Function>
GridPointer LagrangeCurve(const Function& f, double t0, double t1, int pieces)
{
  constexpr int order = 10;
  Mesh mesh;
  for (int piece = 0; piece < pieces; ++piece)
  {
    const double from = t0 + (t1 - t0) * piece / pieces;
    const double to = t0 + (t1 - t0) * (piece + 1) / pieces;
    const std::vector<Point> points = Sampled(f, from, to, order);
    Ids ids{ mesh.Add(points.front()), mesh.Add(points.back()) };
    for (int i = 1; i < order; ++i)
    {
      ids.push_back(mesh.Add(points[static_cast<std::size_t>(i)]));
    }
    mesh.Add(VTK_LAGRANGE_CURVE, ids);
  }
  return MakeGrid(mesh);
}

/// Rational weights for the points of a grid of Bezier cells.
inline void SetRationalWeights(vtkDataSet* grid, const std::vector<double>& weights)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("RationalWeights");
  for (double weight : weights)
  {
    array->InsertNextValue(weight);
  }
  grid->GetPointData()->SetRationalWeights(array);
}

/// Cosine, sine and weight of the control points of a quarter circle, turned by quarters.
inline std::array<double, 3> QuarterCircle(int i, int quarters)
{
  static constexpr double points[3][2] = { { 1, 0 }, { 1, 1 }, { 0, 1 } };
  const double* p = points[i];
  const double rotated[4][2] = { { p[0], p[1] }, { -p[1], p[0] }, { -p[0], -p[1] },
    { p[1], -p[0] } };
  return { rotated[quarters % 4][0], rotated[quarters % 4][1], i == 1 ? std::sqrt(0.5) : 1.0 };
}

/// A circle about z as four rational Bezier curves.
inline GridPointer BezierCircle(double radius, const Point& centre = {})
{
  Mesh mesh;
  std::vector<double> weights;
  for (int quarter = 0; quarter < 4; ++quarter)
  {
    Ids ids;
    for (int i : { 0, 2, 1 }) // ends first
    {
      const auto [c, s, w] = QuarterCircle(i, quarter);
      ids.push_back(mesh.Add(centre + Point{ radius * c, radius * s, 0 }));
      weights.push_back(w);
    }
    mesh.Add(VTK_BEZIER_CURVE, ids);
  }
  GridPointer grid = MakeGrid(mesh);
  SetRationalWeights(grid, weights);
  return grid;
}

/// Where VTK has the points of a biquadratic quadrilateral, along both parameters.
constexpr int BiquadraticOrder[9][2] = { { 0, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 }, { 1, 0 }, { 2, 1 },
  { 1, 2 }, { 0, 1 }, { 1, 1 } };

/// A surface of revolution about z as rational biquadratic Bezier quadrilaterals: circles of
/// `radius` whose centres are at `distance` from z, `quarters` quarters of them from angle `first`.
inline GridPointer BezierRevolution(double distance, double radius, int first, int quarters)
{
  Mesh mesh;
  std::vector<double> weights;
  for (int patch = 0; patch < 4 * quarters; ++patch)
  {
    Ids ids;
    for (const auto& [i, j] : BiquadraticOrder)
    {
      const auto around = QuarterCircle(i, patch % 4);
      const auto tube = QuarterCircle(j, first + patch / 4);
      const double r = distance + radius * tube[0];
      ids.push_back(mesh.Add({ r * around[0], r * around[1], radius * tube[1] }));
      weights.push_back(around[2] * tube[2]);
    }
    mesh.Add(VTK_BEZIER_QUADRILATERAL, ids);
  }
  GridPointer grid = MakeGrid(mesh);
  SetRationalWeights(grid, weights);
  return grid;
}

/// A cylinder about the line along z through `centre`, its middle, as four rational patches.
inline GridPointer BezierCylinder(double radius, double length, const Point& centre = {})
{
  Mesh mesh;
  std::vector<double> weights;
  for (int quarter = 0; quarter < 4; ++quarter)
  {
    Ids ids;
    for (const auto& [i, j] : BiquadraticOrder)
    {
      const auto [c, s, w] = QuarterCircle(i, quarter);
      ids.push_back(mesh.Add(centre + Point{ radius * c, radius * s, 0.5 * (j - 1) * length }));
      weights.push_back(w);
    }
    mesh.Add(VTK_BEZIER_QUADRILATERAL, ids);
  }
  GridPointer grid = MakeGrid(mesh);
  SetRationalWeights(grid, weights);
  return grid;
}

inline GridPointer BezierTorus(double R, double r)
{
  return BezierRevolution(R, r, 0, 4);
}

/// Eight octants, with poles on z.
inline GridPointer BezierSphere(double radius)
{
  return BezierRevolution(0.0, radius, 3, 2);
}

/// A filter of the intersections of curves; without others those with themselves.
template <class Filter>
vtkSmartPointer<Filter> MakeCurveFilter(vtkDataObject* curves, vtkDataObject* others = nullptr)
{
  return MakeOf<Filter>(curves, others);
}

/// A point array of a filter's output after an update, all components in a row.
inline std::vector<double> OutputArray(vtkAlgorithm* filter, const std::string& name, int port = 0)
{
  filter->Update();
  auto* data = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(port));
  return ValuesOf(data->GetPointData()->GetArray(name.c_str()));
}

inline std::vector<double> OutputCellArray(
  vtkAlgorithm* filter, const std::string& name, int port = 0)
{
  filter->Update();
  auto* data = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(port));
  return ValuesOf(data->GetCellData()->GetArray(name.c_str()));
}

inline std::vector<Point> OutputPoints(vtkAlgorithm* filter, int port = 0)
{
  filter->Update();
  auto* data = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(port));
  std::vector<Point> points(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    data->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  return points;
}

/// Where the points are along a curve that is `pieces` equal cells from `from` to `to`. Side:
/// "SkdCurve" or "SkdOtherCurve".
inline std::vector<double> PlacesOfPieces(
  vtkAlgorithm* filter, double from, double to, int pieces, const std::string& side = "SkdCurve")
{
  const std::vector<double> cells = OutputArray(filter, side + "CellId");
  std::vector<double> positions = OutputArray(filter, side + "Parameter");
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    positions[i] = from + (cells[i] + positions[i]) * (to - from) / pieces;
  }
  return positions;
}

}

#endif
