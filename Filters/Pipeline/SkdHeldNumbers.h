// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdHeldNumbers.h
 * @brief Numbers as arrays of a type can hold them: integers that would overflow are the least or
 * the largest, and those of 64 bits, of which a double has the first 53, are not rounded in
 * between.
 */

#ifndef SkdHeldNumbers_h
#define SkdHeldNumbers_h

#include "vtkDataArray.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace skdtree
{
/// Whether a type has integers that are no doubles.
template <typename Value>
constexpr bool SkdIsLong = std::is_integral_v<Value>&& std::numeric_limits<Value>::digits >
  std::numeric_limits<double>::digits;

/// The nearest number of a type; of integers 0 for NaN.
template <typename Value>
Value SkdNearestNumber(double x)
{
  if constexpr (std::is_integral_v<Value>)
  {
    using Limits = std::numeric_limits<Value>;
    const double rounded = std::round(x);
    return std::isnan(x)                                 ? Value(0)
      : rounded >= std::ldexp(1.0, Limits::digits)       ? Limits::max()
      : rounded <= static_cast<double>(Limits::lowest()) ? Limits::lowest()
                                                         : static_cast<Value>(rounded);
  }
  else
  {
    return static_cast<Value>(x);
  }
}

/// a - b, rounded.
template <typename Value>
double SkdDifference(Value a, Value b)
{
  const auto wide = [](Value x) { return static_cast<std::uint64_t>(x); };
  return a < b ? -static_cast<double>(wide(b) - wide(a)) : static_cast<double>(wide(a) - wide(b));
}

/// The integer nearest to a + x that is a number of its type.
template <typename Value>
Value SkdNearestSum(Value a, double x)
{
  using Limits = std::numeric_limits<Value>;
  const auto wide = [](Value number) { return static_cast<std::uint64_t>(number); };
  const double far = std::ldexp(1.0, std::numeric_limits<std::uint64_t>::digits);
  const double step = std::min(std::round(std::abs(x)), far);
  const std::uint64_t room =
    x < 0.0 ? wide(a) - wide(Limits::lowest()) : wide(Limits::max()) - wide(a);
  if (step == far || static_cast<std::uint64_t>(step) >= room)
  {
    return x < 0.0 ? Limits::lowest() : Limits::max();
  }
  const auto whole = static_cast<std::uint64_t>(step);
  return static_cast<Value>(x < 0.0 ? wide(a) - whole : wide(a) + whole);
}

/// The sum of weights times valueOf(i), for i below n. Where integers are so long that they are no
/// doubles, it is found from their differences, if the weights sum up to 1: if all are the same, it
/// is that.
template <typename Value, class ValueOf>
Value SkdInterpolated(vtkIdType n, const double* weights, const ValueOf& valueOf)
{
  double sum = 0.0;
  for (vtkIdType i = 0; i < n; ++i)
  {
    sum += weights[i] * static_cast<double>(valueOf(i));
  }
  if constexpr (SkdIsLong<Value>)
  {
    constexpr double most = 9007199254740992.0; // of which all integers below are doubles
    constexpr double rounding = 1e-9;
    double all = 0.0;
    double largest = 0.0;
    double beyond = 0.0; // the first
    for (vtkIdType i = 0; i < n; ++i)
    {
      all += weights[i];
      largest = std::max(largest, std::abs(static_cast<double>(valueOf(i))));
      beyond += weights[i] * SkdDifference<Value>(valueOf(i), valueOf(0));
    }
    if (largest >= most && std::abs(all - 1.0) < rounding)
    {
      return SkdNearestSum<Value>(valueOf(0), beyond);
    }
  }
  return SkdNearestNumber<Value>(sum);
}

/// A value of any array of numbers, not rounded if both types have it.
template <typename Value>
Value SkdNumberAt(vtkDataArray* array, vtkIdType tuple, int component)
{
  if constexpr (SkdIsLong<Value>)
  {
    using Limits = std::numeric_limits<Value>;
    const vtkVariant number =
      array->GetVariantValue(tuple * array->GetNumberOfComponents() + component);
    const bool isNegative = number.IsNumeric() && number.ToDouble() < 0.0;
    if (number.IsUnsignedLongLong() || number.IsUnsignedLong())
    {
      const std::uint64_t value = number.ToUnsignedLongLong();
      return static_cast<Value>(std::min<std::uint64_t>(value, Limits::max()));
    }
    if (number.IsLongLong() || number.IsLong())
    {
      return isNegative && !Limits::is_signed ? Value(0) : static_cast<Value>(number.ToLongLong());
    }
  }
  return SkdNearestNumber<Value>(array->GetComponent(tuple, component));
}
}

#endif
