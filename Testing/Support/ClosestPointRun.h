// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ClosestPointRun.h
 * @brief vtkSkdTreeClosestPoint run on points and a source, and its output by value
 */
#ifndef skdtest_ClosestPointRun_h
#define skdtest_ClosestPointRun_h

#include "Support/FilterRun.h"
#include "Support/MakeOf.h"

#include "vtkSkdTreeClosestPoint.h"

namespace skdtest
{

using FilterPointer = vtkSmartPointer<vtkSkdTreeClosestPoint>;

inline FilterPointer MakeFilter(vtkDataObject* input, vtkDataObject* source)
{
  return MakeOf<vtkSkdTreeClosestPoint>(input, source);
}

inline FilterPointer MakeSignedFilter(vtkDataObject* input, vtkDataObject* source)
{
  FilterPointer filter = MakeFilter(input, source);
  filter->SignedDistanceOn();
  return filter;
}

/// The values of a point array of a filter's first output, after an update.
inline std::vector<double> RunArray(vtkSkdTreeClosestPoint* filter, const char* name)
{
  filter->Update();
  return PointArray(filter->GetOutput(), name);
}

inline std::vector<double> RunDistances(vtkSkdTreeClosestPoint* filter)
{
  return RunArray(filter, "SkdDistance");
}

inline int RunTreesBuilt(vtkSkdTreeClosestPoint* filter)
{
  filter->Update();
  return static_cast<int>(Reported(filter, "TreesBuilt"));
}

}

#endif
