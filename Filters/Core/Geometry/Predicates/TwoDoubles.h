// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A SIMD vector of two doubles, as Tree/Lanes.h for floats.
#ifndef skd_Predicates_TwoDoubles_h
#define skd_Predicates_TwoDoubles_h

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
