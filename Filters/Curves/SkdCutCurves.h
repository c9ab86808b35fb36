// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCutCurves_h
#define SkdCutCurves_h

#include "Curves/SkdSurfaceHits.h"

class vtkPolyData;

namespace skdtree
{
/// The intersections that cut curves.
struct SkdCutTask
{
  const SkdCurveSet& Curves;
  const std::vector<SkdBlock>& CurveBlocks;
  const std::vector<SkdSurfaceElement>& Elements;
  const SkdSurfaceHitFinder& Finder;
  bool IsComposite; ///< the curves' data set
  double Delta;     ///< chord tolerance of what becomes a polyline

  /// Of each curve among all that all processes read; -1: another process outputs it.
  const std::vector<vtkIdType>& Numbers;
};

/// Fills `output` with the curves cut at the intersections (by curve, and along it), each piece
/// with the parts of the surfaces that contain it: see
/// vtkSkdTreeCurveSurfaceIntersection::SetCutCurves.
void SkdCutCurves(const SkdCutTask& task, const std::vector<SkdSurfaceIntersection>& intersections,
  vtkPolyData* output);
}

#endif
