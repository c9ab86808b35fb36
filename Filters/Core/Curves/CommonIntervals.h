// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_CommonIntervals_h
#define skd_Curves_CommonIntervals_h

#include "Tolerances.h"

#include <vector>

namespace skd
{

/// Whether a curve runs within something, and the intervals of it that are on that itself, not on
/// what continues it. `Size` + 1 points along the curve are tried, from the middle on, so that a
/// curve that does not is mostly rejected by its first point.
///
/// `within` knows both:
///   Follow(foot)                what is nearest to the curve's point at foot.T, found from where
///   foot
///                               is; whether both are the same to within rounding
///   Depth(foot)                 how far the foot is within its sides or ends; negative beyond
///   Append(begin, end, hits)    a interval
template <class Within, class Hit>
class CommonIntervals
{
public:
  static constexpr int MaximumSize = 127;

  CommonIntervals(const Within& within, int size)
    : What(within)
    , Size(size)
  {
  }

  /// If it does, appends both ends of each interval, one after the other.
  bool Find(const Hit& start, std::vector<Hit>& hits)
  {
    const int middle = this->Size / 2;
    if (!this->FollowTo(-1, middle, start) ||
      !this->FollowTo(this->Size + 1, middle + 1, this->Feet[middle]))
    {
      return false;
    }
    this->AppendIntervals(hits);
    return true;
  }

private:
  /// From `first` on, to before `end`.
  bool FollowTo(int end, int first, Hit foot)
  {
    const int step = end < first ? -1 : 1;
    for (int i = first; i != end; i += step)
    {
      foot.T = static_cast<double>(i) / this->Size;
      if (!this->What.Follow(foot))
      {
        return false;
      }
      this->Feet[i] = foot;
    }
    return true;
  }

  void AppendIntervals(std::vector<Hit>& hits) const
  {
    Hit begin;
    bool isOn = false;
    for (int i = 0; i <= this->Size; ++i)
    {
      const bool isNext = this->What.Depth(this->Feet[i]) >= -tolerances::OnInterval;
      if (isNext && !isOn)
      {
        begin = i == 0 ? this->Feet[0] : this->Border(this->Feet[i], this->Feet[i - 1]);
      }
      if (!isNext && isOn)
      {
        this->What.Append(begin, this->Border(this->Feet[i - 1], this->Feet[i]), hits);
      }
      isOn = isNext;
    }
    if (isOn)
    {
      this->What.Append(begin, this->Feet[this->Size], hits);
    }
  }

  /// Between a point that is on it and one beyond.
  Hit Border(Hit on, Hit beyond) const
  {
    for (int iteration = 0; iteration < 60; ++iteration)
    {
      Hit middle = on;
      middle.T = 0.5 * (on.T + beyond.T);
      this->What.Follow(middle);
      (this->What.Depth(middle) >= 0.0 ? on : beyond) = middle;
    }
    return on;
  }

  const Within& What;
  const int Size;
  Hit Feet[MaximumSize + 1];
};

}

#endif
