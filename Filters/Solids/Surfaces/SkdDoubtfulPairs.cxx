// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdDoubtfulPairs.h"

#include "Cells/Read/SkdForEach.h"
#include "Core/Search/Tree/PackedRTree.h"
#include "Pipeline/SkdLoop.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace skdtree
{
namespace
{
/// Of a difference of two points, each of which is moved by up to sqrt(3) roundings, and with room
/// for products of several.
constexpr double RoundingsOfEdge = 8.0;

/// What arithmetic does to products of lengths; motions are rigid to 1e-9 (skd::RigidMotion).
constexpr double Distortion = 1e-8;

/// Looks at pairs with an error bound that rounding after a motion is within.
class PairTest
{
public:
  PairTest(const SkdMovedTriangles& set, double rounding)
    : Set(set)
    , Error(RoundingsOfEdge * rounding)
  {
  }

  /// Whether all that two triangles have in common surely are corners that they share.
  bool IsSure(std::uint32_t first, std::uint32_t second) const
  {
    const SkdTriangleSet::Corners& a = this->Set.GetCorners(first);
    const SkdTriangleSet::Corners& b = this->Set.GetCorners(second);
    return this->HasOthersOnOneSide(a, b) || this->HasOthersOnOneSide(b, a) ||
      this->IsBeyondAnEdge(a, b) || this->IsBeyondAnEdge(b, a) || this->AreApartAtCorner(a, b) ||
      this->AreApartAlongEdges(a, b);
  }

private:
  using Corners = SkdTriangleSet::Corners;

  static bool Has(const Corners& corners, std::uint32_t point)
  {
    return corners[0] == point || corners[1] == point || corners[2] == point;
  }

  const skd::Vector3& At(std::uint32_t point) const { return this->Set.GetPoints()[point]; }

  /// Whether the corners of another triangle that a triangle does not have, if there are any, are
  /// on one side of its plane and stay there.
  bool HasOthersOnOneSide(const Corners& plane, const Corners& other) const
  {
    int side = 0;
    for (const std::uint32_t corner : other)
    {
      if (!Has(plane, corner))
      {
        const int here = this->SideOf(plane, this->At(corner));
        if (here == 0 || here == -side)
        {
          return false;
        }
        side = here;
      }
    }
    return side != 0;
  }

  /// The sign of a volume that has it also with other roundings; else 0.
  int SideOf(const Corners& plane, const skd::Vector3& x) const
  {
    const skd::Vector3 u = this->At(plane[1]) - this->At(plane[0]);
    const skd::Vector3 v = this->At(plane[2]) - this->At(plane[0]);
    const skd::Vector3 w = x - this->At(plane[0]);
    const double a = Norm(u);
    const double b = Norm(v);
    const double c = Norm(w);
    const double volume = Dot(Cross(u, v), w);
    const double doubt = this->Error * (a * b + b * c + c * a) + Distortion * a * b * c;
    return (volume > doubt) - (volume < -doubt);
  }

  /// Whether a plane upright on a triangle, through one of its edges, has all of another one beyond
  /// it but for the ends of the edge: what they have in common is in the plane. That tells
  /// neighbours in one plane, and those along a common edge with an angle of more than a right one.
  bool IsBeyondAnEdge(const Corners& of, const Corners& other) const
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::uint32_t from = of[i];
      const std::uint32_t to = of[(i + 1) % 3];
      const std::uint32_t apex = of[(i + 2) % 3];
      const skd::Vector3 edge = this->At(to) - this->At(from);
      const skd::Vector3 within = this->At(apex) - this->At(from);
      const bool isBeyond = std::all_of(other.begin(), other.end(),
        [&](std::uint32_t corner)
        {
          return corner == from || corner == to ||
            (corner != apex && this->IsBeyond(edge, within, this->At(corner) - this->At(from)));
        });
      if (isBeyond)
      {
        return true;
      }
    }
    return false;
  }

  /// Whether a point is beyond an edge, seen upright on the triangle of the edge and another point,
  /// and stays there.
  bool IsBeyond(
    const skd::Vector3& edge, const skd::Vector3& within, const skd::Vector3& point) const
  {
    const double a = Norm(within);
    const double b = Norm(point);
    const double c = Norm(edge);
    const double doubt = 4.0 * c * (this->Error * (a * b + b * c + c * a) + Distortion * a * b * c);
    return Dot(Cross(within, edge), Cross(point, edge)) < -doubt;
  }

  /// Whether triangles with a common corner are on different sides of a plane through it, upright
  /// on the difference of the directions in which they are. In one plane they may be opposite each
  /// other, so that the edges of both are on two lines.
  bool AreApartAtCorner(const Corners& first, const Corners& second) const
  {
    const auto at = std::find_first_of(first.begin(), first.end(), second.begin(), second.end());
    if (at == first.end())
    {
      return false;
    }
    const skd::Vector3 normal = this->DirectionFrom(*at, first) - this->DirectionFrom(*at, second);
    return this->IsAbove(*at, normal, first) && this->IsAbove(*at, -1.0 * normal, second);
  }

  /// Whether triangles without a common edge are on different sides of a plane that is parallel to
  /// an edge of each, but for a common corner: so are all that are apart, unless planes or edges of
  /// one tell it (Gottschalk et al., SIGGRAPH 1996).
  bool AreApartAlongEdges(const Corners& first, const Corners& second) const
  {
    const auto shared =
      std::find_first_of(first.begin(), first.end(), second.begin(), second.end());
    for (std::size_t i = 0; i < 3; ++i)
    {
      const skd::Vector3 edge = this->At(first[(i + 1) % 3]) - this->At(first[i]);
      for (std::size_t k = 0; k < 3; ++k)
      {
        const skd::Vector3 normal =
          Cross(edge, this->At(second[(k + 1) % 3]) - this->At(second[k]));
        const bool areApart = shared == first.end()
          ? this->AreApart(first, second, normal)
          : (this->IsAbove(*shared, normal, first) &&
              this->IsAbove(*shared, -1.0 * normal, second)) ||
            (this->IsAbove(*shared, -1.0 * normal, first) &&
              this->IsAbove(*shared, normal, second));
        if (areApart)
        {
          return true;
        }
      }
    }
    return false;
  }

  /// Whether a plane with this normal is between triangles without a common corner.
  bool AreApart(const Corners& first, const Corners& second, const skd::Vector3& normal) const
  {
    const skd::Vector3& origin = this->At(first[0]);
    double farthest = 0.0;
    const auto rangeOf = [&](const Corners& of)
    {
      std::pair<double, double> range(
        std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
      for (const std::uint32_t corner : of)
      {
        const skd::Vector3 x = this->At(corner) - origin;
        range.first = std::min(range.first, Dot(x, normal));
        range.second = std::max(range.second, Dot(x, normal));
        farthest = std::max(farthest, Norm(x));
      }
      return range;
    };
    const auto a = rangeOf(first);
    const auto b = rangeOf(second);
    const double doubt = 4.0 * Norm(normal) * (this->Error + Distortion * farthest);
    return b.first - a.second > doubt || a.first - b.second > doubt;
  }

  /// The sum of those of the edges from a corner.
  skd::Vector3 DirectionFrom(std::uint32_t corner, const Corners& of) const
  {
    skd::Vector3 sum{};
    for (const std::uint32_t other : of)
    {
      const skd::Vector3 edge = this->At(other) - this->At(corner);
      const double length = Norm(edge);
      sum = length > 0.0 ? sum + (1.0 / length) * edge : sum;
    }
    return sum;
  }

  /// Whether all other corners are above a plane through one of them and stay there.
  bool IsAbove(std::uint32_t corner, const skd::Vector3& normal, const Corners& of) const
  {
    return std::all_of(of.begin(), of.end(),
      [&](std::uint32_t other)
      {
        const skd::Vector3 edge = this->At(other) - this->At(corner);
        const double doubt = 2.0 * Norm(normal) * (this->Error + Distortion * Norm(edge));
        return other == corner || Dot(edge, normal) > doubt;
      });
  }

  const SkdMovedTriangles& Set;
  const double Error;
};

std::vector<skd::Box3> MakeBoxes(const SkdMovedTriangles& set, std::uint32_t begin, double margin)
{
  const std::size_t n = set.GetSet().GetTriangles().size() - begin;
  std::vector<skd::Box3> boxes(n);
  SkdForEach(static_cast<vtkIdType>(n),
    [&](vtkIdType i)
    { boxes[i] = set.GetBox(begin + static_cast<std::uint32_t>(i)).Inflated(margin); });
  return boxes;
}
}

std::optional<SkdIndexPairs> SkdFindDoubtfulPairs(
  const SkdMovedTriangles& set, std::uint32_t begin, double rounding, SkdLoop& loop)
{
  const PairTest test(set, rounding);
  const std::vector<skd::Box3> boxes = MakeBoxes(set, begin, RoundingsOfEdge * rounding);
  const skd::PackedRTree tree(boxes);
  const std::size_t most = 64 * boxes.size(); // looks, as in SkdTrianglePairs
  std::atomic<std::size_t> looks{ 0 };
  const auto packets = static_cast<vtkIdType>(tree.GetNumberOfPackets());
  std::vector<SkdIndexPairs> found(static_cast<std::size_t>(packets));
  loop.SetTotal(packets);
  const bool isDone = loop.For(packets,
    [&](vtkIdType first, vtkIdType last)
    {
      skd::PackedRTree::OverlapLists lists;
      for (vtkIdType packet = first; packet < last && looks <= most; ++packet)
      {
        tree.ForEachOverlapWithin(static_cast<std::size_t>(packet), lists,
          [&](std::uint32_t box, const std::vector<std::uint32_t>& others)
          {
            for (const std::uint32_t other : others)
            {
              const auto [low, high] = std::minmax({ begin + box, begin + other });
              if (!test.IsSure(low, high))
              {
                found[static_cast<std::size_t>(packet)].emplace_back(low, high);
              }
            }
            return (looks += others.size()) <= most;
          });
      }
    });
  SkdIndexPairs all;
  for (const SkdIndexPairs& some : found)
  {
    all.insert(all.end(), some.begin(), some.end());
  }
  std::sort(all.begin(), all.end());
  return isDone && looks <= most ? std::make_optional(std::move(all)) : std::nullopt;
}
}
