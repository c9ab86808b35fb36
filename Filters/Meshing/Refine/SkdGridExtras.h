// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdGridExtras.h
 * @brief Optional values of the cells of an adaptive grid, computed after refinement.
 */

#ifndef SkdGridExtras_h
#define SkdGridExtras_h

#include "Bodies/SkdParts.h"
#include "Meshing/Refine/SkdGridFields.h"

class vtkAlgorithm;

namespace skdtree
{
class SkdEnclosure;

/// By level and cell; empty if not requested.
struct SkdGridExtras
{
  std::vector<std::vector<unsigned char>> Inside;
  std::vector<std::vector<double>> Distances; ///< with a sign where Inside is wanted, too
  std::vector<std::vector<double>> Fractions;
  std::vector<SkdGridField> Fields;
};

struct SkdGridRequests
{
  bool Inside = false;
  bool Fractions = false;
  bool Distances = false;
  double Epsilon = 0.0; ///< of the tree that fractions are computed with

  bool NeedBoundary() const { return this->Inside || this->Fractions; }
};

/// Reports the algorithm's progress, from `first` to `last`. `enclosure` is used only if needed.
SkdGridExtras SkdFindExtras(const SkdGrid& grid, const SkdGridRequests& requests,
  const SkdParts& parts, const SkdEnclosure& enclosure, vtkAlgorithm* algorithm, double first,
  double last);
}

#endif
