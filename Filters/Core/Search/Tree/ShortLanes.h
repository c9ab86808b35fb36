// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// SIMD vectors of small integers, as Lanes.h for floats.
#ifndef skd_Tree_ShortLanes_h
#define skd_Tree_ShortLanes_h

#include "Lanes.h"

#include <cstdint>
#include <cstring>

#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__SSE2__)
#include <emmintrin.h>
#define SKD_HAS_SHORT_LANES 1
#else
#define SKD_HAS_SHORT_LANES 0
#endif

namespace skd
{

/// Four bytes side by side.
struct FourBytes
{
  std::uint8_t At[4];
};

namespace detail
{
#if SKD_HAS_SHORT_LANES
inline __m128i LoadBytes(const FourBytes& bytes)
{
  int loaded;
  std::memcpy(&loaded, bytes.At, sizeof(loaded));
  return _mm_cvtsi32_si128(loaded);
}
inline FourBytes StoredBytes(__m128i bytes)
{
  const int low = _mm_cvtsi128_si32(bytes);
  FourBytes stored;
  std::memcpy(stored.At, &low, sizeof(low));
  return stored;
}
#endif
}

inline FourBytes Least(const FourBytes& a, const FourBytes& b)
{
#if SKD_HAS_SHORT_LANES
  return detail::StoredBytes(_mm_min_epu8(detail::LoadBytes(a), detail::LoadBytes(b)));
#else
  FourBytes least = a;
  for (int i = 0; i < 4; ++i)
  {
    least.At[i] = b.At[i] < a.At[i] ? b.At[i] : a.At[i];
  }
  return least;
#endif
}

inline FourBytes Greatest(const FourBytes& a, const FourBytes& b)
{
#if SKD_HAS_SHORT_LANES
  return detail::StoredBytes(_mm_max_epu8(detail::LoadBytes(a), detail::LoadBytes(b)));
#else
  FourBytes greatest = a;
  for (int i = 0; i < 4; ++i)
  {
    greatest.At[i] = b.At[i] > a.At[i] ? b.At[i] : a.At[i];
  }
  return greatest;
#endif
}

/// Whether any lane is equal to that of the other.
inline bool HaveEqual(const FourBytes& a, const FourBytes& b)
{
#if SKD_HAS_SHORT_LANES
  const __m128i equal = _mm_cmpeq_epi8(detail::LoadBytes(a), detail::LoadBytes(b));
  return (_mm_movemask_epi8(equal) & 15) != 0;
#else
  bool haveEqual = false;
  for (int i = 0; i < 4; ++i)
  {
    haveEqual = haveEqual || a.At[i] == b.At[i];
  }
  return haveEqual;
#endif
}

/// Eight integers.
class EightShorts
{
public:
  EightShorts() = default;

  /// The same eight times.
  explicit EightShorts(std::int16_t value)
  {
#if SKD_HAS_SHORT_LANES
    this->Values = _mm_set1_epi16(value);
#else
    for (std::int16_t& lane : this->Values)
    {
      lane = value;
    }
#endif
  }

  static EightShorts Load(const std::int16_t (&values)[8])
  {
    EightShorts loaded;
    std::memcpy(&loaded.Values, values, sizeof(loaded.Values));
    return loaded;
  }

  /// All bits of the lanes are set where a > b.
  friend EightShorts Above(const EightShorts& a, const EightShorts& b)
  {
    EightShorts above;
#if SKD_HAS_SHORT_LANES
    above.Values = _mm_cmpgt_epi16(a.Values, b.Values);
#else
    for (int lane = 0; lane < 8; ++lane)
    {
      above.Values[lane] = a.Values[lane] > b.Values[lane] ? -1 : 0;
    }
#endif
    return above;
  }

  friend EightShorts operator|(const EightShorts& a, const EightShorts& b)
  {
    EightShorts either;
#if SKD_HAS_SHORT_LANES
    either.Values = _mm_or_si128(a.Values, b.Values);
#else
    for (int lane = 0; lane < 8; ++lane)
    {
      either.Values[lane] = a.Values[lane] | b.Values[lane];
    }
#endif
    return either;
  }

  /// A bit for each lane that is negative.
  friend unsigned NegativeLanes(const EightShorts& a)
  {
#if SKD_HAS_SHORT_LANES
    return static_cast<unsigned>(_mm_movemask_epi8(_mm_packs_epi16(a.Values, _mm_setzero_si128())));
#else
    unsigned negative = 0;
    for (int lane = 0; lane < 8; ++lane)
    {
      negative |= (a.Values[lane] < 0 ? 1u : 0u) << lane;
    }
    return negative;
#endif
  }

private:
#if SKD_HAS_SHORT_LANES
  __m128i Values;
#else
  std::int16_t Values[8];
#endif
};

/// Two integers side by side.
struct ShortPair
{
  std::int16_t First;
  std::int16_t Second;
};

namespace detail
{
#if defined(SKD_PLAIN_LANES) || !defined(__GNUC__)
using IntegerVector = std::uint32_t;
#else
typedef std::uint32_t IntegerVector __attribute__((vector_size(sizeof(FloatVector))));
#endif

/// First * with.First + Second * with.Second, of each pair.
inline IntegerVector SumsOfProducts(const ShortPair* pairs, const ShortPair& with)
{
#if SKD_HAS_SHORT_LANES && (defined(__AVX2__) || !defined(__AVX__))
  int both;
  std::memcpy(&both, &with, sizeof(both));
#if defined(__AVX2__)
  const auto* const from = reinterpret_cast<const __m256i*>(pairs);
  return (IntegerVector)_mm256_madd_epi16(_mm256_loadu_si256(from), _mm256_set1_epi32(both));
#else
  const auto* const from = reinterpret_cast<const __m128i*>(pairs);
  return (IntegerVector)_mm_madd_epi16(_mm_loadu_si128(from), _mm_set1_epi32(both));
#endif
#else
  std::uint32_t sums[VectorWidth];
  for (int i = 0; i < VectorWidth; ++i)
  {
    sums[i] = static_cast<std::uint32_t>(pairs[i].First * with.First) +
      static_cast<std::uint32_t>(pairs[i].Second * with.Second);
  }
  IntegerVector loaded;
  std::memcpy(&loaded, sums, sizeof(loaded));
  return loaded;
#endif
}

/// Of each, 2^15 times as much.
inline IntegerVector Shifted15(const std::uint16_t* values)
{
#if SKD_HAS_SHORT_LANES && defined(__AVX2__)
  const auto* const from = reinterpret_cast<const __m128i*>(values);
  return (IntegerVector)_mm256_slli_epi32(_mm256_cvtepu16_epi32(_mm_loadu_si128(from)), 15);
#elif SKD_HAS_SHORT_LANES && !defined(__AVX__)
  const __m128i some = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(values));
  return (IntegerVector)_mm_srli_epi32(_mm_unpacklo_epi16(_mm_setzero_si128(), some), 1);
#else
  std::uint32_t shifted[VectorWidth];
  for (int i = 0; i < VectorWidth; ++i)
  {
    shifted[i] = std::uint32_t(values[i]) << 15;
  }
  IntegerVector loaded;
  std::memcpy(&loaded, shifted, sizeof(loaded));
  return loaded;
#endif
}
}

/// Eight integers of 32 bits; arithmetic is modulo 2^32.
class EightIntegers
{
public:
  EightIntegers() = default;

  /// First * with.First + Second * with.Second, of each pair.
  static EightIntegers SumsOfProducts(const ShortPair (&pairs)[8], const ShortPair& with)
  {
    return Each(
      [&](int i) { return detail::SumsOfProducts(pairs + i * detail::VectorWidth, with); });
  }
  static EightIntegers Shifted15(const std::uint16_t (&values)[8])
  {
    return Each([&](int i) { return detail::Shifted15(values + i * detail::VectorWidth); });
  }
  friend EightIntegers operator+(const EightIntegers& a, const EightIntegers& b)
  {
    return Each([&](int i) { return a.Registers[i] + b.Registers[i]; });
  }
  friend EightIntegers operator-(const EightIntegers& a, const EightIntegers& b)
  {
    return Each([&](int i) { return a.Registers[i] - b.Registers[i]; });
  }
  friend EightIntegers operator|(const EightIntegers& a, const EightIntegers& b)
  {
    return Each([&](int i) { return a.Registers[i] | b.Registers[i]; });
  }

  /// A bit for each lane that is negative.
  friend unsigned NegativeLanes(const EightIntegers& a)
  {
    unsigned negative = 0;
    for (int i = 0; i < Count; ++i)
    {
#if defined(SKD_PLAIN_LANES) || !defined(__GNUC__)
      negative |= (a.Registers[i] >> 31) << i;
#else
      negative |= detail::Bits((detail::TruthVector)a.Registers[i] < 0)
        << (i * detail::VectorWidth);
#endif
    }
    return negative;
  }

private:
  static constexpr int Count = 8 / detail::VectorWidth;

  template <class Register>
  static EightIntegers Each(const Register& at)
  {
    EightIntegers made;
    for (int i = 0; i < Count; ++i)
    {
      made.Registers[i] = at(i);
    }
    return made;
  }

  detail::IntegerVector Registers[Count] = {};
};

}

#endif
