// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBoxSet_h
#define SkdBoxSet_h

#include "Core/Search/Tree/PackedRTree.h"

#include <optional>
#include <utility>
#include <vector>

namespace skdtree
{
/// Boxes, of which those that overlap another are to be found: of few by a look at all, of more by
/// a tree. O(n) to make.
class SkdBoxSet
{
public:
  explicit SkdBoxSet(std::vector<skd::Box3> boxes)
    : Boxes(std::move(boxes))
  {
    constexpr std::size_t few = 32;
    if (this->Boxes.size() > few)
    {
      this->Tree.emplace(this->Boxes);
    }
  }

  /// The box of some points and all that is nearer to it than a tolerance.
  template <class Points>
  static skd::Box3 BoxOf(const Points& points, double tolerance)
  {
    skd::Box3 box;
    for (const skd::Vector3& x : points)
    {
      box.Add(x);
    }
    return box.Inflated(tolerance);
  }

  std::size_t size() const { return this->Boxes.size(); }
  const skd::Box3& operator[](std::size_t i) const { return this->Boxes[i]; }

  /// Calls visit(i) for each box that overlaps this one.
  template <class Visit>
  void ForEachOverlapping(const skd::Box3& box, const Visit& visit) const
  {
    if (this->Tree)
    {
      this->Tree->ForEachOverlapping(box,
        [&](std::uint32_t i)
        {
          if (this->Boxes[i].Overlaps(box))
          {
            visit(i);
          }
        });
      return;
    }
    for (std::uint32_t i = 0; i < this->Boxes.size(); ++i)
    {
      if (this->Boxes[i].Overlaps(box))
      {
        visit(i);
      }
    }
  }

private:
  std::vector<skd::Box3> Boxes;
  std::optional<skd::PackedRTree> Tree;
};
}

#endif
