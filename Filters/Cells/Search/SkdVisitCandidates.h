// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// SkdCellTree::VisitCandidates, apart so that few files depend on the query that it runs.
#ifndef SkdVisitCandidates_h
#define SkdVisitCandidates_h

#include "Cells/Search/SkdCellTree.h"
#include "Core/Search/LeafFilters/CompactTree.h"
#include "Core/Search/Queries/CandidateLists.h"
#include "Core/Search/Tree/LazyTree.h"

namespace skdtree
{
template <class Visit>
void SkdCellTree::VisitCandidates(
  const SkdCandidateRange& above, const skd::Box3& box, Visit visit) const
{
  if (this->Lazy)
  {
    skd::VisitCandidates(*this->Lazy, above.First, above.Last, box, visit);
  }
  else
  {
    skd::VisitCandidates(this->View, above.First, above.Last, box, visit);
  }
}
}

#endif
