// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// SIMD vectors of small integers, as Lanes.h for floats.
#ifndef skd_Tree_ShortLanes_h
#define skd_Tree_ShortLanes_h

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

}

#endif
