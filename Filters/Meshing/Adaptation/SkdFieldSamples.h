// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdFieldSamples.h
 * @brief A field as values at points.
 */

#ifndef SkdFieldSamples_h
#define SkdFieldSamples_h

#include "Core/Geometry/Vector.h"
#include "vtkType.h"

#include <set>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkDataSet;

namespace skdtree
{
struct SkdFieldSamples
{
  /// Of the points of all blocks, or else of the middles of their cells: the named array, or the
  /// first of numbers; of several components their magnitude. Ghosts have no value.
  static SkdFieldSamples Read(vtkDataObject* source, const std::string& name);

  /// Those with a position and a value, in an order of their own, and what is the same at the same
  /// place once: points where pieces of a mesh meet count alike, however many of the pieces were
  /// read together and in whatever order. O(n log n), O(n) where they are in that order, as those
  /// of images are.
  SkdFieldSamples Distinct() const;

  std::vector<skd::Vector3> Positions;
  std::vector<double> Values; ///< NaN where there is none
  bool AreOfPoints = false;   ///< else of cells
  bool IsStructured = false;
  std::set<skd::Vector3> TooLarge; ///< where values are whose squares are no numbers: none count
  std::string FirstTooLarge;       ///< whose: a point or cell

  bool HasAny() const;

private:
  void AddAll(vtkDataSet* mesh, int type, vtkDataArray* array, const std::string& where);
};
}

#endif
