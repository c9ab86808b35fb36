// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Question.h
 * @brief what is asked of a search structure, and what it answers
 */
#ifndef skdbench_Question_h
#define skdbench_Question_h

#include "Support/Point.h"

#include "vtkType.h"

#include <limits>
#include <string>
#include <vector>

namespace skdbench
{

using skdtest::Bounds;
using skdtest::Point;

enum class Question
{
  ClosestPoint,
  ClosestPointWithinRadius,
  FirstHit,
  AllHits,
  FindCell,
  FindCellWithHint,
  CellsInBox
};

/// One question's input; which members count depends on the question.
struct Query
{
  Point From{}; // the point, or the start of the segment
  Point To{};   // the end of the segment
  Bounds Box{};
  double Radius = 0.0;
};

/// One answer. A structure that lists cells keeps the list: it lives until the next question.
struct Answer
{
  vtkIdType Cell = -1;
  double Value = std::numeric_limits<double>::infinity(); // squared distance, or t of the hit
  Point Where{};
  const vtkIdType* Cells = nullptr;
  vtkIdType NumberOfCells = 0;
};

/// A kind of work that is timed: a question and the queries that stand for it.
struct Work
{
  std::string Name;
  Question Asked;
  std::vector<Query> Queries;
};

}

#endif
