// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCompensatedSum_h
#define SkdCompensatedSum_h

#include <algorithm>
#include <cmath>
#include <vector>

namespace skdtree
{
/// A sum whose error does not grow with the number of what is added (Neumaier, ZAMM 54 (1974)
/// 39-51). NaN and infinity stay what they are.
class SkdCompensatedSum
{
public:
  SkdCompensatedSum() = default;

  /// A sum that another process has, by its two parts.
  SkdCompensatedSum(double sum, double lost)
    : Sum(sum)
    , Lost(lost)
  {
  }

  void Add(double value)
  {
    const double sum = this->Sum + value;
    this->Lost += std::abs(this->Sum) >= std::abs(value) ? (this->Sum - sum) + value
                                                         : (value - sum) + this->Sum;
    this->Sum = sum;
  }

  void Add(const SkdCompensatedSum& other)
  {
    this->Add(other.Sum);
    this->Lost += other.Lost;
  }

  double Get() const { return std::isfinite(this->Sum) ? this->Sum + this->Lost : this->Sum; }

  ///@{
  /// The sum as it was rounded, and what rounding took from it.
  double GetSum() const { return this->Sum; }
  double GetLost() const { return this->Lost; }
  ///@}

private:
  double Sum = 0.0;
  double Lost = 0.0;
};

/// The sum of what several processes have: the same on all of them, in whatever order they have it.
inline double SkdSumOfProcesses(std::vector<double> numbers)
{
  std::sort(numbers.begin(), numbers.end());
  SkdCompensatedSum sum;
  for (const double number : numbers)
  {
    sum.Add(number);
  }
  return sum.Get();
}
}

#endif
