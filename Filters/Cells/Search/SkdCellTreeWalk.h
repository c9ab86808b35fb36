// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCellTreeWalk_h
#define SkdCellTreeWalk_h

#include "Cells/Search/SkdCellTree.h"
#include "Core/Search/LeafFilters/CompactTree.h"
#include "Core/Search/Tree/LazyTree.h"
#include "Core/Search/Tree/Walk.h"

namespace skdtree
{
template <class Query>
void SkdCellTree::Walk(Query& query) const
{
  if (this->Lazy)
  {
    skd::Walk(*this->Lazy, query);
  }
  else
  {
    skd::Walk(this->View, query);
  }
}

inline const skd::Frame<3>& SkdCellTree::GetFrame() const
{
  return this->Lazy ? this->Lazy->GetFrame() : this->View.GetFrame();
}
}

#endif
