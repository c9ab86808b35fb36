// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Sieves_PlaneRow_h
#define skd_Sieves_PlaneRow_h

#include "../Tree/Lanes.h"
#include "Raster.h"

namespace skd
{

/// A plane for each of eight cells that has the whole cell on one side: Normal . x is at most
/// Offset * OffsetUnit there, on the raster. Normals are whole numbers, and no error: with each
/// goes the offset that it needs.
struct alignas(64) PlaneRow
{
  static constexpr int Width = 8;
  static constexpr double OffsetUnit = 4.0 * Raster::Reach; ///< no product is greater
  /// A margin, in units, above what rounding does to corners, to a point and in MayHold().
  static constexpr double Rounding = 0.25;

  std::int16_t Normal[3][Width] = {};
  std::int16_t Offset[Width] = {}; // 0 . x <= 0: until it is set, a plane excludes nothing

  /// The plane along a face of what the points (on the raster) span, beside them all and `margin`
  /// away from them, given a direction across it, either way, and a point of it: outward is where
  /// the points reach less far from there. A direction without length excludes nothing.
  void SetAlongFace(int lane, const Vector3& across, const Vector3& onFace, const Vector3* points,
    int count, double margin)
  {
    Vector3 normal;
    if (!RoundToNormal(across, normal))
    {
      return;
    }
    const Heights heights = HeightsAlong(normal, points, count);
    const double height = Dot(normal, onFace);
    if (heights.Most - height > height - heights.Least)
    {
      this->Put(lane, -1.0 * normal, -heights.Least, margin);
      return;
    }
    this->Put(lane, normal, heights.Most, margin);
  }

  /// Bit i: x, which is within the raster's reach, may be in the cell of lane i.
  SKD_IN_ONE_PIECE unsigned MayHold(const float* x) const
  {
    unsigned held = 0;
    for (int first = 0; first < Width; first += NativeWidth)
    {
      using L = Lanes<NativeWidth>;
      const auto normal = [&](int axis) { return L::LoadShorts(this->Normal[axis] + first); };
      const L height = normal(0) * L(x[0]) + normal(1) * L(x[1]) + normal(2) * L(x[2]);
      const L offset = L::LoadShorts(this->Offset + first) * L(float(OffsetUnit));
      held |= LessEqual(height, offset) << first;
    }
    return held;
  }

private:
  struct Heights
  {
    double Least;
    double Most;
  };

  static Heights HeightsAlong(const Vector3& normal, const Vector3* points, int count)
  {
    Heights heights{ std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest() };
    for (int i = 0; i < count; ++i)
    {
      const double height = Dot(normal, points[i]);
      heights.Least = std::min(heights.Least, height);
      heights.Most = std::max(heights.Most, height);
    }
    return heights;
  }

  /// False of a direction without length.
  static bool RoundToNormal(const Vector3& direction, Vector3& normal)
  {
    const double largest =
      std::max({ std::abs(direction[0]), std::abs(direction[1]), std::abs(direction[2]) });
    if (!(largest > 0.0 && std::isfinite(largest)))
    {
      return false;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      normal[axis] = Raster::Round(direction[axis] / largest * Raster::Reach);
    }
    return true;
  }

  void Put(int lane, const Vector3& normal, double most, double margin)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Normal[axis][lane] = static_cast<std::int16_t>(normal[axis]);
    }
    const double needed = std::ceil((most + Norm(normal) * margin) / OffsetUnit);
    this->Offset[lane] =
      static_cast<std::int16_t>(std::clamp<double>(needed, -Raster::Reach, Raster::Reach));
  }
};

}

#endif
