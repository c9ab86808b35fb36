// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_CurvePatchCell_h
#define skd_Curves_CurvePatchCell_h

#include "SeparatingQuadric.h"
#include "Tolerances.h"

namespace skd
{

/// A part of a curve and a part of a patch that may meet; what the search for their common points
/// (CurvePatchSolver) halves, excludes, or solves.
struct CurvePatchCell
{
  BezierCurve Curve;
  BezierPatch Patch;
  Interval T{ 0.0, 1.0 };
  Interval R{ 0.0, 1.0 };
  Interval S{ 0.0, 1.0 };
  int Depth = 0;

  double MiddleT() const { return 0.5 * (this->T.Min + this->T.Max); }
  double MiddleR() const { return 0.5 * (this->R.Min + this->R.Max); }
  double MiddleS() const { return 0.5 * (this->S.Min + this->S.Max); }

  /// Whether it lies beyond the long side of a triangle.
  bool IsOutside() const
  {
    return this->Patch.IsTriangle && this->R.Min + this->S.Min > 1.0 + tolerances::BeyondLongSide;
  }
};

/// The control points of a cell in space, and its three edges: from end to end of the curve, and
/// along r and s from side to side of the patch.
class CurvePatchHulls
{
public:
  explicit CurvePatchHulls(const CurvePatchCell& cell)
    : CurveSize(cell.Curve.Degree + 1)
    , PatchSize(cell.Patch.Size())
    , IsBounded(cell.Curve.IsInHull() && cell.Patch.IsInHull())
  {
    for (int i = 0; i < this->CurveSize; ++i)
    {
      this->Curve[i] = cell.Curve.Control(i);
    }
    for (int i = 0; i < this->PatchSize; ++i)
    {
      this->Patch[i] = Projected(cell.Patch.Points[i]);
    }
    const Vector3 c00 = cell.Patch.Corner(0, 0);
    const Vector3 c10 = cell.Patch.Corner(1, 0);
    const Vector3 c01 = cell.Patch.Corner(0, 1);
    const Vector3 c11 = cell.Patch.Corner(1, 1);
    this->Along = this->Curve[this->CurveSize - 1] - this->Curve[0];
    this->AlongR = 0.5 * ((c10 - c00) + (c11 - c01));
    this->AlongS = 0.5 * ((c01 - c00) + (c11 - c10));
  }

  /// Whether curve and patch are certainly farther apart than the tolerance.
  bool AreApart(double tolerance) const
  {
    if (!this->IsBounded)
    {
      return false;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      Vector3 direction{};
      direction[axis] = 1.0;
      if (this->AreApartAlong(direction, tolerance))
      {
        return true;
      }
    }
    return this->AreApartAlong(Cross(this->AlongR, this->AlongS), tolerance) ||
      this->AreApartAlong(Cross(this->Along, this->AlongR), tolerance) ||
      this->AreApartAlong(Cross(this->Along, this->AlongS), tolerance);
  }

  /// The same of a curve that is curved as the patch is. Dearer, and not tried on patches of high
  /// degree.
  bool AreApartAround(const CurvePatchCell& cell, double tolerance) const
  {
    constexpr int largest = 36;
    return this->IsBounded && this->PatchSize <= largest &&
      SeparatingQuadric(cell.Patch).Separates(cell.Curve, cell.Patch, tolerance);
  }

  /// Whether both lie between two planes along the patch that are not farther apart than that. A
  /// patch whose sides do not show its directions, because it closes on itself, say, has none
  /// unless it is as small as that itself.
  bool AreTogether(double tolerance) const
  {
    const Vector3 normal = Cross(this->AlongR, this->AlongS);
    const double size = Norm(this->AlongR) * Norm(this->AlongS);
    if (!this->IsBounded || !(Norm(normal) > tolerances::FlatNormal * size))
    {
      return this->IsBounded && SpreadOf(this->Curve, this->CurveSize) <= tolerance &&
        SpreadOf(this->Patch, this->PatchSize) <= tolerance;
    }
    Extent curve;
    Extent patch;
    curve.Add(this->Curve, this->CurveSize, normal);
    patch.Add(this->Patch, this->PatchSize, normal);
    return curve.LengthWith(patch) <= tolerance * Norm(normal);
  }

  /// 0: the curve is the largest; 1, 2: the patch is, along r or s.
  int Largest() const
  {
    const double sizes[3] = { SpreadOf(this->Curve, this->CurveSize),
      this->PatchSpread(this->AlongR, this->AlongS),
      this->PatchSpread(this->AlongS, this->AlongR) };
    return static_cast<int>(std::max_element(sizes, sizes + 3) - sizes);
  }

  Vector3 Along;
  Vector3 AlongR;
  Vector3 AlongS;

private:
  bool AreApartAlong(const Vector3& direction, double tolerance) const
  {
    Extent curve;
    Extent patch;
    curve.Add(this->Curve, this->CurveSize, direction);
    patch.Add(this->Patch, this->PatchSize, direction);
    return curve.IsApart(patch, tolerance * Norm(direction));
  }

  static double SpreadOf(const Vector3* points, int size)
  {
    double length = 0.0;
    for (int i = 1; i < size; ++i)
    {
      length += Norm(points[i] - points[i - 1]);
    }
    return length;
  }

  /// The patch's length along one of its edges; where that has none, its chordal deviation.
  double PatchSpread(const Vector3& along, const Vector3& other) const
  {
    const double length = Norm(along);
    return length > tolerances::LeastSide * Norm(other)
      ? length
      : 0.5 * SpreadOf(this->Patch, this->PatchSize) / this->PatchSize;
  }

  int CurveSize;
  int PatchSize;
  bool IsBounded;
  Vector3 Curve[MaximumDegree + 1];
  Vector3 Patch[(MaximumDegree + 1) * (MaximumDegree + 1)];
};

}

#endif
