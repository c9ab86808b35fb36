// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Constructed points to some two hundred bits, with an error bound: between pairs of doubles
/// (ClosePoint.h) and exact numbers (ExactPoint.h), which have a thousand bits for crossings of
/// segments between crossings.
#ifndef skd_Predicates_LongPoint_h
#define skd_Predicates_LongPoint_h

#include "ExactPoint.h"

#include <algorithm>
#include <array>
#include <limits>

namespace skd
{

/// A point, each coordinate of which is known to within an error.
struct LongPoint
{
  std::array<BigNumber, 3> X;
  int Error = std::numeric_limits<int>::min() / 4; ///< below 2^(32 Error), as BigNumber::Top()

  explicit LongPoint(const ExactPoint& point)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Divide(point.X[axis], point.W, this->X[axis]);
    }
  }

private:
  /// Adds quotients in double precision, of what those before left.
  void Divide(BigNumber rest, const BigNumber& by, BigNumber& quotient)
  {
    constexpr int most = 4;
    for (int i = 0; i < most && rest.Sign() != 0; ++i)
    {
      const BigNumber part(BigNumber::Ratio(rest, by));
      quotient = quotient + part;
      rest = rest - part * by;
    }
    if (rest.Sign() != 0)
    {
      this->Error = std::max(this->Error, rest.Top() - by.Top() + 1);
    }
  }
};

/// The sign of the area of a, b, c as seen along an axis; 0: not known. Differences are wrong by
/// less than twice the error, and each of the two products by less than 2 * 2 * error * the largest
/// difference + 4 * error^2.
inline int LongOrient2D(const LongPoint& a, const LongPoint& b, const LongPoint& c, int axis)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const BigNumber ab[2] = { b.X[u] - a.X[u], b.X[v] - a.X[v] };
  const BigNumber ac[2] = { c.X[u] - a.X[u], c.X[v] - a.X[v] };
  const BigNumber area = ab[0] * ac[1] - ab[1] * ac[0];
  const int error = std::max({ a.Error, b.Error, c.Error });
  const int largest = std::max({ error, ab[0].Top(), ab[1].Top(), ac[0].Top(), ac[1].Top() });
  return area.Top() >= error + largest + 2 ? area.Sign() : 0;
}

}

#endif
