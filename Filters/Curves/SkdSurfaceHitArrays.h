// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSurfaceHitArrays_h
#define SkdSurfaceHitArrays_h

#include "Curves/SkdSurfaceHits.h"

#include <set>

class vtkPolyData;

namespace skdtree
{
/// Where curves meet surfaces, and whose they are.
struct SkdSurfaceHitTable
{
  const SkdCurveSet& Curves;
  const std::vector<SkdBlock>& CurveBlocks;
  const SkdSurfaceSet& Surfaces;
  const std::vector<SkdBlock>& SurfaceBlocks;
  std::vector<SkdSurfaceIntersection> Intersections;
  std::vector<vtkIdType> Numbers;             ///< of each intersection along its curve, from 1
  const std::vector<vtkIdType>& CurveNumbers; ///< of each curve among all that all processes read
};

/// Fills `output` with a vertex for each intersection and the arrays that
/// vtkSkdTreeCurveSurfaceIntersection describes.
void SkdStoreSurfaceHits(const SkdSurfaceHitTable& table, vtkPolyData* output);

///@{
/// Adds the block indices of the curves' cells, and of the surfaces'.
void SkdStoreCurveBlocks(const SkdSurfaceHitTable& table, vtkPolyData* output);
void SkdStoreSurfaceBlocks(const SkdSurfaceHitTable& table, vtkPolyData* output);
///@}

/// Adds the data of both sides there. Returns the names that are in use already.
std::set<std::string> SkdStoreDataAtHits(const SkdSurfaceHitTable& table, vtkPolyData* output);
}

#endif
