// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/SkdBezierCell.h"

#include "Cells/SkdParametricCell.h"
#include "Core/Curves/BernsteinBasis.h"
#include "vtkBezierCurve.h"
#include "vtkBezierQuadrilateral.h"
#include "vtkBezierTriangle.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkPoints.h"

namespace
{
skd::Vector3 PointOf(vtkCell* cell, vtkIdType i)
{
  skd::Vector3 point;
  cell->GetPoints()->GetPoint(i, point.X);
  return point;
}

/// The points of a Bezier cell seen from the first of them, times their weights.
class Controls
{
public:
  Controls(vtkCell* cell, vtkDoubleArray* weights)
    : Cell(cell)
    , Weights(
        weights && weights->GetNumberOfTuples() == cell->GetNumberOfPoints() ? weights : nullptr)
    , Origin(PointOf(cell, 0))
  {
  }

  skd::Homogeneous Get(vtkIdType i) const
  {
    return skd::Weighted(PointOf(this->Cell, i) - this->Origin, this->Weight(i));
  }

  bool AreWeightsPositive() const
  {
    for (vtkIdType i = 0; this->Weights && i < this->Weights->GetNumberOfTuples(); ++i)
    {
      if (!(this->Weight(i) > 0.0 && std::isfinite(this->Weight(i))))
      {
        return false;
      }
    }
    return true;
  }

private:
  double Weight(vtkIdType i) const { return this->Weights ? this->Weights->GetValue(i) : 1.0; }

  vtkCell* Cell;
  vtkDoubleArray* Weights;
  skd::Vector3 Origin;
};

int TriangleDegree(vtkIdType points)
{
  const int degree = static_cast<int>((std::sqrt(8.0 * points + 1.0) - 3.0) / 2.0 + 1e-9);
  return points == 7 ? 3 : degree; // the quadratic triangle with a seventh point in its middle
}

/// The degrees of a cell by its type; 0 where it is none of ours.
struct Degrees
{
  int R = 0;
  int S = 0;
  bool IsTriangle = false;
};

Degrees CurveDegree(vtkCell* cell)
{
  switch (cell->GetCellType())
  {
    case VTK_QUADRATIC_EDGE:
    case VTK_CUBIC_LINE:
    case VTK_LAGRANGE_CURVE:
    case VTK_BEZIER_CURVE:
      return { static_cast<int>(cell->GetNumberOfPoints()) - 1, 0, false };
    default:
      return {};
  }
}

Degrees PatchDegrees(vtkCell* cell)
{
  switch (cell->GetCellType())
  {
    case VTK_QUADRATIC_TRIANGLE:
    case VTK_BIQUADRATIC_TRIANGLE:
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_BEZIER_TRIANGLE:
    {
      const int degree = TriangleDegree(cell->GetNumberOfPoints());
      return { degree, degree, true };
    }
    case VTK_QUADRATIC_QUAD:
    case VTK_BIQUADRATIC_QUAD:
      return { 2, 2, false };
    case VTK_QUADRATIC_LINEAR_QUAD:
      return { 2, 1, false };
    case VTK_LAGRANGE_QUADRILATERAL:
    case VTK_BEZIER_QUADRILATERAL:
    {
      const int* order = vtkHigherOrderQuadrilateral::SafeDownCast(cell)->GetOrder();
      return { order[0], order[1], false };
    }
    default:
      return {};
  }
}

SkdBezierFault FaultOf(vtkCell* cell, const Degrees& degrees, int least)
{
  if (degrees.R < 1 || degrees.S < least)
  {
    return SkdBezierFault::Type;
  }
  if (std::max(degrees.R, degrees.S) > skd::MaximumDegree)
  {
    return SkdBezierFault::Degree;
  }
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    if (!skd::IsFinite(PointOf(cell, i)))
    {
      return SkdBezierFault::Coordinate;
    }
  }
  return SkdBezierFault::None;
}

skd::Homogeneous Sample(const SkdParametricCell& cell, double r, double s)
{
  return skd::Weighted(cell.Value({ { r, s, 0.0 } }), 1.0);
}

double Power(double base, vtkIdType exponent)
{
  double power = 1.0;
  for (vtkIdType i = 0; i < exponent; ++i)
  {
    power *= base;
  }
  return power;
}

/// n! / (a! b! c!), where n = a + b + c.
double Trinomial(const vtkIdType (&index)[3])
{
  double value = 1.0;
  vtkIdType n = 0;
  for (const vtkIdType count : index)
  {
    for (vtkIdType i = 1; i <= count; ++i)
    {
      value *= static_cast<double>(++n) / static_cast<double>(i);
    }
  }
  return value;
}

/// A Bezier triangle, without the division by its weights, at any (r, s): also beyond its long
/// side, where that could fail.
skd::Homogeneous SampleTriangle(
  const Controls& controls, vtkIdType size, int degree, double r, double s)
{
  skd::Homogeneous sum{};
  for (vtkIdType i = 0; i < size; ++i)
  {
    vtkIdType index[3] = {};
    vtkHigherOrderTriangle::BarycentricIndex(i, index, degree);
    const double weight =
      Trinomial(index) * Power(r, index[0]) * Power(s, index[1]) * Power(1.0 - r - s, index[2]);
    sum = sum + weight * controls.Get(i);
  }
  return sum;
}

template <class Evaluate>
void FillBySamples(skd::BezierPatch& patch, const Evaluate& evaluate)
{
  for (int j = 0; j <= patch.DegreeS; ++j)
  {
    for (int i = 0; i <= patch.DegreeR; ++i)
    {
      patch.Point(i, j) =
        evaluate(static_cast<double>(i) / patch.DegreeR, static_cast<double>(j) / patch.DegreeS);
    }
  }
  skd::ConvertToBernstein(patch);
}

void FillFromBezier(skd::BezierPatch& patch, const Controls& controls, const int* order)
{
  for (int j = 0; j <= patch.DegreeS; ++j)
  {
    for (int i = 0; i <= patch.DegreeR; ++i)
    {
      patch.Point(i, j) = controls.Get(vtkHigherOrderQuadrilateral::PointIndexFromIJK(i, j, order));
    }
  }
}

SkdBezierFault FillPatch(vtkCell* cell, skd::BezierPatch& patch)
{
  if (auto* triangle = vtkBezierTriangle::SafeDownCast(cell))
  {
    const Controls controls(cell, triangle->GetRationalWeights());
    FillBySamples(patch,
      [&](double r, double s)
      { return SampleTriangle(controls, cell->GetNumberOfPoints(), patch.DegreeR, r, s); });
    return controls.AreWeightsPositive() ? SkdBezierFault::None : SkdBezierFault::Weight;
  }
  if (auto* quad = vtkBezierQuadrilateral::SafeDownCast(cell))
  {
    const Controls controls(cell, quad->GetRationalWeights());
    FillFromBezier(patch, controls, quad->GetOrder());
    return controls.AreWeightsPositive() ? SkdBezierFault::None : SkdBezierFault::Weight;
  }
  const SkdParametricCell parametric(cell, PointOf(cell, 0));
  FillBySamples(patch, [&](double r, double s) { return Sample(parametric, r, s); });
  return SkdBezierFault::None;
}

/// Both ends come first among a cell's points.
vtkIdType OrderAlongCurve(int i, int degree)
{
  return i == 0 ? 0 : (i == degree ? 1 : i + 1);
}

SkdBezierFault FillCurve(vtkCell* cell, skd::BezierCurve& curve)
{
  if (auto* bezier = vtkBezierCurve::SafeDownCast(cell))
  {
    const Controls controls(cell, bezier->GetRationalWeights());
    for (int i = 0; i <= curve.Degree; ++i)
    {
      curve.Points[i] = controls.Get(OrderAlongCurve(i, curve.Degree));
    }
    return controls.AreWeightsPositive() ? SkdBezierFault::None : SkdBezierFault::Weight;
  }
  const Controls controls(cell, nullptr); // the points are where the parameter is i / n
  for (int i = 0; i <= curve.Degree; ++i)
  {
    curve.Points[i] = controls.Get(OrderAlongCurve(i, curve.Degree));
  }
  skd::BernsteinBasisOf(curve.Degree).Convert(curve.Points);
  return SkdBezierFault::None;
}
}

//------------------------------------------------------------------------------
SkdBezierCell<skd::BezierCurve> SkdReadBezierCurve(vtkCell* cell)
{
  const Degrees degrees = CurveDegree(cell);
  SkdBezierCell<skd::BezierCurve> read{ {}, {}, FaultOf(cell, degrees, 0) };
  if (read.Fault == SkdBezierFault::None)
  {
    read.Origin = PointOf(cell, 0);
    read.Form.Degree = degrees.R;
    read.Fault = FillCurve(cell, read.Form);
  }
  return read;
}

//------------------------------------------------------------------------------
SkdBezierCell<skd::BezierPatch> SkdReadBezierPatch(vtkCell* cell)
{
  const Degrees degrees = PatchDegrees(cell);
  SkdBezierCell<skd::BezierPatch> read{ {}, {}, FaultOf(cell, degrees, 1) };
  if (read.Fault == SkdBezierFault::None)
  {
    read.Origin = PointOf(cell, 0);
    read.Form.DegreeR = degrees.R;
    read.Form.DegreeS = degrees.S;
    read.Form.IsTriangle = degrees.IsTriangle;
    read.Fault = FillPatch(cell, read.Form);
  }
  return read;
}
