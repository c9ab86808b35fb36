// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdFacePoints.h"

#include <algorithm>

namespace skdtree
{
SkdSplitPoint SkdFacePoints::PointAt(std::uint32_t triangle, const skd::Vector3& x)
{
  constexpr double inside = -1e-9; // but for rounding
  double most = SkdLeastWeight(this->Set.GetCornerPoints(triangle), x);
  if (most < inside)
  {
    this->List();
    const std::uint32_t face = this->FaceOf(triangle);
    auto at = std::lower_bound(this->All.begin(), this->All.end(), OfFace{ face, 0 });
    for (; at != this->All.end() && at->first == face && most < inside; ++at)
    {
      const double least = SkdLeastWeight(this->Set.GetCornerPoints(at->second), x);
      triangle = least > most ? at->second : triangle;
      most = std::max(most, least);
    }
  }
  return SkdPointIn(this->Set, triangle, x);
}

std::uint32_t SkdFacePoints::FaceOf(std::uint32_t triangle) const
{
  return this->Faces.Find(this->Origins.empty() ? triangle : this->Origins[triangle] / 2);
}

void SkdFacePoints::List()
{
  if (this->All.empty())
  {
    const auto count = static_cast<std::uint32_t>(this->Set.GetSet().GetTriangles().size());
    for (std::uint32_t triangle = 0; triangle < count; ++triangle)
    {
      this->All.emplace_back(this->FaceOf(triangle), triangle);
    }
    std::sort(this->All.begin(), this->All.end());
  }
}
}
