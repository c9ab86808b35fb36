// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_BezierPatch_h
#define skd_Curves_BezierPatch_h

#include "BezierCurve.h"
#include "Tolerances.h"

namespace skd
{

/// A point of a patch and its derivatives along r and s.
struct SurfacePoint
{
  Vector3 X;
  Vector3 DR;
  Vector3 DS;

  Vector3 Normal() const { return Cross(this->DR, this->DS); }
};

/// A piece of a surface in Bernstein form, polynomial or rational, (r, s) in [0, 1]^2. A triangle
/// is such a piece of which only r + s <= 1 counts: a polynomial of that total degree is one of the
/// square, too.
struct BezierPatch
{
  int DegreeR = 1;
  int DegreeS = 1;
  bool IsTriangle = false;
  Homogeneous Points[(MaximumDegree + 1) * (MaximumDegree + 1)]; ///< r runs first

  BezierPatch() = default;
  BezierPatch(const BezierPatch& other) { *this = other; }
  // Copies only the points in use. NOLINTNEXTLINE(bugprone-unhandled-self-assignment)
  BezierPatch& operator=(const BezierPatch& other)
  {
    this->DegreeR = other.DegreeR;
    this->DegreeS = other.DegreeS;
    this->IsTriangle = other.IsTriangle;
    BezierCurve::Copy(other.Points, other.Size(), this->Points);
    return *this;
  }

  int Size() const { return (this->DegreeR + 1) * (this->DegreeS + 1); }
  Homogeneous& Point(int i, int j) { return this->Points[i + j * (this->DegreeR + 1)]; }
  const Homogeneous& Point(int i, int j) const { return this->Points[i + j * (this->DegreeR + 1)]; }
  Vector3 Corner(int r, int s) const
  {
    return Projected(this->Point(r * this->DegreeR, s * this->DegreeS));
  }

  bool IsRational() const
  {
    return std::any_of(this->Points, this->Points + this->Size(),
      [](const Homogeneous& point) { return point[3] != 1.0; });
  }

  bool IsInHull() const
  {
    return std::all_of(this->Points, this->Points + this->Size(),
      [](const Homogeneous& point) { return point[3] > 0.0; });
  }

  /// Any (r, s), also beyond the patch. O(DegreeR^2 DegreeS).
  SurfacePoint At(double r, double s) const
  {
    BezierCurve across; // the points at r, and their derivatives along r
    BezierCurve slopes;
    across.Degree = slopes.Degree = this->DegreeS;
    for (int j = 0; j <= this->DegreeS; ++j)
    {
      EvaluateRow(&this->Point(0, j), this->DegreeR, r, across.Points[j], slopes.Points[j]);
    }
    Homogeneous x;
    Homogeneous alongS;
    Homogeneous alongR;
    Homogeneous unused;
    EvaluateRow(across.Points, this->DegreeS, s, x, alongS);
    EvaluateRow(slopes.Points, this->DegreeS, s, alongR, unused);
    const double scale = 1.0 / x[3];
    SurfacePoint point;
    point.X = scale * Space(x);
    point.DR = scale * (Space(alongR) - alongR[3] * point.X);
    point.DS = scale * (Space(alongS) - alongS[3] * point.X);
    return point;
  }

  Homogeneous WeightedAt(double r, double s) const
  {
    BezierCurve across;
    across.Degree = this->DegreeS;
    for (int j = 0; j <= this->DegreeS; ++j)
    {
      Homogeneous unused;
      EvaluateRow(&this->Point(0, j), this->DegreeR, r, across.Points[j], unused);
    }
    return across.WeightedAt(s);
  }

  /// Keeps the part of r in [0, 1/2] and gives the other.
  BezierPatch SplitOffR()
  {
    BezierPatch other = *this;
    for (int j = 0; j <= this->DegreeS; ++j)
    {
      Halve(&this->Point(0, j), &other.Point(0, j), this->DegreeR, 1);
    }
    return other;
  }

  BezierPatch SplitOffS()
  {
    BezierPatch other = *this;
    for (int i = 0; i <= this->DegreeR; ++i)
    {
      Halve(&this->Point(i, 0), &other.Point(i, 0), this->DegreeS, this->DegreeR + 1);
    }
    return other;
  }

  Box3 Bounds() const
  {
    Box3 box;
    for (int i = 0; i < this->Size(); ++i)
    {
      box.Add(Projected(this->Points[i]));
    }
    return box;
  }

private:
  static void EvaluateRow(
    const Homogeneous* points, int degree, double t, Homogeneous& value, Homogeneous& slope)
  {
    Homogeneous level[MaximumDegree + 1];
    BezierCurve::Copy(points, degree + 1, level);
    for (int i = degree; i > 1; --i)
    {
      for (int k = 0; k < i; ++k)
      {
        level[k] = Lerp(level[k], level[k + 1], t);
      }
    }
    slope = double(degree) * (level[1] - level[0]);
    value = Lerp(level[0], level[1], t);
  }

  /// `low` keeps the points of the first half, `high`, which holds the same, those of the second.
  static void Halve(Homogeneous* low, Homogeneous* high, int degree, int stride)
  {
    for (int i = 0; i <= degree; ++i)
    {
      low[i * stride] = high[0];
      for (int k = 0; k < degree - i; ++k)
      {
        high[k * stride] = 0.5 * (high[k * stride] + high[(k + 1) * stride]);
      }
    }
  }
};

/// A box that holds the patch, of a triangle only the part that counts: its control points beyond
/// the long side need not be near it, those of its halves' halves that have a part in it are.
inline Box3 BoundsOnDomain(
  const BezierPatch& patch, double r = 0.0, double s = 0.0, double size = 1.0)
{
  constexpr double least = 1.0 / 16.0;
  const bool isWhole = !patch.IsTriangle || r + s + 2.0 * size <= 1.0;
  if (patch.IsInHull() && (isWhole || size <= least || patch.Size() == 4))
  {
    return patch.Bounds();
  }
  Box3 box;
  if (r + s >= 1.0 || size < tolerances::LeastPart)
  {
    return box;
  }
  BezierPatch parts[4];
  parts[0] = patch;
  parts[1] = parts[0].SplitOffR();
  parts[2] = parts[0].SplitOffS();
  parts[3] = parts[1].SplitOffS();
  for (int i = 0; i < 4; ++i)
  {
    box.Add(
      BoundsOnDomain(parts[i], r + 0.5 * size * (i & 1), s + 0.5 * size * (i >> 1), 0.5 * size));
  }
  return box;
}

}

#endif
