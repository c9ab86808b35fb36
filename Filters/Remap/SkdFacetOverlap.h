// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdFacetOverlap.h
 * @brief What two flat pieces of surfaces that nearly coincide have in common.
 */

#ifndef SkdFacetOverlap_h
#define SkdFacetOverlap_h

#include "Core/Geometry/Overlap/PolygonOverlap.h"
#include "Core/Geometry/Overlap/TangentFrame.h"
#include "Remap/SkdPieceView.h"
#include "Remap/SkdRemapTolerances.h"

#include <array>
#include <cmath>

namespace skdtree
{
/// As long as twice the area.
inline skd::Vector3 SkdAreaVectorOf(const SkdPieceView& piece)
{
  skd::Vector3 area{ { 0.0, 0.0, 0.0 } };
  for (int i = 2; i < piece.Piece.Size; ++i)
  {
    const skd::Vector3& a = piece.Corners[0];
    area = area + Cross(piece.Corners[i - 1] - a, piece.Corners[i] - a);
  }
  return area;
}

inline skd::Vector3 SkdNormalOf(const SkdPieceView& piece)
{
  const skd::Vector3 area = SkdAreaVectorOf(piece);
  return (1.0 / Norm(area)) * area;
}

/// One facet, the base, and another one that is projected onto its plane along its normal. The
/// facets of a surface that is seen from everywhere over the base fit together there without a gap,
/// for one projection takes all of them: their overlaps add up to the base, to rounding. The
/// projections of neighbouring bases differ; so do the sums over a facet that is projected.
class SkdFacetOverlap
{
public:
  SkdFacetOverlap(const SkdPieceView& base, const SkdFacetRules& rules)
    : Base(base)
    , Frame(base.Piece.Reference, SkdNormalOf(base))
    , Rules(rules)
  {
  }

  /// Finds it, on the base. False if there is none, or none that counts: facets must face each
  /// other as the rules say, and be no farther apart, in the mean over the overlap.
  bool Find(const SkdPieceView& other)
  {
    const skd::Vector3 normal = SkdNormalOf(other);
    const double cosine = Dot(normal, this->Frame.GetNormal());
    if (!this->Rules.Faces(cosine) || !(std::abs(cosine) > remap_tolerances::EdgeOn))
    {
      return false;
    }
    const bool isBaseCut =
      this->Base.Piece.Own.Measure <= other.Piece.Own.Measure * std::abs(cosine);
    const skd::ClipResult result = this->Cut(other, cosine < 0.0, isBaseCut);
    const bool isAll = isBaseCut && result == skd::ClipResult::All;
    this->Result = isAll ? this->Base.Piece.Own : this->Frame.Moments(this->Common);
    if (result == skd::ClipResult::Nothing || !(this->Result.Measure > 0.0))
    {
      return false;
    }
    const skd::Vector3 middle =
      this->Base.Piece.Reference + (1.0 / this->Result.Measure) * this->Result.First;
    this->Gap = std::abs(Dot(other.Piece.Reference - middle, normal) / cosine);
    return this->Gap <= this->Rules.DistanceFor(this->Base.Piece.Radius, other.Piece.Radius);
  }

  ///@{
  /// What was found: the overlap, its moments about the base's reference, and how far the facets
  /// are apart there along the base's normal.
  const skd::TangentFrame& GetFrame() const { return this->Frame; }
  const skd::ConvexPolygon& GetCommon() const { return this->Common; }
  const skd::Moments& GetMoments() const { return this->Result; }
  double GetGap() const { return this->Gap; }
  ///@}

private:
  // The smaller one, as it is seen, is cut by the other one.
  skd::ClipResult Cut(const SkdPieceView& other, bool isReversed, bool isBaseCut)
  {
    std::array<skd::Vector3, skd::ConvexPolygon::Most> corners;
    const int size = other.Piece.Size;
    for (int i = 0; i < size; ++i)
    {
      corners[i] = other.Corners[isReversed ? size - 1 - i : i];
    }
    const skd::PolygonView polygon{ corners.data(), size };
    const skd::PolygonView base = this->Base.AsPolygon();
    return isBaseCut ? skd::FindOverlap(this->Frame, base, polygon, this->Common)
                     : skd::FindOverlap(this->Frame, polygon, base, this->Common);
  }

  const SkdPieceView& Base;
  skd::TangentFrame Frame;
  const SkdFacetRules& Rules;
  skd::ConvexPolygon Common;
  skd::Moments Result;
  double Gap = 0.0;
};
}

#endif
