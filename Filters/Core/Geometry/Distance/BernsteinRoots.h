// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where on [0, 1] a polynomial rises through zero, from its Bernstein coefficients.
///
/// The coefficients change sign at least as often as the polynomial; where they do so once there is
/// one root, where they never do there is none, and halving the interval leads to one or the other.
#ifndef skd_Geometry_Distance_BernsteinRoots_h
#define skd_Geometry_Distance_BernsteinRoots_h

#include "../Tolerances.h"

#include <cmath>

namespace skd
{

/// A polynomial of degree N on [Min, Max]: its coefficients in the Bernstein basis of that
/// interval.
template <int N>
struct BernsteinPolynomial
{
  double Coefficients[N + 1];
  double Min = 0.0;
  double Max = 1.0;

  double At(double share) const { return this->Min + share * (this->Max - this->Min); }

  /// How often the coefficients change sign, and whether the first of them that is not 0 is below.
  int SignChanges(bool& beginsBelow) const
  {
    int changes = 0;
    double last = 0.0;
    for (const double coefficient : this->Coefficients)
    {
      if (coefficient != 0.0)
      {
        const double sign = coefficient < 0.0 ? -1.0 : 1.0;
        changes += last * sign < 0.0 ? 1 : 0;
        beginsBelow = last == 0.0 ? sign < 0.0 : beginsBelow;
        last = sign;
      }
    }
    return changes;
  }

  /// By de Casteljau's scheme: this keeps the left half, the right half is returned.
  BernsteinPolynomial SplitOffRight()
  {
    BernsteinPolynomial right(*this);
    for (int i = 0; i <= N; ++i)
    {
      this->Coefficients[i] = right.Coefficients[0];
      for (int k = 0; k < N - i; ++k)
      {
        right.Coefficients[k] = 0.5 * right.Coefficients[k] + 0.5 * right.Coefficients[k + 1];
      }
    }
    this->Max = right.Min = this->At(0.5);
    return right;
  }

  /// Value and slope at a share of the interval.
  void Evaluate(double share, double& value, double& slope) const
  {
    double level[N + 1];
    for (int i = 0; i <= N; ++i)
    {
      level[i] = this->Coefficients[i];
    }
    for (int i = N; i > 1; --i)
    {
      for (int k = 0; k < i; ++k)
      {
        level[k] += share * (level[k + 1] - level[k]);
      }
    }
    slope = N * (level[1] - level[0]);
    value = level[0] + share * (level[1] - level[0]);
  }

  /// The root when there is but one and the polynomial rises there: Newton's steps, kept in bounds.
  double OnlyRisingRoot() const
  {
    double below = 0.0;
    double above = 1.0;
    double share = 0.5;
    for (int iteration = 0; iteration < 60; ++iteration)
    {
      double value;
      double slope;
      this->Evaluate(share, value, slope);
      const double newton = share - value / slope;
      if (value == 0.0 || std::abs(newton - share) <= tolerances::PolynomialRoot)
      {
        break;
      }
      (value < 0.0 ? below : above) = share;
      share = newton > below && newton < above ? newton : 0.5 * (below + above);
    }
    return this->At(share);
  }
};

/// Calls visit(t) for each t in [0, 1] where the polynomial rises through zero. Roots closer to
/// each other than about 1e-8 may be visited as one.
template <int N, class Visit>
void VisitRisingRoots(const BernsteinPolynomial<N>& polynomial, Visit&& visit)
{
  constexpr int depthLimit = 27;
  BernsteinPolynomial<N> stack[depthLimit + 2];
  int depths[depthLimit + 2] = { 0 };
  stack[0] = polynomial;
  for (int size = 1; size > 0;)
  {
    BernsteinPolynomial<N>& part = stack[--size];
    bool beginsBelow = false;
    const int changes = part.SignChanges(beginsBelow);
    if (changes == 1 && beginsBelow)
    {
      visit(part.OnlyRisingRoot());
    }
    else if (changes > 1 && depths[size] == depthLimit)
    {
      visit(part.At(0.5));
    }
    else if (changes > 1)
    {
      stack[size + 1] = part.SplitOffRight();
      depths[size + 1] = ++depths[size];
      size += 2;
    }
  }
}

}

#endif
