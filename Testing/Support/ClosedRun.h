// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ClosedRun.h
 * @brief vtkSkdTreeBooleanOperation, and whether its output is closed in every way
 */
#ifndef skdtest_ClosedRun_h
#define skdtest_ClosedRun_h

#include "Support/ClosedSurface.h"
#include "Support/Reported.h"
#include "Support/SolidRun.h"

namespace skdtest
{

/// The output of a filter that is set up, closed by all ways of output, and found without a word.
inline vtkSmartPointer<vtkPolyData> RunClosed(vtkSkdTreeBooleanOperation* filter)
{
  EventCounter events(filter);
  filter->Update();
  EXPECT_EQ(events.Errors + events.Warnings, 0) << events.Error << events.Warning;
  vtkSmartPointer<vtkPolyData> output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(Reported(output, "BadEdges"), 0.0);
  ExpectClosed(output);
  return output;
}

}

#endif
