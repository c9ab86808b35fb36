// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdReduction.h
 * @brief What several processes find together, each of which has a part of what is compared.
 */

#ifndef SkdReduction_h
#define SkdReduction_h

#include "Pipeline/SkdCompensatedSum.h"

#include <vector>

class vtkMultiProcessController;

namespace skdtree
{
/// All processes must call each function together; all get the same. Of one process alone it is
/// what this has. Each function takes a process O(log(n)) messages.
class SkdReduction
{
public:
  /// Of the processes of a controller, or of one process: nullptr.
  explicit SkdReduction(vtkMultiProcessController* controller = nullptr)
    : Controller(controller)
  {
  }

  int GetRank() const;
  int GetNumberOfProcesses() const;

  /// Whether it is so on any of them.
  bool IsAny(bool here) const { return this->Largest(here ? 1.0 : 0.0) != 0.0; }

  double Largest(double here) const
  {
    std::vector<double> numbers{ here };
    this->TakeLargest(numbers);
    return numbers[0];
  }

  /// Each of the numbers becomes the largest of those of all processes with its index.
  void TakeLargest(std::vector<double>& numbers) const;

  ///@{
  /// Each becomes the sum.
  void AddUp(std::vector<long long>& numbers) const;
  long long Sum(long long here) const
  {
    std::vector<long long> numbers{ here };
    this->AddUp(numbers);
    return numbers[0];
  }
  ///@}

  /// The sums, but for one rounding: whichever process has what, and in whatever order.
  std::vector<double> Sum(const std::vector<SkdCompensatedSum>& here) const;

  /// The numbers of all, process by process, each of which has as many.
  std::vector<double> Gather(const std::vector<double>& here) const;

  /// The same where each process has a number of its own of them, which all know.
  std::vector<double> Gather(
    const std::vector<double>& here, const std::vector<double>& numbers) const;

private:
  vtkMultiProcessController* Controller;
};
}

#endif
