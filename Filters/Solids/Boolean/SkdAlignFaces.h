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
///@{
/// The bits that the points of a data set were rounded to: 24 of floats, and of surfaces made of
/// such (which say so, see SkdBooleanNames::CoordinateBits); else 53. The least of several.
int SkdCoordinateBits(vtkDataSet* mesh);
int SkdLeastCoordinateBits(const std::vector<SkdBlock>& blocks);
///@}

///@{
/// Where faces of two bodies are flush (SkdFlushFaces), moves their points into one plane, and
/// along the planes of the faces beside them that have several triangles, by at most 128 roundings.
/// Points of data sets of 53 bits stay. The set must not be merged. Returns how many points have
/// moved, or whether some may.
vtkIdType SkdAlignFaces(const std::vector<SkdBlock>& blocks, SkdTriangleSet& set);
bool SkdHasFacesToAlign(const std::vector<SkdBlock>& blocks, const SkdTriangleSet& set);
///@}
}

#endif
