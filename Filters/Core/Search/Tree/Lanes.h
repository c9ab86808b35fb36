// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// SIMD vectors of eight floats: all dependencies on compiler and processor are here. Every
/// operation is equivalent to a plain loop over lanes; compile with SKD_PLAIN_LANES to use that
/// loop.
#ifndef skd_Tree_Lanes_h
#define skd_Tree_Lanes_h

#include "../../Geometry/ForEachAxis.h"
#include "Bits.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

// The header of all instruction sets takes ten times as long to compile as that of SSE2.
#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__AVX__)
#include <immintrin.h>
#elif !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__SSE2__)
#include <emmintrin.h>
#endif

/// Before a function: inlines everything that it calls. For functions that run at every node, which
/// should compile to a few instructions.
#if defined(__GNUC__)
#define SKD_FLATTEN __attribute__((flatten))
#else
#define SKD_FLATTEN
#endif

/// Before a function: it is never inlined. For functions that run once a query, which would take
/// registers from those that run at every node.
#if defined(__GNUC__)
#define SKD_NOINLINE __attribute__((noinline))
#else
#define SKD_NOINLINE
#endif

namespace skd
{
namespace detail
{

#if defined(SKD_PLAIN_LANES) || !defined(__GNUC__)
using FloatVector = float;
using TruthVector = bool;
using ShortVector = std::int16_t;
#elif defined(__AVX__)
typedef float FloatVector __attribute__((vector_size(32)));
typedef int TruthVector __attribute__((vector_size(32)));
typedef std::int16_t ShortVector __attribute__((vector_size(16)));
#else
typedef float FloatVector __attribute__((vector_size(16)));
typedef int TruthVector __attribute__((vector_size(16)));
typedef std::int16_t ShortVector __attribute__((vector_size(8)));
#endif

constexpr int VectorWidth = sizeof(FloatVector) / sizeof(float);

/// One as it lies in an array: GCC would take a copy of its bytes on a way through the stack.
#if defined(SKD_PLAIN_LANES) || !defined(__GNUC__)
using FloatsInMemory = float;
#else
typedef FloatVector FloatsInMemory __attribute__((aligned(sizeof(float)), may_alias));
#endif

/// All lanes the same. What compilers know to be no difference: the sum with zeros they would make.
inline FloatVector Same(float value)
{
  return value - FloatVector{};
}

inline FloatVector ToFloats(ShortVector values)
{
#if defined(SKD_PLAIN_LANES) || !defined(__GNUC__)
  return static_cast<float>(values);
#elif defined(__AVX2__)
  // GCC 12 makes two halves of the last line below, and without AVX goes through memory.
  return _mm256_cvtepi32_ps(_mm256_cvtepi16_epi32((__m128i)values));
#elif defined(__SSE2__) && !defined(__AVX__)
  const __m128i shorts = _mm_cvtsi64_si128((long long)values);
  return _mm_cvtepi32_ps(_mm_srai_epi32(_mm_unpacklo_epi16(shorts, shorts), 16));
#else
  return __builtin_convertvector(values, FloatVector);
#endif
}

inline FloatVector SquareRoot(FloatVector values)
{
#if defined(SKD_PLAIN_LANES) || !defined(__GNUC__)
  return std::sqrt(values);
#elif defined(__AVX__)
  return _mm256_sqrt_ps(values);
#elif defined(__SSE2__)
  return _mm_sqrt_ps(values);
#else
  for (int i = 0; i < VectorWidth; ++i)
  {
    values[i] = std::sqrt(values[i]);
  }
  return values;
#endif
}

/// The larger and the smaller lane by lane: the second if one is NaN. (Of vectors of which one is
/// constant GCC 12 makes a comparison and a choice.)
inline FloatVector Larger(FloatVector a, FloatVector b)
{
#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__AVX__)
  return _mm256_max_ps(a, b);
#elif !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__SSE2__)
  return _mm_max_ps(a, b);
#else
  return a > b ? a : b;
#endif
}
inline FloatVector Smaller(FloatVector a, FloatVector b)
{
#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__AVX__)
  return _mm256_min_ps(a, b);
#elif !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__SSE2__)
  return _mm_min_ps(a, b);
#else
  return a < b ? a : b;
#endif
}

/// a - b * c, rounded once where that is one instruction.
inline FloatVector MinusProduct(FloatVector a, FloatVector b, FloatVector c)
{
#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__AVX__) && defined(__FMA__)
  return _mm256_fnmadd_ps(b, c, a);
#else
  return a - b * c;
#endif
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

/// Prefetches `Size` bytes of memory.
template <std::size_t Size>
void FetchLines(const void* address)
{
#if defined(__GNUC__)
  constexpr std::size_t line = 64;
  __builtin_prefetch(address);
  // GCC would remove calls of a function without any other effect.
  __asm__ volatile("");
  if constexpr (Size > line)
  {
    FetchLines<Size - line>(static_cast<const char*>(address) + line);
  }
#else
  (void)address;
#endif
}

/// The number of lanes of the machine's registers.
constexpr int NativeWidth = detail::VectorWidth;

/// Doubles side by side, or one alone: arithmetic, comparisons and `? :` go lane by lane.
#if defined(SKD_PLAIN_LANES) || !defined(__GNUC__)
using DoubleVector = double;
#else
typedef double DoubleVector __attribute__((vector_size(sizeof(detail::FloatVector))));
#endif
constexpr int NativeDoubles = sizeof(DoubleVector) / sizeof(double);

inline DoubleVector LoadDoubles(const double* values)
{
  DoubleVector loaded;
  std::memcpy(&loaded, values, sizeof(loaded));
  return loaded;
}

/// The first `Number` of them, and zeros.
template <int Number>
DoubleVector LoadDoubles(const double* values)
{
  static_assert(0 < Number && Number <= NativeDoubles, "some of a register");
#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__AVX__)
  if constexpr (Number == 3)
  {
    // As compilers store them: what was stored just now in two parts cannot be loaded as a whole
    // before it is in the cache.
    const __m256d firstTwo = _mm256_castpd128_pd256(_mm_loadu_pd(values));
    return _mm256_insertf128_pd(firstTwo, _mm_load_sd(values + 2), 1);
  }
#endif
  double padded[NativeDoubles] = {};
  std::memcpy(padded, values, Number * sizeof(double));
  return LoadDoubles(padded);
}

#if defined(SKD_PLAIN_LANES) || !defined(__GNUC__)
inline double LaneOf(DoubleVector values, int)
{
  return values;
}
template <class At>
DoubleVector DoublesOf(const At& at)
{
  return at(0);
}
#else
inline double LaneOf(DoubleVector values, int lane)
{
  return values[lane];
}
/// at(0), at(1) ... side by side. Floats are made doubles all at once.
template <class At>
DoubleVector DoublesOf(const At& at)
{
  using Number = decltype(at(0));
  typedef Number Numbers __attribute__((vector_size(sizeof(Number) * NativeDoubles)));
  Numbers numbers;
  ForEachAxis<NativeDoubles>([&](int lane) { numbers[lane] = at(lane); });
  return __builtin_convertvector(numbers, DoubleVector);
}
#endif

inline double SquareRoot(double value)
{
  return std::sqrt(value);
}
#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__)
inline DoubleVector SquareRoot(DoubleVector values)
{
#if defined(__AVX__)
  return _mm256_sqrt_pd(values);
#elif defined(__SSE2__)
  return _mm_sqrt_pd(values);
#else
  for (int i = 0; i < NativeDoubles; ++i)
  {
    values[i] = std::sqrt(values[i]);
  }
  return values;
#endif
}
#endif

/// The larger and the smaller lane by lane: the second if one is NaN.
inline DoubleVector Larger(DoubleVector a, DoubleVector b)
{
#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__AVX__)
  return _mm256_max_pd(a, b);
#elif !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__SSE2__)
  return _mm_max_pd(a, b);
#else
  return a > b ? a : b;
#endif
}
inline DoubleVector Smaller(DoubleVector a, DoubleVector b)
{
#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__AVX__)
  return _mm256_min_pd(a, b);
#elif !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__SSE2__)
  return _mm_min_pd(a, b);
#else
  return a < b ? a : b;
#endif
}

#if defined(SKD_PLAIN_LANES) || !defined(__GNUC__)
inline DoubleVector WithoutSign(DoubleVector a)
{
  return std::abs(a);
}
inline DoubleVector TimesSign(DoubleVector a, DoubleVector b)
{
  return std::signbit(b) ? -a : a;
}
inline unsigned SignBits(DoubleVector a)
{
  return std::signbit(a) ? 1u : 0u;
}
#else
namespace detail
{
typedef std::int64_t BitsVector __attribute__((vector_size(sizeof(FloatVector))));
constexpr std::int64_t SignBit = std::numeric_limits<std::int64_t>::min();
}
inline DoubleVector WithoutSign(DoubleVector a)
{
  return (DoubleVector)((detail::BitsVector)a & ~detail::SignBit);
}
/// a where b has no sign bit, -a where it has.
inline DoubleVector TimesSign(DoubleVector a, DoubleVector b)
{
  return (DoubleVector)((detail::BitsVector)a ^ ((detail::BitsVector)b & detail::SignBit));
}
/// Bit i is set where lane i has the sign bit.
inline unsigned SignBits(DoubleVector a)
{
#if defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_pd(a));
#elif defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_pd(a));
#else
  unsigned bits = 0;
  for (int i = 0; i < NativeDoubles; ++i)
  {
    bits |= (std::signbit(a[i]) ? 1u : 0u) << i;
  }
  return bits;
#endif
}
#endif

/// Bit i is set where a > b in lane i; never for NaN.
inline unsigned Above(DoubleVector a, DoubleVector b)
{
#if defined(SKD_PLAIN_LANES) || !defined(__GNUC__)
  return a > b ? 1u : 0u;
#else
  return SignBits((DoubleVector)(a > b));
#endif
}

/// Whether a <= b in every lane; false with NaN.
inline bool AllLessEqual(DoubleVector a, DoubleVector b)
{
#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__AVX__)
  return _mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_LE_OQ)) == 15;
#elif !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__SSE2__)
  return _mm_movemask_pd(_mm_cmple_pd(a, b)) == 3;
#else
  double less[NativeDoubles];
  const DoubleVector one = a <= b ? DoubleVector{} + 1.0 : DoubleVector{};
  std::memcpy(less, &one, sizeof(less));
  return *std::min_element(less, less + NativeDoubles) > 0.0;
#endif
}

/// Doubles as numbers of another type, as a conversion makes them.
template <class Number>
void StoreAs(const DoubleVector& values, Number* to)
{
#if defined(SKD_PLAIN_LANES) || !defined(__GNUC__)
  *to = static_cast<Number>(values);
#else
  typedef Number Numbers __attribute__((vector_size(sizeof(Number) * NativeDoubles)));
  const Numbers converted = __builtin_convertvector(values, Numbers);
  std::memcpy(to, &converted, sizeof(converted));
#endif
}

/// One number in every lane of a register.
class InEveryLane
{
public:
  InEveryLane() = default;
  explicit InEveryLane(float value)
    : Values(detail::Same(value))
  {
  }

private:
  template <int W>
  friend class Lanes;

  detail::FloatVector Values;
};

/// One number for every lane of many operations, as it is quickest to load: AVX spreads it out as
/// it loads it.
#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__AVX__)
using Spread = float;
#else
using Spread = InEveryLane;
#endif

/// Lane by lane arithmetic on W floats. NaN: Max(a, b) and Min(a, b) give b if either is NaN.
template <int W>
class Lanes
{
public:
  static_assert(W % detail::VectorWidth == 0, "whole vectors only");

  Lanes() = default;
  explicit Lanes(float value)
    : Lanes(InEveryLane(value))
  {
  }
  explicit Lanes(const InEveryLane& value)
  {
    for (detail::FloatVector& some : this->Registers)
    {
      some = value.Values;
    }
  }

  /// Of what is used twice: GCC 12 would read it from memory each time, and what it is combined
  /// with by a load of its own.
  Lanes InRegisters() const
  {
    Lanes lanes = *this;
#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__AVX__)
    for (detail::FloatVector& some : lanes.Registers)
    {
      __asm__("" : "+x"(some));
    }
#endif
    return lanes;
  }

  static Lanes Load(const float* values)
  {
    Lanes lanes;
    for (detail::FloatVector& some : lanes.Registers)
    {
      some = *reinterpret_cast<const detail::FloatsInMemory*>(values);
      values += detail::VectorWidth;
    }
    return lanes;
  }
  static Lanes LoadShorts(const std::int16_t* values)
  {
    Lanes lanes;
    for (detail::FloatVector& some : lanes.Registers)
    {
      detail::ShortVector shorts;
      std::memcpy(&shorts, values, sizeof(shorts));
      some = detail::ToFloats(shorts);
      values += detail::VectorWidth;
    }
    return lanes;
  }
  void Store(float* values) const
  {
    for (const detail::FloatVector& some : this->Registers)
    {
      *reinterpret_cast<detail::FloatsInMemory*>(values) = some;
      values += detail::VectorWidth;
    }
  }

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
  /// a - b * c, for bounds that hold with one rounding and with two.
  friend Lanes MinusProduct(const Lanes& a, const Lanes& b, const Lanes& c)
  {
    Lanes result;
    for (int i = 0; i < Count; ++i)
    {
      result.Registers[i] = detail::MinusProduct(a.Registers[i], b.Registers[i], c.Registers[i]);
    }
    return result;
  }
  friend Lanes operator/(const Lanes& a, const Lanes& b)
  {
    return Map(a, b, [](detail::FloatVector x, detail::FloatVector y) { return x / y; });
  }
  friend Lanes Sqrt(const Lanes& a)
  {
    return Map(
      a, a, [](detail::FloatVector x, detail::FloatVector) { return detail::SquareRoot(x); });
  }
  friend Lanes Max(const Lanes& a, const Lanes& b)
  {
    return Map(
      a, b, [](detail::FloatVector x, detail::FloatVector y) { return detail::Larger(x, y); });
  }
  friend Lanes Min(const Lanes& a, const Lanes& b)
  {
    return Map(
      a, b, [](detail::FloatVector x, detail::FloatVector y) { return detail::Smaller(x, y); });
  }

  /// Yes or no lane by lane. To ask for its bits takes longer than to combine it.
  class Truths
  {
  public:
    friend Truths operator&(const Truths& a, const Truths& b)
    {
      Truths both;
      for (int i = 0; i < Count; ++i)
      {
        both.Registers[i] = a.Registers[i] & b.Registers[i];
      }
      return both;
    }

    /// Bit i is that of lane i.
    unsigned Bits() const
    {
      unsigned bits = 0;
      for (int i = 0; i < Count; ++i)
      {
        bits |= detail::Bits(this->Registers[i]) << (i * detail::VectorWidth);
      }
      return bits;
    }

  private:
    friend class Lanes;

    detail::TruthVector Registers[W / detail::VectorWidth];
  };

  /// Where a <= b; never for NaN.
  static Truths AreLessEqual(const Lanes& a, const Lanes& b)
  {
    Truths truths;
    for (int i = 0; i < Count; ++i)
    {
      truths.Registers[i] = a.Registers[i] <= b.Registers[i];
    }
    return truths;
  }
  /// The same by bits.
  friend unsigned LessEqual(const Lanes& a, const Lanes& b)
  {
    return AreLessEqual(a, b).Bits();
  }

  /// Lane by lane a <= b ? yes : no.
  friend Lanes IfLessEqual(const Lanes& a, const Lanes& b, const Lanes& yes, const Lanes& no)
  {
    Lanes result;
    for (int i = 0; i < Count; ++i)
    {
      result.Registers[i] = a.Registers[i] <= b.Registers[i] ? yes.Registers[i] : no.Registers[i];
    }
    return result;
  }

private:
  static constexpr int Count = W / detail::VectorWidth;

  template <class Function>
  static Lanes Map(const Lanes& a, const Lanes& b, Function function)
  {
    Lanes result;
    for (int i = 0; i < Count; ++i)
    {
      result.Registers[i] = function(a.Registers[i], b.Registers[i]);
    }
    return result;
  }

  detail::FloatVector Registers[Count];
};

}

#endif
