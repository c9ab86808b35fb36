// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exact orientation tests: a floating-point filter decides nearly always, exact expansions decide
/// the rest (J. R. Shewchuk, Discrete & Computational Geometry 18 (1997) 305-363). Exact as long as
/// no product of three differences over- or underflows: coordinates, unless 0, of a magnitude
/// within 1e-80 .. 1e100. NaN gives 0.
#ifndef skd_Predicates_Orient3D_h
#define skd_Predicates_Orient3D_h

#include "../Tolerances.h"
#include "../TwoDoubles.h"
#include "Expansion.h"

#include <array>
#include <limits>

namespace skd
{

namespace detail
{

inline int SignOf(double value)
{
  return (value > 0.0) - (value < 0.0);
}

/// Half a unit in the last place of 1: Shewchuk's epsilon.
constexpr double HalfUlp = 0.5 * std::numeric_limits<double>::epsilon();

/// What rounding may do to an area, relative to the magnitudes that it is summed of.
constexpr double Orient2DBound = (3.0 + 16.0 * HalfUlp) * HalfUlp;

/// What rounding may do to a volume, relative to the magnitudes that it is summed of.
constexpr double Orient3DBound = (8.0 + 64.0 * HalfUlp) * HalfUlp;

inline Expansion<16> ExactOrient2D(
  const Vector3& a, const Vector3& b, const Vector3& c, int u, int v)
{
  using Difference = Expansion<2>;
  const Difference abU = Difference::Difference(b[u], a[u]);
  const Difference abV = Difference::Difference(b[v], a[v]);
  const Difference acU = Difference::Difference(c[u], a[u]);
  const Difference acV = Difference::Difference(c[v], a[v]);
  return abU * acV - abV * acU;
}

inline Expansion<192> ExactOrient3D(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  using Difference = Expansion<2>;
  const auto along = [&](int axis) { return Difference::Difference(d[axis], a[axis]); };
  const Expansion<64> x = along(0) * ExactOrient2D(a, b, c, 1, 2);
  const Expansion<64> y = along(1) * ExactOrient2D(a, b, c, 2, 0);
  const Expansion<64> z = along(2) * ExactOrient2D(a, b, c, 0, 1);
  return x + y + z;
}

}

/// The sign of the area of a, b, c seen along an axis: 1 when they turn from the next axis towards
/// the one after it.
inline int Orient2D(const Vector3& a, const Vector3& b, const Vector3& c, int axis)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const double left = (b[u] - a[u]) * (c[v] - a[v]);
  const double right = (b[v] - a[v]) * (c[u] - a[u]);
  const double area = left - right;
  const double magnitude = std::abs(left) + std::abs(right);
  if (!(std::abs(area) <= detail::Orient2DBound * magnitude) || magnitude == 0.0) // also of NaN
  {
    return detail::SignOf(area);
  }
  return detail::ExactOrient2D(a, b, c, u, v).Sign();
}

/// The same number as Orient2D has the sign of, to about a unit in the last place.
inline double AreaOf(const Vector3& a, const Vector3& b, const Vector3& c, int axis)
{
  return detail::ExactOrient2D(a, b, c, (axis + 1) % 3, (axis + 2) % 3).Value();
}

/// A plane through three points with a floating-point side test that reports when it is certain:
/// for many points, or if most are certain.
class FloatingPlane
{
public:
  FloatingPlane(const Vector3& a, const Vector3& b, const Vector3& c)
    : A(a)
  {
    const Vector3 ab = b - a;
    const Vector3 ac = c - a;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      const double left = ab[u] * ac[v];
      const double right = ab[v] * ac[u];
      this->Normal[axis] = left - right;
      this->Magnitude[axis] = std::abs(left) + std::abs(right);
    }
  }

  /// The axis along which the triangle is seen largest, within rounding.
  int DominantAxis() const { return LargestAxis(this->Normal); }

  /// The sign of (b - a) x (c - a) . (x - a); 0 also where rounding could matter.
  int SureSideOf(const Vector3& x) const
  {
    const Volume volume = this->VolumeTo(x);
    const double rounding = detail::Orient3DBound * volume.Magnitude;
    return (volume.Value > rounding) - (volume.Value < -rounding);
  }

  /// Whether two points are surely on one side, the same for both: 1 or -1; else 0.
  int SureSideOfBoth(const Vector3& x, const Vector3& y) const
  {
    const auto along = [&](int axis)
    { return TwoDoubles(x[axis], y[axis]) - TwoDoubles(this->A[axis]); };
    const TwoDoubles ax[3] = { along(0), along(1), along(2) };
    const TwoDoubles value = ax[0] * TwoDoubles(this->Normal[0]) +
      ax[1] * TwoDoubles(this->Normal[1]) + ax[2] * TwoDoubles(this->Normal[2]);
    const TwoDoubles magnitude = Abs(ax[0]) * TwoDoubles(this->Magnitude[0]) +
      Abs(ax[1]) * TwoDoubles(this->Magnitude[1]) + Abs(ax[2]) * TwoDoubles(this->Magnitude[2]);
    const TwoDoubles rounding = magnitude * TwoDoubles(detail::Orient3DBound);
    constexpr unsigned both = 3;
    return (Above(value, rounding) == both) - (Above(TwoDoubles(0.0) - rounding, value) == both);
  }

private:
  friend int Orient3D(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d);

  struct Volume
  {
    double Value;
    double Magnitude; ///< of what it is summed of

    bool MayBeRounding() const // not of NaN
    {
      return std::abs(this->Value) <= detail::Orient3DBound * this->Magnitude &&
        this->Magnitude != 0.0;
    }
  };

  Volume VolumeTo(const Vector3& x) const
  {
    const Vector3 ax = x - this->A;
    return { ax[0] * this->Normal[0] + ax[1] * this->Normal[1] + ax[2] * this->Normal[2],
      std::abs(ax[0]) * this->Magnitude[0] + std::abs(ax[1]) * this->Magnitude[1] +
        std::abs(ax[2]) * this->Magnitude[2] };
  }

  Vector3 A;
  Vector3 Normal;
  Vector3 Magnitude; // of the products that a coordinate of the normal is the difference of
};

/// The sign of (b - a) x (c - a) . (d - a): 1 when d lies where the normal of a, b, c points to, 0
/// when all four lie in one plane.
inline int Orient3D(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  const FloatingPlane::Volume volume = FloatingPlane(a, b, c).VolumeTo(d);
  return volume.MayBeRounding() ? detail::ExactOrient3D(a, b, c, d).Sign()
                                : detail::SignOf(volume.Value);
}

namespace detail
{

/// A plane through three points, and volumes above it, by pairs of doubles.
class PlaneByPairs
{
public:
  PlaneByPairs(const Vector3& a, const Vector3& b, const Vector3& c)
    : A(a)
  {
    DoubleDouble ab[3], ac[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      ab[axis] = ExactSum(b[axis], -a[axis]);
      ac[axis] = ExactSum(c[axis], -a[axis]);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      const DoubleDouble left = ab[u] * ac[v];
      const DoubleDouble right = ab[v] * ac[u];
      this->Normal[axis] = left + DoubleDouble{ -right.High, -right.Low };
      this->Magnitude[axis] = std::abs(left.High) + std::abs(right.High);
    }
  }

  /// NaN where pairs do not determine how the number is rounded.
  double VolumeTo(const Vector3& d) const
  {
    DoubleDouble volume{ 0.0, 0.0 };
    double magnitude = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const DoubleDouble ad = ExactSum(d[axis], -this->A[axis]);
      volume = volume + ad * this->Normal[axis];
      magnitude += std::abs(ad.High) * this->Magnitude[axis];
    }
    // Each step is right to about 2^-100 of what it adds up, and the sum of an exact expansion's
    // parts to less: where both roundings of so much more and so much less agree, they are the
    // expansion's.
    constexpr double relative = 0x1p-94;
    const double error = relative * magnitude;
    const bool isTold = magnitude > tolerances::LeastProduct &&
      volume.High + (volume.Low + error) == volume.High &&
      volume.High + (volume.Low - error) == volume.High;
    return isTold ? volume.High : std::numeric_limits<double>::quiet_NaN();
  }

private:
  Vector3 A;
  DoubleDouble Normal[3];
  double Magnitude[3];
};

}

/// A plane through three points, and volumes above it to about a unit in the last place: the
/// numbers that Orient3D has the signs of.
class AccuratePlane
{
public:
  AccuratePlane(const Vector3& a, const Vector3& b, const Vector3& c)
    : A(a)
    , B(b)
    , C(c)
    , Pairs(a, b, c)
  {
  }

  double VolumeTo(const Vector3& x) const
  {
    const double volume = this->Pairs.VolumeTo(x);
    return volume == volume ? volume : detail::ExactOrient3D(this->A, this->B, this->C, x).Value();
  }

private:
  Vector3 A;
  Vector3 B;
  Vector3 C;
  detail::PlaneByPairs Pairs;
};

}

#endif
