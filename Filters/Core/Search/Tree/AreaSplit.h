// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_AreaSplit_h
#define skd_Tree_AreaSplit_h

#include "SplitAtRank.h"

#include <array>
#include <cmath>

namespace skd
{

/// The split with the least sum of box areas times numbers of leaves, proportional to the expected
/// number of visits by a random query (surface area heuristic; J. D. MacDonald, K. S. Booth,
/// "Heuristics for ray tracing using space subdivision", Visual Computer 6 (1990) 153-166).
///
///   centroids in 16 bins along each axis      [:. |..:|.  | : ]
///   a cut between two bins, rounded to        <- box ->|<- box ->
///   whole leaves
///
/// Large ranges are sampled. O(1) for these, O(n) for others; no allocation.
template <int D>
class AreaSplit
{
public:
  struct Cut
  {
    int Axis;
    std::uint64_t Left; ///< leaves before the cut
  };

  /// The number of leaves, and the range of numbers allowed before the cut.
  struct Bounds
  {
    std::uint64_t Leaves;
    std::uint64_t Least;
    std::uint64_t Most;
  };

  AreaSplit(const Element<D>* first, const Element<D>* last, std::uint32_t capacity)
    : Number(static_cast<double>(last - first))
    , Capacity(capacity)
  {
    const std::ptrdiff_t stride = 1 + (last - first) / SampleSize;
    Corner low = Spread(std::numeric_limits<float>::max());
    Corner high = Spread(std::numeric_limits<float>::lowest());
    for (const Element<D>* at = first; at < last; at += Step(at, last, stride))
    {
      for (int axis = 0; axis < D; ++axis)
      {
        low[axis] = std::min(low[axis], TwiceCentroid(*at, axis));
        high[axis] = std::max(high[axis], TwiceCentroid(*at, axis));
      }
    }
    this->FillBins(first, last, stride, low, high);
  }

  /// If all cuts are equally good, the one in the middle.
  Cut Best(const Bounds& bounds, int longestAxis) const
  {
    Candidate best{ std::numeric_limits<double>::infinity(),
      { longestAxis, std::clamp(bounds.Leaves / 2, bounds.Least, bounds.Most) } };
    for (int i = 0; i < D; ++i)
    {
      this->TryAxis((longestAxis + i) % D, bounds, best);
    }
    return best.Where;
  }

private:
  static constexpr int NumberOfBins = 16;
  static constexpr std::ptrdiff_t SampleSize = 2048;
  using Corner = std::array<float, D>;

  struct Bin
  {
    FloatBox<D> Box = NoBox<D>();
    double Count = 0.0;
  };
  struct Candidate
  {
    double Cost;
    Cut Where;
  };

  static Corner Spread(float value)
  {
    Corner corner;
    corner.fill(value);
    return corner;
  }
  static float TwiceCentroid(const Element<D>& element, int axis)
  {
    return element.Box.Min[axis] + element.Box.Max[axis];
  }
  static std::ptrdiff_t Step(const Element<D>* at, const Element<D>* last, std::ptrdiff_t stride)
  {
    return std::min(stride, last - at);
  }

  void FillBins(const Element<D>* first, const Element<D>* last, std::ptrdiff_t stride,
    const Corner& low, const Corner& high)
  {
    Corner scale;
    for (int axis = 0; axis < D; ++axis)
    {
      const float wanted = 0.9999f * NumberOfBins / (high[axis] - low[axis]);
      scale[axis] = std::isfinite(wanted) ? wanted : 0.0f;
    }
    for (const Element<D>* at = first; at < last; at += Step(at, last, stride))
    {
      for (int axis = 0; axis < D; ++axis)
      {
        const float inBins = (TwiceCentroid(*at, axis) - low[axis]) * scale[axis];
        Bin& bin = this->Bins[axis][std::min(static_cast<int>(inBins), NumberOfBins - 1)];
        Enclose(bin.Box, at->Box);
        bin.Count += 1.0;
      }
      this->Sampled += 1.0;
    }
  }

  void TryAxis(int axis, const Bounds& bounds, Candidate& best) const
  {
    const auto& bins = this->Bins[axis];
    std::array<double, NumberOfBins> areaAfter;
    FloatBox<D> box = NoBox<D>();
    for (int i = NumberOfBins - 1; i > 0; --i)
    {
      Enclose(box, bins[i].Box);
      areaAfter[i] = HalfArea(box);
    }
    box = NoBox<D>();
    double count = 0.0;
    for (int i = 0; i + 1 < NumberOfBins; ++i)
    {
      Enclose(box, bins[i].Box);
      count += bins[i].Count;
      if (count > 0.0 && count < this->Sampled)
      {
        const double before = count / this->Sampled * this->Number;
        this->Try(axis, before, HalfArea(box), areaAfter[i + 1], bounds, best);
      }
    }
  }

  /// The cut after so many elements. Rounding it takes some of one box into the other, which makes
  /// that larger: the more, the less sure are the areas.
  void Try(int axis, double before, double areaBefore, double areaAfter, const Bounds& bounds,
    Candidate& best) const
  {
    // NOLINTNEXTLINE(bugprone-incorrect-roundings): never negative
    const auto nearest = static_cast<std::uint64_t>(before / this->Capacity + 0.5);
    const std::uint64_t left = std::clamp(nearest, bounds.Least, bounds.Most);
    const double moved = std::abs(double(left) * this->Capacity - before) / this->Number;
    const double work = areaBefore * double(left) + areaAfter * double(bounds.Leaves - left);
    const double cost = work * (1.0 + moved);
    if (cost < best.Cost)
    {
      best = { cost, { axis, left } };
    }
  }

  double Number;
  std::uint32_t Capacity;
  double Sampled = 0.0;
  std::array<std::array<Bin, NumberOfBins>, D> Bins;
};

}

#endif
