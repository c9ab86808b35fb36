// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_LeafFilters_QuantizationGrid_h
#define skd_LeafFilters_QuantizationGrid_h

#include "../Tree/Frame.h"

#include <cstdint>

namespace skd
{

/// A 16-bit integer grid over a leaf's box, in which coordinates are at most Largest. Cells much
/// smaller than the data set are thus represented as accurately as large ones, in a quarter of the
/// memory of doubles.
///
/// The unit is never below 2^-46 of the tree's frame, where double precision ends: there a position
/// is off by less than Slack besides the half unit that rounding costs.
class QuantizationGrid
{
public:
  static constexpr int Largest = 32767;
  static constexpr double Slack = 1.0 / 64.0;
  /// A corner, once rounded, is at most so far from its position, in each coordinate; in all, that
  /// is with sqrt(3).
  static constexpr double CornerError = 0.5 + Slack;
  static constexpr double CornerDistance = 0.9;

  QuantizationGrid() = default;

  explicit QuantizationGrid(const FloatBox<3>& box)
  {
    double half = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Centre[axis] = 0.5f * (box.Min[axis] + box.Max[axis]);
      half = std::max({ half, double(box.Max[axis]) - this->Centre[axis],
        double(this->Centre[axis]) - box.Min[axis] });
    }
    constexpr double least = 1.0 / (std::uint64_t(1) << 46);
    this->Unit = static_cast<float>(std::max(least, half / (Largest - 1)));
  }

  /// In units, of a position in the tree's frame.
  Vector3 Of(const Vector3& position) const
  {
    const double inverse = 1.0 / this->Unit;
    return { { inverse * (position[0] - this->Centre[0]), inverse * (position[1] - this->Centre[1]),
      inverse * (position[2] - this->Centre[2]) } };
  }

  static std::int16_t Round(double coordinate)
  {
    return static_cast<std::int16_t>(
      std::lrint(std::clamp(coordinate, -double(Largest), double(Largest))));
  }

  float Centre[3];
  float Unit;
};

}

#endif
