// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_CurvePairCell_h
#define skd_Curves_CurvePairCell_h

#include "CurvePair.h"
#include "SeparatingQuadric.h"

namespace skd
{

/// Parts of two curves that may meet.
struct CurvePairCell
{
  BezierCurve First;
  BezierCurve Second;
  Interval T{ 0.0, 1.0 };
  Interval S{ 0.0, 1.0 };
  int Depth = 0;
};

/// The control points of a cell in space, and the chords.
class CurvePairHulls
{
public:
  explicit CurvePairHulls(const CurvePairCell& cell)
    : Sizes{ cell.First.Degree + 1, cell.Second.Degree + 1 }
    , IsBounded(cell.First.IsInHull() && cell.Second.IsInHull())
  {
    for (int i = 0; i < this->Sizes[0]; ++i)
    {
      this->Points[0][i] = cell.First.Control(i);
    }
    for (int i = 0; i < this->Sizes[1]; ++i)
    {
      this->Points[1][i] = cell.Second.Control(i);
    }
    this->Chords[0] = cell.First.End() - cell.First.Start();
    this->Chords[1] = cell.Second.End() - cell.Second.Start();
  }

  /// Whether both are certainly farther apart than the tolerance.
  bool AreApart(double tolerance) const
  {
    const Vector3 across = Cross(this->Chords[0], this->Chords[1]);
    const Vector3 directions[6] = { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } }, across,
      Cross(this->Chords[0], across), Cross(this->Chords[1], across) };
    return this->IsBounded &&
      std::any_of(directions, directions + 6,
        [&](const Vector3& direction) { return this->AreApartAlong(direction, tolerance); });
  }

  /// The same of curves that are curved alike. Dearer.
  bool AreApartAround(const CurvePairCell& cell, double tolerance) const
  {
    return this->IsBounded &&
      SeparatingQuadric(cell.Second.At(0.5)).Separates(cell.First, cell.Second, tolerance);
  }

  /// Whether both lie in one tube of that width along the first.
  bool AreTogether(double tolerance) const
  {
    const Vector3 along = this->Chords[0];
    Vector3 axis{};
    const double sizes[3] = { std::abs(along[0]), std::abs(along[1]), std::abs(along[2]) };
    axis[static_cast<int>(std::min_element(sizes, sizes + 3) - sizes)] = 1.0;
    const Vector3 side = Cross(along, axis);
    if (!(Norm2(along) > 0.0)) // a part that ends where it begins has no direction
    {
      return this->IsBounded && this->Spread(0) <= tolerance && this->Spread(1) <= tolerance;
    }
    return this->IsBounded && this->WidthAlong(side) <= tolerance * Norm(side) &&
      this->WidthAlong(Cross(along, side)) <= tolerance * Norm(Cross(along, side));
  }

  bool Largest() const { return this->Spread(0) >= this->Spread(1); }

private:
  Extent ExtentOf(int which, const Vector3& direction) const
  {
    Extent extent;
    extent.Add(this->Points[which], this->Sizes[which], direction);
    return extent;
  }

  bool AreApartAlong(const Vector3& direction, double tolerance) const
  {
    return this->ExtentOf(0, direction)
      .IsApart(this->ExtentOf(1, direction), tolerance * Norm(direction));
  }

  double WidthAlong(const Vector3& direction) const
  {
    return this->ExtentOf(0, direction).LengthWith(this->ExtentOf(1, direction));
  }

  double Spread(int which) const
  {
    double length = 0.0;
    for (int i = 1; i < this->Sizes[which]; ++i)
    {
      length += Norm(this->Points[which][i] - this->Points[which][i - 1]);
    }
    return length;
  }

  int Sizes[2];
  bool IsBounded;
  Vector3 Points[2][MaximumDegree + 1];
  Vector3 Chords[2];
};

/// From the gap between two curves to the steps of both parameters that close it, as both run on
/// average; across both nothing closes it.
class PairInverse
{
public:
  explicit PairInverse(const CurvePairCell& cell)
    : Rows(Vector3{}, Vector3{}, Vector3{})
  {
    Vector3 sums[2] = {};
    int counts[2] = {};
    ForEachDerivative(cell,
      [&](int axis, const Vector3& coefficient)
      {
        sums[axis] = sums[axis] + coefficient;
        ++counts[axis];
      });
    this->Rows = CurvePair::Inverse((1.0 / counts[0]) * sums[0], (-1.0 / counts[1]) * sums[1]);
  }

  /// Krawczyk's test of the cell, of the two directions that the inverse sees.
  Contraction<2> ContractionOf(const CurvePairCell& cell, double tolerance) const
  {
    Contraction<2> contraction{};
    if (!this->Rows.IsRegular)
    {
      contraction.Spread[0] = contraction.Spread[1] = std::numeric_limits<double>::infinity();
      return contraction;
    }
    double most[2][2] = {};
    ForEachDerivative(cell,
      [&](int axis, const Vector3& coefficient)
      {
        for (int i = 0; i < 2; ++i)
        {
          const double off =
            std::abs(Dot(this->Rows.Rows[i], coefficient) - (i == axis ? 1.0 : 0.0));
          most[i][axis] = std::max(most[i][axis], off);
        }
      });
    const double middle[2] = { 0.5, 0.5 };
    this->Step(cell, middle, contraction.Step);
    contraction.Spread[0] = most[0][0] + most[0][1];
    contraction.Spread[1] = most[1][0] + most[1][1];
    const double weight = cell.First.WeightedAt(0.5)[3] * cell.Second.WeightedAt(0.5)[3];
    contraction.Slack[0] = tolerance * weight * Norm(this->Rows.Rows[0]);
    contraction.Slack[1] = tolerance * weight * Norm(this->Rows.Rows[1]);
    return contraction;
  }

  /// A simplified step of Newton's, in the cell's own parameters.
  void Step(const CurvePairCell& cell, const double (&at)[2], double (&step)[2]) const
  {
    const Vector3 gap = Combined(cell.First.WeightedAt(at[0]), cell.Second.WeightedAt(at[1]));
    step[0] = -Dot(this->Rows.Rows[0], gap);
    step[1] = -Dot(this->Rows.Rows[1], gap);
  }

private:
  /// First less second, without a division: a polynomial of both parameters.
  static Vector3 Combined(const Homogeneous& first, const Homogeneous& second)
  {
    return second[3] * Space(first) - first[3] * Space(second);
  }

  template <class Visit>
  static void ForEachDerivative(const CurvePairCell& cell, Visit visit)
  {
    const bool isRational = cell.First.IsRational() || cell.Second.IsRational();
    const int firsts = isRational ? cell.First.Degree + 1 : 1;
    const int seconds = isRational ? cell.Second.Degree + 1 : 1;
    for (int i = 0; i < cell.First.Degree; ++i)
    {
      const Homogeneous step = cell.First.Points[i + 1] - cell.First.Points[i];
      for (int j = 0; j < seconds; ++j)
      {
        visit(0, double(cell.First.Degree) * Combined(step, cell.Second.Points[j]));
      }
    }
    for (int j = 0; j < cell.Second.Degree; ++j)
    {
      const Homogeneous step = cell.Second.Points[j + 1] - cell.Second.Points[j];
      for (int i = 0; i < firsts; ++i)
      {
        visit(1, double(cell.Second.Degree) * Combined(cell.First.Points[i], step));
      }
    }
  }

  InverseRows Rows;
};

}

#endif
