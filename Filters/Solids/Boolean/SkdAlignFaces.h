// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdAlignFaces.h
 * @brief Faces that are flush but for the rounding of their points to floats, put in one plane.
 *
 * Points that are stored as floats are off by up to 2^-24 of their coordinates. So faces of turned
 * bodies that were in one plane cross each other, or have gaps between them, which exact tests
 * would keep.
 */

#ifndef SkdAlignFaces_h
#define SkdAlignFaces_h

#include "Solids/Surfaces/SkdTriangleSet.h"

#include <vector>

namespace skdtree
{
/// The bits that the points of data sets were rounded to: 24 of floats, and of surfaces made of
/// such (which say so, see SkdBooleanNames::CoordinateBits); else 53.
std::vector<int> SkdCoordinateBits(const std::vector<SkdBlock>& blocks);

///@{
/// Where faces of two bodies are flush (SkdFlushFaces), moves their points into one plane, and
/// along the planes of the faces beside them that have several triangles, by at most 128 roundings.
/// `bits` are those of the set's blocks; points of 53 bits stay. The set must not be merged.
/// Returns how many points have moved; of a piece, whether some may, by those of its triangles that
/// meet others.
vtkIdType SkdAlignFaces(const std::vector<int>& bits, SkdTriangleSet& set);
bool SkdHasFacesToAlign(
  const std::vector<int>& bits, const SkdTriangleSet& set, const std::vector<std::uint32_t>& among);
///@}
}

#endif
