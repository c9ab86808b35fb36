// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPartAsker_h
#define SkdPartAsker_h

#include "Pipeline/SkdQueryPoints.h"
#include "Search/InOut/SkdInOut.h"

/// Classifies the query points of a mesh by all parts. One object a thread.
///
/// For query points in rows, one line along each row classifies all of its points by a closed part:
/// the side changes only where the line crosses the boundary. Where bodies of a part overlap,
/// points are classified one by one. Results are those of single points, except within rounding
/// error of the boundary.
class SkdPartClassifier
{
public:
  SkdPartClassifier(const std::vector<SkdPart>& parts, const SkdInsideRules& rules, double band,
    const SkdQueryPoints& queryPoints);

  /// The innermost part is the smallest that contains the point, ties to the lowest id. Processing
  /// the points of a row consecutively is fastest.
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
