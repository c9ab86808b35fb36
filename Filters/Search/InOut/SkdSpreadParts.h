// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSpreadParts_h
#define SkdSpreadParts_h

#include "Exchange/Bodies/SkdSpreadBody.h"
#include "Pipeline/SkdQueryPoints.h"
#include "Search/InOut/SkdInOut.h"

#include <deque>
#include <vector>

namespace skdtree
{
/// The parts of a Source that stays in its pieces: each block one, which may be on all processes.
/// All processes must call each function together.
class SkdSpreadParts
{
public:
  /// Updates the parts to the source. Returns the number of parts made, 0 if all were reused.
  int Update(const SkdSpreadSource& spread, double epsilon);

  ///@{
  /// The same on all processes.
  std::size_t GetNumber() const { return this->Parts.size(); }
  bool HaveFaces() const;
  bool AreFit() const; ///< see SkdSpreadBody
  ///@}

  /// Classifies query points as SkdPartClassifier does with the automatic method. A process may
  /// have none.
  SkdSpreadResult Ask(const SkdQueryPoints& points, SkdLoop& loop, std::vector<SkdInOut>& answers);

  /// How often a point or a line was sent to another process since the last Update().
  std::uint64_t CountRequests() const;

private:
  struct Part
  {
    int Id;
    SkdSpreadBody Body;
    double Diagonal;
    std::uint64_t RequestsBefore = 0; // the last Update()
  };

  static SkdSpreadResult AskPart(
    Part& part, const SkdQueryPoints& points, SkdLoop& loop, std::vector<char>& isInside);
  static std::vector<char> AskRows(
    Part& part, const SkdQueryPoints& points, std::vector<char>& isInside);

  vtkSmartPointer<vtkDataObject> Known; // what the parts are of
  double Epsilon = -1.0;
  std::deque<Part> Parts;
};
}

#endif
