// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Predicates_BigNumber_h
#define skd_Predicates_BigNumber_h

#include "DigitList.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace skd
{

/// A binary number of arbitrary precision: sums, differences and products are exact, without
/// overflow or underflow. For the few signs that no filter decides and whose degree is too high for
/// an Expansion; some hundred times slower than a double.
///
/// Boost.Multiprecision would halve this file; but comparisons took a fifth longer with it
/// (crossings a seventh less), and all who build this would need it.
class BigNumber
{
public:
  BigNumber() = default; ///< 0

  /// A finite number.
  explicit BigNumber(double value)
  {
    int exponent = 0;
    const double mantissa = std::frexp(std::abs(value), &exponent);
    auto digits = static_cast<std::uint64_t>(std::ldexp(mantissa, 53));
    const int shift = exponent - 53;
    this->Exponent = shift >= 0 ? shift / 32 : -((31 - shift) / 32);
    const int rest = shift - 32 * this->Exponent; // 0 to 31
    const std::uint64_t high = rest > 0 ? digits >> (64 - rest) : 0;
    digits <<= rest;
    this->Digits = DigitList(3);
    this->Digits.data()[0] = static_cast<std::uint32_t>(digits);
    this->Digits.data()[1] = static_cast<std::uint32_t>(digits >> 32);
    this->Digits.data()[2] = static_cast<std::uint32_t>(high);
    this->IsNegative = value < 0.0;
    this->Trim();
  }

  int Sign() const { return this->Digits.empty() ? 0 : (this->IsNegative ? -1 : 1); }

  /// The position of the digit after the highest, in digits of 32 bits: the magnitude is below
  /// 2^(32 Top()) and, unless the number is 0, at least 2^(32 (Top() - 1)).
  int Top() const { return this->Exponent + static_cast<int>(this->Digits.size()); }

  friend BigNumber operator-(BigNumber a)
  {
    a.IsNegative = !a.IsNegative;
    return a;
  }

  friend BigNumber operator+(const BigNumber& a, const BigNumber& b)
  {
    return Sum(a, b, b.IsNegative);
  }

  friend BigNumber operator-(const BigNumber& a, const BigNumber& b)
  {
    return Sum(a, b, !b.IsNegative);
  }

  friend BigNumber operator*(const BigNumber& a, const BigNumber& b)
  {
    BigNumber product;
    product.Digits = DigitList(a.Digits.size() + b.Digits.size());
    const std::uint32_t* const ofA = a.Digits.data();
    const std::uint32_t* const ofB = b.Digits.data();
    for (std::size_t i = 0; i < a.Digits.size(); ++i)
    {
      std::uint32_t* const to = product.Digits.data() + i;
      std::uint64_t carry = 0;
      for (std::size_t k = 0; k < b.Digits.size(); ++k)
      {
        carry += static_cast<std::uint64_t>(ofA[i]) * ofB[k] + to[k];
        to[k] = static_cast<std::uint32_t>(carry);
        carry >>= 32;
      }
      to[b.Digits.size()] = static_cast<std::uint32_t>(carry);
    }
    product.Exponent = a.Exponent + b.Exponent;
    product.IsNegative = a.IsNegative != b.IsNegative;
    product.Trim();
    return product;
  }

  /// a / b, b != 0, to a few units in the last place.
  static double Ratio(const BigNumber& a, const BigNumber& b)
  {
    if (a.Digits.empty())
    {
      return 0.0;
    }
    const double ratio = a.Leading() / b.Leading();
    return std::ldexp(a.IsNegative != b.IsNegative ? -ratio : ratio, 32 * (a.Top() - b.Top()));
  }

private:
  std::uint32_t At(int digit) const
  {
    const int i = digit - this->Exponent;
    return i >= 0 && i < static_cast<int>(this->Digits.size()) ? this->Digits[i] : 0;
  }

  /// The magnitude over 2^(32 Top).
  double Leading() const
  {
    double leading = 0.0;
    for (int i = 4; i > 0; --i) // the lowest first
    {
      leading = std::ldexp(leading + this->At(this->Top() - i), -32);
    }
    return leading;
  }

  static int CompareMagnitudes(const BigNumber& a, const BigNumber& b)
  {
    const int lowest = std::min(a.Exponent, b.Exponent);
    for (int digit = std::max(a.Top(), b.Top()) - 1; digit >= lowest; --digit)
    {
      if (a.At(digit) != b.At(digit))
      {
        return a.At(digit) < b.At(digit) ? -1 : 1;
      }
    }
    return 0;
  }

  /// The sum of a and the magnitude of b with a sign.
  static BigNumber Sum(const BigNumber& a, const BigNumber& b, bool isNegative)
  {
    if (b.Digits.empty() || (!a.Digits.empty() && a.IsNegative == isNegative))
    {
      return b.Digits.empty() ? a : Combine(a, b, 1);
    }
    if (!a.Digits.empty() && CompareMagnitudes(a, b) >= 0)
    {
      return Combine(a, b, -1);
    }
    BigNumber sum = a.Digits.empty() ? b : Combine(b, a, -1);
    sum.IsNegative = isNegative;
    return sum;
  }

  /// The magnitudes added, or the lower taken from the higher; the sign of a.
  static BigNumber Combine(const BigNumber& a, const BigNumber& b, int sign)
  {
    BigNumber sum;
    sum.Exponent = std::min(a.Exponent, b.Exponent);
    sum.IsNegative = a.IsNegative;
    const int top = std::max(a.Top(), b.Top()) + 1;
    sum.Digits = DigitList(static_cast<std::size_t>(top - sum.Exponent));
    std::uint32_t* to = sum.Digits.data();
    std::int64_t carry = 0;
    for (int digit = sum.Exponent; digit < top; ++digit)
    {
      carry +=
        static_cast<std::int64_t>(a.At(digit)) + sign * static_cast<std::int64_t>(b.At(digit));
      *to++ = static_cast<std::uint32_t>(carry & 0xffffffff);
      carry = carry < 0 ? -1 : carry >> 32;
    }
    sum.Trim();
    return sum;
  }

  void Trim() { this->Exponent += static_cast<int>(this->Digits.Trim()); }

  DigitList Digits; // the lowest first; neither end is 0
  int Exponent = 0; // the position of the lowest, in digits of 32 bits
  bool IsNegative = false;
};

}

#endif
