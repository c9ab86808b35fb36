// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_PaddedVector_h
#define skd_Geometry_Cells_PaddedVector_h

#include "../Vector.h"

#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__AVX2__)
#include <algorithm>
#include <immintrin.h>
#endif

namespace skd
{

#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__AVX2__)

/// A Vector3 in one register of four doubles, the last of which means nothing. Each coordinate is
/// rounded as that of a Vector3 is.
class PaddedVector
{
public:
  PaddedVector() = default;
  PaddedVector(const Vector3& v)
    : Values(
        _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(v.X)), _mm_load_sd(v.X + 2), 1))
  {
  }
  explicit operator Vector3() const { return { { (*this)[0], (*this)[1], (*this)[2] } }; }
  double operator[](int axis) const { return this->Values[axis]; }

  friend PaddedVector operator+(PaddedVector a, PaddedVector b) { return a.Values + b.Values; }
  friend PaddedVector operator-(PaddedVector a, PaddedVector b) { return a.Values - b.Values; }
  friend PaddedVector operator*(double factor, PaddedVector a)
  {
    return _mm256_set1_pd(factor) * a.Values;
  }
  friend PaddedVector Abs(PaddedVector a)
  {
    return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a.Values);
  }
  friend double MaxNorm(PaddedVector a)
  {
    const PaddedVector sizes = Abs(a);
    return std::max(std::max(sizes[0], sizes[1]), sizes[2]);
  }
  friend double Dot(PaddedVector a, PaddedVector b)
  {
    const PaddedVector product(a.Values * b.Values);
    return product[0] + product[1] + product[2];
  }
  friend PaddedVector Cross(PaddedVector a, PaddedVector b)
  {
    return Next(a.Values * Next(b.Values) - Next(a.Values) * b.Values);
  }

private:
  PaddedVector(__m256d values)
    : Values(values)
  {
  }
  /// In the place of each coordinate the next.
  static __m256d Next(__m256d a) { return _mm256_permute4x64_pd(a, 0b11001001); }

  __m256d Values;
};

#else

using PaddedVector = Vector3;

#endif

}

#endif
