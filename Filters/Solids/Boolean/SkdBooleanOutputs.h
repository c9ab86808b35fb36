// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBooleanOutputs_h
#define SkdBooleanOutputs_h

#include "Solids/Boolean/SkdBooleanReport.h"
#include "Solids/Boolean/SkdBooleanSurface.h"

namespace skdtree
{
/// How the outputs of an operation are made: see the properties of vtkSkdTreeBooleanOperation.
struct SkdBooleanOptions
{
  bool KeepsPolygons;
  bool JoinsPieces;
  bool MergesPieces;
  bool ClosesCut;
  bool IsCutByPlane; ///< the Source is a plane, open or as the face of a body
};

/// Fills the outputs of an operation: the surface of what is solid, or after a split of each part,
/// one after the other, no point in two of them; and the section, what of the Source is within the
/// Input, of operations that a sheet or a plane cuts in, and of a split. Names of arrays that are
/// already in use are inserted into `refused`. O(n) for each part, besides SkdJoinPieces.
SkdBooleanTotals SkdFillBooleanOutputs(SkdSolidArrangement& solids, const SkdBooleanBlocks& blocks,
  const SkdBooleanRule& rule, const SkdBooleanOptions& options, vtkPolyData* surface,
  vtkPolyData* section, std::set<std::string>& refused);
}

#endif
