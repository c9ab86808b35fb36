// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBooleanSurface_h
#define SkdBooleanSurface_h

#include "Solids/Boolean/SkdSolidArrangement.h"

#include <set>
#include <string>

class vtkPolyData;

/// Arrays of a Boolean combination: of each face the input that it comes from (0 or 1), the solid
/// there (of more than two), the cell and, of composite data, its block; of an imprint how many
/// solids are in front of the face and behind it.
struct SkdBooleanNames
{
  static constexpr const char* Input = "SkdInputId";
  static constexpr const char* Solid = "SkdSolidId";
  static constexpr const char* Cell = "SkdCellId";
  static constexpr const char* Block = "SkdBlockIndex";
  static constexpr const char* Front = "SkdSolidsInFront";
  static constexpr const char* Back = "SkdSolidsBehind";
  static constexpr const char* All[] = { Input, Solid, Cell, Block, Front, Back };
};

/// What the output of a Boolean operation is made of.
struct SkdBooleanParts
{
  const SkdSolidArrangement& Solids;
  const SkdBooleanBlocks& Blocks;
  const SkdBooleanRule& Rule;
  const SkdBooleanBoundary& Boundary;
  bool KeepsPolygons; ///< polygons of which no triangle is split stay such
  bool MergesPieces;  ///< pieces of one triangle become convex polygons; not in an imprint
};

/// Fills `output` with the facets of a boundary, and with the point and cell data that all data
/// sets have: of a face those of its cell, of a new point the mean of its triangle's corners. Names
/// of arrays that are already in use are inserted into `refused`, but for SkdBooleanNames: arrays
/// of an operation before have ids of other inputs.
void SkdFillBooleanSurface(
  const SkdBooleanParts& parts, vtkPolyData* output, std::set<std::string>& refused);

#endif
