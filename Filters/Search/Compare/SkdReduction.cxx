// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Compare/SkdReduction.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <numeric>

namespace skdtree
{
namespace
{
template <class Number>
void Reduce(vtkMultiProcessController* controller, std::vector<Number>& numbers, int operation)
{
  if (controller)
  {
    const std::vector<Number> own = numbers;
    controller->AllReduce(
      own.data(), numbers.data(), static_cast<vtkIdType>(numbers.size()), operation);
  }
}
}

int SkdReduction::GetRank() const
{
  return this->Controller ? this->Controller->GetLocalProcessId() : 0;
}

int SkdReduction::GetNumberOfProcesses() const
{
  return this->Controller ? this->Controller->GetNumberOfProcesses() : 1;
}

void SkdReduction::TakeLargest(std::vector<double>& numbers) const
{
  Reduce(this->Controller, numbers, vtkCommunicator::MAX_OP);
}

void SkdReduction::AddUp(std::vector<long long>& numbers) const
{
  Reduce(this->Controller, numbers, vtkCommunicator::SUM_OP);
}

std::vector<double> SkdReduction::Sum(const std::vector<SkdCompensatedSum>& here) const
{
  std::vector<double> parts;
  for (const SkdCompensatedSum& sum : here)
  {
    parts.push_back(sum.GetSum());
    parts.push_back(sum.GetLost());
  }
  const std::vector<double> all = this->Gather(parts);
  std::vector<double> sums;
  for (std::size_t i = 0; i < here.size(); ++i)
  {
    SkdCompensatedSum sum;
    for (std::size_t at = 2 * i; at < all.size(); at += parts.size())
    {
      sum.Add({ all[at], all[at + 1] });
    }
    sums.push_back(sum.Get());
  }
  return sums;
}

std::vector<double> SkdReduction::Gather(const std::vector<double>& here) const
{
  if (!this->Controller)
  {
    return here;
  }
  std::vector<double> all(here.size() * static_cast<std::size_t>(this->GetNumberOfProcesses()));
  this->Controller->AllGather(here.data(), all.data(), static_cast<vtkIdType>(here.size()));
  return all;
}

std::vector<double> SkdReduction::Gather(
  const std::vector<double>& here, const std::vector<double>& numbers) const
{
  if (!this->Controller)
  {
    return here;
  }
  std::vector<vtkIdType> lengths(numbers.begin(), numbers.end());
  std::vector<vtkIdType> offsets(lengths.size(), 0);
  std::partial_sum(lengths.begin(), lengths.end() - 1, offsets.begin() + 1);
  std::vector<double> all(static_cast<std::size_t>(offsets.back() + lengths.back()));
  this->Controller->AllGatherV(
    here.data(), all.data(), static_cast<vtkIdType>(here.size()), lengths.data(), offsets.data());
  return all;
}
}
