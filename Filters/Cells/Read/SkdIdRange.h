// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdIdRange_h
#define SkdIdRange_h

#include "vtkType.h"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace skdtree
{
/// Whether ids, of any value, are all those of points: the signs of differences are combined, so
/// that loops need no branch.
template <class Id>
class SkdIdRange
{
public:
  explicit SkdIdRange(vtkIdType numberOfPoints)
    : Last(static_cast<Unsigned>(
        std::min<vtkIdType>(numberOfPoints - 1, std::numeric_limits<Id>::max())))
  {
  }

  void Add(Id id)
  {
    const auto bits = static_cast<Unsigned>(id);
    this->Bits |= bits | (this->Last - bits);
  }
  bool HasAll() const { return this->Bits >> (8 * sizeof(Id) - 1) == 0; }

private:
  using Unsigned = std::make_unsigned_t<Id>;

  Unsigned Last;
  Unsigned Bits = 0;
};
}

#endif
