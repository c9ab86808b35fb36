// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdBooleanFaces.h"

#include "Bodies/SkdEdgeTable.h"
#include "Solids/Boolean/SkdFacetMerger.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace skdtree
{
namespace
{
using Corners = SkdTriangleSet::Corners;

class FaceMaker
{
public:
  FaceMaker(const SkdMovedTriangles& set, const SkdFacets& facets, const SkdFacetSigns& signs,
    const SkdFaceOptions& options)
    : Moved(set)
    , Set(set.GetSet())
    , Facets(facets)
    , Signs(signs)
    , Options(options)
    , Junctions(options.IsMerged ? this->FindJunctions() : std::vector<SkdSplitEdge>())
    , Merger(set, facets, this->Junctions)
  {
  }

  SkdBooleanFaces Make()
  {
    const auto n = static_cast<std::uint32_t>(this->Facets.GetNumberOfFacets());
    for (std::uint32_t facet = 0; facet < n;)
    {
      const std::uint32_t end = this->FindEndOfPolygon(facet);
      if (end > facet + 1 && this->AddOutline(facet, end))
      {
        facet = end;
        continue;
      }
      const std::uint32_t next = this->Options.IsMerged ? this->FindEndOfPieces(facet) : facet + 1;
      this->AddPieces(facet, next);
      facet = next;
    }
    return std::move(this->Faces);
  }

private:
  /// The edges, ascending, at which more than two facets of the boundary meet.
  std::vector<SkdSplitEdge> FindJunctions() const
  {
    std::vector<SkdSplitEdge> junctions;
    const std::size_t points = this->Moved.GetPoints().size() + this->Facets.NewPoints.size();
    SkdMakeEdgeTable(this->Facets.Corners, points)
      .ForEach(
        [&](std::uint32_t low, const SkdEdgeUse* first, const SkdEdgeUse* last)
        {
          const auto count = std::count_if(
            first, last, [this](const SkdEdgeUse& use) { return this->Signs[use.Triangle] != 0; });
          if (count > 2)
          {
            junctions.emplace_back(low, first->High);
          }
        });
    return junctions;
  }

  std::uint32_t FindEndOfPieces(std::uint32_t facet) const
  {
    const auto& parents = this->Facets.Parents;
    const auto at = parents.begin() + facet;
    return static_cast<std::uint32_t>(std::upper_bound(at, parents.end(), *at) - parents.begin());
  }

  /// Adds the pieces of a triangle that are in the boundary, those of each sign by themselves.
  void AddPieces(std::uint32_t first, std::uint32_t end)
  {
    if (end == first + 1)
    {
      if (this->Signs[first] != 0)
      {
        const Corners corners = this->CornersOf(first);
        this->Add(first, corners.begin(), corners.end());
      }
      return;
    }
    for (const int sign : { 1, -1 })
    {
      std::vector<std::uint32_t> pieces;
      for (std::uint32_t facet = first; facet < end; ++facet)
      {
        if (this->Signs[facet] == sign)
        {
          pieces.push_back(facet);
        }
      }
      if (pieces.empty())
      {
        continue;
      }
      for (SkdFacetMerger::Polygon& polygon : this->Merger.Merge(pieces))
      {
        if (sign < 0)
        {
          std::reverse(polygon.begin(), polygon.end());
        }
        this->Add(pieces[0], polygon.begin(), polygon.end());
      }
    }
  }

  std::uint32_t CellOf(std::uint32_t facet) const
  {
    return this->Set.GetCellOf(this->Facets.Parents[facet]);
  }

  Corners CornersOf(std::uint32_t facet) const
  {
    Corners corners = this->Facets.Corners[facet];
    if (this->Signs[facet] < 0)
    {
      std::swap(corners[1], corners[2]);
    }
    return corners;
  }

  /// The end of a cell's facets that begin here, if these are all of its triangles, not split, and
  /// of one sign; else the facet itself.
  std::uint32_t FindEndOfPolygon(std::uint32_t facet) const
  {
    if (this->Options.IsPolygon.empty())
    {
      return facet;
    }
    const std::uint32_t cell = this->CellOf(facet);
    const std::uint32_t parent = this->Facets.Parents[facet];
    const bool isFirst = parent == 0 || this->Set.GetCellOf(parent - 1) != cell;
    if (!this->Options.IsPolygon[cell] || !isFirst || this->Signs[facet] == 0)
    {
      return facet;
    }
    std::uint32_t end = facet;
    for (std::uint32_t triangle = parent;
         triangle < this->Set.GetTriangles().size() && this->Set.GetCellOf(triangle) == cell;
         ++triangle, ++end)
    {
      if (end == this->Facets.GetNumberOfFacets() || this->Facets.Parents[end] != triangle ||
        this->Signs[end] != this->Signs[facet] ||
        this->Facets.Corners[end] != this->Set.GetTriangles()[triangle])
      {
        return facet;
      }
    }
    return end;
  }

  /// Adds the outline of facets as a face, if it is one loop that passes no point twice, and that
  /// VTK can triangulate.
  bool AddOutline(std::uint32_t first, std::uint32_t end)
  {
    this->Edges.clear();
    for (std::uint32_t facet = first; facet < end; ++facet)
    {
      const Corners corners = this->CornersOf(facet);
      for (int i = 0; i < 3; ++i)
      {
        const SkdSplitEdge edge{ corners[i], corners[(i + 1) % 3] };
        const auto opposite = std::find(
          this->Edges.begin(), this->Edges.end(), SkdSplitEdge{ edge.second, edge.first });
        if (opposite != this->Edges.end())
        {
          this->Edges.erase(opposite);
        }
        else
        {
          this->Edges.push_back(edge);
        }
      }
    }
    this->Loop.clear();
    std::uint32_t at = this->Edges.empty() ? 0 : this->Edges[0].first;
    while (this->Loop.size() < this->Edges.size() &&
      std::find(this->Loop.begin(), this->Loop.end(), at) == this->Loop.end())
    {
      const auto next = std::find_if(this->Edges.begin(), this->Edges.end(),
        [at](const SkdSplitEdge& edge) { return edge.first == at; });
      if (next == this->Edges.end())
      {
        return false;
      }
      this->Loop.push_back(at);
      at = next->second;
    }
    const bool isFace =
      this->Loop.size() == end - first + 2 && at == this->Loop[0] && this->IsLoopCutByVtk();
    if (isFace)
    {
      this->Add(first, this->Loop.begin(), this->Loop.end());
    }
    return isFace;
  }

  bool IsLoopCutByVtk()
  {
    const auto cornerOf = [this](vtkIdType i)
    { return this->Facets.GetPosition(this->Moved, this->Loop[static_cast<std::size_t>(i)]); };
    return this->IsPlainQuad(cornerOf) ||
      this->Triangulation.IsCutByVtk(static_cast<vtkIdType>(this->Loop.size()), cornerOf);
  }

  /// Quads with corners far from straight and sides that do not differ much need no closer look.
  template <class CornerOf>
  bool IsPlainQuad(const CornerOf& cornerOf) const
  {
    constexpr double leastSine2 = 1e-4;
    constexpr double leastRatio2 = 1e-6; // of a side to the longest
    if (this->Loop.size() != 4)
    {
      return false;
    }
    std::array<skd::Vector3, 4> sides;
    double longest2 = 0.0;
    for (vtkIdType i = 0; i < 4; ++i)
    {
      sides[i] = cornerOf((i + 1) % 4) - cornerOf(i);
      longest2 = std::max(longest2, Norm2(sides[i]));
    }
    const double unit = 1.0 / std::sqrt(longest2); // so that no product overflows
    std::for_each(sides.begin(), sides.end(), [unit](skd::Vector3& side) { side = unit * side; });
    const skd::Vector3 normal = Cross(sides[0] + sides[1], sides[1] + sides[2]);
    bool isPlain = true;
    for (std::size_t i = 0; i < 4; ++i)
    {
      const skd::Vector3& next = sides[(i + 1) % 4];
      const double cross = Dot(Cross(sides[i], next), normal);
      isPlain = isPlain && cross > 0.0 && Norm2(sides[i]) > leastRatio2 &&
        cross * cross > leastSine2 * Norm2(sides[i]) * Norm2(next) * Norm2(normal);
    }
    return isPlain;
  }

  template <class Iterator>
  void Add(std::uint32_t facet, Iterator first, Iterator last)
  {
    this->Faces.Add(facet, first, last);
  }

  const SkdMovedTriangles& Moved;
  const SkdTriangleSet& Set;
  const SkdFacets& Facets;
  const SkdFacetSigns& Signs;
  const SkdFaceOptions& Options;
  const std::vector<SkdSplitEdge> Junctions;
  SkdFacetMerger Merger;
  SkdTriangulation Triangulation;
  SkdBooleanFaces Faces;
  std::vector<SkdSplitEdge> Edges; // of an outline
  std::vector<std::uint32_t> Loop;
};

/// One face for each facet.
SkdBooleanFaces MakeFacets(const SkdFacetSigns& signs)
{
  const auto unused = std::count(signs.begin(), signs.end(), 0);
  SkdBooleanFaces faces;
  faces.Facets.resize(signs.size() - static_cast<std::size_t>(unused));
  std::uint32_t* to = faces.Facets.data();
  SkdBooleanFaces::ForEachRun(signs,
    [&to](std::size_t first, std::size_t last)
    {
      std::iota(to, to + (last - first), static_cast<std::uint32_t>(first));
      to += last - first;
    });
  return faces;
}
}

SkdBooleanFaces SkdMakeBooleanFaces(const SkdMovedTriangles& set, const SkdFacets& facets,
  const SkdFacetSigns& signs, const SkdFaceOptions& options)
{
  return options.IsPolygon.empty() && !options.IsMerged
    ? MakeFacets(signs)
    : FaceMaker(set, facets, signs, options).Make();
}
}
