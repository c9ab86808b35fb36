// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Read/SkdForEach.h"
#include "Solids/Surfaces/SkdSplitSegments.h"

#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace skdtree
{
namespace
{
/// A part of a segment between two points that follow each other, seen along an axis.
struct Piece
{
  std::uint32_t A;
  std::uint32_t B;
  std::uint32_t Segment;
  bool IsNew;
  double Min[2];
  double Max[2];
};

/// What a thread finds, and what it works in.
struct Found
{
  std::vector<SkdSplitEvent> Events;
  std::vector<Piece> Pieces;
  std::vector<std::uint32_t> Chain;
};

/// The intersections of the segments of one triangle.
class Triangle
{
public:
  Triangle(const SkdSplitSegments& segments, int axis, Found& found)
    : Segments(segments)
    , Points(segments.GetPoints())
    , Axis(axis)
    , Events(found.Events)
    , Pieces(found.Pieces)
    , Chain(found.Chain)
  {
    this->Pieces.clear();
  }

  void Add(std::uint32_t segment)
  {
    std::vector<std::uint32_t>& chain = this->Chain;
    this->Segments.GetChain(segment, chain);
    if (chain.size() == 1)
    {
      this->AddPiece(chain[0], chain[0], segment);
    }
    for (std::size_t i = 1; i < chain.size(); ++i)
    {
      this->AddPiece(chain[i - 1], chain[i], segment);
    }
  }

  void Find()
  {
    std::sort(this->Pieces.begin(), this->Pieces.end(),
      [](const Piece& a, const Piece& b) { return a.Min[0] < b.Min[0]; });
    for (auto piece = this->Pieces.begin(); piece != this->Pieces.end(); ++piece)
    {
      for (auto other = piece + 1; other != this->Pieces.end() && other->Min[0] <= piece->Max[0];
           ++other)
      {
        if (other->Min[1] <= piece->Max[1] && piece->Min[1] <= other->Max[1] &&
          other->Segment != piece->Segment && (piece->IsNew || other->IsNew))
        {
          this->Meet(*piece, *other);
        }
      }
    }
  }

private:
  void AddPiece(std::uint32_t a, std::uint32_t b, std::uint32_t segment)
  {
    Piece piece{ a, b, segment, this->Segments.GetSegment(segment).IsNew, {}, {} };
    const double margin = 2.0 * this->Points.GetError();
    for (int i = 0; i < 2; ++i)
    {
      const int axis = (this->Axis + 1 + i) % 3;
      const double atA = this->Points.GetPosition(a)[axis];
      const double atB = this->Points.GetPosition(b)[axis];
      piece.Min[i] = std::min(atA, atB) - margin;
      piece.Max[i] = std::max(atA, atB) + margin;
    }
    this->Pieces.push_back(piece);
  }

  void Meet(const Piece& x, const Piece& y)
  {
    if (this->IsOnOneSide(x, y) || this->IsOnOneSide(y, x) || this->GoApart(x, y))
    {
      return; // exact signs would tell the same, slowly where pieces are nearly on a line
    }
    const int a = this->SideOf(x.A, y);
    const int b = x.A == x.B ? a : this->SideOf(x.B, y);
    const int c = this->SideOf(y.A, x);
    const int d = y.A == y.B ? c : this->SideOf(y.B, x);
    if (a * b < 0 && c * d < 0)
    {
      this->Events.push_back({ SkdSplitEvent::Cross, std::min(x.Segment, y.Segment),
        std::max(x.Segment, y.Segment), this->Axis });
    }
  }

  /// Whether both ends of a piece surely are on the same side of another.
  bool IsOnOneSide(const Piece& piece, const Piece& other) const
  {
    const auto sideOf = [&](std::uint32_t point)
    {
      return skd::FilteredOrient2D(this->Points.GetPosition(other.A),
        this->Points.GetPosition(other.B), this->Points.GetPosition(point), this->Axis,
        this->Points.GetError());
    };
    const int side = sideOf(piece.A);
    return side != 0 && side == sideOf(piece.B);
  }

  /// Whether two pieces that have an end in common surely are on different sides of it along an
  /// axis, so that they have nothing else in common.
  bool GoApart(const Piece& x, const Piece& y) const
  {
    const bool isAtA = x.A == y.A || x.A == y.B;
    const std::uint32_t shared = isAtA ? x.A : x.B;
    if (!isAtA && x.B != y.A && x.B != y.B)
    {
      return false;
    }
    const skd::Vector3& at = this->Points.GetPosition(shared);
    const skd::Vector3 toX = this->Points.GetPosition(isAtA ? x.B : x.A) - at;
    const skd::Vector3 toY = this->Points.GetPosition(shared == y.A ? y.B : y.A) - at;
    const double doubt = 4.0 * this->Points.GetError();
    const auto goApart = [&](int axis)
    {
      return std::min(std::abs(toX[axis]), std::abs(toY[axis])) > doubt &&
        (toX[axis] > 0.0) != (toY[axis] > 0.0);
    };
    return goApart(0) || goApart(1) || goApart(2);
  }

  /// The side of a piece on which a point lies. 0: on its line, possibly on the piece, which is
  /// recorded.
  int SideOf(std::uint32_t point, const Piece& piece)
  {
    if (point == piece.A || point == piece.B)
    {
      return 0;
    }
    const bool isLone = piece.A == piece.B;
    const int side = isLone ? 0 : this->Points.Orient(piece.A, piece.B, point, this->Axis);
    if (side == 0)
    {
      this->PutDown(point, piece, isLone);
    }
    return side;
  }

  void PutDown(std::uint32_t point, const Piece& piece, bool isLone)
  {
    const int axis = this->Points.FindAxis(piece.A, isLone ? point : piece.B);
    if (isLone || axis < 0)
    {
      this->PutDownSame(axis < 0, point, piece.A);
      return;
    }
    const int sign = this->Points.Compare(piece.B, piece.A, axis);
    const int fromA = sign * this->Points.Compare(point, piece.A, axis);
    const int fromB = sign * this->Points.Compare(piece.B, point, axis);
    this->PutDownSame(fromA == 0, point, piece.A);
    this->PutDownSame(fromB == 0, point, piece.B);
    if (fromA > 0 && fromB > 0)
    {
      this->Events.push_back({ SkdSplitEvent::On, piece.Segment, point, 0 });
    }
  }

  void PutDownSame(bool isSame, std::uint32_t a, std::uint32_t b)
  {
    if (isSame)
    {
      this->Events.push_back({ SkdSplitEvent::Same, std::min(a, b), std::max(a, b), 0 });
    }
  }

  const SkdSplitSegments& Segments;
  const SkdSplitPoints& Points;
  const int Axis;
  std::vector<SkdSplitEvent>& Events;
  std::vector<Piece>& Pieces;
  std::vector<std::uint32_t>& Chain;
};

using Elements = std::vector<SkdSplitElement>;

/// Where the elements of each triangle begin, and the end.
std::vector<std::size_t> FindStarts(const Elements& elements)
{
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    if (i == 0 || elements[i].Triangle != elements[i - 1].Triangle)
    {
      starts.push_back(i);
    }
  }
  starts.push_back(elements.size());
  return starts;
}
}

std::vector<SkdSplitEvent> SkdSplitSegments::FindEvents(int number) const
{
  const Side& side = this->GetSide(number);
  const std::vector<std::size_t> starts = FindStarts(side.Elements);
  const auto isNew = [&](const SkdSplitElement& element)
  { return this->GetSegment(element.Segment).IsNew; };
  const auto findIn = [&](std::size_t begin, std::size_t end, Found& found)
  {
    const auto first = side.Elements.begin();
    if (end - begin > 1 && std::any_of(first + begin, first + end, isNew))
    {
      const std::uint32_t at = side.Elements[begin].Triangle;
      Triangle triangle(*this, side.Set->Get(at).Axis, found);
      std::for_each(first + begin, first + end,
        [&](const SkdSplitElement& element) { triangle.Add(element.Segment); });
      triangle.Find();
    }
  };
  vtkSMPThreadLocal<Found> foundBy;
  std::atomic<std::size_t> count{ 0 };
  SkdForEach(
    static_cast<vtkIdType>(starts.size()) - 1,
    [&](vtkIdType i)
    {
      Found& found = foundBy.Local();
      const std::size_t before = found.Events.size();
      if (count <= this->MostEvents)
      {
        findIn(starts[i], starts[i + 1], found);
        count += found.Events.size() - before;
      }
    },
    64);
  std::vector<SkdSplitEvent> all;
  for (const Found& some : foundBy)
  {
    all.insert(all.end(), some.Events.begin(), some.Events.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}
}
