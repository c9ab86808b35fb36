// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdCurves.h"

#include <algorithm>

namespace skdtree
{
void SkdCurveParts::LeaveOutInside()
{
  const auto isInside = [this](const SkdEndPair& segment)
  {
    auto at = std::lower_bound(this->Sides.begin(), this->Sides.end(), segment,
      [](const SkdEndPair& a, const SkdEndPair& b) { return a.A != b.A ? a.A < b.A : a.B < b.B; });
    const auto isSame = [&](const SkdEndPair& side)
    { return side.A == segment.A && side.B == segment.B; };
    return this->Sides.end() - at >= 2 && isSame(*at) && isSame(*++at);
  };
  this->Segments.erase(
    std::remove_if(this->Segments.begin(), this->Segments.end(), isInside), this->Segments.end());
}
}
