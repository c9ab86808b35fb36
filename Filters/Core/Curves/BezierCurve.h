// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_BezierCurve_h
#define skd_Curves_BezierCurve_h

#include "../Geometry/Segment.h"

#include <algorithm>
#include <vector>

namespace skd
{

/// The highest degree of a piece of a curve, and of a patch along either parameter: VTK's own
/// limit.
constexpr int MaximumDegree = 10;

/// (w x, w y, w z, w): a point with a weight.
using Homogeneous = Vector<4>;

inline Homogeneous Weighted(const Vector3& point, double weight)
{
  return { { weight * point[0], weight * point[1], weight * point[2], weight } };
}

/// What is left of a homogeneous point without its weight.
inline Vector3 Space(const Homogeneous& point)
{
  return { { point[0], point[1], point[2] } };
}

inline Vector3 Projected(const Homogeneous& point)
{
  return (1.0 / point[3]) * Space(point);
}

/// The point moved.
inline Homogeneous Shifted(const Homogeneous& point, const Vector3& shift)
{
  return point +
    Homogeneous{ { point[3] * shift[0], point[3] * shift[1], point[3] * shift[2], 0.0 } };
}

/// A point of a curve and its derivatives.
struct CurvePoint
{
  Vector3 X;
  Vector3 D1;
  Vector3 D2;
};

/// A piece of a curve in Bernstein form, polynomial or rational, t in [0, 1]. It lies in the convex
/// hull of its control points when all weights are positive.
struct BezierCurve
{
  int Degree = 1;
  Homogeneous Points[MaximumDegree + 1];

  static BezierCurve Line(const Vector3& a, const Vector3& b)
  {
    BezierCurve line;
    line.Points[0] = Weighted(a, 1.0);
    line.Points[1] = Weighted(b, 1.0);
    return line;
  }

  bool IsLine() const { return this->Degree == 1 && !this->IsRational(); }

  bool IsRational() const
  {
    return std::any_of(this->Points, this->Points + this->Degree + 1,
      [](const Homogeneous& point) { return point[3] != 1.0; });
  }

  /// Whether the control points' convex hull holds the curve.
  bool IsInHull() const
  {
    return std::all_of(this->Points, this->Points + this->Degree + 1,
      [](const Homogeneous& point) { return point[3] > 0.0; });
  }

  Vector3 Control(int i) const { return Projected(this->Points[i]); }
  Vector3 Start() const { return this->Control(0); }
  Vector3 End() const { return this->Control(this->Degree); }

  /// By de Casteljau's scheme: O(Degree^2). Any t, also beyond [0, 1].
  CurvePoint At(double t) const
  {
    Homogeneous level[MaximumDegree + 1];
    Copy(this->Points, this->Degree + 1, level);
    Homogeneous second{};
    for (int i = this->Degree; i > 0; --i)
    {
      if (i == 2)
      {
        second = double(this->Degree * (this->Degree - 1)) *
          ((level[2] - level[1]) - (level[1] - level[0]));
      }
      if (i > 1)
      {
        Step(level, i, t);
      }
    }
    const Homogeneous first = double(this->Degree) * (level[1] - level[0]);
    return Derived(Lerp(level[0], level[1], t), first, second);
  }

  Homogeneous WeightedAt(double t) const
  {
    Homogeneous level[MaximumDegree + 1];
    Copy(this->Points, this->Degree + 1, level);
    for (int i = this->Degree; i > 0; --i)
    {
      Step(level, i, t);
    }
    return level[0];
  }

  /// The piece on [from, to], with parameters of its own.
  BezierCurve Restricted(double from, double to) const
  {
    BezierCurve part = *this;
    if (to != 1.0)
    {
      part.CutTo(to);
    }
    if (from != 0.0)
    {
      part.CutFrom(from / to);
    }
    return part;
  }

  /// As std::copy, of which GCC 12 fears that the size might be negative.
  static void Copy(const Homogeneous* from, int size, Homogeneous* to)
  {
    for (int i = 0; i < size; ++i)
    {
      to[i] = from[i];
    }
  }

  /// The box of the control points.
  Box3 Bounds() const
  {
    Box3 box;
    for (int i = 0; i <= this->Degree; ++i)
    {
      box.Add(this->Control(i));
    }
    return box;
  }

private:
  static void Step(Homogeneous* level, int size, double t)
  {
    for (int k = 0; k < size; ++k)
    {
      level[k] = Lerp(level[k], level[k + 1], t);
    }
  }

  static CurvePoint Derived(
    const Homogeneous& point, const Homogeneous& first, const Homogeneous& second)
  {
    const double scale = 1.0 / point[3];
    CurvePoint derived;
    derived.X = scale * Space(point);
    derived.D1 = scale * (Space(first) - first[3] * derived.X);
    derived.D2 = scale * (Space(second) - 2.0 * first[3] * derived.D1 - second[3] * derived.X);
    return derived;
  }

  void CutTo(double t)
  {
    for (int i = 1; i <= this->Degree; ++i)
    {
      for (int k = this->Degree; k >= i; --k)
      {
        this->Points[k] = Lerp(this->Points[k - 1], this->Points[k], t);
      }
    }
  }

  void CutFrom(double t)
  {
    for (int i = this->Degree; i > 0; --i)
    {
      Step(this->Points, i, t);
    }
  }
};

/// Appends the halves of a cell of two curves, First and Second, that are parts T and S of others:
/// either curve is halved.
template <class Cell>
void PushHalves(const Cell& cell, bool isFirst, std::vector<Cell>& cells)
{
  Cell low = cell;
  Cell high = cell;
  if (isFirst)
  {
    low.T.Max = high.T.Min = 0.5 * (cell.T.Min + cell.T.Max);
    low.First = cell.First.Restricted(0.0, 0.5);
    high.First = cell.First.Restricted(0.5, 1.0);
  }
  else
  {
    low.S.Max = high.S.Min = 0.5 * (cell.S.Min + cell.S.Max);
    low.Second = cell.Second.Restricted(0.0, 0.5);
    high.Second = cell.Second.Restricted(0.5, 1.0);
  }
  cells.push_back(low);
  cells.push_back(high);
}

}

#endif
