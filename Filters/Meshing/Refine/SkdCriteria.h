// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCriteria.h
 * @brief Refinement criteria for any kind of cells: parts that they intersect or come near, the
 * inside, a field.
 */

#ifndef SkdCriteria_h
#define SkdCriteria_h

#include "Bodies/SkdParts.h"
#include "Meshing/Refine/SkdRegion.h"

#include <functional>
#include <vector>

namespace skdtree
{
/// Cells nearer to a part than Distance are refined to Level.
struct SkdDistanceBand
{
  double Distance;
  int Level;
};

struct SkdCriteria
{
  int MaximumLevel = 5;
  std::vector<int> PartLevels; ///< one a part: where it meets cells they are refined to that level
  /// @{ Beyond MinimumSurfaceLevel, refine only where a part's normals deviate by more than this
  /// angle from their mean. In radians; negative: everywhere.
  double NormalDeviation = -1.0;
  int MinimumSurfaceLevel = 0;
  ///@}
  std::vector<SkdDistanceBand> Bands;
  SkdOverlapTest Test = SkdOverlapTest::Exact;
  int InsideLevel = 0;                                 ///< of cells whose middle is inside
  std::function<bool(const skd::Vector3&)> IsInside;   ///< called if InsideLevel is above 0
  int FieldLevel = 0;                                  ///< of cells where the field wants it
  std::function<bool(const SkdRegion&)> IsFieldWanted; ///< called if FieldLevel is above 0

  /// Whether a part that intersects the region requires a level above this one. Thread-safe.
  bool IsWantedByParts(int level, const SkdRegion& region, const SkdParts& parts) const;

  /// Whether any other criterion does. Thread-safe.
  bool IsWantedByOthers(int level, const SkdRegion& region, const SkdParts& parts) const;
};
}

#endif
