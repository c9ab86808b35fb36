// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCurveTree.h
 * @brief Curves divided into nearly straight pieces, and their skD-tree (section 6.1); reused while
 * the meshes are unchanged.
 */

#ifndef SkdCurveTree_h
#define SkdCurveTree_h

#include "Core/Geometry/Segment.h"
#include "Core/Search/Tree/Tree.h"
#include "Curves/SkdCurveSet.h"
#include "Pipeline/SkdBlockSnapshots.h"

namespace skdtree
{
/// A part of a piece that is within `Deviation` of its chord and turns by less than 45 degrees.
struct SkdCurveSpan
{
  std::size_t Piece;
  skd::Interval Range;
  skd::Segment<3> Chord;
  double Deviation;
  bool IsLine; ///< the chord is the part itself, with the very coordinates of its ends
};

/// The representation of polylines, and the chord tolerance relative to the curves' diagonal.
struct SkdCurveSettings
{
  SkdPolylineForm Form;
  double ChordTolerance;
  double Epsilon;

  bool operator==(const SkdCurveSettings& other) const
  {
    return this->Form == other.Form && this->ChordTolerance == other.ChordTolerance &&
      this->Epsilon == other.Epsilon;
  }
};

class SkdCurveTree
{
public:
  /// Returns whether anything was updated.
  bool Update(const std::vector<SkdBlock>& blocks, const SkdCurveSettings& settings);

  const SkdCurveSet& GetCurves() const { return this->Curves; }
  const SkdCurveSettings& GetSettings() const { return this->Settings; }
  const std::vector<SkdCurveSpan>& GetSpans() const { return this->Spans; }

  /// The part of the curve, relative to an origin.
  skd::BezierCurve GetForm(const SkdCurveSpan& span, const skd::Vector3& origin) const;

  /// The box of the span's control points.
  const skd::Box3& GetBox(std::size_t span) const { return this->Boxes[span]; }

  /// visit(number of span) for all whose safety boxes meet the box. Thread-safe. SkdVisitCurves.h
  /// has it.
  template <class Visit>
  void VisitWithin(const skd::Box3& box, Visit visit) const;

  double GetAbsoluteEpsilon() const { return this->AbsoluteEpsilon; }

private:
  void Cut(double delta);
  void Build(double epsilon);

  SkdBlockSnapshots Meshes;
  SkdCurveSettings Settings{ {}, -1.0, -1.0 };
  SkdCurveSet Curves;
  std::vector<SkdCurveSpan> Spans;
  std::vector<skd::Box3> Boxes;
  skd::Tree<3> Tree;
  double AbsoluteEpsilon = 0.0;
};
}

#endif
