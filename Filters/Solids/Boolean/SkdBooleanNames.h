// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBooleanNames_h
#define SkdBooleanNames_h

namespace skdtree
{
/// Arrays of a Boolean combination: of each face the input that it comes from (0 or 1), the solid
/// there (of more than two), the cell and, of composite data, its block; a number that pieces of
/// one face have in common; of an imprint how many solids are in front of the face and behind it;
/// of a split the part that the face is of.
struct SkdBooleanNames
{
  static constexpr const char* Input = "SkdInputId";
  static constexpr const char* Solid = "SkdSolidId";
  static constexpr const char* Cell = "SkdCellId";
  static constexpr const char* Block = "SkdBlockIndex";
  static constexpr const char* Face = "SkdFaceId";
  static constexpr const char* Front = "SkdSolidsInFront";
  static constexpr const char* Back = "SkdSolidsBehind";
  static constexpr const char* Part = "SkdPartId";
  static constexpr const char* CoordinateBits = "CoordinateBits"; ///< of the report
  static constexpr const char* All[] = { Input, Solid, Cell, Block, Face, Front, Back, Part };
};
}

#endif
