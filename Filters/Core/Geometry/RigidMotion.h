// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_RigidMotion_h
#define skd_Geometry_RigidMotion_h

#include "Box.h"
#include "Tolerances.h"

#include <optional>

namespace skd
{

/// x -> Rows x + Shift, Rows orthonormal: a rotation or reflection, and a translation. Distances
/// are preserved, so a tree needs no rebuild if its whole set moves (section 2).
struct RigidMotion
{
  Vector3 Rows[3];
  Vector3 Shift;

  /// From a row-major 4 x 4 matrix; empty unless it is rigid to 1e-9.
  static std::optional<RigidMotion> FromMatrix(const double matrix[16])
  {
    RigidMotion motion;
    for (int i = 0; i < 3; ++i)
    {
      motion.Rows[i] = { { matrix[4 * i], matrix[4 * i + 1], matrix[4 * i + 2] } };
      motion.Shift[i] = matrix[4 * i + 3];
    }
    constexpr double tolerance = tolerances::Orthonormal;
    const bool isAffine = matrix[12] == 0.0 && matrix[13] == 0.0 && matrix[14] == 0.0 &&
      matrix[15] == 1.0 && IsFinite(motion.Shift);
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j <= i; ++j)
      {
        const double product = Dot(motion.Rows[i], motion.Rows[j]);
        if (!(isAffine && std::abs(product - (i == j ? 1.0 : 0.0)) <= tolerance))
        {
          return std::nullopt;
        }
      }
    }
    return motion;
  }

  Vector3 Rotate(const Vector3& direction) const
  {
    return { { Dot(this->Rows[0], direction), Dot(this->Rows[1], direction),
      Dot(this->Rows[2], direction) } };
  }
  Vector3 RotateBack(const Vector3& direction) const
  {
    return direction[0] * this->Rows[0] + direction[1] * this->Rows[1] +
      direction[2] * this->Rows[2];
  }

  Vector3 Forward(const Vector3& x) const { return this->Rotate(x) + this->Shift; }
  Vector3 Back(const Vector3& x) const { return this->RotateBack(x - this->Shift); }

  /// The bounds of the moved box, and of the box moved back.
  Box3 Forward(const Box3& box) const
  {
    return Around(this->Forward(box.Centroid()), this->HalfExtent(box, &RigidMotion::Rotate));
  }
  Box3 Back(const Box3& box) const
  {
    return Around(this->Back(box.Centroid()), this->HalfExtent(box, &RigidMotion::RotateBack));
  }

private:
  using Turning = Vector3 (RigidMotion::*)(const Vector3&) const;

  /// Half lengths of the rotated box: the magnitudes of the rotated half edges, added up.
  Vector3 HalfExtent(const Box3& box, Turning rotation) const
  {
    Vector3 half{ { 0.0, 0.0, 0.0 } };
    for (int axis = 0; axis < 3; ++axis)
    {
      Vector3 edge{ { 0.0, 0.0, 0.0 } };
      edge[axis] = 0.5 * box.Length(axis);
      const Vector3 rotated = (this->*rotation)(edge);
      for (int i = 0; i < 3; ++i)
      {
        half[i] += std::abs(rotated[i]);
      }
    }
    return half;
  }

  static Box3 Around(const Vector3& centre, const Vector3& half)
  {
    return { centre - half, centre + half };
  }
};

/// The motion that first does `first`, then `second`.
inline RigidMotion Compose(const RigidMotion& second, const RigidMotion& first)
{
  RigidMotion both;
  for (int i = 0; i < 3; ++i)
  {
    both.Rows[i] = first.RotateBack(second.Rows[i]);
  }
  both.Shift = second.Forward(first.Shift);
  return both;
}

inline RigidMotion Inverse(const RigidMotion& motion)
{
  RigidMotion inverse;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      inverse.Rows[i][j] = motion.Rows[j][i];
    }
  }
  inverse.Shift = -1.0 * motion.RotateBack(motion.Shift);
  return inverse;
}

}

#endif
