// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPartAsker_h
#define SkdPartAsker_h

#include "InOut/SkdInOut.h"
#include "InOut/SkdQueryPoints.h"

/// Asks all parts for the query points of a mesh. One object a thread.
///
/// Of query points that are in rows one line along each row answers all of it for a closed part:
/// between two passes through the boundary the side stays the same. Where bodies of a part overlap
/// points are asked one by one. The answers are those of single points, but within rounding of the
/// boundary, where either may be the answer.
class SkdPartAsker
{
public:
  SkdPartAsker(const std::vector<SkdPart>& parts, const SkdInsideRules& rules, double band,
    const SkdQueryPoints& queryPoints);

  /// The innermost part is the smallest that holds the point, ties to the lowest id. The cost is
  /// least when query points of a row follow each other.
  SkdInOut Ask(vtkIdType queryPoint);

private:
  struct Row
  {
    vtkIdType Number = -1; // none yet
    double From[3];
    double Along[3];                               // of length 1
    std::vector<std::vector<SkdPassAlong>> Passes; // by part, ascending
  };

  bool HasRowOf(const SkdPart& part) const;
  void GoToRow(vtkIdType number);
  SkdSide AskRow(std::size_t part, const double x[3], std::uint64_t queryPoint) const;

  const std::vector<SkdPart>& Parts;
  const SkdInsideRules& Rules;
  double Band;
  const SkdQueryPoints& QueryPoints;
  bool UsesRows;
  Row TheRow;
};

#endif
