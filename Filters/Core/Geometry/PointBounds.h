// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_PointBounds_h
#define skd_Geometry_PointBounds_h

#include "Box.h"
#include "PointArray.h"
#include "TwoDoubles.h"

#include <cstddef>
#include <limits>

namespace skd
{

/// The box of points in space, none of which is NaN, two sides at a time. Least coordinates are
/// kept as the greatest of their negatives, so that all sides are found by one operation; they lie
/// in the order of a box: -x, -y; -z, x; y, z.
class PointBounds
{
public:
  /// Coordinates that lie one after the other.
  template <class Number>
  void Add(const Number* point)
  {
    const TwoDoubles xy = TwoDoubles::Read(point);
    const TwoDoubles yz = TwoDoubles::Read(point + 1);
    this->Sides[0] = Larger(this->Sides[0], TwoDoubles(-1.0) * xy);
    this->Sides[1] = Larger(this->Sides[1], TwoDoubles(-1.0, 1.0) * Between(yz, xy));
    this->Sides[2] = Larger(this->Sides[2], yz);
  }
  void Add(const Box3& box)
  {
    this->Add(box.Min.X);
    this->Add(box.Max.X);
  }
  template <class Id>
  void Add(const PointArray& points, const Id* ids, std::size_t number)
  {
    points.Floats ? this->AddAll(points.Floats, ids, number)
                  : this->AddAll(points.Doubles, ids, number);
  }

  Box3 Box() const
  {
    const TwoDoubles* s = this->Sides;
    return { { { -s[0].First(), -s[0].Second(), -s[1].First() } },
      { { s[1].Second(), s[2].First(), s[2].Second() } } };
  }

  const TwoDoubles* GetSides() const { return this->Sides; } ///< three pairs

private:
  template <class Number, class Id>
  void AddAll(const Number* coordinates, const Id* ids, std::size_t number)
  {
    for (std::size_t i = 0; i < number; ++i)
    {
      this->Add(coordinates + 3 * static_cast<std::size_t>(ids[i]));
    }
  }

  static constexpr double None = std::numeric_limits<double>::lowest();
  TwoDoubles Sides[3] = { TwoDoubles(None), TwoDoubles(None), TwoDoubles(None) };
};

}

#endif
