// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdNewPoints_h
#define SkdNewPoints_h

#include "Solids/Surfaces/SkdSplitTriangles.h"

#include <memory>
#include <vector>

namespace skdtree
{
/// The points that splitting made. They stay as they are, so that copies, of which an operation
/// makes some, have them in common.
class SkdNewPoints
{
public:
  SkdNewPoints(std::vector<SkdSplitPoint> points = {})
    : All(std::make_shared<const std::vector<SkdSplitPoint>>(std::move(points)))
    , First(this->All->data())
  {
  }

  std::size_t size() const { return this->All->size(); }
  const SkdSplitPoint& operator[](std::size_t i) const { return this->First[i]; }
  const std::vector<SkdSplitPoint>& Get() const { return *this->All; }

  /// Copied also where it could be moved: it always has points, if none.
  SkdNewPoints(const SkdNewPoints&) = default;
  SkdNewPoints& operator=(const SkdNewPoints&) = default;

private:
  std::shared_ptr<const std::vector<SkdSplitPoint>> All;
  const SkdSplitPoint* First; // for a look at one by one step less
};
}

#endif
