// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdSectionFaces.h"

#include "Bodies/SkdEdgeTable.h"
#include "Bodies/SkdTriangulation.h"
#include "Core/Geometry/DisjointSets.h"

#include <algorithm>

namespace skdtree
{
namespace
{
using Corners = SkdTriangleSet::Corners;

constexpr std::size_t MostCorners = 4000;

class SectionMaker
{
public:
  SectionMaker(const SkdMovedTriangles& set, const SkdFacets& facets, const SkdFacetSigns& signs,
    SkdFaceSets& faces)
    : Moved(set)
    , Facets(facets)
    , Faces(faces)
  {
    for (std::uint32_t facet = 0; facet < signs.size(); ++facet)
    {
      if (signs[facet] > 0)
      {
        this->Pieces.push_back(facet);
        this->PieceCorners.push_back(facets.Corners[facet]);
      }
    }
  }

  SkdBooleanFaces Make()
  {
    this->FindParts();
    for (std::uint32_t part = 0; part < this->PiecesOf.size(); ++part)
    {
      const auto pieces = this->PiecesOf[part];
      if (this->FindLoop(part) && this->IsLoopCutByVtk())
      {
        this->Add(pieces[0], this->Loop.begin(), this->Loop.end());
        continue;
      }
      for (const std::uint32_t piece : pieces)
      {
        const Corners& corners = this->PieceCorners[piece];
        this->Add(piece, corners.begin(), corners.end());
      }
    }
    return std::move(this->Made);
  }

private:
  /// Whether pieces at an edge are two of one face, side by side.
  bool AreOfOneFace(const SkdEdgeUse* first, const SkdEdgeUse* last)
  {
    const auto faceOf = [this](const SkdEdgeUse& use)
    { return this->Faces.Find(this->Facets.Parents[this->Pieces[use.Triangle]]); };
    return last - first == 2 && first[0].IsForward != first[1].IsForward &&
      faceOf(first[0]) == faceOf(first[1]);
  }

  /// The connected parts of faces, and the edges around them.
  void FindParts()
  {
    const std::size_t points = this->Moved.GetPoints().size() + this->Facets.NewPoints.size();
    const skd::EdgeTable<> edges = SkdMakeEdgeTable(this->PieceCorners, points);
    skd::DisjointSets<> sets(this->Pieces.size());
    std::vector<std::array<bool, 3>> isBorder(this->Pieces.size(), { false, false, false });
    edges.ForEach(
      [&](std::uint32_t, const SkdEdgeUse* first, const SkdEdgeUse* last)
      {
        if (this->AreOfOneFace(first, last))
        {
          sets.Unite(first[0].Triangle, first[1].Triangle);
          return;
        }
        std::for_each(
          first, last, [&](const SkdEdgeUse& use) { isBorder[use.Triangle][use.Side] = true; });
      });
    const std::vector<std::uint32_t> partOf = sets.Number();
    const std::size_t count =
      partOf.empty() ? 0 : *std::max_element(partOf.begin(), partOf.end()) + std::size_t(1);
    this->PiecesOf = skd::IndexRows(count,
      [&](const auto& add)
      {
        for (std::uint32_t piece = 0; piece < partOf.size(); ++piece)
        {
          add(partOf[piece], piece);
        }
      });
    this->BorderOf = skd::IndexRows(count,
      [&](const auto& add)
      {
        for (std::uint32_t piece = 0; piece < partOf.size(); ++piece)
        {
          for (std::uint32_t side = 0; side < 3; ++side)
          {
            if (isBorder[piece][side])
            {
              add(partOf[piece], 3 * piece + side);
            }
          }
        }
      });
  }

  /// Whether all of the border of a part is one loop that passes no point twice, and there is no
  /// point within; the loop.
  bool FindLoop(std::uint32_t part)
  {
    const auto pieces = this->PiecesOf[part];
    this->Loop.clear();
    if (pieces.size() < 2 || pieces.size() + 2 > MostCorners ||
      this->BorderOf[part].size() != pieces.size() + 2)
    {
      return false;
    }
    std::vector<SkdSplitEdge> edges; // from, to
    for (const std::uint32_t at : this->BorderOf[part])
    {
      const Corners& corners = this->PieceCorners[at / 3];
      edges.emplace_back(corners[at % 3], corners[(at % 3 + 1) % 3]);
    }
    std::sort(edges.begin(), edges.end());
    const auto beginAtOnePoint = [](const SkdSplitEdge& a, const SkdSplitEdge& b)
    { return a.first == b.first; };
    if (std::adjacent_find(edges.begin(), edges.end(), beginAtOnePoint) != edges.end())
    {
      return false;
    }
    std::uint32_t at = edges[0].first;
    do
    {
      this->Loop.push_back(at);
      at = std::lower_bound(edges.begin(), edges.end(), SkdSplitEdge{ at, 0 })->second;
    } while (at != this->Loop[0]);
    return this->Loop.size() == edges.size();
  }

  bool IsLoopCutByVtk()
  {
    return this->Triangulation.IsCutByVtk(static_cast<vtkIdType>(this->Loop.size()),
      [this](vtkIdType i)
      { return this->Facets.GetPosition(this->Moved, this->Loop[static_cast<std::size_t>(i)]); });
  }

  template <class Iterator>
  void Add(std::uint32_t piece, Iterator first, Iterator last)
  {
    this->Made.Add(this->Pieces[piece], first, last);
  }

  const SkdMovedTriangles& Moved;
  const SkdFacets& Facets;
  SkdFaceSets& Faces;
  std::vector<std::uint32_t> Pieces; // facets
  std::vector<Corners> PieceCorners;
  skd::IndexRows PiecesOf; // of each part
  skd::IndexRows BorderOf; // of each part, 3 * piece + side
  SkdTriangulation Triangulation;
  SkdBooleanFaces Made;
  std::vector<std::uint32_t> Loop;
};
}

SkdBooleanFaces SkdMakeSectionFaces(const SkdMovedTriangles& set, const SkdFacets& facets,
  const SkdFacetSigns& signs, SkdFaceSets& faces)
{
  return SectionMaker(set, facets, signs, faces).Make();
}
}
