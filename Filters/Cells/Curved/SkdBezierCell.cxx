// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Curved/SkdBezierCell.h"
#include "Cells/Read/SkdTolerances.h"

#include "vtkBezierCurve.h"
#include "vtkBezierQuadrilateral.h"
#include "vtkBezierTriangle.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkPoints.h"

namespace skdtree
{
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

  skd::PatchNode NodeAt(vtkIdType i) const
  {
    const skd::Vector3 x = PointOf(this->Cell, i);
    return { { x[0], x[1], x[2], this->Weight(i) } };
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

/// The points of the quadratic triangle that has one more in its middle.
constexpr vtkIdType BubbleTriangle = 7;

/// 0 of a number of points that is none of a triangle's.
int TriangleDegree(vtkIdType points)
{
  const int degree =
    static_cast<int>((std::sqrt(8.0 * points + 1.0) - 3.0) / 2.0 + SkdTolerances::Degree);
  const bool isFull = (degree + 1) * (degree + 2) / 2 == points;
  return isFull ? degree : (points == BubbleTriangle ? 2 : 0);
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

bool IsBezier(vtkCell* cell)
{
  return cell->GetCellType() >= VTK_BEZIER_CURVE && cell->GetCellType() <= VTK_BEZIER_PYRAMID;
}

vtkDoubleArray* WeightsOf(vtkCell* cell)
{
  if (auto* triangle = vtkBezierTriangle::SafeDownCast(cell))
  {
    return triangle->GetRationalWeights();
  }
  auto* quad = vtkBezierQuadrilateral::SafeDownCast(cell);
  return quad ? quad->GetRationalWeights() : nullptr;
}

/// Calls visit(index among the cell's points, i, j). Corners come first, then the middles of sides.
template <class Visit>
void ForEachNode(vtkCell* cell, const skd::NodePatch& patch, const Visit& visit)
{
  if (patch.IsTriangle)
  {
    const vtkIdType size = (patch.DegreeR + 1) * (patch.DegreeR + 2) / 2;
    for (vtkIdType at = 0; at < size; ++at)
    {
      vtkIdType index[3] = {};
      vtkHigherOrderTriangle::BarycentricIndex(at, index, patch.DegreeR);
      visit(at, static_cast<int>(index[0]), static_cast<int>(index[1]));
    }
    return;
  }
  constexpr int quadratic[9][2] = { { 0, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 }, { 1, 0 }, { 2, 1 },
    { 1, 2 }, { 0, 1 }, { 1, 1 } };
  constexpr int linear[6][2] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 0, 1 }, { 1, 0 }, { 1, 1 } };
  if (vtkHigherOrderQuadrilateral::SafeDownCast(cell))
  {
    const int order[2] = { patch.DegreeR, patch.DegreeS };
    for (int j = 0; j <= patch.DegreeS; ++j)
    {
      for (int i = 0; i <= patch.DegreeR; ++i)
      {
        visit(vtkHigherOrderQuadrilateral::PointIndexFromIJK(i, j, order), i, j);
      }
    }
    return;
  }
  const auto& lattice = patch.DegreeS == 1 ? linear : quadratic;
  for (vtkIdType at = 0; at < cell->GetNumberOfPoints(); ++at)
  {
    visit(at, lattice[at][0], lattice[at][1]);
  }
}

skd::NodeMeaning MeaningOf(vtkCell* cell)
{
  const vtkIdType size = cell->GetNumberOfPoints();
  return IsBezier(cell)                                       ? skd::NodeMeaning::Controls
    : cell->GetCellType() == VTK_QUADRATIC_QUAD               ? skd::NodeMeaning::Serendipity
    : PatchDegrees(cell).IsTriangle && size == BubbleTriangle ? skd::NodeMeaning::Bubble
                                                              : skd::NodeMeaning::Values;
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
SkdBezierFault SkdReadNodePatch(vtkCell* cell, skd::NodePatch& nodes)
{
  const Degrees degrees = PatchDegrees(cell);
  const SkdBezierFault fault = FaultOf(cell, degrees, 1);
  if (fault != SkdBezierFault::None)
  {
    return fault;
  }
  nodes.DegreeR = degrees.R;
  nodes.DegreeS = degrees.S;
  nodes.IsTriangle = degrees.IsTriangle;
  nodes.Meaning = MeaningOf(cell);
  const Controls controls(cell, WeightsOf(cell));
  ForEachNode(
    cell, nodes, [&](vtkIdType at, int i, int j) { nodes.At(i, j) = controls.NodeAt(at); });
  if (nodes.Meaning == skd::NodeMeaning::Bubble)
  {
    nodes.Middle = controls.NodeAt(BubbleTriangle - 1);
  }
  return controls.AreWeightsPositive() ? SkdBezierFault::None : SkdBezierFault::Weight;
}

//------------------------------------------------------------------------------
SkdBezierCell<skd::BezierPatch> SkdReadBezierPatch(vtkCell* cell)
{
  skd::NodePatch nodes;
  SkdBezierCell<skd::BezierPatch> read{ {}, {}, SkdReadNodePatch(cell, nodes) };
  if (read.Fault == SkdBezierFault::None)
  {
    read.Origin = PointOf(cell, 0);
    read.Form = skd::ToBezier(nodes, read.Origin);
  }
  return read;
}
}
