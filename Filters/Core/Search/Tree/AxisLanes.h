// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_AxisLanes_h
#define skd_Tree_AxisLanes_h

#include "../../Geometry/ForEachAxis.h"
#include "../../Geometry/Vector.h"
#include "Lanes.h"

#include <cstring>
#include <type_traits>

namespace skd
{

/// Arithmetic on all axes at once, in double precision: for what is done once a query. NaN as in
/// Lanes.
template <int D>
class AxisLanes
{
public:
  AxisLanes() = default;
  explicit AxisLanes(double value)
  {
    ForEachAxis<Count>([&](int i) { this->Registers[i] = value - DoubleVector{}; });
  }
  explicit AxisLanes(const Vector<D>& values)
  {
    ForEachAxis<Count - 1>(
      [&](int i) { this->Registers[i] = LoadDoubles(values.X + i * NativeDoubles); });
    constexpr int before = Room - NativeDoubles;
    this->Registers[Count - 1] = LoadDoubles<D - before>(values.X + before);
  }

  /// Of at(axis).
  template <class At>
  static AxisLanes Of(const At& at)
  {
    AxisLanes lanes;
    ForEachAxis<Count>(
      [&](int i)
      {
        const int first = i * NativeDoubles;
        const auto in = [&](int lane)
        { return first + lane < D ? at(first + lane) : decltype(at(0))(); };
        lanes.Registers[i] = DoublesOf(in);
      });
    return lanes;
  }

  Vector<D> Values() const
  {
    Vector<D> values;
    double padded[Room];
    std::memcpy(padded, this->Registers, sizeof(padded));
    ForEachAxis<D>([&](int axis) { values[axis] = padded[axis]; });
    return values;
  }

  /// What whole registers hold: D, and what is beyond.
  static constexpr int Room = (D + NativeDoubles - 1) / NativeDoubles * NativeDoubles;

  /// Rounded to floats.
  void StorePadded(float (&to)[Room]) const
  {
    ForEachAxis<Count>([&](int i) { StoreAs(this->Registers[i], to + i * NativeDoubles); });
  }

  /// The same, each for every lane of operations on boxes.
  friend void SpreadOut(const AxisLanes& from, Spread* to)
  {
#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__AVX__)
    static_assert(std::is_same_v<Spread, float>, "as they are stored");
    ForEachAxis<Count>(
      [&](int i)
      {
        StoreAs(from.Registers[i], to + i * NativeDoubles);
        // GCC 12 would take them out of the register again, one by one.
        __asm__("" : "+m"(*reinterpret_cast<float(*)[NativeDoubles]>(to + i * NativeDoubles)));
      });
#else
    float values[Room];
    from.StorePadded(values);
    ForEachAxis<Room>([&](int i) { to[i] = Spread(values[i]); });
#endif
  }

  friend AxisLanes operator+(const AxisLanes& a, const AxisLanes& b)
  {
    return Map(a, b, [](DoubleVector x, DoubleVector y) { return x + y; });
  }
  friend AxisLanes operator-(const AxisLanes& a, const AxisLanes& b)
  {
    return Map(a, b, [](DoubleVector x, DoubleVector y) { return x - y; });
  }
  AxisLanes operator-() const
  {
    return AxisLanes(0.0) - *this;
  }
  friend AxisLanes operator*(const AxisLanes& a, const AxisLanes& b)
  {
    return Map(a, b, [](DoubleVector x, DoubleVector y) { return x * y; });
  }
  friend AxisLanes operator/(const AxisLanes& a, const AxisLanes& b)
  {
    return Map(a, b, [](DoubleVector x, DoubleVector y) { return x / y; });
  }
  friend AxisLanes Max(const AxisLanes& a, const AxisLanes& b)
  {
    return Map(a, b, [](DoubleVector x, DoubleVector y) { return Larger(x, y); });
  }
  friend AxisLanes Min(const AxisLanes& a, const AxisLanes& b)
  {
    return Map(a, b, [](DoubleVector x, DoubleVector y) { return Smaller(x, y); });
  }

  friend AxisLanes Abs(const AxisLanes& a)
  {
    return Map(a, a, [](DoubleVector x, DoubleVector) { return WithoutSign(x); });
  }
  /// a where b has no sign bit, -a where it has.
  friend AxisLanes TimesSign(const AxisLanes& a, const AxisLanes& b)
  {
    return Map(a, b, [](DoubleVector x, DoubleVector y) { return skd::TimesSign(x, y); });
  }
  /// Bit i: axis i has the sign bit.
  unsigned Signs() const
  {
    unsigned bits = 0;
    ForEachAxis<Count>([&](int i) { bits |= SignBits(this->Registers[i]) << (i * NativeDoubles); });
    return bits & LowBits(D);
  }

  /// On each axis what is on the next, on the last what is on the first.
  friend AxisLanes Next(const AxisLanes& a)
  {
#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__AVX2__)
    if constexpr (D == 3)
    {
      AxisLanes next;
      next.Registers[0] = _mm256_permute4x64_pd(a.Registers[0], 0b11001001);
      return next;
    }
#endif
    return Of([&](int axis) { return a[(axis + 1) % D]; });
  }
  double operator[](int axis) const
  {
    return LaneOf(this->Registers[axis / NativeDoubles], axis % NativeDoubles);
  }

  /// a b - c, rounded once.
  friend AxisLanes ProductMinus(const AxisLanes& a, const AxisLanes& b, const AxisLanes& c)
  {
#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__AVX__) && defined(__FMA__)
    AxisLanes result;
    ForEachAxis<Count>([&](int i)
      { result.Registers[i] = _mm256_fmsub_pd(a.Registers[i], b.Registers[i], c.Registers[i]); });
    return result;
#else
    return Of([&](int axis) { return std::fma(a[axis], b[axis], -c[axis]); });
#endif
  }

  /// Bit i: a > b on axis i; never for NaN.
  friend unsigned Above(const AxisLanes& a, const AxisLanes& b)
  {
    unsigned bits = 0;
    ForEachAxis<Count>(
      [&](int i) { bits |= skd::Above(a.Registers[i], b.Registers[i]) << (i * NativeDoubles); });
    return bits & LowBits(D);
  }

  /// Whether a <= b on every axis; false with NaN.
  friend bool AllLessEqual(const AxisLanes& a, const AxisLanes& b)
  {
    bool areLess = true;
    ForEachAxis<Count>(
      [&](int i) { areLess = areLess & skd::AllLessEqual(a.Registers[i], b.Registers[i]); });
    return areLess;
  }

private:
  static constexpr int Count = Room / NativeDoubles;

  template <class Function>
  static AxisLanes Map(const AxisLanes& a, const AxisLanes& b, Function function)
  {
    AxisLanes result;
    ForEachAxis<Count>(
      [&](int i) { result.Registers[i] = function(a.Registers[i], b.Registers[i]); });
    return result;
  }

  DoubleVector Registers[Count];
};

}

#endif
