// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBooleanSurface_h
#define SkdBooleanSurface_h

#include "Solids/Boolean/SkdBooleanNames.h"
#include "Solids/Boolean/SkdSolidArrangement.h"

#include <set>
#include <string>

class vtkPolyData;

namespace skdtree
{
/// What the output of a Boolean operation is made of.
struct SkdBooleanParts
{
  SkdSolidArrangement& Solids; ///< whose faces are looked up
  const SkdBooleanBlocks& Blocks;
  const SkdBooleanRule& Rule;
  const SkdBooleanBoundary& Boundary;
  bool KeepsPolygons;     ///< polygons of which no triangle is split stay such
  bool JoinsPieces;       ///< faces have numbers, for operations that follow
  bool MergesPieces;      ///< pieces of one triangle become convex polygons; not in an imprint
  bool IsSection = false; ///< flat faces become polygons, if pieces are joined
};

/// Fills `output` with the facets of a boundary, and with the point and cell data that all data
/// sets have: of a face those of its cell, of a new point the mean of its triangle's corners. Names
/// of arrays that are already in use are inserted into `refused`, but for SkdBooleanNames: arrays
/// of an operation before have ids of other inputs.
void SkdFillBooleanSurface(
  const SkdBooleanParts& parts, vtkPolyData* output, std::set<std::string>& refused);
}

#endif
