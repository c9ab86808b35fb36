// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSpreadSides.h
 * @brief Which points are inside a surface that stays in the pieces that processes have of it.
 */

#ifndef SkdSpreadSides_h
#define SkdSpreadSides_h

#include "Exchange/Bodies/SkdSpreadBody.h"
#include "Exchange/SkdSpreadSource.h"

class vtkMultiProcessController;

namespace skdtree
{
/// All processes must call Update() and Find() together.
class SkdSpreadSides
{
public:
  /// Updates to the pieces that processes have.
  void Update(vtkDataObject* piece, double epsilon, vtkMultiProcessController* controller);

  /// By this process, at the last Update().
  int GetTreesBuilt() const { return this->TreesBuilt; }

  /// Whether there are faces that tell sides (SkdSpreadBody::IsFit), and did of all points since
  /// the last Update(); else all faces together must. The same on all processes.
  bool AreSure() const { return this->Sure; }

  /// Calls set(i, isInside) for each of n points, pointOf(i). Returns whether it was done: not if
  /// it was aborted on any process, or is not sure.
  template <class PointOf, class Set>
  bool Find(std::size_t n, const PointOf& pointOf, const Set& set, SkdLoop& loop)
  {
    const SkdSpreadResult result = this->Body.FindSides(
      n, pointOf, [](std::size_t) { return true; }, set, loop);
    this->Sure = this->Sure && result != SkdSpreadResult::Undecided;
    return result == SkdSpreadResult::Done;
  }

  /// What this process has sent since the last Update().
  const SkdTraffic& GetTraffic() const { return this->Spread.GetTransport().GetTraffic(); }

private:
  SkdSpreadSource Spread;
  SkdSpreadBody Body;
  bool Sure = false;
  int TreesBuilt = 0;
};
}

#endif
