// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdRepeatedId_h
#define SkdRepeatedId_h

#include "Core/Geometry/Vector.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace skdtree
{
/// A global id that two different points or two different cells have: pieces cannot be joined by
/// such ids.
struct SkdRepeatedId
{
  struct Owner
  {
    int Process;
    vtkIdType Id; ///< in that process's piece
  };

  bool IsThere = false;
  bool IsOfPoints = false;
  vtkIdType GlobalId = 0;
  std::array<Owner, 2> Owners{};

  /// This one or, if there is none, another.
  const SkdRepeatedId& Or(const SkdRepeatedId& other) const
  {
    return this->IsThere ? *this : other;
  }

  /// A sentence that names both.
  std::string Describe() const
  {
    const std::string kind = this->IsOfPoints ? "point " : "cell ";
    const auto nameOf = [&kind](const Owner& owner)
    { return kind + std::to_string(owner.Id) + " of process " + std::to_string(owner.Process); };
    return nameOf(this->Owners[0]) + " and " + nameOf(this->Owners[1]) + " have the global id " +
      std::to_string(this->GlobalId) + ".";
  }
};

/// Whether points of one global id are too far from each other to be one that was computed twice.
inline bool SkdAreDifferent(const skd::Vector3& a, const skd::Vector3& b, double largestCoordinate)
{
  constexpr double tolerance = 1e-6;
  bool are = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    are = are || std::abs(a[axis] - b[axis]) > tolerance * largestCoordinate; // not of NaN
  }
  return are;
}
}

#endif
