// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Referee.h
 * @brief compares the results of all structures for one query, and reports wrong ones
 *
 * No structure is trusted. An answer counts when the cell that it names bears it out, by VTK's own
 * test of that one cell; the best that counts is the truth, and who says otherwise is wrong. An
 * answer within rounding of the truth is right, and so is the truth itself only known to within the
 * rounding of the structure.
 */
#ifndef skdbench_Referee_h
#define skdbench_Referee_h

#include "QueryKind.h"

#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace skdbench
{

/// An answer that is still valid after the next query.
struct Record
{
  Record(const Answer& answer, double precision);

  vtkIdType Cell;
  double Value;
  Point Where;
  std::vector<vtkIdType> Cells; // ascending, each once
  double Precision;             // relative to the size of the scene
};

class Referee
{
public:
  explicit Referee(vtkDataSet* data);

  /// For each record whether it is wrong.
  std::vector<bool> Judge(
    QueryKind queryKind, const Query& query, const std::vector<Record>& records);

private:
  std::vector<bool> JudgeClosest(
    const Query& query, const std::vector<Record>& records, double radius);
  std::vector<bool> JudgeFirstHit(const Query& query, const std::vector<Record>& records);
  std::vector<bool> JudgeFindCell(const Query& query, const std::vector<Record>& records);
  std::vector<bool> JudgeLists(
    QueryKind queryKind, const Query& query, const std::vector<Record>& records);

  bool MustBeListed(QueryKind queryKind, const Query& query, vtkIdType cell);
  bool MayBeListed(QueryKind queryKind, const Query& query, vtkIdType cell);
  bool IsHit(const Query& query, vtkIdType cell, double tolerance);
  bool IsInBox(const Query& query, vtkIdType cell);
  bool IsInside(const Point& x, vtkIdType cell);

  bool Has(vtkIdType cell) const;

  /// False of an id that no cell has.
  bool LookAt(vtkIdType cell);

  /// Infinity for an id that no cell has.
  double DistanceToCell(const Point& x, vtkIdType cell);

  /// Of the last cell and point looked at: 0 unless a shape function is negative.
  double Outside() const;

  /// How far the cell's faces are from flat: by as much their shape is a matter of opinion.
  double Warp(vtkIdType cell);

  double Slack(const Record& record) const { return record.Precision * this->Size; }

  vtkDataSet* Data;
  vtkSmartPointer<vtkGenericCell> Cell; // the one that is looked at
  std::vector<double> Weights;
  double Size;
  double LineTolerance;
};

}

#endif
