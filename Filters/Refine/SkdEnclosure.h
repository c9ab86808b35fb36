// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdEnclosure.h
 * @brief What parts enclose, be their boundary closed or not.
 */

#ifndef SkdEnclosure_h
#define SkdEnclosure_h

#include "Pipeline/SkdSignedSource.h"
#include "Pipeline/SkdWinding.h"

#include <memory>

class SkdEnclosure
{
public:
  /// Makes it that of the blocks; see SkdSignedSource. Returns how many trees of the boundary were
  /// built: 0 when all was kept.
  int Update(const std::vector<SkdBlock>& blocks, double epsilon, double chordalDeviation);

  const SkdSignedSource& GetBoundary() const { return this->Boundary; }
  bool IsClosed() const { return this->Boundary.GetNumberOfOpenEdges() == 0; }

  /// See SkdSolid; where the boundary has open edges by its winding number, its
  /// triangles turned so that they agree (SkdFindTurned). Thread-safe.
  bool IsInside(const skd::Vector3& x) const
  {
    return this->Winding ? this->Winding->IsInside(x.X) : this->Boundary.IsInside(x.X);
  }

private:
  SkdSignedSource Boundary;
  std::unique_ptr<SkdWinding> Winding; // if it is open
};

#endif
