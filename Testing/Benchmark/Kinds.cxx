// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Structure.h"

#include "vtkDataSet.h"

namespace skdbench
{

std::vector<Kind> AllKinds()
{
  std::vector<Kind> kinds = SkdKinds();
  for (Kind& kind : VtkKinds())
  {
    kinds.push_back(std::move(kind));
  }
  return kinds;
}

double LineTolerance(vtkDataSet* data)
{
  // Not zero: with zero vtkTriangle asks its own hit to lie exactly in its plane and loses most.
  return 1e-8 * data->GetLength();
}

}
