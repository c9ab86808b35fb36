// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdEnclosure.h
 * @brief The region enclosed by parts, with a closed or open boundary.
 */

#ifndef SkdEnclosure_h
#define SkdEnclosure_h

#include "Pipeline/SkdSignedSource.h"
#include "Pipeline/SkdWinding.h"

#include <memory>

class SkdEnclosure
{
public:
  /// Updates it to the blocks; see SkdSignedSource. Returns the number of trees built for the
  /// boundary, 0 if all were reused.
  int Update(const std::vector<SkdBlock>& blocks, double epsilon, double chordalDeviation);

  const SkdSignedSource& GetBoundary() const { return this->Boundary; }
  bool IsClosed() const { return this->Boundary.GetNumberOfOpenEdges() == 0; }

  /// See SkdSolid; for a boundary with open edges the winding number of its consistently oriented
  /// triangles decides (SkdFindReversed). Thread-safe.
  bool IsInside(const skd::Vector3& x) const
  {
    return this->Winding ? this->Winding->IsInside(x.X) : this->Boundary.IsInside(x.X);
  }

private:
  SkdSignedSource Boundary;
  std::unique_ptr<SkdWinding> Winding; // if it is open
};

#endif
