// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCurvedSimplices_h
#define SkdCurvedSimplices_h

#include "Core/Geometry/Simplices/SimplexSet.h"

#include <vector>

class vtkCell;

namespace skdtree
{
/// Makes a set of simplices of a curved cell (SkdParametricCell::DomainOf() knows its type): 8
/// straight pieces along each of its parameters. `bounds` are those of its points. `parameters`,
/// unless nullptr, gets those of the set's points (SkdParametricCell's).
void SkdReadCurved(skd::SimplexSet& set, vtkCell* cell, const skd::Box3& bounds,
  std::vector<skd::Vector3>* parameters = nullptr);
}

#endif
