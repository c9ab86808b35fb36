// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Polygons_FlipMesh_h
#define skd_Geometry_Polygons_FlipMesh_h

#include <array>
#include <cstddef>
#include <vector>

namespace skd
{

/// Triangles in the plane that know their neighbours, cut and flipped: how they hang together, not
/// where they are. All turn left. Points are numbers; 0, 1, 2 make the first triangle.
class FlipMesh
{
public:
  /// Side i is the one opposite to corner i.
  struct Triangle
  {
    std::array<int, 3> Corners;
    std::array<int, 3> Neighbours; // across each side, -1: none
    std::array<bool, 3> IsFixed;   // sides that must stay
  };
  struct Side
  {
    int At;
    int Index;
  };

  /// The sides around a point that was put in, two to four.
  struct Outer
  {
    std::array<Side, 4> Sides;
    int Count;

    const Side* begin() const { return this->Sides.data(); }
    const Side* end() const { return this->Sides.data() + this->Count; }
  };

  FlipMesh() = default;

  /// Begins again, in the memory that there is.
  void Begin(int numberOfPoints)
  {
    const auto n = static_cast<std::size_t>(numberOfPoints);
    this->TriangleAt.assign(n, -1);
    this->Triangles.clear();
    this->Triangles.reserve(2 * n);
    this->Triangles.push_back({ { 0, 1, 2 }, { -1, -1, -1 }, { false, false, false } });
    this->Own(0);
  }

  const std::vector<Triangle>& GetAll() const { return this->Triangles; }

  static int Next(int i) { return i == 2 ? 0 : i + 1; }
  static int Previous(int i) { return i == 0 ? 2 : i - 1; }

  ///@{
  /// The ends of a side, and the corner that it is opposite to.
  int From(const Side& side) const { return this->Triangles[side.At].Corners[Next(side.Index)]; }
  int To(const Side& side) const { return this->Triangles[side.At].Corners[Previous(side.Index)]; }
  int Apex(const Side& side) const { return this->Triangles[side.At].Corners[side.Index]; }
  ///@}

  /// Which corner of a triangle a point is.
  int IndexOf(int at, int corner) const
  {
    const auto& corners = this->Triangles[at].Corners;
    return corners[0] == corner ? 0 : (corners[1] == corner ? 1 : 2);
  }

  /// The same side as its other triangle has it; At is -1 on the border.
  Side Across(const Side& side) const
  {
    const int other = this->Triangles[side.At].Neighbours[side.Index];
    return other < 0 ? Side{ -1, 0 } : Side{ other, Next(this->IndexOf(other, this->From(side))) };
  }

  /// Calls visit(triangle, index of the point in it) around a point until it returns true.
  template <class Visit>
  bool VisitAround(int point, Visit visit) const
  {
    const int start = this->TriangleAt[point];
    int at = start;
    do
    {
      const int i = this->IndexOf(at, point);
      if (visit(at, i))
      {
        return true;
      }
      at = this->Triangles[at].Neighbours[Next(i)];
    } while (at >= 0 && at != start);
    const int first = this->IndexOf(start, point);
    at = at < 0 ? this->Triangles[start].Neighbours[Previous(first)] : -1;
    while (at >= 0) // the other way from the start
    {
      const int i = this->IndexOf(at, point);
      if (visit(at, i))
      {
        return true;
      }
      at = this->Triangles[at].Neighbours[Previous(i)];
    }
    return false;
  }

  /// The side that goes from a point to another; At is -1 of none.
  Side FindSide(int from, int to) const
  {
    Side found{ -1, 0 };
    this->VisitAround(from,
      [&](int at, int i)
      {
        if (this->Triangles[at].Corners[Next(i)] == to)
        {
          found = { at, Previous(i) };
        }
        return found.At >= 0;
      });
    return found;
  }

  /// The side between two points, one way or the other.
  Side FindEitherSide(int a, int b) const
  {
    const Side side = this->FindSide(a, b);
    return side.At >= 0 ? side : this->FindSide(b, a);
  }

  /// Puts a point into a triangle. Returns the sides around.
  Outer SplitInside(int point, int at)
  {
    const Triangle old = this->Triangles[at];
    const int n = static_cast<int>(this->Triangles.size());
    const int parts[3] = { at, n, n + 1 };
    this->Triangles.resize(this->Triangles.size() + 2);
    for (int i = 0; i < 3; ++i) // part i keeps side i, with the point as its corner 0
    {
      this->Triangles[parts[i]] = { { point, old.Corners[Next(i)], old.Corners[Previous(i)] },
        { old.Neighbours[i], parts[Next(i)], parts[Previous(i)] },
        { old.IsFixed[i], false, false } };
    }
    for (const int part : parts)
    {
      this->LinkBack({ part, 0 });
      this->Own(part);
    }
    return { { { { at, 0 }, { n, 0 }, { n + 1, 0 } } }, 3 };
  }

  /// Puts a point on a side: cuts its triangles in two each. Returns the sides around.
  Outer SplitSide(int point, const Side& side)
  {
    const Side other = this->Across(side);
    const int n = static_cast<int>(this->Triangles.size());
    const int second = n + 1;
    Outer outer{ {}, 0 };
    this->HalveSide(point, side, n, outer);
    if (other.At >= 0)
    {
      this->HalveSide(point, other, second, outer);
      this->LinkBoth({ side.At, 1 }, { second, 2 });
      this->LinkBoth({ n, 2 }, { other.At, 1 });
    }
    return outer;
  }

  /// Takes the other diagonal: the side's triangle keeps the side's first end.
  void Flip(const Side& side, const Side& other)
  {
    const Triangle a = this->Triangles[side.At];
    const Triangle b = this->Triangles[other.At];
    const int i = side.Index;
    const int k = other.Index;
    this->Triangles[side.At] = { { a.Corners[i], a.Corners[Next(i)], b.Corners[k] },
      { b.Neighbours[Next(k)], other.At, a.Neighbours[Previous(i)] },
      { b.IsFixed[Next(k)], false, a.IsFixed[Previous(i)] } };
    this->Triangles[other.At] = { { b.Corners[k], b.Corners[Next(k)], a.Corners[i] },
      { a.Neighbours[Next(i)], side.At, b.Neighbours[Previous(k)] },
      { a.IsFixed[Next(i)], false, b.IsFixed[Previous(k)] } };
    for (const int at : { side.At, other.At })
    {
      this->LinkBack({ at, 0 });
      this->Own(at);
    }
  }

  /// Makes a side one that must stay.
  void Fix(const Side& side)
  {
    this->Triangles[side.At].IsFixed[side.Index] = true;
    const Side other = this->Across(side);
    if (other.At >= 0)
    {
      this->Triangles[other.At].IsFixed[other.Index] = true;
    }
  }

private:
  void Own(int at)
  {
    for (const int corner : this->Triangles[at].Corners)
    {
      this->TriangleAt[corner] = at;
    }
  }

  void Link(const Side& side, int neighbour)
  {
    this->Triangles[side.At].Neighbours[side.Index] = neighbour;
  }

  /// Tells what is across a side that its triangle is another now.
  void LinkBack(const Side& side)
  {
    const Side other = this->Across(side);
    if (other.At >= 0)
    {
      this->Link(other, side.At);
    }
  }

  /// The halves as point, apex, end: side 1 or 2 lies on the side that is cut.
  void HalveSide(int point, const Side& side, int added, Outer& outer)
  {
    const Triangle old = this->Triangles[side.At];
    const int i = side.Index;
    const int apex = old.Corners[i];
    const bool isFixed = old.IsFixed[i];
    this->Triangles[side.At] = { { point, apex, old.Corners[Next(i)] },
      { old.Neighbours[Previous(i)], -1, added }, { old.IsFixed[Previous(i)], isFixed, false } };
    this->Triangles.push_back({ { point, old.Corners[Previous(i)], apex },
      { old.Neighbours[Next(i)], side.At, -1 }, { old.IsFixed[Next(i)], false, isFixed } });
    for (const int part : { side.At, added })
    {
      this->LinkBack({ part, 0 });
      this->Own(part);
      outer.Sides[static_cast<std::size_t>(outer.Count++)] = { part, 0 };
    }
  }

  void LinkBoth(const Side& a, const Side& b)
  {
    this->Link(a, b.At);
    this->Link(b, a.At);
  }

  std::vector<Triangle> Triangles;
  std::vector<int> TriangleAt; // of each point, one that has it
};

}

#endif
