// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCurves.h
 * @brief Curves of contact, before they are output: what they are made of.
 */

#ifndef SkdCurves_h
#define SkdCurves_h

#include "Core/Geometry/Vector.h"
#include "Solids/Surfaces/SkdJoinSegments.h"
#include "vtkType.h"

namespace skdtree
{
/// The cells of a pair of triangles, by their ids in the joined meshes, and their blocks.
struct SkdContactLabel
{
  std::int64_t FirstCell;
  std::int64_t SecondCell;
  std::int32_t FirstBlock;
  std::int32_t SecondBlock;
};

/// What pairs of triangles have in common, by points of contact.
struct SkdCurveParts
{
  std::vector<SkdEndPair> Segments; ///< by ends, each once, of the lowest pair that has it
  std::vector<SkdEndPair> Sides;    ///< of polygons of overlap, by ends
  std::vector<SkdEndPair> Lone;     ///< points alone of the lowest pairs
  std::vector<bool> IsOther;        ///< of each point, whether a pair has more than a point there

  /// One between two polygons of overlap is inside of what overlaps, and no curve.
  void LeaveOutInside();
};

/// What is output.
struct SkdCurves
{
  std::vector<SkdEndPair> Segments;
  std::vector<SkdEndPair> Lone;
  std::vector<SkdPolyline> Lines; ///< empty if segments are not to be joined
  vtkIdType Number = 0;           ///< of lines, if they were joined

  ///@{
  /// Of several processes. Origins that count on from those of pairs are labels that were received,
  /// and points those that were received.
  std::vector<SkdContactLabel> ReceivedLabels;
  std::vector<skd::Vector3> ReceivedPoints;
  ///@}
};
}

#endif
