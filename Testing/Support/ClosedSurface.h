// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ClosedSurface.h
 * @brief Whether a surface is closed as it is stored, when VTK triangulates it, and when equal
 *        points are merged
 */
#ifndef skdtest_ClosedSurface_h
#define skdtest_ClosedSurface_h

#include "Support/MeshBuilder.h"

#include "vtkCellArray.h"
#include "vtkCleanPolyData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace skdtest
{

struct EdgeCounts
{
  std::size_t Open = 0;       // not passed as often in one direction as in the other
  std::size_t OnlyOnce = 0;   // of one face
  std::size_t ZeroLength = 0; // between equal coordinates
};

inline EdgeCounts CountEdges(vtkPolyData* surface)
{
  std::map<std::pair<vtkIdType, vtkIdType>, std::pair<int, int>> passes;
  EdgeCounts counts;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      const vtkIdType a = ids->GetId(i);
      const vtkIdType b = ids->GetId((i + 1) % ids->GetNumberOfIds());
      auto& [sum, count] = passes[{ std::min(a, b), std::max(a, b) }];
      sum += a < b ? 1 : -1;
      ++count;
      Point x, y;
      surface->GetPoint(a, x.data());
      surface->GetPoint(b, y.data());
      counts.ZeroLength += x == y;
    }
  }
  for (const auto& edge : passes)
  {
    counts.Open += edge.second.first != 0;
    counts.OnlyOnce += edge.second.second == 1;
  }
  return counts;
}

inline vtkSmartPointer<vtkPolyData> Triangulated(vtkPolyData* surface)
{
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(surface);
  filter->Update();
  return filter->GetOutput();
}

/// With a tolerance of 0.
inline vtkSmartPointer<vtkPolyData> Cleaned(vtkPolyData* surface)
{
  vtkNew<vtkCleanPolyData> filter;
  filter->SetInputData(surface);
  filter->ToleranceIsAbsoluteOn();
  filter->SetAbsoluteTolerance(0.0);
  filter->Update();
  return filter->GetOutput();
}

inline void ExpectClosed(vtkPolyData* output)
{
  const vtkSmartPointer<vtkPolyData> directions[] = { output, Triangulated(output), Cleaned(output),
    Cleaned(Triangulated(output)), Triangulated(Cleaned(output)) };
  for (int direction = 0; direction < 5; ++direction)
  {
    SCOPED_TRACE("way " + std::to_string(direction));
    const EdgeCounts counts = CountEdges(directions[direction]);
    EXPECT_EQ(counts.Open, 0u);
    EXPECT_EQ(counts.OnlyOnce, 0u);
    EXPECT_EQ(counts.ZeroLength, 0u);
    EXPECT_EQ(
      directions[direction]->GetNumberOfPoints(), output->GetNumberOfPoints()); // no two are equal
  }
}

}

#endif
