// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPointQuestions_h
#define SkdPointQuestions_h

#include "Core/Geometry/Vector.h"
#include "Exchange/SkdNearPoints.h"
#include "Exchange/SkdPieceNumbers.h"

namespace skdtree
{
/// What a process tells of a point of its piece that others may have, too.
struct SkdPointQuestion
{
  ///@{
  /// When a point is added to the joined mesh: ghosts after all others, in the order in which cells
  /// use them, or not at all.
  static constexpr vtkIdType AtOnce = -1;
  static constexpr vtkIdType Never = -2;
  ///@}

  skd::Vector3 X;
  vtkIdType GlobalId; ///< if all points have such
  vtkIdType Point;
  vtkIdType Order;
  bool IsIncomplete;
};

/// What it gets to know.
struct SkdPointAnswer
{
  SkdPointOrigin Numbered; ///< by whom
  SkdPointOrigin Data;
  SkdPointOrigin FirstLike; ///< see SkdNumberPoints; a process of -1: no other piece has such
};

using SkdPointQuestions = SkdRowsByProcess<SkdPointQuestion>;
using SkdPointAnswers = SkdRowsByProcess<SkdPointAnswer>;

///@{
/// Of all processes' questions that one has got.
SkdPointAnswers SkdAnswerByGlobalIds(
  const SkdPointQuestions& queries, double largestCoordinate, SkdRepeatedId& repeated);
SkdPointAnswers SkdAnswerByCoordinates(
  const SkdPointQuestions& queries, const SkdRounding& rounding);
///@}
}

#endif
