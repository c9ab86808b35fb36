// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_ElementSizes_h
#define skd_Tree_ElementSizes_h

#include "RawVector.h"
#include "SplitAtRank.h"
#include "SplitRule.h"

#include <cstddef>
#include <vector>

namespace skd
{

/// Statistics of a set of elements that decide whether median splits are good enough: boxes of
/// volume cells overlap, and a median that cuts through large ones leaves both sides large. From a
/// reproducible sample of at most SampleSize elements.
template <int D>
class ElementSizes
{
public:
  static constexpr std::size_t SampleSize = 4096;
  static constexpr double LeastOverlap = 0.25;
  static constexpr double LeastSpread = 1.2;

  explicit ElementSizes(const RawVector<Element<D>>& elements)
  {
    const std::size_t stride = 1 + elements.size() / SampleSize;
    double count = 0.0;
    for (std::size_t i = 0; i < elements.size(); i += stride)
    {
      this->Add(elements[i].Box);
      count += 1.0;
    }
    this->Scale(count, static_cast<double>(elements.size()));
  }
  /// Of a sample of so many elements.
  ElementSizes(const std::vector<Element<D>>& sample, std::size_t all)
  {
    for (const Element<D>& element : sample)
    {
      this->Add(element.Box);
    }
    this->Scale(static_cast<double>(sample.size()), static_cast<double>(all));
  }

  /// The average number of boxes that contain a point of the common bounding box.
  double Overlap() const { return this->TheOverlap; }
  /// The mean of the squared areas of the boxes over the square of their mean: 1 when all are
  /// equal.
  double Spread() const { return this->TheSpread; }

  SplitRule Choose() const
  {
    const bool isArea = this->TheOverlap >= LeastOverlap && this->TheSpread >= LeastSpread;
    return isArea ? SplitRule::SurfaceArea : SplitRule::Median;
  }

private:
  void Add(const FloatBox<D>& box)
  {
    double volume = 1.0;
    for (int axis = 0; axis < D; ++axis)
    {
      volume *= double(box.Max[axis]) - box.Min[axis];
    }
    const double area = HalfArea(box);
    this->Volume += volume;
    this->Area += area;
    this->Area2 += area * area;
    Enclose(this->All, box);
  }

  void Scale(double sampled, double all)
  {
    double volume = 1.0;
    for (int axis = 0; axis < D; ++axis)
    {
      volume *= double(this->All.Max[axis]) - this->All.Min[axis];
    }
    this->TheOverlap = volume > 0.0 ? this->Volume / volume * (all / sampled) : 0.0;
    this->TheSpread = this->Area > 0.0 ? this->Area2 * sampled / (this->Area * this->Area) : 1.0;
  }

  FloatBox<D> All = NoBox<D>();
  double Volume = 0.0;
  double Area = 0.0;
  double Area2 = 0.0;
  double TheOverlap = 0.0;
  double TheSpread = 1.0;
};

/// The rule chosen by Automatic; other rules are returned unchanged.
template <int D>
SplitRule RuleFor(SplitRule rule, const RawVector<Element<D>>& elements)
{
  return rule == SplitRule::Automatic ? ElementSizes<D>(elements).Choose() : rule;
}

}

#endif
