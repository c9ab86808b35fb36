// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdPieceOverlap.h
 * @brief What two convex pieces of cells have in common.
 */

#ifndef SkdPieceOverlap_h
#define SkdPieceOverlap_h

#include "Core/Geometry/Overlap/LonLatOverlap.h"
#include "Core/Geometry/Overlap/SegmentOverlap.h"
#include "Core/Geometry/Overlap/SolidOverlap.h"
#include "Remap/SkdFacetOverlap.h"
#include "Remap/SkdOverlapPieces.h"

namespace skdtree
{
/// Calls visit(piece of a target cell, piece of a donor cell) for all pairs.
template <class Visit>
void SkdForEachPiecePair(const SkdOverlapPieces& targets, std::uint32_t target,
  const SkdOverlapPieces& donors, std::uint32_t donor, const Visit& visit)
{
  const auto ofTarget = targets.PiecesOf(target);
  const auto ofDonor = donors.PiecesOf(donor);
  for (std::uint32_t i = ofTarget.First; i < ofTarget.Last; ++i)
  {
    const SkdPieceView one(targets.BlockOf(target), i);
    for (std::uint32_t k = ofDonor.First; k < ofDonor.Last; ++k)
    {
      visit(one, SkdPieceView(donors.BlockOf(donor), k));
    }
  }
}

/// Takes nothing but measures; others may want to see overlaps, too.
struct SkdNoShapes
{
  void Take(const skd::Segment<3>&) const {}
  template <class Frame>
  void Take(const Frame&, const skd::ConvexPolygon&) const
  {
  }
  void Take(const skd::LonLatCell&) const {}
  void Take(const skd::SphericalFrame&, const skd::PolygonView&, const skd::LonLatCell&) const {}
  void Take(const skd::Vector3&, const skd::ConvexSolid&) const {}
};

/// Of two pieces, about the reference of the smaller one, which is the one that is cut. Shapes are
/// shown to `shapes` where there are any. A piece within another is not cut: its own moments are
/// the answer, to the last bit. Of curved surfaces the second piece, the donor's, is the base that
/// the first one is projected onto (SkdFacetOverlap).
template <class Shapes>
class SkdPieceOverlap
{
public:
  SkdPieceOverlap(const SkdOverlapSettings& settings, const Shapes& shapes)
    : Settings(settings)
    , TheShapes(shapes)
  {
  }

  /// The moments and what they are about, without the pieces' signs.
  skd::Moments Find(
    const SkdPieceView& one, const SkdPieceView& other, const skd::Vector3*& reference) const
  {
    if (this->Settings.Space == SkdOverlapSpace::CurvedSurface)
    {
      return this->OfFacets(one, other, reference);
    }
    const bool isOneSmaller = one.Piece.Own.Measure <= other.Piece.Own.Measure;
    const SkdPieceView& within = isOneSmaller ? one : other;
    const SkdPieceView& around = isOneSmaller ? other : one;
    reference = &within.Piece.Reference;
    const double distance = one.Piece.Radius + other.Piece.Radius;
    if (!(Distance2(one.Piece.Reference, other.Piece.Reference) < distance * distance))
    {
      return {};
    }
    switch (this->Settings.Space)
    {
      case SkdOverlapSpace::Line:
        return this->OfSegments(within, around);
      case SkdOverlapSpace::Plane:
        return this->OfPolygons(skd::PlanarFrame(*reference), within, around);
      case SkdOverlapSpace::Sphere:
        return within.Piece.IsLonLat || around.Piece.IsLonLat
          ? this->OfLonLat(within, around, reference)
          : this->OfPolygons(skd::SphericalFrame(*reference), within, around);
      case SkdOverlapSpace::Volume:
        return this->OfSolids(within, around);
      case SkdOverlapSpace::CurvedSurface:
        break;
    }
    return {};
  }

private:
  skd::Moments OfFacets(
    const SkdPieceView& target, const SkdPieceView& donor, const skd::Vector3*& reference) const
  {
    reference = &donor.Piece.Reference;
    SkdFacetOverlap overlap(donor, this->Settings.Facets);
    if (!overlap.Find(target))
    {
      return {};
    }
    this->TheShapes.Take(overlap.GetFrame(), overlap.GetCommon());
    return overlap.GetMoments();
  }

  skd::Moments OfSegments(const SkdPieceView& within, const SkdPieceView& around) const
  {
    const auto common = skd::CommonInterval(
      { within.Corners[0], within.Corners[1] }, { around.Corners[0], around.Corners[1] });
    if (!common)
    {
      return {};
    }
    this->TheShapes.Take(*common);
    return skd::MomentsOf(*common, within.Piece.Reference);
  }

  template <class Frame>
  skd::Moments OfPolygons(
    const Frame& frame, const SkdPieceView& within, const SkdPieceView& around) const
  {
    skd::ConvexPolygon overlap;
    const skd::ClipResult result =
      skd::FindOverlap(frame, within.AsPolygon(), around.AsPolygon(), overlap);
    if (result == skd::ClipResult::Nothing)
    {
      return {};
    }
    this->TheShapes.Take(frame, overlap);
    return result == skd::ClipResult::All ? within.Piece.Own : frame.Moments(overlap);
  }

  skd::Moments OfLonLat(
    const SkdPieceView& within, const SkdPieceView& around, const skd::Vector3*& reference) const
  {
    if (within.Piece.IsLonLat && around.Piece.IsLonLat)
    {
      const auto common = skd::CommonCell(within.AsLonLat(), around.AsLonLat());
      if (!common)
      {
        return {};
      }
      this->TheShapes.Take(*common);
      return skd::MomentsOf(*common, *reference);
    }
    const SkdPieceView& polygon = within.Piece.IsLonLat ? around : within;
    const SkdPieceView& cell = within.Piece.IsLonLat ? within : around;
    reference = &polygon.Piece.Reference;
    const skd::Moments moments = skd::FindOverlap(*reference, polygon.AsPolygon(), cell.AsLonLat());
    if (moments.Measure > 0.0)
    {
      this->TheShapes.Take(skd::SphericalFrame(*reference), polygon.AsPolygon(), cell.AsLonLat());
    }
    return moments;
  }

  skd::Moments OfSolids(const SkdPieceView& within, const SkdPieceView& around) const
  {
    skd::Moments moments;
    skd::FindOverlap(within.Piece.Reference, within.AsSolid(), around.AsSolid(),
      [&](const skd::ConvexSolid& solid, skd::ClipResult result)
      {
        moments = result == skd::ClipResult::All ? within.Piece.Own : solid.Moments();
        this->TheShapes.Take(within.Piece.Reference, solid);
      });
    return moments;
  }

  const SkdOverlapSettings& Settings;
  const Shapes& TheShapes;
};
}

#endif
