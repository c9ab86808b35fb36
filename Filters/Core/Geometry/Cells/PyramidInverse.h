// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_PyramidInverse_h
#define skd_Geometry_Cells_PyramidInverse_h

#include "../Tolerances.h"
#include "InverseMap.h"
#include "LinearShapes.h"

namespace skd
{

/// The inverse of a pyramid's map. The line from the apex through x meets the base in at most two
/// points (r, s): two bilinear equations in these, a quadratic one in r. No iteration is needed but
/// to win back digits. Seen from the apex, x is w (E + r U + s V + r s W), with w = 1 - t.
template <>
class InverseMap<Pyramid>
{
public:
  InverseMap(const Vector3* points, const Vector3& x)
    : Y(x - points[4])
    , E(points[0] - points[4])
    , U(points[1] - points[0])
    , V(points[3] - points[0])
    , W((points[2] - points[1]) - V)
  {
    this->SolveBase();
  }

  /// Of the two points that nearer to the middle.
  Vector3 Guess() const
  {
    return this->FromMiddle(this->Positions[1]) < this->FromMiddle(this->Positions[0])
      ? this->Positions[1]
      : this->Positions[0];
  }

  std::optional<Vector3> Find(const Vector3& guess) const
  {
    const double tolerance = tolerances::Residual *
      (MaxNorm(this->Y) + MaxNorm(this->E) + MaxNorm(this->U) + MaxNorm(this->V) +
        MaxNorm(this->W));
    for (Vector3 p : { guess, this->Positions[0], this->Positions[1] })
    {
      for (int iteration = 0; iteration < 4; ++iteration)
      {
        if (MaxNorm(this->Residual(Pyramid::ClampToDomain(p))) <= tolerance)
        {
          return p;
        }
        p = this->Improved(p);
      }
    }
    return std::nullopt;
  }

private:
  static double FromMiddle(const Vector3& p) { return Distance2(p, Vector3{ { 0.5, 0.5, 0.5 } }); }

  Vector3 Base(double r, double s) const
  {
    return this->E + r * (this->U + s * this->W) + s * this->V;
  }

  Vector3 Residual(const Vector3& p) const
  {
    return (1.0 - p[2]) * this->Base(p[0], p[1]) - this->Y;
  }

  /// Newton's step in w, r w and s w: not singular at the apex.
  Vector3 Improved(const Vector3& p) const
  {
    const double w = 1.0 - p[2];
    const Matrix3 jacobian{ { this->E - p[0] * p[1] * this->W, this->U + p[1] * this->W,
      this->V + p[0] * this->W } };
    const Vector3 step = jacobian.Solve(this->Residual(p));
    const double next = w - step[0];
    return { { (p[0] * w - step[1]) / next, (p[1] * w - step[2]) / next, 1.0 - next } };
  }

  /// The base's points on the line from the apex through x: two components of their cross product
  /// with Y vanish, those without the greatest component of Y.
  void SolveBase()
  {
    const double size = MaxNorm(this->Y);
    if (!(size > 0.0))
    {
      this->Positions[0] = this->Positions[1] = { { 0.0, 0.0, 1.0 } };
      return;
    }
    int k = std::abs(this->Y[1]) > std::abs(this->Y[0]) ? 1 : 0;
    k = std::abs(this->Y[2]) > std::abs(this->Y[k]) ? 2 : k;
    const Bilinear first = this->Equation((k + 1) % 3, k);
    const Bilinear second = this->Equation((k + 2) % 3, k);
    const double c2 = first.R * second.RS - second.R * first.RS;
    const double c1 =
      first.One * second.RS - second.One * first.RS + first.R * second.S - second.R * first.S;
    const double c0 = first.One * second.S - second.One * first.S;
    const double root = std::sqrt(std::max(0.0, c1 * c1 - 4.0 * c2 * c0));
    const double q = -0.5 * (c1 + std::copysign(root, c1));
    this->Positions[0] = this->PointAt(c0 / q, first, second);
    this->Positions[1] = this->PointAt(q / c2, first, second);
  }

  /// One + r R + s S + r s RS = 0.
  struct Bilinear
  {
    double One, R, S, RS;
  };

  Bilinear Equation(int i, int k) const
  {
    const double share = this->Y[i] / this->Y[k];
    return { this->E[i] - share * this->E[k], this->U[i] - share * this->U[k],
      this->V[i] - share * this->V[k], this->W[i] - share * this->W[k] };
  }

  Vector3 PointAt(double r, const Bilinear& first, const Bilinear& second) const
  {
    const double below1 = first.S + r * first.RS;
    const double below2 = second.S + r * second.RS;
    const double s = std::abs(below1) > std::abs(below2) ? -(first.One + r * first.R) / below1
                                                         : -(second.One + r * second.R) / below2;
    const Vector3 base = this->Base(r, s);
    return { { r, s, 1.0 - Dot(this->Y, base) / Norm2(base) } };
  }

  Vector3 Y;
  Vector3 E;
  Vector3 U;
  Vector3 V;
  Vector3 W;
  Vector3 Positions[2];
};

}

#endif
