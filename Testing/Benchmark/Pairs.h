// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Pairs.h
 * @brief tree against tree: which cells of two data sets have boxes that overlap, or meet
 *
 * To add a peer: derive from PairFinder in a file of its own, and append it in AllPairFinders
 * (Pairs.cxx) when CMake has found it.
 */
#ifndef skdbench_Pairs_h
#define skdbench_Pairs_h

#include "Measure.h"

#include <memory>
#include <utility>
#include <vector>

namespace skdbench
{

using PairList = std::vector<std::pair<vtkIdType, vtkIdType>>;

/// One way to find pairs; where it gives false it cannot.
class PairFinder
{
public:
  virtual ~PairFinder() = default;

  /// Builds what is there before pairs of boxes are searched; nothing for those without trees.
  virtual bool Build(vtkDataSet* first, vtkDataSet* second) = 0;

  /// Finds the pairs of cells whose boxes overlap, and keeps them in its own way: then they are
  /// these, in any order.
  virtual bool FindBoxes() = 0;
  virtual PairList BoxPairs() const = 0;

  /// The pairs of triangles that have a point in common: from nothing, without Build.
  virtual bool FindTriangles(vtkDataSet* first, vtkDataSet* second) = 0;
  virtual PairList TrianglePairs() const = 0;
};

struct PairKind
{
  std::string Name;
  Family Of;
  std::unique_ptr<PairFinder> (*Make)();
};

PairKind EmbreePairKind(); // where CMake found it; likewise:
PairKind CgalPairKind();

/// Milliseconds of spheres that cross, and of two that are nearly one.
Results MeasurePairs(const Options& options);

}

#endif
