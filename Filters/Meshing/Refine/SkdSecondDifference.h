// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSecondDifference.h
 * @brief The normalised second difference of a field in a box.
 *
 * R. Loehner, "An adaptive finite element scheme for transient problems in CFD", Comput. Methods
 * Appl. Mech. Eng. 61 (1987) 323-338, in the form for grids of B. Fryxell et al., Astrophys. J.
 * Suppl. 131 (2000) 273: the second differences along pairs of axes, by the first differences on
 * both sides and a part of the values themselves, so that ripples of small amplitude do not count.
 */

#ifndef SkdSecondDifference_h
#define SkdSecondDifference_h

#include "Core/Geometry/Box.h"

#include <cmath>

namespace skdtree
{
/// The second differences of a function on the points of a box: its centre and those half a side
/// from it along one or two axes.
template <class ValueAt>
class SkdSecondDifference
{
public:
  /// valueAt(x) is the value at a point, or NaN where there is none.
  SkdSecondDifference(const skd::Box3& box, const ValueAt& valueAt)
    : Middle(box.Centroid())
    , Half(0.5 * (box.Max - box.Min))
    , At(valueAt)
    , Centre(valueAt(this->Middle))
  {
  }

  /// 0 where the function is linear, at most 1; 0 if there are no values. Differences of points
  /// without a value do not count, nor do axes along which the box has no length. At most 19
  /// evaluations.
  double Find()
  {
    for (int p = 0; p < 3; ++p)
    {
      if (this->Half[p] > 0.0)
      {
        this->AddAlong(p);
        for (int q = 0; q < p; ++q)
        {
          this->AddMixed(p, q);
        }
      }
    }
    return this->Below > 0.0 ? std::sqrt(this->Above / this->Below) : 0.0;
  }

private:
  /// The share of the values that is added to the first differences, as in Fryxell et al.
  static constexpr double Filter = 0.01;

  double Value(int p, double s, int q, double t) const
  {
    skd::Vector3 x = this->Middle;
    x[p] += s * this->Half[p];
    x[q] += t * this->Half[q];
    return this->At(x);
  }

  void AddAlong(int axis)
  {
    const double before = this->Value(axis, -1.0, axis, 0.0);
    const double after = this->Value(axis, 1.0, axis, 0.0);
    this->Add((after - this->Centre) - (this->Centre - before),
      std::abs(after - this->Centre) + std::abs(this->Centre - before) +
        Filter * (std::abs(after) + 2.0 * std::abs(this->Centre) + std::abs(before)));
  }

  // The difference along one axis of that along the other is the same for both orders; the first
  // differences are not.
  void AddMixed(int p, int q)
  {
    if (!(this->Half[q] > 0.0))
    {
      return;
    }
    const double low[2] = { this->Value(p, -1.0, q, -1.0), this->Value(p, 1.0, q, -1.0) };
    const double high[2] = { this->Value(p, -1.0, q, 1.0), this->Value(p, 1.0, q, 1.0) };
    const double second = 0.25 * ((high[1] - high[0]) - (low[1] - low[0]));
    const double filter =
      0.25 * Filter * (std::abs(low[0]) + std::abs(low[1]) + std::abs(high[0]) + std::abs(high[1]));
    this->Add(second, 0.25 * (std::abs(high[1] - high[0]) + std::abs(low[1] - low[0])) + filter);
    this->Add(second, 0.25 * (std::abs(high[1] - low[1]) + std::abs(high[0] - low[0])) + filter);
  }

  void Add(double second, double first)
  {
    if (std::isfinite(second) && std::isfinite(first))
    {
      this->Above += second * second;
      this->Below += first * first;
    }
  }

  const skd::Vector3 Middle;
  const skd::Vector3 Half;
  const ValueAt& At;
  const double Centre;
  double Above = 0.0;
  double Below = 0.0;
};
}

#endif
