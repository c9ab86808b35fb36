// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdFindShape_h
#define SkdFindShape_h

#include "Exchange/SkdPieceNumbers.h"
#include "Pipeline/SkdJoinedShape.h"

namespace skdtree
{
/// What the mesh looks like that all pieces are together: the same on all processes, which must
/// call it together. O(points and cells of the piece).
SkdJoinedShape SkdFindShape(SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts,
  const SkdPieceNumbers& numbers);
}

#endif
