// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Eight floats side by side: the one place that knows how this compiler and machine compute on
/// several numbers at once. Everything means what the plain loop over lanes means; compile with
/// SKD_PLAIN_LANES to get just that loop.
#ifndef skd_Tree_Lanes_h
#define skd_Tree_Lanes_h

#include <cstring>

#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__SSE2__)
#include <immintrin.h>
#endif

namespace skd
{
namespace detail
{

#if defined(SKD_PLAIN_LANES) || !defined(__GNUC__)
using FloatVector = float;
using TruthVector = bool;
#elif defined(__AVX__)
typedef float FloatVector __attribute__((vector_size(32)));
typedef int TruthVector __attribute__((vector_size(32)));
#else
typedef float FloatVector __attribute__((vector_size(16)));
typedef int TruthVector __attribute__((vector_size(16)));
#endif

constexpr int VectorWidth = sizeof(FloatVector) / sizeof(float);

/// All lanes the same. The sum with zeros is exact, but for the sign of zero.
inline FloatVector Same(float value)
{
  return FloatVector{} + value;
}

/// Bit i is set where lane i of `truth` is.
inline unsigned Bits(TruthVector truth)
{
#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_ps((__m256)truth));
#elif !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_ps((__m128)truth));
#elif defined(SKD_PLAIN_LANES) || !defined(__GNUC__)
  return truth ? 1u : 0u;
#else
  unsigned bits = 0;
  for (int i = 0; i < VectorWidth; ++i)
  {
    if (truth[i] != 0)
    {
      bits |= 1u << i;
    }
  }
  return bits;
#endif
}

}

/// The number of the lowest bit that is set, of at least one.
inline int LowestBit(unsigned bits)
{
#if defined(__GNUC__)
  return __builtin_ctz(bits);
#else
  int lowest = 0;
  while ((bits >> lowest & 1u) == 0)
  {
    ++lowest;
  }
  return lowest;
#endif
}

/// Lane by lane arithmetic on W floats. NaN: Max(a, b) and Min(a, b) give b if either is NaN.
template <int W>
class Lanes
{
public:
  static_assert(W % detail::VectorWidth == 0, "whole vectors only");

  Lanes() = default;
  explicit Lanes(float value)
  {
    for (detail::FloatVector& part : this->Parts)
    {
      part = detail::Same(value);
    }
  }

  static Lanes Load(const float* values)
  {
    Lanes lanes;
    std::memcpy(lanes.Parts, values, sizeof(lanes.Parts));
    return lanes;
  }
  void Store(float* values) const { std::memcpy(values, this->Parts, sizeof(this->Parts)); }

  friend Lanes operator+(const Lanes& a, const Lanes& b)
  {
    return Map(a, b, [](detail::FloatVector x, detail::FloatVector y) { return x + y; });
  }
  friend Lanes operator-(const Lanes& a, const Lanes& b)
  {
    return Map(a, b, [](detail::FloatVector x, detail::FloatVector y) { return x - y; });
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b)
  {
    return Map(a, b, [](detail::FloatVector x, detail::FloatVector y) { return x * y; });
  }
  friend Lanes Max(const Lanes& a, const Lanes& b)
  {
    return Map(a, b, [](detail::FloatVector x, detail::FloatVector y) { return x > y ? x : y; });
  }
  friend Lanes Min(const Lanes& a, const Lanes& b)
  {
    return Map(a, b, [](detail::FloatVector x, detail::FloatVector y) { return x < y ? x : y; });
  }

  /// Bit i is set where a <= b in lane i; never for NaN.
  friend unsigned LessEqual(const Lanes& a, const Lanes& b)
  {
    unsigned bits = 0;
    for (int i = 0; i < Count; ++i)
    {
      bits |= detail::Bits(a.Parts[i] <= b.Parts[i]) << (i * detail::VectorWidth);
    }
    return bits;
  }

private:
  static constexpr int Count = W / detail::VectorWidth;

  template <class Function>
  static Lanes Map(const Lanes& a, const Lanes& b, Function function)
  {
    Lanes result;
    for (int i = 0; i < Count; ++i)
    {
      result.Parts[i] = function(a.Parts[i], b.Parts[i]);
    }
    return result;
  }

  detail::FloatVector Parts[Count];
};

}

#endif
