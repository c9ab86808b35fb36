// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCurveHits.h
 * @brief Intersections of curves with curves (section 6.1), each once.
 */

#ifndef SkdCurveHits_h
#define SkdCurveHits_h

#include "Curves/SkdCurveHit.h"
#include "Curves/SkdCurveTree.h"

#include <vector>

namespace skd
{
struct CurvePairHit;
}

namespace skdtree
{
class SkdLoop;

/// Two pieces of curves whose safety cylinders overlap: within `Extent` of each other's chords.
struct SkdCurveCandidate
{
  std::size_t First; ///< of the first set's spans
  std::size_t Second;
  double Extent;
  int NumberOfHits;

  bool operator<(const SkdCurveCandidate& other) const
  {
    return this->First != other.First ? this->First < other.First : this->Second < other.Second;
  }
};

struct SkdCurveIntersections
{
  std::vector<SkdCurveHit> Hits;             ///< by both curves, then along both
  std::vector<SkdCurveInterval> Intervals;   ///< likewise
  std::vector<SkdCurveCandidate> Candidates; ///< ascending
};

/// What is looked for.
struct SkdCurveTask
{
  double Clearance = 0.0;    ///< reports pairs of curves that do not intersect but come as near
  bool IgnoresJoints = true; ///< curves that go on as each other are one
  bool TellsCandidates = false;
};

class SkdCurveHitFinder
{
public:
  /// For self-intersections `first` and `second` are the same. Then each pair is reported once, and
  /// adjacent pieces of a curve are not compared.
  SkdCurveHitFinder(
    const SkdCurveTree& first, const SkdCurveTree& second, const SkdCurveTask& task);

  /// In parallel over the pieces of the first set.
  SkdCurveIntersections Find(SkdLoop& loop) const;

  /// The distance that is 0 to within rounding.
  double GetRounding() const { return this->Rounding; }

private:
  struct Worker; ///< of a thread

  bool IsSelf() const { return &this->First == &this->Second; }
  void FindOnSpan(std::size_t span, Worker& worker) const;
  void Examine(std::size_t first, std::size_t second, Worker& worker) const;
  bool AddHit(const SkdCurveSpan& first, const SkdCurveSpan& second, const skd::CurvePairHit& hit,
    Worker& worker) const;
  void FindNear(const SkdCurveSpan& first, const SkdCurveSpan& second, Worker& worker) const;
  bool AreNeighbours(const SkdCurveSpan& first, const SkdCurveSpan& second) const;
  SkdCurveLocation LocationOf(const SkdCurveTree& tree, const SkdCurveSpan& span, double t) const;
  static void FindEnd(const SkdCurveTree& tree, SkdCurveLocation& location);
  bool IsJoint(const SkdCurveHit& hit) const;

  const SkdCurveTree& First;
  const SkdCurveTree& Second;
  SkdCurveTask Task;
  double Rounding;
};
}

#endif
