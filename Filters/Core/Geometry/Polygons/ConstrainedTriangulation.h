// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Polygons_ConstrainedTriangulation_h
#define skd_Geometry_Polygons_ConstrainedTriangulation_h

#include "FlipMesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace skd
{

/// What a constrained triangulation is made in, for one after the other.
struct TriangulationMemory
{
  FlipMesh Mesh;
  std::vector<FlipMesh::Side> Open;
};

/// A triangle cut into triangles that have given points as corners and given segments as edges.
///
/// Points are numbers to it: 0, 1 and 2 are the triangle's own corners, which turn left. All it
/// knows of their positions comes from
///   int orient(a, b, c): 1 when a, b, c turn left, -1 right, 0 on one line; signs must be exact;
///   bool isBetter(a, b, c, d): whether the edge from c to d is better than that from a to b (c on
///     the left of it, d on the right). Only as to shape: it may be rounded.
/// So coordinates may be of any kind of number. First points on the border are added, then those
/// inside, then edges, none of which may cross another but at a point.
///
/// By flips of edges (S. W. Sloan, Computers & Structures 47 (1993) 441-450). About O(n) for points
/// that are added near the ones before, and for an edge that crosses k others about O(k), at
/// most O(k^2).
template <class Orient, class IsBetter>
class ConstrainedTriangulation
{
public:
  ConstrainedTriangulation(
    int numberOfPoints, Orient orient, IsBetter isBetter, TriangulationMemory memory = {})
    : Orientation(std::move(orient))
    , Better(std::move(isBetter))
    , Mesh(std::move(memory.Mesh))
    , Open(std::move(memory.Open))
  {
    this->Mesh.Begin(numberOfPoints);
  }

  /// For the next one. Only the triangulation's destructor may be called then.
  TriangulationMemory TakeMemory() { return { std::move(this->Mesh), std::move(this->Open) }; }

  /// The triangles: all turn left.
  const std::vector<FlipMesh::Triangle>& GetTriangles() const { return this->Mesh.GetAll(); }

  /// The triangles, and what is beside each.
  const FlipMesh& GetMesh() const { return this->Mesh; }

  /// Adds a point on the border, between the neighbouring points `from` and `to`.
  void AddOnBorder(int point, int from, int to)
  {
    this->PutOn(point, this->Mesh.FindSide(from, to));
  }

  /// Adds a point inside. Returns it, or the one that is at that position already.
  int Add(int point)
  {
    const int at = this->Locate(point);
    int zeros[3];
    int count = 0;
    for (int i = 0; i < 3; ++i)
    {
      if (this->OrientSide(at, i, point) == 0)
      {
        zeros[count++] = i;
      }
    }
    if (count > 1) // the corner that two sides share
    {
      return this->Mesh.GetAll()[at].Corners[3 - zeros[0] - zeros[1]];
    }
    if (count == 1)
    {
      this->PutOn(point, { at, zeros[0] });
    }
    else
    {
      this->Last = at;
      this->Improve(this->Mesh.SplitInside(point, at));
    }
    return point;
  }

  /// Makes the segment between two points an edge, or edges when there are points on it.
  void Constrain(int a, int b)
  {
    while (a != b)
    {
      a = this->ConstrainFirst(a, b);
    }
  }

private:
  using Side = FlipMesh::Side;

  void PutOn(int point, const Side& side)
  {
    this->Last = side.At;
    this->Improve(this->Mesh.SplitSide(point, side));
  }

  int OrientSide(int at, int i, int point) const
  {
    return this->Orientation(this->Mesh.From({ at, i }), this->Mesh.To({ at, i }), point);
  }

  /// The triangle that a point lies in: by a walk, or, should that go in circles, by a look at all.
  int Locate(int point)
  {
    int at = this->Last;
    for (std::size_t step = 0; step < 2 * this->Mesh.GetAll().size() + 8; ++step)
    {
      int next = at;
      for (int k = 0; k < 3 && next == at; ++k)
      {
        const int i = static_cast<int>((step + static_cast<std::size_t>(k)) % 3);
        const int across = this->Mesh.GetAll()[at].Neighbours[i];
        next = across >= 0 && this->OrientSide(at, i, point) < 0 ? across : at;
      }
      if (next == at)
      {
        return at;
      }
      at = next;
    }
    for (at = 0; at < static_cast<int>(this->Mesh.GetAll().size()); ++at)
    {
      if (this->OrientSide(at, 0, point) >= 0 && this->OrientSide(at, 1, point) >= 0 &&
        this->OrientSide(at, 2, point) >= 0)
      {
        return at;
      }
    }
    return this->Last;
  }

  /// Whether the two triangles of a side make a quadrilateral that its other diagonal lies in.
  bool IsConvex(const Side& side, const Side& other) const
  {
    const int apex = this->Mesh.Apex(side);
    const int across = this->Mesh.Apex(other);
    return this->Orientation(apex, this->Mesh.From(side), across) > 0 &&
      this->Orientation(across, this->Mesh.To(side), apex) > 0;
  }

  void Improve(const FlipMesh::Outer& outer)
  {
    this->Open.assign(outer.begin(), outer.end());
    this->ImproveOpen();
  }

  /// Flips open sides, and those around them, as long as that makes them better.
  void ImproveOpen()
  {
    std::size_t left = 64 + 16 * this->Mesh.GetAll().size(); // should rounding go in circles
    while (!this->Open.empty() && left > 0)
    {
      const Side side = this->Open.back();
      this->Open.pop_back();
      const Side other = this->Mesh.Across(side);
      if (other.At < 0 || this->Mesh.GetAll()[side.At].IsFixed[side.Index] ||
        !this->Better(this->Mesh.From(side), this->Mesh.To(side), this->Mesh.Apex(side),
          this->Mesh.Apex(other)) ||
        !this->IsConvex(side, other))
      {
        continue;
      }
      this->Mesh.Flip(side, other);
      --left;
      for (const int at : { side.At, other.At })
      {
        this->Open.push_back({ at, 0 });
        this->Open.push_back({ at, 2 });
      }
    }
  }

  /// Where a segment leaves its first point: along a side, up to `Ending`, or across one (-1).
  struct Start
  {
    Side First;
    int Ending;
  };

  Start FindStart(int a, int b) const
  {
    Start start{ { -1, 0 }, -1 };
    this->Mesh.VisitAround(a,
      [&](int at, int i)
      {
        const int right = this->Mesh.To({ at, FlipMesh::Previous(i) });
        const int left = this->Mesh.From({ at, FlipMesh::Next(i) });
        const int ofRight = right == b ? 0 : this->Orientation(a, b, right);
        const int ofLeft = left == b ? 0 : this->Orientation(a, b, left);
        if (right == b || (ofRight == 0 && ofLeft > 0))
        {
          start = { { at, FlipMesh::Previous(i) }, right };
        }
        else if (left == b || (ofLeft == 0 && ofRight < 0))
        {
          start = { { at, FlipMesh::Next(i) }, left };
        }
        else if (ofRight < 0 && ofLeft > 0)
        {
          start = { { at, i }, -1 };
        }
        return start.First.At >= 0;
      });
    return start;
  }

  /// Makes the segment's part from a to the first point on it an edge. Returns that point.
  int ConstrainFirst(int a, int b)
  {
    const Start start = this->FindStart(a, b);
    if (start.First.At < 0)
    {
      return b; // not a segment within
    }
    int ending = start.Ending;
    if (ending < 0)
    {
      std::vector<Edge> crossed = this->FindCrossed(start.First, a, b, ending); // sets the ending
      this->Uncross(std::move(crossed), a, ending);
    }
    this->Mesh.Fix(this->Mesh.FindEitherSide(a, ending));
    return ending;
  }

  using Edge = std::pair<int, int>; // from the right of a segment to the left

  /// The edges that the segment crosses from its first side up to the first point on it.
  std::vector<Edge> FindCrossed(Side side, int a, int b, int& ending) const
  {
    std::vector<Edge> crossed;
    while (ending < 0)
    {
      crossed.emplace_back(this->Mesh.From(side), this->Mesh.To(side));
      const Side other = this->Mesh.Across(side);
      const int apex = this->Mesh.Apex(other);
      const int orientation = apex == b ? 0 : this->Orientation(a, b, apex);
      ending = orientation == 0 ? apex : -1;
      side = { other.At,
        orientation > 0 ? FlipMesh::Next(other.Index) : FlipMesh::Previous(other.Index) };
    }
    return crossed;
  }

  /// Flips edges until none crosses the segment. They are gone through in their order along it,
  /// again and again; when one no longer crosses, the one before may be ready for it.
  void Uncross(std::vector<Edge> crossed, int a, int b)
  {
    std::vector<Edge> made;
    std::vector<Edge> passed; // those that were looked at, the last one at the end
    std::reverse(crossed.begin(), crossed.end()); // the next one at the end
    const auto orientation = [&](int point)
    { return point == a || point == b ? 0 : this->Orientation(a, b, point); };
    while (!crossed.empty())
    {
      const Edge edge = crossed.back();
      crossed.pop_back();
      const Side side = this->Mesh.FindSide(edge.first, edge.second);
      const Side other = this->Mesh.Across(side);
      if (this->IsConvex(side, other))
      {
        const int p = this->Mesh.Apex(side);
        const int q = this->Mesh.Apex(other);
        this->Mesh.Flip(side, other);
        const int orientationP = orientation(p);
        if (orientationP * orientation(q) < 0)
        {
          passed.emplace_back(orientationP < 0 ? p : q, orientationP < 0 ? q : p);
        }
        else
        {
          made.emplace_back(p, q);
          MoveLast(passed, crossed);
        }
      }
      else
      {
        passed.push_back(edge);
      }
      if (crossed.empty())
      {
        crossed.swap(passed);
        std::reverse(crossed.begin(), crossed.end());
      }
    }
    this->Mesh.Fix(this->Mesh.FindEitherSide(a, b));
    this->Open.clear();
    for (const Edge& edge : made)
    {
      this->Open.push_back(this->Mesh.FindEitherSide(edge.first, edge.second));
    }
    this->ImproveOpen();
  }

  static void MoveLast(std::vector<Edge>& from, std::vector<Edge>& to)
  {
    if (!from.empty())
    {
      to.push_back(from.back());
      from.pop_back();
    }
  }

  Orient Orientation;
  IsBetter Better;
  FlipMesh Mesh;
  std::vector<Side> Open; // sides that may become better
  int Last = 0;
};

}

#endif
