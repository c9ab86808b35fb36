// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdJoinedExtents.h
 * @brief The extents of a mesh that lies in pieces, so that tolerances of trees of a piece are
 * those of a tree of the whole.
 */

#ifndef SkdJoinedExtents_h
#define SkdJoinedExtents_h

#include "Cells/Read/SkdMagnitudes.h"
#include "Cells/Search/SkdMeshExtent.h"
#include "Exchange/SkdStamp.h"
#include "Exchange/SkdTransport.h"

#include <map>

namespace skdtree
{
class SkdJoinedExtents
{
public:
  /// Of the pieces of all processes, by block index: the cells that a tree with these magnitudes
  /// has, without ghosts. All processes must call it together. Where no piece has changed a byte is
  /// exchanged; else O(n) for the cells of the piece, and 64 bytes a block are.
  const std::map<int, SkdMeshExtent>& Update(
    SkdTransport& transport, vtkDataObject* piece, const SkdMagnitudes& magnitudes);

private:
  SkdStamp Known;
  std::map<int, SkdMeshExtent> Extents;
};
}

#endif
