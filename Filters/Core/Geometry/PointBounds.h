// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_PointBounds_h
#define skd_Geometry_PointBounds_h

#include "Box.h"
#include "ForEachAxis.h"
#include "PointArray.h"
#include "TwoDoubles.h"

#include <cstddef>
#include <limits>

#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__AVX2__)
#include <immintrin.h>
#define SKD_HAS_FOUR_DOUBLES 1
#else
#define SKD_HAS_FOUR_DOUBLES 0
#endif

namespace skd
{

/// The box of points in space, none of which is NaN, by vectors: four numbers at a time (x, y, y,
/// z) or two. A point is read as two pairs of numbers, and nothing beyond it.
class PointBounds
{
public:
  template <class Id>
  void Add(const PointArray& points, const Id* ids, std::size_t number)
  {
    points.Floats ? this->AddAll(points.Floats, ids, number)
                  : this->AddAll(points.Doubles, ids, number);
  }

  ///@{
  /// Coordinates that lie one after the other.
#if SKD_HAS_FOUR_DOUBLES
  void Add(const double* point)
  {
    const __m128d xy = _mm_loadu_pd(point);
    this->Add(_mm256_insertf128_pd(_mm256_castpd128_pd256(xy), _mm_loadu_pd(point + 1), 1));
  }
  void Add(const float* point)
  {
    const __m128i xy = _mm_loadu_si64(point), yz = _mm_loadu_si64(point + 1);
    this->Add(_mm256_cvtps_pd(_mm_castsi128_ps(_mm_unpacklo_epi64(xy, yz))));
  }
  ///@}

  Box3 Box() const
  {
    const __m256d low = this->Low, high = this->High;
    return { { { low[0], low[1], low[3] } }, { { high[0], high[1], high[3] } } };
  }

  __m256d Least() const
  {
    return this->Low;
  }
  __m256d Greatest() const
  {
    return this->High;
  }

private:
  void Add(__m256d point)
  {
    this->Low = _mm256_min_pd(this->Low, point);
    this->High = _mm256_max_pd(this->High, point);
  }
  void Add(const PointBounds& other)
  {
    this->Low = _mm256_min_pd(this->Low, other.Low);
    this->High = _mm256_max_pd(this->High, other.High);
  }

  __m256d Low = _mm256_set1_pd(std::numeric_limits<double>::max());
  __m256d High = _mm256_set1_pd(std::numeric_limits<double>::lowest());
#else
  template <class Number>
  void Add(const Number* point)
  {
    const TwoDoubles xy = TwoDoubles::Read(point);
    const TwoDoubles yz = TwoDoubles::Read(point + 1);
    this->Sides[0] = Larger(this->Sides[0], TwoDoubles(-1.0) * xy);
    this->Sides[1] = Larger(this->Sides[1], TwoDoubles(-1.0, 1.0) * Between(yz, xy));
    this->Sides[2] = Larger(this->Sides[2], yz);
  }
  ///@}

  Box3 Box() const
  {
    const TwoDoubles* s = this->Sides;
    return { { { -s[0].First(), -s[0].Second(), -s[1].First() } },
      { { s[1].Second(), s[2].First(), s[2].Second() } } };
  }

  /// Least coordinates as the greatest of their negatives, so that all sides are found by one
  /// operation, in the order of a box: -x, -y; -z, x; y, z.
  const TwoDoubles* GetSides() const
  {
    return this->Sides;
  }

private:
  void Add(const PointBounds& other)
  {
    ForEachAxis<3>(
      [&](int pair) { this->Sides[pair] = Larger(this->Sides[pair], other.Sides[pair]); });
  }

  static constexpr double None = std::numeric_limits<double>::lowest();
  TwoDoubles Sides[3] = { TwoDoubles(None), TwoDoubles(None), TwoDoubles(None) };
#endif

  /// Several boxes at once: of one, each point waits for the comparisons of the one before.
  template <class Number, class Id>
  void AddAll(const Number* coordinates, const Id* ids, std::size_t number)
  {
    constexpr std::size_t several = 4;
    PointBounds parts[several];
    const auto add = [&](PointBounds& to, std::size_t i)
    { to.Add(coordinates + 3 * static_cast<std::size_t>(ids[i])); };
    const std::size_t last = number - number % several;
    for (std::size_t i = 0; i < last; i += several)
    {
      ForEachAxis<several>([&](int part) { add(parts[part], i + static_cast<std::size_t>(part)); });
    }
    for (std::size_t i = last; i < number; ++i)
    {
      add(*this, i);
    }
    for (const PointBounds& part : parts)
    {
      this->Add(part);
    }
  }
};

}

#endif
