// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCurveJoints.h
 * @brief Joints at which curve cells continue each other.
 */

#ifndef SkdCurveJoints_h
#define SkdCurveJoints_h

#include "Core/Geometry/Vector.h"

#include <vector>

namespace skdtree
{
/// An end of an open curve.
struct SkdCurveEnd
{
  std::size_t Number; ///< 2 * curve, and 1 more where it ends
  skd::Vector3 X;
  skd::Vector3 Outward; ///< the direction in which the curve would go on, of any length
};

class SkdCurveJoints
{
public:
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  SkdCurveJoints() = default;

  /// Joins pairs of ends whose distance is at most `rounding`. If more than two coincide, pairs
  /// with the smallest angle, less than a right angle, are joined. More than 64 coincident ends are
  /// not joined. O(n log n).
  SkdCurveJoints(std::vector<SkdCurveEnd> ends, std::size_t numberOfCurves, double rounding);

  /// The number of the joint at the start or the end of a curve, or None.
  std::size_t At(std::size_t curve, bool atEnd) const
  {
    return this->Joints.empty() ? None : this->Joints[2 * curve + (atEnd ? 1 : 0)];
  }

private:
  void Join(std::vector<SkdCurveEnd>& group);

  std::vector<std::size_t> Joints;
  std::size_t Count = 0;
};
}

#endif
