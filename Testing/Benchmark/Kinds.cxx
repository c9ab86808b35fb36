// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Structure.h"

#include "vtkDataSet.h"

namespace skdbench
{

std::vector<Kind> AllKinds()
{
  std::vector<Kind> kinds;
  const auto append = [&kinds](const std::vector<Kind>& more)
  { kinds.insert(kinds.end(), more.begin(), more.end()); };
  append(SkdKinds());
  append(VtkKinds());
#ifdef SKDBENCH_HAS_EMBREE
  append(EmbreeKinds());
#endif
#ifdef SKDBENCH_HAS_CGAL
  append(CgalKinds());
#endif
#ifdef SKDBENCH_HAS_BOOST
  append(BoostKinds());
#endif
  return kinds;
}

double LineTolerance(vtkDataSet* data)
{
  // Not zero: with zero vtkTriangle requires its own hit to lie exactly in its plane and loses
  // most.
  return 1e-8 * data->GetLength();
}

}
