// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file QueryKind.h
 * @brief queries of a search structure, and their results
 */
#ifndef skdbench_QueryKind_h
#define skdbench_QueryKind_h

#include "Support/Point.h"

#include "vtkType.h"

#include <limits>
#include <string>
#include <vector>

namespace skdbench
{

using skdtest::Bounds;
using skdtest::Point;

enum class QueryKind
{
  ClosestPoint,
  ClosestPointWithinRadius,
  FirstHit,
  AllHits,
  FindCell,
  FindCellWithHint,
  CellsInBox
};

/// The input of a query; its kind determines which members are used.
struct Query
{
  Point From{}; // the point, or the start of the segment
  Point To{};   // the end of the segment
  Bounds Box{};
  double Radius = 0.0;
};

/// One result. A structure that lists cells keeps the list: it is valid until the next query.
struct Answer
{
  vtkIdType Cell = -1;
  double Value = std::numeric_limits<double>::infinity(); // squared distance, or t of the hit
  Point Where{};
  const vtkIdType* Cells = nullptr;
  vtkIdType NumberOfCells = 0;
};

/// Timed work: a kind of query, and a sample of queries.
struct Work
{
  std::string Name;
  QueryKind Requested;
  std::vector<Query> Queries;
};

}

#endif
