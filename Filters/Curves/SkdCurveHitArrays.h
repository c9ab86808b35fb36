// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCurveHitArrays_h
#define SkdCurveHitArrays_h

#include "Curves/SkdCurveHits.h"

#include <set>

class vtkPolyData;
class vtkUnstructuredGrid;

namespace skdtree
{
/// The curves of one input.
struct SkdCurveSide
{
  const SkdCurveTree& Tree;
  const std::vector<SkdBlock>& Blocks;
  bool IsComposite;
};

/// Where curves meet, and whose they are.
struct SkdCurveHitTable
{
  SkdCurveSide First;
  SkdCurveSide Second;
  SkdCurveIntersections Intersections;
};

/// Fills `output` with a vertex for each intersection and the arrays that
/// vtkSkdTreeCurveIntersection describes.
void SkdStoreCurveHits(const SkdCurveHitTable& table, vtkPolyData* output);

/// Adds the data of the first curves there, and of the second ones unless these are the same.
/// Returns the names that are in use already.
std::set<std::string> SkdStoreDataOfCurves(const SkdCurveHitTable& table, vtkPolyData* output);

/// Fills `output` with the common intervals, within a chord tolerance in world units.
void SkdStoreIntervals(const SkdCurveHitTable& table, double delta, vtkPolyData* output);

/// Fills `output` with a box around the region that the safety cylinders of each two candidates
/// have in common.
void SkdStoreCandidates(const SkdCurveHitTable& table, vtkUnstructuredGrid* output);
}

#endif
