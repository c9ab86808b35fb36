// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A SIMD vector of two doubles, as Search/Tree/Lanes.h for floats.
#ifndef skd_Geometry_TwoDoubles_h
#define skd_Geometry_TwoDoubles_h

#include <cmath>

#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__SSE2__)
#include <emmintrin.h>
#define SKD_HAS_DOUBLE_LANES 1
#else
#define SKD_HAS_DOUBLE_LANES 0
#endif

namespace skd
{

/// Two numbers. Arithmetic rounds lane by lane, as for one.
class TwoDoubles
{
public:
  explicit TwoDoubles(double both)
    : TwoDoubles(both, both)
  {
  }

  /// Two numbers that lie one after the other.
  static TwoDoubles Read(const float* values)
  {
#if SKD_HAS_DOUBLE_LANES
    return _mm_cvtps_pd(_mm_castsi128_ps(_mm_loadu_si64(values)));
#else
    return { values[0], values[1] };
#endif
  }
  static TwoDoubles Read(const double* values)
  {
#if SKD_HAS_DOUBLE_LANES
    return _mm_loadu_pd(values);
#else
    return { values[0], values[1] };
#endif
  }

#if SKD_HAS_DOUBLE_LANES
  TwoDoubles(double first, double second)
    : Values(_mm_set_pd(second, first))
  {
  }

  friend TwoDoubles operator+(TwoDoubles a, TwoDoubles b)
  {
    return _mm_add_pd(a.Values, b.Values);
  }
  friend TwoDoubles operator-(TwoDoubles a, TwoDoubles b)
  {
    return _mm_sub_pd(a.Values, b.Values);
  }
  friend TwoDoubles operator*(TwoDoubles a, TwoDoubles b)
  {
    return _mm_mul_pd(a.Values, b.Values);
  }
  friend TwoDoubles Abs(TwoDoubles a)
  {
    return _mm_andnot_pd(_mm_set1_pd(-0.0), a.Values);
  }
  friend TwoDoubles Larger(TwoDoubles a, TwoDoubles b)
  {
    return _mm_max_pd(a.Values, b.Values);
  }
  /// The second of a and the first of b.
  friend TwoDoubles Between(TwoDoubles a, TwoDoubles b)
  {
    return _mm_shuffle_pd(a.Values, b.Values, 1);
  }

  double First() const
  {
    return _mm_cvtsd_f64(this->Values);
  }
  double Second() const
  {
    return _mm_cvtsd_f64(_mm_unpackhi_pd(this->Values, this->Values));
  }
  __m128d Lanes() const
  {
    return this->Values;
  }

  /// A bit for each lane where a > b; never for NaN.
  friend unsigned Above(TwoDoubles a, TwoDoubles b)
  {
    return static_cast<unsigned>(_mm_movemask_pd(_mm_cmpgt_pd(a.Values, b.Values)));
  }

private:
  TwoDoubles(__m128d values)
    : Values(values)
  {
  }

  __m128d Values;
#else
  TwoDoubles(double first, double second)
    : Values{ first, second }
  {
  }

  friend TwoDoubles operator+(TwoDoubles a, TwoDoubles b)
  {
    return { a.Values[0] + b.Values[0], a.Values[1] + b.Values[1] };
  }
  friend TwoDoubles operator-(TwoDoubles a, TwoDoubles b)
  {
    return { a.Values[0] - b.Values[0], a.Values[1] - b.Values[1] };
  }
  friend TwoDoubles operator*(TwoDoubles a, TwoDoubles b)
  {
    return { a.Values[0] * b.Values[0], a.Values[1] * b.Values[1] };
  }
  friend TwoDoubles Abs(TwoDoubles a)
  {
    return { std::abs(a.Values[0]), std::abs(a.Values[1]) };
  }
  friend TwoDoubles Larger(TwoDoubles a, TwoDoubles b)
  {
    return { a.Values[0] > b.Values[0] ? a.Values[0] : b.Values[0],
      a.Values[1] > b.Values[1] ? a.Values[1] : b.Values[1] };
  }
  /// The second of a and the first of b.
  friend TwoDoubles Between(TwoDoubles a, TwoDoubles b)
  {
    return { a.Values[1], b.Values[0] };
  }

  double First() const
  {
    return this->Values[0];
  }
  double Second() const
  {
    return this->Values[1];
  }

  /// A bit for each lane where a > b; never for NaN.
  friend unsigned Above(TwoDoubles a, TwoDoubles b)
  {
    return (a.Values[0] > b.Values[0] ? 1u : 0u) | (a.Values[1] > b.Values[1] ? 2u : 0u);
  }

private:
  double Values[2];
#endif
};

}

#endif
