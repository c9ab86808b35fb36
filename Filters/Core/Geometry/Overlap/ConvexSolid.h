// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A convex polyhedron cut by half spaces, with no allocation. It is a graph: each corner has three
/// neighbours; a cut only uses the sides of its corners, so that rounding never opens it.
/// After Powell, Abel, J. Comput. Phys. 297 (2015).
#ifndef skd_Geometry_Overlap_ConvexSolid_h
#define skd_Geometry_Overlap_ConvexSolid_h

#include "ConvexClip.h"
#include "Moments.h"
#include "SolidTopology.h"

namespace skd
{

/// Where Normal . x + Offset is positive. Points within the tolerance of the border are on it.
struct HalfSpace
{
  Vector3 Normal;
  double Offset;
  double Tolerance;

  double operator()(const Vector3& x) const
  {
    const double side = Dot(this->Normal, x) + this->Offset;
    return std::abs(side) <= this->Tolerance ? 0.0 : side;
  }
};

/// Within the side of a face, whose corners are counter-clockwise seen from without. The same for
/// both cells that have it, but for the sign. `extent` bounds the coordinates.
template <class CornerAt>
HalfSpace InsideOf(const CornerAt& cornerAt, int size, double extent)
{
  int least = 0;
  for (int i = 1; i < size; ++i)
  {
    least = cornerAt(i) < cornerAt(least) ? i : least;
  }
  const Vector3& first = cornerAt(least);
  Vector3 normal{ { 0.0, 0.0, 0.0 } };
  if (size == 4)
  {
    normal = Cross(cornerAt(3) - cornerAt(1), cornerAt(2) - cornerAt(0));
  }
  for (int i = 2; i < size && size != 4; ++i)
  {
    normal = normal +
      Cross(cornerAt((least + i) % size) - first, cornerAt((least + i - 1) % size) - first);
  }
  return { normal, -Dot(normal, first),
    ClipTolerance * extent * (std::abs(normal[0]) + std::abs(normal[1]) + std::abs(normal[2])) };
}

class ConvexSolid
{
public:
  static constexpr int Most = 128;

  /// The topology is simple.
  ConvexSolid(const SolidTopology& topology, const Vector3* corners)
    : Size(topology.Size)
  {
    std::copy_n(corners, this->Size, this->Corners.begin());
    std::copy_n(topology.Neighbours.begin(), this->Size, this->Neighbours.begin());
  }

  int GetSize() const { return this->Size; }
  const Vector3& GetCorner(int i) const { return this->Corners[i]; }

  /// Keeps what is within; corners stay as they are. Only contact is nothing, and so is what has
  /// more corners than there is room for: convex ones within SolidTopology's limits never have.
  ClipResult Clip(const HalfSpace& halfSpace)
  {
    std::array<double, Most> sides;
    bool isAnyIn = false;
    bool isAnyOut = false;
    for (int i = 0; i < this->Size; ++i)
    {
      sides[i] = halfSpace(this->Corners[i]);
      isAnyIn |= sides[i] > 0.0;
      isAnyOut |= sides[i] < 0.0;
    }
    if (!isAnyIn || !isAnyOut)
    {
      return isAnyIn ? ClipResult::All : ClipResult::Nothing;
    }
    const int old = this->Size;
    if (!this->AddCrossings(sides) || !this->LinkCrossings(old))
    {
      this->Size = 0;
      return ClipResult::Nothing;
    }
    this->Compact(sides, old);
    return ClipResult::Some;
  }

  /// Volume and first moment about the origin.
  skd::Moments Moments() const
  {
    double sixfold = 0.0;
    Vector3 sum{ { 0.0, 0.0, 0.0 } };
    const Vector3& apex = this->Corners[0];
    this->ForEachFace(
      [&](const std::uint8_t* face, int size)
      {
        const Vector3 first = this->Corners[face[0]] - apex;
        Vector3 last = this->Corners[face[1]] - apex;
        for (int i = 2; i < size; ++i)
        {
          const Vector3 next = this->Corners[face[i]] - apex;
          const double volume = Dot(first, Cross(last, next));
          sixfold += volume;
          sum = sum + volume * (first + (last + next));
          last = next;
        }
      });
    const double volume = sixfold / 6.0;
    return { volume, (1.0 / 24.0) * sum + volume * apex };
  }

  /// Calls visit(numbers of corners, how many) for each face, counter-clockwise seen from without.
  template <class Visit>
  void ForEachFace(const Visit& visit) const
  {
    std::array<std::uint8_t, Most> visited; // a bit for each edge that leaves
    std::fill_n(visited.begin(), this->Size, std::uint8_t(0));
    std::array<std::uint8_t, 3 * Most> face;
    for (int start = 0; start < this->Size; ++start)
    {
      for (int k = 0; k < 3; ++k)
      {
        int size = 0;
        int at = start;
        int edge = k;
        while ((visited[at] >> edge & 1) == 0)
        {
          visited[at] = static_cast<std::uint8_t>(visited[at] | 1 << edge);
          face[size++] = static_cast<std::uint8_t>(at);
          const int next = this->Neighbours[at][edge];
          edge = this->After(next, at);
          at = next;
        }
        if (size > 2)
        {
          visit(face.data(), size);
        }
      }
    }
  }

private:
  static constexpr std::uint8_t None = 255;

  /// Which neighbour of `at` comes after `from` around the face.
  int After(int at, int from) const
  {
    const auto& around = this->Neighbours[at];
    return around[0] == from ? 1 : (around[1] == from ? 2 : 0);
  }

  /// Puts a corner on each edge from a corner that is kept to one that is not. Its neighbours: the
  /// kept corner, and those before and after it around the polygon in which the plane cuts the
  /// solid, which LinkCrossings finds.
  bool AddCrossings(const std::array<double, Most>& sides)
  {
    const int old = this->Size;
    for (int i = 0; i < old; ++i)
    {
      for (int k = 0; k < 3 && sides[i] >= 0.0; ++k)
      {
        const int other = this->Neighbours[i][k];
        if (sides[other] >= 0.0)
        {
          continue;
        }
        if (this->Size == Most)
        {
          return false;
        }
        const auto added = static_cast<std::uint8_t>(this->Size++);
        this->Corners[added] = CrossingOf(i, sides[i], other, sides[other]);
        this->Neighbours[added] = { static_cast<std::uint8_t>(i), None, None };
        this->Neighbours[i][k] = added;
      }
    }
    return true;
  }

  /// From the nearer end: the same from both sides.
  Vector3 CrossingOf(int p, double atP, int q, double atQ) const
  {
    const Vector3& a = this->Corners[p];
    const Vector3& b = this->Corners[q];
    return std::abs(atP) <= std::abs(atQ) ? a + (atP / (atP - atQ)) * (b - a)
                                          : b + (atQ / (atQ - atP)) * (a - b);
  }

  /// A convex face that is cut has two new corners, which become neighbours across the cut:
  ///
  ///     start ------- kept corners ------- end        numbers below `old` are kept corners,
  ///        \                               /           so the first one from `old` on is the end
  ///         '- - - -  new edge  - - - - -'
  ///
  /// Walking from each new corner into the face on its left and along that face's kept corners
  /// finds its other end. It passes no corner twice: a walk of more steps than there are corners,
  /// or a corner without both neighbours, means that rounding has made a graph that is none of a
  /// polyhedron. Then this is false.
  bool LinkCrossings(int old)
  {
    constexpr int toInside = 0;
    constexpr int before = 1;
    constexpr int after = 2;
    for (int start = old; start < this->Size; ++start)
    {
      int from = start;
      int at = this->Neighbours[start][toInside];
      for (int steps = 0; at < old; ++steps)
      {
        const int next = this->Neighbours[at][this->After(at, from)];
        from = at;
        at = next;
        if (steps == Most)
        {
          return false;
        }
      }
      this->Neighbours[start][after] = static_cast<std::uint8_t>(at);
      this->Neighbours[at][before] = static_cast<std::uint8_t>(start);
    }
    return std::all_of(this->Neighbours.begin() + old, this->Neighbours.begin() + this->Size,
      [](const auto& around) { return around[before] != None && around[after] != None; });
  }

  void Compact(const std::array<double, Most>& sides, int old)
  {
    std::array<std::uint8_t, Most> indexOf;
    int halfSpace = 0;
    for (int i = 0; i < this->Size; ++i)
    {
      if (i >= old || sides[i] >= 0.0)
      {
        indexOf[i] = static_cast<std::uint8_t>(halfSpace);
        this->Corners[halfSpace] = this->Corners[i];
        this->Neighbours[halfSpace] = this->Neighbours[i];
        ++halfSpace;
      }
    }
    this->Size = halfSpace;
    for (int i = 0; i < halfSpace; ++i)
    {
      for (std::uint8_t& neighbour : this->Neighbours[i])
      {
        neighbour = indexOf[neighbour];
      }
    }
  }

  int Size;
  std::array<Vector3, Most> Corners;
  std::array<std::array<std::uint8_t, 3>, Most> Neighbours;
};

}

#endif
