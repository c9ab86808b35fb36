// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// SkdWeightedValues: quantiles are those of sorted values, whatever their magnitudes and weights.

#include "Search/Compare/SkdWeightedValues.h"

#include "vtkAbstractArray.h"
#include "vtkCommunicator.h"
#include "vtkDummyController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

using namespace skdtree;

namespace
{

using Values = std::vector<SkdWeightedDistance>;
using Query = SkdWeightedValues::Query;

constexpr long long SkdWeightedDistance::*Fine = &SkdWeightedDistance::Fine;
constexpr long long SkdWeightedDistance::*Coarse = &SkdWeightedDistance::Coarse;

std::vector<double> FindIn(
  const Values& values, const std::vector<Query>& queries, const SkdReduction& all = SkdReduction())
{
  const SkdWeightedValues found(
    [&](const auto& visit) { std::for_each(values.begin(), values.end(), visit); }, all);
  return found.Find(queries);
}

/// The first of two processes, of which the other one has nothing. Counts what they tell each
/// other.
class CountedExchanges : public vtkCommunicator
{
public:
  static CountedExchanges* New();
  vtkTypeMacro(CountedExchanges, vtkCommunicator);

  int Number = 0;

  int SendVoidArray(const void*, vtkIdType, int, int, int) override { return 0; }
  int ReceiveVoidArray(void*, vtkIdType, int, int, int) override { return 0; }

  int AllGatherVoidArray(const void* own, void* all, vtkIdType length, int type) override
  {
    ++this->Number;
    const std::size_t size = SizeOf(length, type);
    std::memcpy(all, own, size);
    std::memset(static_cast<char*>(all) + size, 0, size);
    return 1;
  }

  int AllGatherVVoidArray(
    const void* own, void* all, vtkIdType length, vtkIdType*, vtkIdType*, int type) override
  {
    ++this->Number;
    std::memcpy(all, own, SizeOf(length, type));
    return 1;
  }

  int AllReduceVoidArray(const void* own, void* all, vtkIdType length, int type, int) override
  {
    ++this->Number;
    std::memcpy(all, own, SizeOf(length, type));
    return 1;
  }

protected:
  CountedExchanges() { this->MaximumNumberOfProcesses = this->NumberOfProcesses = 2; }

private:
  static std::size_t SizeOf(vtkIdType length, int type)
  {
    return static_cast<std::size_t>(length * vtkAbstractArray::GetDataTypeSize(type));
  }
};

vtkStandardNewMacro(CountedExchanges);

double FindSorted(Values values, const Query& query)
{
  std::sort(values.begin(), values.end(),
    [](const SkdWeightedDistance& a, const SkdWeightedDistance& b) { return a.Value < b.Value; });
  long long sum = 0;
  double last = 0.0;
  for (const SkdWeightedDistance& value : values)
  {
    const long long weight = value.*query.Weight;
    sum += weight;
    last = weight > 0 ? value.Value : last;
    if (weight > 0 && sum >= query.Part)
    {
      return value.Value;
    }
  }
  return last;
}

/// Values over many orders of magnitude, or nearly all alike but for a few; some are zero, some
/// are there many times, some have no weight.
Values MakeValues(std::size_t number, double decades, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> exponent(-decades, 0.0);
  std::uniform_int_distribution<int> weight(0, 1000);
  Values values;
  for (std::size_t i = 0; i < number; ++i)
  {
    const double value = i % 7 == 0 ? 0.0 : std::pow(10.0, exponent(random));
    values.push_back({ i % 3 == 0 ? std::ldexp(std::floor(std::ldexp(value, 10)), -10) : value,
      weight(random), i % 2 == 0 ? weight(random) : 0 });
  }
  return values;
}

}

TEST(WeightedValues, QuantilesAreThoseOfSortedValues)
{
  unsigned seed = 1;
  for (const std::size_t number : { 1, 2, 10, 1000, 30000 })
  {
    for (const double decades : { 0.0, 1e-7, 1.0, 20.0 })
    {
      const Values values = MakeValues(number, decades, seed++);
      std::vector<Query> queries;
      for (const long long part : { -5LL, 1LL, 2LL, 77LL, 1234LL, 250000LL, 7000000LL, 1LL << 60 })
      {
        queries.push_back({ part, Fine });
        queries.push_back({ part, Coarse });
      }
      const std::vector<double> found = FindIn(values, queries);
      for (std::size_t i = 0; i < queries.size(); ++i)
      {
        EXPECT_EQ(found[i], FindSorted(values, queries[i]))
          << number << " values, " << decades << " decades, part " << queries[i].Part;
      }
    }
  }
}

TEST(WeightedValues, AnOutlierLeavesTheOthersApart)
{
  Values values = MakeValues(5000, 1.0, 99);
  values.push_back({ 1e12, 3, 3 });
  for (const long long part : { 10LL, 100000LL, 2000000LL })
  {
    const Query query{ part, Fine };
    EXPECT_EQ(FindIn(values, { query })[0], FindSorted(values, query)) << part;
  }
}

// For each message takes its time, however short it is.
TEST(WeightedValues, FewAreToldAtOnceAndManyByAndBy)
{
  std::vector<Query> queries;
  for (const long long part : { 10LL, 1000LL, 2000LL, 300000LL })
  {
    queries.push_back({ part, Fine });
    queries.push_back({ part, Coarse });
  }
  for (const bool areFew : { true, false })
  {
    const Values values = MakeValues(areFew ? 20000 : 70000, 8.0, 5);
    vtkNew<CountedExchanges> exchanges;
    vtkNew<vtkDummyController> controller;
    controller->SetCommunicator(exchanges);
    const SkdReduction all(controller);
    EXPECT_EQ(FindIn(values, queries, all), FindIn(values, queries));
    EXPECT_EQ(exchanges->Number == 2, areFew) << exchanges->Number;
    EXPECT_GE(exchanges->Number, 2);
  }
}

TEST(WeightedValues, WithoutValuesThereIsZero)
{
  EXPECT_EQ(FindIn({}, { { 1, Fine }, { 0, Coarse } }), std::vector<double>(2, 0.0));
}
