// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdEnclosure.h
 * @brief The region enclosed by parts, with a closed or open boundary.
 */

#ifndef SkdEnclosure_h
#define SkdEnclosure_h

#include "Bodies/SkdSignedSource.h"

namespace skdtree
{
class SkdEnclosure
{
public:
  /// Updates it to the blocks; see SkdSignedSource. Returns the number of trees built for the
  /// boundary, 0 if all were reused.
  int Update(const std::vector<SkdBlock>& blocks, double epsilon, double chordalDeviation)
  {
    return this->Boundary.Update(blocks, epsilon, chordalDeviation);
  }

  const SkdSignedSource& GetBoundary() const { return this->Boundary; }
  bool IsClosed() const { return this->Boundary.GetNumberOfOpenEdges() == 0; }

  /// See SkdSignedSource. Thread-safe.
  bool IsInside(const skd::Vector3& x) const { return this->Boundary.IsInside(x.X); }

private:
  SkdSignedSource Boundary;
};
}

#endif
