// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The queries of SkdSurfaceSet, apart so that few files depend on what they run.
#ifndef SkdVisitSurfaces_h
#define SkdVisitSurfaces_h

#include "Core/Search/Queries/AlongSegment.h"
#include "Core/Search/Queries/WithinBox.h"
#include "Core/Search/Tree/Walk.h"
#include "Curves/SkdSurfaceSet.h"

namespace skdtree
{
template <class Visit>
void SkdSurfaceSet::VisitAlong(const skd::Segment<3>& segment, Visit visit) const
{
  auto visitor = [&](std::uint32_t element)
  {
    visit(element);
    return 1.0;
  };
  skd::AlongSegment<3, decltype(visitor)> query(this->Tree.GetFrame(), segment, 0.0, visitor);
  skd::Walk(this->Tree, query);
}

template <class Visit>
void SkdSurfaceSet::VisitWithin(const skd::Box3& box, Visit visit) const
{
  auto visitor = [&](std::uint32_t element)
  {
    visit(element);
    return true;
  };
  skd::WithinBox<3, decltype(visitor)> query(this->Tree.GetFrame(), box, visitor);
  skd::Walk(this->Tree, query);
}
}

#endif
