// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPartClassifier_h
#define SkdPartClassifier_h

#include "Pipeline/SkdQueryPoints.h"
#include "Search/InOut/SkdInOut.h"

namespace skdtree
{
/// A row of query points, which is a straight line.
struct SkdQueryRow
{
  double From[3];
  double Along[3]; // of length 1
  double Length;

  SkdQueryRow() = default;
  SkdQueryRow(const SkdQueryPoints& queryPoints, vtkIdType number);

  /// What is around a point of the row, given the passes along it: see SkdPassAlong::After.
  int FindAround(const double x[3], const std::vector<SkdPassAlong>& passes) const;
};

/// Adds what a part says of a point to what others have said.
void SkdAddSide(
  const SkdSide& side, int partId, double diagonal, double& smallest, SkdInOut& answer);

/// Before any part has: whether the point is finite.
bool SkdBegin(const double x[3], SkdInOut& answer);

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
    SkdQueryRow Line;
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
}

#endif
