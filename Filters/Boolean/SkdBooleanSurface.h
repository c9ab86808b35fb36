// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBooleanSurface_h
#define SkdBooleanSurface_h

#include "Boolean/SkdBooleanFacets.h"
#include "Boolean/SkdSolids.h"

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

/// The data sets of the surfaces.
struct SkdBooleanBlocks
{
  std::vector<SkdBlock> All;
  int FirstOfSource; ///< those before it are of the Input
  bool IsComposite;
};

/// What a Boolean combination is made of.
struct SkdBooleanParts
{
  const SkdPlacement& Placement;
  const SkdArrangement& Arrangement;
  const SkdFacets& Facets; ///< of the arrangement, or as they are stored
  const SkdBooleanBlocks& Blocks;
  const SkdFacetSigns& Signs;
  const SkdSolids* Solids;             ///< nullptr: no array tells them
  const std::vector<int>* SolidCounts; ///< of each region; nullptr: no arrays tell them
  bool KeepsPolygons;                  ///< polygons of which no triangle is split stay such
  bool MergesPieces;                   ///< pieces of one triangle become convex polygons
};

/// Fills `output` with the facets of a boundary, and with the point and cell data that all data
/// sets have: of a face those of its cell, of a new point the mean of its triangle's corners. Names
/// of arrays that are already in use are inserted into `refused`.
void SkdFillBooleanSurface(
  const SkdBooleanParts& parts, vtkPolyData* output, std::set<std::string>& refused);

#endif
