// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// The split of a range at a rank parts the elements as a sort would.

#include "Core/Search/Tree/SplitAtRank.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <vector>

namespace
{

using Element = skd::Element<3>;
constexpr int Axis = 1;

/// Twice the centroid, and the index.
std::pair<float, std::uint32_t> KeyOf(const Element& e)
{
  return { e.Box.Min[Axis] + e.Box.Max[Axis], e.Index };
}

bool IsBefore(const Element& a, const Element& b)
{
  return KeyOf(a) < KeyOf(b);
}

struct Kind
{
  const char* Name;
  std::function<float(int i, int n, std::mt19937& random)> Centroid;
};

float Uniform(std::mt19937& random)
{
  return static_cast<float>(random()) / 4294967296.0f - 0.5f;
}

std::vector<Kind> Kinds()
{
  return { { "Random", [](int, int, std::mt19937& r) { return Uniform(r); } },
    { "Sorted", [](int i, int n, std::mt19937&) { return float(i) / float(n); } },
    { "Reversed", [](int i, int n, std::mt19937&) { return -float(i) / float(n); } },
    { "Equal", [](int, int, std::mt19937&) { return 0.25f; } },
    { "ZerosOfBothSigns", [](int i, int, std::mt19937&) { return i % 2 ? 0.0f : -0.0f; } },
    { "FewValues", [](int, int, std::mt19937& r) { return float(r() % 3) - 1.0f; } },
    { "Graded", [](int, int, std::mt19937& r) { return std::ldexp(Uniform(r), -int(r() % 100)); } },
    { "Saw", [](int i, int, std::mt19937&) { return float(i % 512); } },
    { "OneOutlier",
      [](int i, int, std::mt19937&) { return i == 7 ? 1e30f : 1e-30f * float(i); } } };
}

std::vector<Element> MakeElements(const Kind& kind, int n)
{
  std::mt19937 random(180);
  std::vector<Element> elements;
  for (int i = 0; i < n; ++i)
  {
    const float centroid = kind.Centroid(i, n, random);
    elements.push_back(
      { { { 0, centroid, 0 }, { 0, centroid, 0 } }, static_cast<std::uint32_t>(i) });
  }
  std::shuffle(elements.begin(), elements.begin() + n / 2, random);
  return elements;
}

TEST(SplitAtRank, PartsAsASortDoes)
{
  for (const Kind& kind : Kinds())
  {
    for (const int n : { 1, 2, 3, 9, 16, 17, 100, 4095, 4096, 4097, 5000, 40000 })
    {
      const std::vector<Element> elements = MakeElements(kind, n);
      std::vector<Element> sorted = elements;
      std::sort(sorted.begin(), sorted.end(), IsBefore);
      for (const int middle : { 0, 1, n / 8, n / 2, n / 2 + 1, 7 * n / 8, n - 1, n })
      {
        std::vector<Element> split = elements;
        Element* const first = split.data();
        skd::SplitAtRank<3>::Run(first, first + middle, first + n, Axis);
        std::sort(split.begin(), split.begin() + middle, IsBefore);
        std::sort(split.begin() + middle, split.end(), IsBefore);
        for (int i = 0; i < n; ++i)
        {
          ASSERT_EQ(split[i].Index, sorted[i].Index)
            << kind.Name << ", " << n << " at " << middle << ", element " << i;
        }
      }
    }
  }
}

TEST(SplitAtRank, IsTheSameEachTime)
{
  const std::vector<Element> elements = MakeElements(Kinds().front(), 20000);
  std::vector<Element> once = elements;
  std::vector<Element> again = elements;
  skd::SplitAtRank<3>::Run(once.data(), once.data() + 9000, once.data() + 20000, Axis);
  skd::SplitAtRank<3>::Run(again.data(), again.data() + 9000, again.data() + 20000, Axis);
  for (std::size_t i = 0; i < once.size(); ++i)
  {
    ASSERT_EQ(once[i].Index, again[i].Index);
  }
}

}
