// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_OutwardRounding_h
#define skd_Tree_OutwardRounding_h

#include "../../Geometry/PointBounds.h"
#include "Frame.h"

#include <cstring>

namespace skd
{

/// Frame::OutwardWithin of many boxes in space, by vectors: the same to the last bit.
class OutwardRounding
{
#if SKD_HAS_DOUBLE_LANES
  /// As Frame::RoundUpInRange.
  static __m128 NextOf(__m128 values)
  {
    const __m128i bits = _mm_castps_si128(_mm_add_ps(values, _mm_setzero_ps()));
    return _mm_castsi128_ps(
      _mm_add_epi32(bits, _mm_or_si128(_mm_srai_epi32(bits, 31), _mm_set1_epi32(1))));
  }
#endif

public:
  OutwardRounding(const Frame<3>& frame, double margin)
#if SKD_HAS_FOUR_DOUBLES
    : Centre(_mm256_setr_pd(frame.Centre[0], frame.Centre[1], frame.Centre[1], frame.Centre[2]))
    , Scale(_mm256_set1_pd(frame.Scale))
    , Margin(_mm256_set1_pd(margin))
  {
  }

  void Round(const PointBounds& bounds, FloatBox<3>& to) const
  {
    const __m128 sign = _mm_set1_ps(-0.0f);
    const __m128 low = this->Local(bounds.Least() - this->Margin);
    const __m128 least = _mm_xor_ps(NextOf(_mm_xor_ps(low, sign)), sign); // x, y, y, z
    const __m128 greatest = NextOf(this->Local(bounds.Greatest() + this->Margin));
    const __m128 zx = _mm_shuffle_ps(least, greatest, _MM_SHUFFLE(0, 0, 3, 3));
    _mm_storeu_ps(to.Min, _mm_shuffle_ps(least, zx, _MM_SHUFFLE(2, 0, 1, 0)));
    _mm_storel_pi(reinterpret_cast<__m64*>(to.Max + 1),
      _mm_shuffle_ps(greatest, greatest, _MM_SHUFFLE(3, 3, 3, 1)));
  }

private:
  /// As Frame::Local.
  __m128 Local(__m256d world) const
  {
    return _mm256_cvtpd_ps((world - this->Centre) * this->Scale);
  }

  __m256d Centre; // in the order of PointBounds
  __m256d Scale;
  __m256d Margin;
#elif SKD_HAS_DOUBLE_LANES
    : Centre{ TwoDoubles(-frame.Centre[0], -frame.Centre[1]),
      TwoDoubles(-frame.Centre[2], frame.Centre[0]), TwoDoubles(frame.Centre[1], frame.Centre[2]) }
    , Scale(frame.Scale)
    , Margin(margin)
  {
  }

  void Round(const PointBounds& bounds, FloatBox<3>& to) const
  {
    const __m128 minus = _mm_setr_ps(-0.0f, -0.0f, -0.0f, 0.0f); // turns three signs
    const __m128 first =
      _mm_xor_ps(NextOf(_mm_movelh_ps(this->Local(bounds, 0), this->Local(bounds, 1))), minus);
    const __m128 second = NextOf(this->Local(bounds, 2));
    static_assert(sizeof(to) == 6 * sizeof(float));
    char* bytes = reinterpret_cast<char*>(&to);
    std::memcpy(bytes, &first, sizeof(first));
    std::memcpy(bytes + sizeof(first), &second, 2 * sizeof(float));
  }

private:
  /// As Frame::Local; of the least coordinates all is negative.
  __m128 Local(const PointBounds& bounds, int pair) const
  {
    const TwoDoubles local =
      (bounds.GetSides()[pair] + this->Margin - this->Centre[pair]) * this->Scale;
    return _mm_cvtpd_ps(local.Lanes());
  }

  TwoDoubles Centre[3]; // in the order of PointBounds
  TwoDoubles Scale;
  TwoDoubles Margin;
#else
    : TheFrame(frame)
    , Margin(margin)
  {
  }

  void Round(const PointBounds& bounds, FloatBox<3>& to) const
  {
    to = this->TheFrame.OutwardWithin(bounds.Box(), this->Margin);
  }

private:
  Frame<3> TheFrame;
  double Margin;
#endif
};

}

#endif
