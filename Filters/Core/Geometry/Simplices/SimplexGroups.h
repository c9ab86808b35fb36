// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Simplices_SimplexGroups_h
#define skd_Geometry_Simplices_SimplexGroups_h

#include "SimplexDistance.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace skd
{
namespace detail
{

/// The simplices of a set, for many searches by boxes: some that follow each other, which are
/// mostly neighbours, have a box in common. The set must live as long and not change.
class SimplexGroups
{
public:
  explicit SimplexGroups(const SimplexSet& set)
    : Set(set)
  {
    const std::size_t count = set.Simplices.size();
    for (std::size_t first = 0; GroupSize < count && first < count; first += GroupSize)
    {
      Box3 bounds;
      for (std::size_t i = first; i < this->EndOf(first); ++i)
      {
        bounds.Add(BoundsOf(set.Corners(set.Simplices[i])));
      }
      this->Bounds.push_back(bounds);
    }
  }

  const SimplexSet& GetSet() const { return this->Set; }

  /// Whether test(corners) is true of any simplex; none is tested of groups whose boxes do not pass
  /// mayHold(box).
  template <class MayHold, class Test>
  bool Any(const MayHold& mayHold, const Test& test) const
  {
    for (std::size_t first = 0; first < this->Set.Simplices.size(); first += GroupSize)
    {
      if (!this->Bounds.empty() && !mayHold(this->Bounds[first / GroupSize]))
      {
        continue;
      }
      for (std::size_t i = first; i < this->EndOf(first); ++i)
      {
        if (test(this->Set.Corners(this->Set.Simplices[i])))
        {
          return true;
        }
      }
    }
    return false;
  }

  /// Calls visit(corners) for the simplices whose boxes overlap a box, in their order.
  template <class Visit>
  void ForEachOverlapping(const Box3& box, const Visit& visit) const
  {
    this->Any([&](const Box3& bounds) { return box.Overlaps(bounds); },
      [&](const Triangle3& corners)
      {
        if (box.Overlaps(BoundsOf(corners)))
        {
          visit(corners);
        }
        return false;
      });
  }

private:
  static constexpr std::size_t GroupSize = 16;

  std::size_t EndOf(std::size_t first) const
  {
    return std::min(first + GroupSize, this->Set.Simplices.size());
  }

  const SimplexSet& Set;
  std::vector<Box3> Bounds; ///< by groups; none of a set that would be one
};

}
}

#endif
