// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_TetrahedronInverse_h
#define skd_Geometry_Cells_TetrahedronInverse_h

#include "../Predicates/TripleProduct.h"
#include "../Tolerances.h"
#include "InverseMap.h"
#include "LinearShapes.h"

namespace skd
{

/// The inverse of a tetrahedron's map: six times the signed volumes of the tetrahedra that x makes
/// with the faces are the weights of the points, before they are divided by their sum.
template <>
class InverseMap<Tetrahedron>
{
public:
  InverseMap(const Vector3* points, const Vector3& x)
    : A(points[0] - x)
    , B(points[1] - x)
    , C(points[2] - x)
    , D(points[3] - x)
  {
    const Vector3 ab = Cross(this->A, this->B);
    const Vector3 cd = Cross(this->C, this->D);
    this->Volumes = { Dot(this->B, cd), -Dot(this->A, cd), Dot(this->D, ab), -Dot(this->C, ab) };
  }

  Vector3 Guess() const { return this->Volumes.PCoords(); }

  /// Where rounding may have changed a sign, or the weights, the volumes are computed anew, with
  /// twice the digits.
  std::optional<Vector3> Find(const Vector3& guess) const
  {
    const double size = std::max(
      std::max(MaxNorm(this->A), MaxNorm(this->B)), std::max(MaxNorm(this->C), MaxNorm(this->D)));
    const double cube = size * size * size;
    const double rounding = tolerances::Volume * cube;
    const bool isCertain = this->Volumes.Least() > rounding || this->Volumes.Most() < -rounding;
    if (isCertain &&
      (std::abs(this->Volumes.Sum()) > 0.01 * cube ||
        MaxNorm(this->PointAt(guess)) <= tolerances::Residual * size))
    {
      return guess;
    }
    const FourVolumes volumes = this->AccurateVolumes();
    const double zero = tolerances::AccurateVolume * cube;
    const bool isInside = (volumes.Least() >= -zero && volumes.Most() > 4.0 * zero) ||
      (volumes.Most() <= zero && volumes.Least() < -4.0 * zero);
    return isInside ? std::optional<Vector3>(volumes.PCoords()) : std::nullopt;
  }

private:
  /// Relative to x.
  Vector3 PointAt(const Vector3& p) const
  {
    return (1.0 - p[0] - p[1] - p[2]) * this->A + p[0] * this->B + p[1] * this->C + p[2] * this->D;
  }

  struct FourVolumes
  {
    double A, B, C, D;

    double Sum() const { return this->A + this->B + (this->C + this->D); }

    Vector3 PCoords() const
    {
      const double scale = 1.0 / this->Sum();
      return { { scale * this->B, scale * this->C, scale * this->D } };
    }

    double Least() const
    {
      return std::min(std::min(this->A, this->B), std::min(this->C, this->D));
    }
    double Most() const { return std::max(std::max(this->A, this->B), std::max(this->C, this->D)); }
  };

  FourVolumes AccurateVolumes() const
  {
    return { AccurateTripleProduct(this->B, this->C, this->D),
      -AccurateTripleProduct(this->A, this->C, this->D),
      AccurateTripleProduct(this->D, this->A, this->B),
      -AccurateTripleProduct(this->C, this->A, this->B) };
  }

  Vector3 A;
  Vector3 B;
  Vector3 C;
  Vector3 D;
  FourVolumes Volumes;
};

}

#endif
