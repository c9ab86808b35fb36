// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/SkdBoolean.h"

#include "Core/Predicates/Orient3D.h"
#include "Pipeline/SkdWinding.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
using Corners = SkdTriangleSet::Corners;
constexpr std::uint32_t None = SkdSplitSegments::None;

/// Of a piece: how it lies to the other surface.
enum class Place : char
{
  Outside,
  Inside,
  Alike,    // in a face of the other that looks the same way
  Opposite, // in one that looks the other way
  Unknown
};

bool IsSolid(SkdBooleanOperation operation, bool a, bool b)
{
  switch (operation)
  {
    case SkdBooleanOperation::Union:
      return a || b;
    case SkdBooleanOperation::Intersection:
      return a && b;
    case SkdBooleanOperation::Difference:
      return a && !b;
    case SkdBooleanOperation::ReverseDifference:
      return b && !a;
    default:
      return a != b;
  }
}

vtkSmartPointer<vtkPolyData> PolyDataOf(const SkdPlacedTriangles& set)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(set.GetPoints().size()));
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, set.GetPoints()[i].X);
  }
  vtkNew<vtkCellArray> cells;
  for (const Corners& corners : set.GetSet().GetTriangles())
  {
    cells->InsertNextCell({ static_cast<vtkIdType>(corners[0]), static_cast<vtkIdType>(corners[1]),
      static_cast<vtkIdType>(corners[2]) });
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(cells);
  return surface;
}

/// The least height, by which the pieces are found whose middle is far from their edges.
double HeightOf(const std::array<skd::Vector3, 3>& x)
{
  const double longest = std::max({ Norm2(x[1] - x[0]), Norm2(x[2] - x[1]), Norm2(x[0] - x[2]) });
  return longest > 0.0 ? Norm(Cross(x[1] - x[0], x[2] - x[0])) / std::sqrt(longest) : 0.0;
}

class Combination
{
public:
  Combination(const SkdPlacement& placement, const std::vector<SkdTrianglePair>& pairs,
    const SkdContactPoints& contacts, const SkdSplitSegments& segments,
    const std::array<SkdSplitResult, 2>& split)
    : Pairs(pairs)
    , Contacts(contacts)
    , Points(segments.GetPoints())
    , Split(split)
    , Sets{ &placement.First, &placement.GetSecond() }
  {
    for (int side = 0; side < 2; ++side)
    {
      this->IsTurned[side] = SkdSixVolumes(*this->Sets[side]) < 0.0;
      this->MakePointOf(segments, side);
      this->Places[side].assign(split[side].Triangles.size(), Place::Unknown);
    }
    for (int side = 0; side < 2; ++side)
    {
      this->ListEdges(side);
      this->PlaceOverlaps(side);
    }
    for (int side = 0; side < 2; ++side)
    {
      this->PlaceRegions(side);
    }
  }

  SkdBooleanResult Combine(SkdBooleanOperation operation) const
  {
    SkdBooleanResult result;
    for (int side = 0; side < 2; ++side)
    {
      for (std::size_t i = 0; i < this->Split[side].Triangles.size(); ++i)
      {
        const int turn = this->Decide(operation, side, this->Places[side][i]);
        Corners corners = this->Split[side].Triangles[i];
        for (std::uint32_t& corner : corners)
        {
          corner = this->IdOf(side, corner);
        }
        if (turn != 0)
        {
          if ((turn < 0) != this->IsTurned[side])
          {
            std::swap(corners[1], corners[2]);
          }
          result.Pieces.push_back({ corners, side, this->Split[side].Parents[i] });
        }
      }
    }
    this->NumberPoints(result);
    return result;
  }

private:
  /// The point that each corner of a side is in both surfaces, and the first number after those of
  /// points and of sides before.
  void MakePointOf(const SkdSplitSegments& segments, int side)
  {
    this->CornerOf[side] = &segments.GetSide(side).CornerOf;
    const auto n = static_cast<std::uint32_t>(this->Sets[side]->GetPoints().size());
    this->PointOf[side].assign(n, None);
    for (std::uint32_t point = 0; point < this->Points.GetNumberOfPoints(); ++point)
    {
      const std::uint32_t corner = (*this->CornerOf[side])[point];
      if (corner != None)
      {
        this->PointOf[side][corner] = this->Points.Find(point);
      }
    }
    this->Before[side] = this->Points.GetNumberOfPoints() +
      (side == 0 ? 0u : static_cast<std::uint32_t>(this->Sets[0]->GetPoints().size()));
  }

  /// A point of the contacts, or None.
  std::uint32_t PointAt(int side, std::uint32_t local) const
  {
    const auto n = static_cast<std::uint32_t>(this->PointOf[side].size());
    return local < n ? this->PointOf[side][local] : this->Split[side].Ids[local - n];
  }

  /// The same number for the same point of both sides.
  std::uint32_t IdOf(int side, std::uint32_t local) const
  {
    const std::uint32_t point = this->PointAt(side, local);
    return point != None ? point : this->Before[side] + local;
  }

  skd::Vector3 PositionAt(int side, std::uint32_t local) const
  {
    const auto n = static_cast<std::uint32_t>(this->PointOf[side].size());
    return local < n ? this->Sets[side]->GetPoints()[local]
                     : this->Split[side].Points[local - n].Position;
  }

  /// Pieces in what triangles of one plane have in common: a convex polygon, which no piece leaves.
  void PlaceOverlaps(int side)
  {
    const std::vector<std::uint32_t>& parents = this->Split[side].Parents;
    for (std::size_t pair = 0; pair < this->Pairs.size(); ++pair)
    {
      if (this->Pairs[pair].Contact.Count < 3)
      {
        continue;
      }
      const std::uint32_t triangle = side == 0 ? this->Pairs[pair].First : this->Pairs[pair].Second;
      const auto range = std::equal_range(parents.begin(), parents.end(), triangle);
      for (auto at = range.first; at != range.second; ++at)
      {
        const auto piece = static_cast<std::size_t>(at - parents.begin());
        if (this->IsInOverlap(side, this->Split[side].Triangles[piece], pair))
        {
          this->Places[side][piece] = this->AreAlike(pair) ? Place::Alike : Place::Opposite;
        }
      }
    }
  }

  int AxisOf(std::size_t pair) const { return this->Sets[0]->Get(this->Pairs[pair].First).Axis; }

  bool AreAlike(std::size_t pair) const
  {
    const int axis = this->AxisOf(pair);
    const auto sign = [&](int side, std::uint32_t triangle)
    {
      const auto x = this->Sets[side]->GetCornerPoints(triangle);
      const int seen = skd::Orient2D(x[0], x[1], x[2], axis);
      return this->IsTurned[side] ? -seen : seen;
    };
    return sign(0, this->Pairs[pair].First) == sign(1, this->Pairs[pair].Second);
  }

  bool IsInOverlap(int side, const Corners& piece, std::size_t pair) const
  {
    const int axis = this->AxisOf(pair);
    const int count = this->Pairs[pair].Contact.Count;
    bool isLeft = false;
    bool isRight = false;
    for (const std::uint32_t local : piece)
    {
      const std::uint32_t point = this->PointAt(side, local);
      if (point == None)
      {
        return false;
      }
      for (int i = 0; i < count; ++i)
      {
        const int sign = this->Points.Orient(this->Contacts.GetPoint(pair, i),
          this->Contacts.GetPoint(pair, (i + 1) % count), point, axis);
        isLeft = isLeft || sign > 0;
        isRight = isRight || sign < 0;
      }
    }
    return !(isLeft && isRight);
  }

  /// Other pieces: a region at a time, by the piece whose middle is farthest from its edges.
  void PlaceRegions(int side)
  {
    std::vector<std::size_t> pieces;
    std::vector<Corners> triangles;
    std::vector<SkdSplitEdge> borders = this->Split[side].Curves;
    for (std::size_t i = 0; i < this->Places[side].size(); ++i)
    {
      const Corners& corners = this->Split[side].Triangles[i];
      if (this->Places[side][i] == Place::Unknown)
      {
        pieces.push_back(i);
        triangles.push_back(corners);
        continue;
      }
      for (int edge = 0; edge < 3; ++edge)
      {
        borders.push_back(SkdMakeSplitEdge(corners[edge], corners[(edge + 1) % 3]));
      }
    }
    const std::vector<std::uint32_t> regions = SkdFindSplitRegions(triangles, std::move(borders));
    std::vector<Place> places = this->AskForRegions(side, triangles, regions);
    for (std::size_t i = pieces.size(); i-- > 0;) // the lowest that knows decides
    {
      for (int edge = 0; edge < 3; ++edge)
      {
        const Place place = this->PlaceAtEdge(side, pieces[i], edge);
        places[regions[i]] = place == Place::Unknown ? places[regions[i]] : place;
      }
    }
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
      this->Places[side][pieces[i]] = places[regions[i]];
    }
  }

  std::vector<Place> AskForRegions(int side, const std::vector<Corners>& triangles,
    const std::vector<std::uint32_t>& regions) const
  {
    struct Best
    {
      double Height = -1.0;
      skd::Vector3 Middle;
    };
    std::vector<Best> best;
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      best.resize(std::max<std::size_t>(best.size(), regions[i] + 1));
      const std::array<skd::Vector3, 3> x{ this->PositionAt(side, triangles[i][0]),
        this->PositionAt(side, triangles[i][1]), this->PositionAt(side, triangles[i][2]) };
      const double height = HeightOf(x);
      if (height > best[regions[i]].Height)
      {
        best[regions[i]] = { height, (1.0 / 3.0) * (x[0] + x[1] + x[2]) };
      }
    }
    const SkdWinding other(PolyDataOf(*this->Sets[1 - side]));
    std::vector<Place> places(best.size());
    vtkSMPTools::For(0, static_cast<vtkIdType>(best.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          places[i] = other.IsInside(best[i].Middle.X) ? Place::Inside : Place::Outside;
        }
      });
    return places;
  }

  /// An edge that a piece has, by points of the contacts.
  struct EdgeOf
  {
    SkdSplitEdge Edge;
    std::uint32_t Piece;
    bool operator<(const EdgeOf& other) const
    {
      return this->Edge != other.Edge ? this->Edge < other.Edge : this->Piece < other.Piece;
    }
  };

  void ListEdges(int side)
  {
    const std::vector<Corners>& triangles = this->Split[side].Triangles;
    for (std::uint32_t piece = 0; piece < triangles.size(); ++piece)
    {
      for (int i = 0; i < 3; ++i)
      {
        const std::uint32_t a = this->PointAt(side, triangles[piece][i]);
        const std::uint32_t b = this->PointAt(side, triangles[piece][(i + 1) % 3]);
        if (a != None && b != None && a != b)
        {
          this->Edges[side].push_back({ SkdMakeSplitEdge(a, b), piece });
        }
      }
    }
    std::sort(this->Edges[side].begin(), this->Edges[side].end());
  }

  /// On which side of the plane of a triangle a piece of another one is that meets it in an edge of
  /// the piece, from a to b: 1 in front, -1 behind, 0 in it. The exact side of a corner of the
  /// piece's triangle that is not in the plane, and of the line through a and b, decide.
  int SideOf(int side, std::uint32_t triangle, int other, std::uint32_t plane, std::uint32_t a,
    std::uint32_t b) const
  {
    const std::array<skd::Vector3, 3> x = this->Sets[side]->GetCornerPoints(triangle);
    const std::array<skd::Vector3, 3> p = this->Sets[other]->GetCornerPoints(plane);
    const int axis = this->Sets[side]->Get(triangle).Axis;
    const int seen = axis < 0 ? 0 : skd::Orient2D(x[0], x[1], x[2], axis);
    for (const skd::Vector3& corner : x)
    {
      const int above = seen == 0 ? 0 : skd::Orient3D(p[0], p[1], p[2], corner);
      if (above != 0)
      {
        const int left = skd::ExactArea(
          this->Points.GetExact(a), this->Points.GetExact(b), skd::ExactPoint(corner), axis)
                           .Sign();
        const int front = above * left * seen;
        return this->IsTurned[other] ? -front : front;
      }
    }
    return 0;
  }

  /// How a piece lies between the two faces of the other surface that meet at one of its edges;
  /// unknown if there are not two, or one without area.
  Place PlaceAtEdge(int side, std::size_t piece, int edge) const
  {
    const int other = 1 - side;
    const Corners& corners = this->Split[side].Triangles[piece];
    const std::uint32_t a = this->PointAt(side, corners[edge]);
    const std::uint32_t b = this->PointAt(side, corners[(edge + 1) % 3]);
    const std::vector<EdgeOf>& edges = this->Edges[other];
    const std::uint32_t parent = this->Split[side].Parents[piece];
    if (a == None || b == None || !this->Sets[side]->HasArea(parent))
    {
      return Place::Unknown;
    }
    const auto range =
      std::equal_range(edges.begin(), edges.end(), EdgeOf{ SkdMakeSplitEdge(a, b), 0 },
        [](const EdgeOf& l, const EdgeOf& r) { return l.Edge < r.Edge; });
    if (range.second - range.first != 2)
    {
      return Place::Unknown;
    }
    const std::uint32_t first = range.first->Piece;
    const std::uint32_t second = (range.first + 1)->Piece;
    const std::uint32_t planes[2] = { this->Split[other].Parents[first],
      this->Split[other].Parents[second] };
    if (!this->Sets[other]->HasArea(planes[0]) || !this->Sets[other]->HasArea(planes[1]))
    {
      return Place::Unknown;
    }
    const int toFirst = this->SideOf(side, parent, other, planes[0], a, b);
    const int toSecond = this->SideOf(side, parent, other, planes[1], a, b);
    const int turn = this->SideOfPiece(other, second, planes[0], a, b);
    if (toFirst == 0 && (turn == 0 || toSecond == 0))
    {
      return Place::Unknown;
    }
    const bool isBehindFirst = toFirst < 0;
    const bool isBehindSecond = toSecond < 0;
    const bool isInside =
      turn > 0 ? isBehindFirst || isBehindSecond : isBehindFirst && (turn == 0 || isBehindSecond);
    return isInside ? Place::Inside : Place::Outside;
  }

  /// On which side of the plane of a face of its own surface a piece is that has an edge there.
  int SideOfPiece(
    int side, std::uint32_t piece, std::uint32_t plane, std::uint32_t a, std::uint32_t b) const
  {
    const Corners& corners = this->Split[side].Triangles[piece];
    for (int i = 0; i < 3; ++i)
    {
      if (this->PointAt(side, corners[i]) == b && this->PointAt(side, corners[(i + 1) % 3]) == a)
      {
        std::swap(a, b); // its own direction
        break;
      }
    }
    return this->SideOf(side, this->Split[side].Parents[piece], side, plane, a, b);
  }

  /// 1: the piece bounds the result as it is, -1: turned over, 0: not at all.
  int Decide(SkdBooleanOperation operation, int side, Place place) const
  {
    const bool isAlike = place == Place::Alike;
    const bool isOpposite = place == Place::Opposite;
    if (side == 1 && (isAlike || isOpposite))
    {
      return 0; // there once, of the first
    }
    const bool isInside = place == Place::Inside;
    const auto ask = [&](bool own, bool other)
    { return side == 0 ? IsSolid(operation, own, other) : IsSolid(operation, other, own); };
    const bool front = ask(false, isInside || isOpposite);
    const bool back = ask(true, isInside || isAlike);
    return static_cast<int>(back) - static_cast<int>(front);
  }

  void NumberPoints(SkdBooleanResult& result) const
  {
    std::vector<std::uint32_t> numbers(this->Before[1] + this->Sets[1]->GetPoints().size(), None);
    for (SkdBooleanPiece& piece : result.Pieces)
    {
      for (std::uint32_t& corner : piece.Corners)
      {
        numbers[corner] = 0;
      }
    }
    for (int side = 0; side < 2; ++side)
    {
      const std::size_t n = this->PointOf[side].size() + this->Split[side].Ids.size();
      for (std::uint32_t local = 0; local < n; ++local)
      {
        const std::uint32_t id = this->IdOf(side, local);
        if (numbers[id] == 0)
        {
          result.Points.push_back({ this->PositionAt(side, local), side, local });
          numbers[id] = static_cast<std::uint32_t>(result.Points.size());
        }
      }
    }
    for (SkdBooleanPiece& piece : result.Pieces)
    {
      for (std::uint32_t& corner : piece.Corners)
      {
        corner = numbers[corner] - 1;
      }
    }
  }

  const std::vector<SkdTrianglePair>& Pairs;
  const SkdContactPoints& Contacts;
  const SkdSplitPoints& Points;
  const std::array<SkdSplitResult, 2>& Split;
  std::array<const SkdPlacedTriangles*, 2> Sets;
  std::array<const std::vector<std::uint32_t>*, 2> CornerOf;
  std::array<std::vector<std::uint32_t>, 2> PointOf; // of each corner
  std::array<std::uint32_t, 2> Before;
  std::array<bool, 2> IsTurned;
  std::array<std::vector<Place>, 2> Places; // of each piece
  std::array<std::vector<EdgeOf>, 2> Edges; // ascending
};
}

SkdBadEdges SkdFindBadEdges(const Corners* triangles, std::size_t count)
{
  struct Way
  {
    SkdSplitEdge Edge;
    int Sign;
  };
  std::vector<Way> ways;
  ways.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const std::uint32_t a = triangles[i][k];
      const std::uint32_t b = triangles[i][(k + 1) % 3];
      ways.push_back({ SkdMakeSplitEdge(a, b), a < b ? 1 : -1 });
    }
  }
  vtkSMPTools::Sort(
    ways.begin(), ways.end(), [](const Way& a, const Way& b) { return a.Edge < b.Edge; });
  SkdBadEdges bad;
  for (std::size_t i = 0; i < ways.size();)
  {
    const SkdSplitEdge edge = ways[i].Edge;
    int sum = 0;
    for (; i < ways.size() && ways[i].Edge == edge; ++i)
    {
      sum += ways[i].Sign;
    }
    if (sum != 0 && bad.Count++ == 0)
    {
      bad.First = edge;
    }
  }
  return bad;
}

double SkdSixVolumes(const SkdPlacedTriangles& set)
{
  const std::size_t n = set.GetSet().GetTriangles().size();
  double sum = 0.0;
  for (std::uint32_t triangle = 0; triangle < n; ++triangle)
  {
    const skd::Vector3& origin = set.GetPoints()[set.GetCorners(0)[0]];
    const auto x = set.GetCornerPoints(triangle);
    sum += Dot(x[0] - origin, Cross(x[1] - origin, x[2] - origin));
  }
  return sum;
}

SkdBooleanResult SkdCombine(const SkdPlacement& placement,
  const std::vector<SkdTrianglePair>& pairs, const SkdContactPoints& contacts,
  const SkdSplitSegments& segments, const std::array<SkdSplitResult, 2>& split,
  SkdBooleanOperation operation)
{
  return Combination(placement, pairs, contacts, segments, split).Combine(operation);
}
