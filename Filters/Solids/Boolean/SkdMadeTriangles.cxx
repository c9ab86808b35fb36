// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdMadeTriangles.h"

#include "Solids/Boolean/SkdBoxSet.h"
#include "Solids/Boolean/SkdRoundedPlane.h"

#include <algorithm>
#include <limits>

namespace skdtree
{
namespace
{
using Corners = SkdTriangleSet::Corners;

/// Pieces of one part that face alike.
class FacingPieces
{
public:
  FacingPieces(const SkdPieceParts& parts, std::uint32_t part, bool areOpposite)
    : Parts(parts)
  {
    for (const std::uint32_t piece : parts.GetPiecesOf(part))
    {
      if (parts.IsOpposite(piece) == areOpposite)
      {
        this->Pieces.push_back(piece);
      }
    }
    const auto isOfFirst = [&](std::uint32_t piece)
    { return parts.GetUnmergedPartOf(piece) == parts.GetUnmergedPartOf(this->Pieces.front()); };
    if (!std::all_of(this->Pieces.begin(), this->Pieces.end(), isOfFirst))
    {
      this->Boxes.emplace(this->ListBoxes());
    }
  }

  /// The part of the piece that has the middle of a triangle, or is nearest to it.
  std::uint32_t PartAt(const Corners& corners) const
  {
    std::uint32_t found = this->Pieces.front();
    if (this->Boxes)
    {
      const skd::Vector3 middle = (1.0 / 3.0) *
        (this->Parts.GetPosition(corners[0]) + this->Parts.GetPosition(corners[1]) +
          this->Parts.GetPosition(corners[2]));
      const std::array<skd::Vector3, 3> there{ middle, middle, middle };
      double most = -std::numeric_limits<double>::max();
      this->Boxes->ForEachOverlapping(SkdBoxSet::BoxOf(there, SkdToleranceOf(there)),
        [&](std::uint32_t k)
        {
          const std::uint32_t piece = this->Pieces[k];
          const double least = SkdLeastWeight(this->Parts.PositionsOf(piece), middle);
          found = least > most ? piece : found;
          most = std::max(most, least);
        });
    }
    return this->Parts.GetUnmergedPartOf(found);
  }

private:
  std::vector<skd::Box3> ListBoxes() const
  {
    std::vector<skd::Box3> boxes;
    for (const std::uint32_t piece : this->Pieces)
    {
      boxes.push_back(SkdBoxSet::BoxOf(this->Parts.PositionsOf(piece), 0.0));
    }
    return boxes;
  }

  const SkdPieceParts& Parts;
  std::vector<std::uint32_t> Pieces;
  std::optional<SkdBoxSet> Boxes; // if they are of several parts
};
}

std::vector<SkdMadeTriangle> SkdListMade(
  const SkdPieceParts& parts, std::uint32_t part, const SkdFlatFace::Triangles& triangles)
{
  std::vector<SkdMadeTriangle> made;
  for (const bool areOpposite : { false, true })
  {
    const std::vector<Corners>& some = areOpposite ? triangles.Right : triangles.Left;
    if (!some.empty())
    {
      const FacingPieces pieces(parts, part, areOpposite);
      for (const Corners& corners : some)
      {
        made.push_back({ pieces.PartAt(corners), corners });
      }
    }
  }
  std::stable_sort(made.begin(), made.end());
  return made;
}
}
