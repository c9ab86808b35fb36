// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// SkdCurveTree::VisitWithin, apart so that few files depend on the query that it runs.
#ifndef SkdVisitCurves_h
#define SkdVisitCurves_h

#include "Core/Search/Queries/WithinBox.h"
#include "Core/Search/Tree/Walk.h"
#include "Curves/SkdCurveTree.h"

namespace skdtree
{
template <class Visit>
void SkdCurveTree::VisitWithin(const skd::Box3& box, Visit visit) const
{
  auto visitor = [&](std::uint32_t span)
  {
    visit(static_cast<std::size_t>(span));
    return true;
  };
  skd::WithinBox<3, decltype(visitor)> query(this->Tree.GetFrame(), box, visitor);
  skd::Walk(this->Tree, query);
}
}

#endif
