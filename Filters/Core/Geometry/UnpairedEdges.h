// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_UnpairedEdges_h
#define skd_Geometry_UnpairedEdges_h

#include "MarkedNumbers.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace skd
{

/// Finds the edges that triangles do not pass as often in one direction as in the other, by taking
/// away the two of each pair as triangles come. A few that wait for their other one are kept at
/// their lower end, further ones in a list, so that memory is 32 bytes a point in a usual surface.
/// That costs less than a table of all edges (EdgeTable), which knows the triangles, too. There may
/// be 2^31 points.
class UnpairedEdges
{
public:
  static constexpr std::size_t MostPoints = std::size_t(1) << 31;

  explicit UnpairedEdges(std::size_t numberOfPoints)
    : AtLower(numberOfPoints, Waiting{ 0, {} })
  {
  }

  void Add(std::uint32_t from, std::uint32_t to)
  {
    const std::uint32_t low = std::min(from, to);
    const std::uint32_t passed = std::max(from, to) << 1 | static_cast<std::uint32_t>(from < to);
    Waiting& waiting = this->AtLower[low];
    const std::uint32_t count = waiting.Count;
    for (std::uint32_t i = 0; i < count; ++i)
    {
      if (waiting.Passed[i] == (passed ^ 1u))
      {
        waiting.Passed[i] = waiting.Passed[count - 1];
        waiting.Count = count - 1;
        return;
      }
    }
    if (count < Waiting::Most)
    {
      waiting.Passed[count] = passed;
      waiting.Count = count + 1;
      return;
    }
    this->Others.push_back({ low, passed });
  }

  template <class Corners>
  void AddTriangle(const Corners& corners)
  {
    this->Add(corners[0], corners[1]);
    this->Add(corners[1], corners[2]);
    this->Add(corners[2], corners[0]);
  }

  bool AreNone()
  {
    const auto isEmpty = [](const Waiting& waiting) { return waiting.Count == 0; };
    return (this->Others.empty() &&
             std::all_of(this->AtLower.begin(), this->AtLower.end(), isEmpty)) ||
      this->FindEnds().List().empty();
  }

  /// Marks the ends of the edges that are left.
  MarkedNumbers FindEnds()
  {
    MarkedNumbers ends(this->AtLower.size());
    this->ListAll();
    std::sort(this->Others.begin(), this->Others.end());
    for (auto first = this->Others.begin(); first != this->Others.end();)
    {
      const auto isOther = [first](const Edge& edge)
      { return edge.Low != first->Low || edge.High() != first->High(); };
      const auto last = std::find_if(first, this->Others.end(), isOther);
      const auto forward =
        std::count_if(first, last, [](const Edge& edge) { return (edge.Passed & 1u) != 0; });
      if (2 * forward != last - first)
      {
        ends.Mark(first->Low);
        ends.Mark(first->High());
      }
      first = last;
    }
    return ends;
  }

private:
  struct Edge
  {
    std::uint32_t Low;
    std::uint32_t Passed; // as in Waiting

    std::uint32_t High() const { return this->Passed >> 1; }
    bool operator<(const Edge& other) const
    {
      return std::tie(this->Low, this->Passed) < std::tie(other.Low, other.Passed);
    }
  };

  /// The edges from one point to higher ones: twice the higher end, and one more of those that are
  /// passed towards it.
  struct Waiting
  {
    static constexpr std::uint32_t Most = 7;
    std::uint32_t Count;
    std::array<std::uint32_t, Most> Passed;
  };

  /// So that those which wait at a point and those in the list are together.
  void ListAll()
  {
    for (std::uint32_t low = 0; low < this->AtLower.size(); ++low)
    {
      Waiting& waiting = this->AtLower[low];
      for (std::uint32_t i = 0; i < waiting.Count; ++i)
      {
        this->Others.push_back({ low, waiting.Passed[i] });
      }
      waiting.Count = 0;
    }
  }

  std::vector<Waiting> AtLower;
  std::vector<Edge> Others;
};

}

#endif
