// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_BernsteinPart_h
#define skd_Geometry_Cells_BernsteinPart_h

#include "BernsteinLayout.h"

#include <algorithm>
#include <limits>

namespace skd
{

/// The least and the largest of some numbers.
struct NumberRange
{
  double Min = std::numeric_limits<double>::max();
  double Max = std::numeric_limits<double>::lowest();

  void Add(double x)
  {
    this->Min = std::min(this->Min, x);
    this->Max = std::max(this->Max, x);
  }
  double Middle() const { return 0.5 * (this->Min + this->Max); }
  double Radius() const { return 0.5 * (this->Max - this->Min); }
  double Size() const { return std::max(std::abs(this->Min), std::abs(this->Max)); }
};

/// A polynomial on a part of its domain: the points Origin + u[0] Legs[0] + ..., u in the layout's
/// domain. It is never less than the least of its coefficients. These belong to the caller. There
/// may be several polynomials, those of a map: what asks for bounds looks at the first one.
struct BernsteinPart
{
  BernsteinLayout Layout;
  Vector3 Origin{};
  Vector3 Legs[3] = {};
  double* Values = nullptr;
  int Count = 1; ///< of polynomials: the coefficients of one, all Layout.Size, after another's

  NumberRange Range() const
  {
    NumberRange range;
    this->Layout.ForEachRow(0,
      [&](int offset, int degree, const int(&)[3])
      {
        for (int i = 0; i <= degree; ++i)
        {
          range.Add(this->Values[offset + i]);
        }
      });
    return range;
  }

  /// The differences along an axis: where none is negative the polynomial does not decrease.
  NumberRange Differences(int axis) const
  {
    NumberRange range;
    const int stride = this->Layout.Stride[axis];
    this->Layout.ForEachRow(axis,
      [&](int offset, int degree, const int(&)[3])
      {
        const double* row = this->Values + offset;
        for (int i = 0; i < degree; ++i)
        {
          range.Add(row[(i + 1) * stride] - row[i * stride]);
        }
      });
    return range;
  }

  /// Bounds of a second derivative along legs.
  NumberRange SecondDerivatives(int a, int b) const
  {
    return a == b ? this->PureDerivatives(a) : this->MixedDerivatives(a, b);
  }

  /// Exchanges the origin and the end of a leg.
  void Reverse(int axis)
  {
    const int stride = this->Layout.Stride[axis];
    this->ForEachRow(axis,
      [&](int offset, int degree)
      {
        double* row = this->Values + offset;
        for (int i = 0; 2 * i < degree; ++i)
        {
          std::swap(row[i * stride], row[(degree - i) * stride]);
        }
      });
    this->MoveOrigin(axis);
  }

  /// Keeps only what does not go along an axis, of a single polynomial.
  void Collapse(int axis)
  {
    const BernsteinLayout next = this->Layout.Without(axis);
    const int strides[2] = { this->Layout.Stride[axis == 0 ? 1 : 0],
      this->Layout.Stride[axis == 2 ? 1 : 2] };
    next.ForEachRow(0,
      [&](int offset, int degree, const int(&index)[3])
      {
        for (int i = 0; i <= degree; ++i)
        {
          this->Values[offset + i] = this->Values[i * strides[0] + index[1] * strides[1]];
        }
      });
    for (int i = axis; i < 2; ++i)
    {
      this->Legs[i] = this->Legs[i + 1];
    }
    this->Layout = next;
  }

  /// Keeps the half at the origin. `other` has room for as many values and gets that at the end of
  /// the leg, which becomes its origin.
  void SplitOff(int axis, BernsteinPart& other)
  {
    double* const room = other.Values;
    other = *this;
    other.Values = room;
    const int stride = this->Layout.Stride[axis];
    this->ForEachRow(axis,
      [&](int offset, int degree)
      { Halve(this->Values + offset, other.Values + offset, degree, stride); });
    other.MoveOrigin(axis);
    this->Legs[axis] = 0.5 * this->Legs[axis];
    other.Legs[axis] = 0.5 * other.Legs[axis];
  }

private:
  /// visit(offset, degree) for each row of each polynomial.
  template <class Visit>
  void ForEachRow(int axis, const Visit& visit) const
  {
    this->Layout.ForEachRow(axis,
      [&](int offset, int degree, const int(&)[3])
      {
        for (int i = 0; i < this->Count; ++i)
        {
          visit(offset + i * this->Layout.Size, degree);
        }
      });
  }

  void MoveOrigin(int axis)
  {
    const Vector3 leg = this->Legs[axis];
    this->Origin = this->Origin + leg;
    for (int i = 0; i < this->Layout.Dimension; ++i)
    {
      this->Legs[i] = this->Layout.AreInSimplex(i, axis) ? this->Legs[i] - leg : this->Legs[i];
    }
    this->Legs[axis] = -1.0 * leg;
  }

  /// By de Casteljau's scheme; the half at the far end in reverse order.
  static void Halve(double* low, double* high, int degree, int stride)
  {
    double level[HighestSquareDegree + 1];
    for (int i = 0; i <= degree; ++i)
    {
      level[i] = low[i * stride];
    }
    for (int i = 0; i <= degree; ++i)
    {
      low[i * stride] = level[0];
      high[i * stride] = level[degree - i];
      for (int k = 0; k < degree - i; ++k)
      {
        level[k] = 0.5 * (level[k] + level[k + 1]);
      }
    }
  }

  static NumberRange Times(double factor, const NumberRange& range)
  {
    return range.Min > range.Max ? NumberRange{ 0.0, 0.0 }
                                 : NumberRange{ factor * range.Min, factor * range.Max };
  }

  NumberRange PureDerivatives(int axis) const
  {
    NumberRange range;
    const int n = this->Layout.Degree[axis];
    const int stride = this->Layout.Stride[axis];
    this->Layout.ForEachRow(axis,
      [&](int offset, int degree, const int(&)[3])
      {
        const double* row = this->Values + offset;
        for (int i = 0; i + 2 <= degree; ++i)
        {
          range.Add((row[(i + 2) * stride] - row[(i + 1) * stride]) -
            (row[(i + 1) * stride] - row[i * stride]));
        }
      });
    return Times(n * (n - 1.0), range);
  }

  NumberRange MixedDerivatives(int a, int b) const
  {
    NumberRange range;
    const bool isSimplex = this->Layout.AreInSimplex(a, b);
    const int strides[2] = { this->Layout.Stride[a], this->Layout.Stride[b] };
    this->Layout.ForEachRow(a,
      [&](int offset, int degree, const int(&index)[3])
      {
        const int last = isSimplex ? degree - 2 : degree - 1;
        for (int i = 0; i <= last && (isSimplex || index[b] < this->Layout.Degree[b]); ++i)
        {
          const double* at = this->Values + offset + i * strides[0];
          range.Add((at[strides[0] + strides[1]] - at[strides[0]]) - (at[strides[1]] - at[0]));
        }
      });
    const int n = this->Layout.Degree[a];
    return Times(n * (isSimplex ? n - 1.0 : double(this->Layout.Degree[b])), range);
  }
};

}

#endif
