// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSampleSides_h
#define SkdSampleSides_h

#include "Pipeline/SkdLoop.h"
#include "Search/Compare/SkdComparedSet.h"
#include "Search/Compare/SkdDistanceStatistics.h"

#include <vector>

namespace skdtree
{
/// Makes distances negative where samples are inside a set whose sides processes tell together; of
/// any other set nothing is done. Those of the corners and the centre are known of parts of
/// triangles (`areParts`). All processes must call it together. Returns whether it was done of all
/// samples, on all processes.
bool SkdFindSides(const SkdComparedSet& to, std::vector<SkdSampledTriangle>& triangles,
  bool areParts, SkdLoop& loop);

/// The most steps of the loop that this takes for a number of triangles.
inline vtkIdType SkdStepsForSides(const SkdComparedSet& to, std::size_t triangles)
{
  return to.GetSpreadSides() ? SkdSampledTriangle::Samples * static_cast<vtkIdType>(triangles) : 0;
}
}

#endif
