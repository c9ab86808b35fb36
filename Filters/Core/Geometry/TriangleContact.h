// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_TriangleContact_h
#define skd_Geometry_TriangleContact_h

#include "Orient3D.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace skd
{

/// A part of a triangle: corner 0 to 2, edge 3 + i from corner i to the next, or its inside.
using TrianglePart = std::int8_t;
constexpr TrianglePart TriangleInside = 6;

inline bool IsCorner(TrianglePart part)
{
  return part < 3;
}
inline bool IsEdge(TrianglePart part)
{
  return part >= 3 && part < TriangleInside;
}

/// A triangle to be asked for contacts: corners, and how it is seen along an axis.
struct SeenTriangle
{
  std::array<Vector3, 3> Corners;
  int Axis; ///< along which it has an area; -1 of a triangle whose corners lie on one line

  explicit SeenTriangle(const std::array<Vector3, 3>& corners)
    : SeenTriangle(corners, FindAxis(corners))
  {
  }
  SeenTriangle(const std::array<Vector3, 3>& corners, int axis)
    : Corners(corners)
    , Axis(axis)
  {
  }

  const Vector3& operator[](int corner) const { return this->Corners[corner]; }

  /// The axis along which the area is largest, as far as rounding tells; -1 if there is none along
  /// any, exactly.
  static int FindAxis(const std::array<Vector3, 3>& corners)
  {
    const Vector3 normal = Cross(corners[1] - corners[0], corners[2] - corners[0]);
    int first = 0;
    for (int axis = 1; axis < 3; ++axis)
    {
      first = std::abs(normal[axis]) > std::abs(normal[first]) ? axis : first;
    }
    for (const int axis : { first, (first + 1) % 3, (first + 2) % 3 })
    {
      if (Orient2D(corners[0], corners[1], corners[2], axis) != 0)
      {
        return axis;
      }
    }
    return -1;
  }
};

/// A point where two triangles touch: the least part of each that it lies on.
struct ContactPoint
{
  TrianglePart First;
  TrianglePart Second;
};

/// What two triangles have in common: nothing, a point, a segment, or when they lie in one plane a
/// convex polygon, by its corners. The corners of a polygon are given around it.
struct TriangleContact
{
  std::array<ContactPoint, 6> Points;
  int Count = 0;
  bool IsFlat = false; ///< both lie in one plane

  void Add(TrianglePart first, TrianglePart second)
  {
    for (int i = 0; i < this->Count; ++i)
    {
      if (this->Points[i].First == first && this->Points[i].Second == second)
      {
        return;
      }
    }
    this->Points[this->Count++] = { first, second };
  }
};

/// For each corner of the first triangle the corner of the second that it is known to be; -1: none.
using SharedCorners = std::array<std::int8_t, 3>;
constexpr SharedCorners NoSharedCorners = { -1, -1, -1 };

namespace detail
{

inline int NextCorner(int corner)
{
  return corner == 2 ? 0 : corner + 1;
}

/// Where a point or line is that has the edges 0 to 2 of a triangle on these sides: -1 outside.
inline TrianglePart PartOf(const std::array<int, 3>& sides)
{
  bool isLeft = false;
  bool isRight = false;
  int zeros = 0;
  int sum = 0;
  for (int edge = 0; edge < 3; ++edge)
  {
    isLeft = isLeft || sides[edge] > 0;
    isRight = isRight || sides[edge] < 0;
    zeros += sides[edge] == 0;
    sum += sides[edge] == 0 ? edge : 0;
  }
  if ((isLeft && isRight) || zeros == 3)
  {
    return -1;
  }
  if (zeros == 2)
  {
    return static_cast<TrianglePart>(sum == 1 ? 1 : (sum == 2 ? 0 : 2)); // edges 0 1, 0 2, 1 2
  }
  return static_cast<TrianglePart>(zeros == 1 ? 3 + sum : TriangleInside);
}

/// The edges of a triangle that a part of it lies on, a bit each.
inline unsigned EdgesAt(TrianglePart part)
{
  if (IsCorner(part))
  {
    return (1u << part) | (1u << (part == 0 ? 2 : part - 1));
  }
  return IsEdge(part) ? 1u << (part - 3) : 0u;
}

/// Finds what two triangles have in common. Of sides of a plane all that is needed are signs, and
/// these are exact, so what is found fits together: between the two ways of looking at a pair, and
/// between all pairs that meet at an edge or a corner.
///
/// Triangles in two planes meet on the line in which the planes do. The ends of what they have in
/// common are corners of one in the plane of the other, or crossings of an edge and a plane.
class ContactFinder
{
public:
  ContactFinder(const SeenTriangle& first, const SeenTriangle& second, const SharedCorners& shared)
    : A(first)
    , B(second)
    , SharedOfA(shared)
  {
    for (std::int8_t corner = 0; corner < 3; ++corner)
    {
      if (shared[corner] >= 0)
      {
        this->SharedOfB[shared[corner]] = corner;
      }
    }
  }

  TriangleContact Find()
  {
    TriangleContact contact;
    const Sides sidesOfA = SidesOf(this->A, this->SharedOfA, this->B);
    const auto zeros = std::count(sidesOfA.begin(), sidesOfA.end(), 0);
    const auto shared = 3 - std::count(this->SharedOfA.begin(), this->SharedOfA.end(), -1);
    const bool isCrossed = HasBothSides(sidesOfA);
    if (zeros == 0 && !isCrossed)
    {
      return contact;
    }
    if (zeros == 3)
    {
      contact.IsFlat = true;
      this->AddFlat(contact);
      return contact;
    }
    this->AddCornersOfA(contact, sidesOfA);
    if (isCrossed || (zeros > 1 && zeros > shared))
    {
      const Sides sidesOfB = SidesOf(this->B, this->SharedOfB, this->A);
      this->AddCornersOfB(contact, sidesOfB);
      this->AddCrossings(contact, sidesOfA, sidesOfB);
    } // else those corners at most
    return contact;
  }

private:
  using Sides = std::array<int, 3>;

  static void Add(TriangleContact& contact, int first, int second)
  {
    if (first >= 0 && second >= 0)
    {
      contact.Add(static_cast<TrianglePart>(first), static_cast<TrianglePart>(second));
    }
  }

  static bool HasBothSides(const Sides& sides)
  {
    return (sides[0] > 0 || sides[1] > 0 || sides[2] > 0) &&
      (sides[0] < 0 || sides[1] < 0 || sides[2] < 0);
  }

  /// On which side of the plane of `of` the corners of a triangle lie.
  static Sides SidesOf(
    const SeenTriangle& corners, const SharedCorners& shared, const SeenTriangle& of)
  {
    Sides sides;
    for (int i = 0; i < 3; ++i)
    {
      sides[i] = shared[i] >= 0 ? 0 : Orient3D(of[0], of[1], of[2], corners[i]);
    }
    return sides;
  }

  /// On which side of the edges of `of` a point of its plane lies.
  static Sides SidesInPlane(const Vector3& x, const SeenTriangle& of, int axis)
  {
    Sides sides;
    for (int edge = 0; edge < 3; ++edge)
    {
      sides[edge] = Orient2D(of[edge], of[NextCorner(edge)], x, axis);
    }
    return sides;
  }

  void AddCornersOfA(TriangleContact& contact, const Sides& sides) const
  {
    for (int i = 0; i < 3; ++i)
    {
      if (sides[i] == 0)
      {
        Add(contact, i,
          this->SharedOfA[i] >= 0 ? this->SharedOfA[i]
                                  : PartOf(SidesInPlane(this->A[i], this->B, this->B.Axis)));
      }
    }
  }

  void AddCornersOfB(TriangleContact& contact, const Sides& sides) const
  {
    for (int i = 0; i < 3; ++i)
    {
      if (sides[i] == 0)
      {
        Add(contact,
          this->SharedOfB[i] >= 0 ? this->SharedOfB[i]
                                  : PartOf(SidesInPlane(this->B[i], this->A, this->A.Axis)),
          i);
      }
    }
  }

  /// How an edge of the first triangle turns about one of the second; 0 if their lines meet.
  int Turn(int edgeA, int edgeB)
  {
    int& turn = this->Turns[edgeA][edgeB];
    if (turn == Unknown)
    {
      const int nextA = NextCorner(edgeA);
      const int nextB = NextCorner(edgeB);
      const auto isShared = [&](int corner)
      { return this->SharedOfA[corner] == edgeB || this->SharedOfA[corner] == nextB; };
      turn = isShared(edgeA) || isShared(nextA)
        ? 0
        : Orient3D(this->A[edgeA], this->A[nextA], this->B[edgeB], this->B[nextB]);
    }
    return turn;
  }

  /// Where edges that have their ends on different sides of the other triangle's plane cross it.
  void AddCrossings(TriangleContact& contact, const Sides& sidesOfA, const Sides& sidesOfB)
  {
    for (int edge = 0; edge < 3; ++edge)
    {
      if (sidesOfA[edge] * sidesOfA[NextCorner(edge)] < 0)
      {
        const Sides turns = { this->Turn(edge, 0), this->Turn(edge, 1), this->Turn(edge, 2) };
        Add(contact, 3 + edge, PartOf(turns));
      }
    }
    for (int edge = 0; edge < 3; ++edge)
    {
      if (sidesOfB[edge] * sidesOfB[NextCorner(edge)] < 0)
      {
        const Sides turns = { this->Turn(0, edge), this->Turn(1, edge), this->Turn(2, edge) };
        Add(contact, PartOf(turns), 3 + edge);
      }
    }
  }

  void AddFlat(TriangleContact& contact) const
  {
    std::array<Sides, 3> ofA;
    std::array<Sides, 3> ofB;
    for (int i = 0; i < 3; ++i)
    {
      ofA[i] = SidesInPlane(this->A[i], this->B, this->B.Axis);
      ofB[i] = SidesInPlane(this->B[i], this->A, this->B.Axis);
      Add(contact, i, PartOf(ofA[i]));
    }
    for (int i = 0; i < 3; ++i)
    {
      Add(contact, PartOf(ofB[i]), i);
    }
    for (int edgeA = 0; edgeA < 3; ++edgeA)
    {
      for (int edgeB = 0; edgeB < 3; ++edgeB)
      {
        if (ofA[edgeA][edgeB] * ofA[NextCorner(edgeA)][edgeB] < 0 &&
          ofB[edgeB][edgeA] * ofB[NextCorner(edgeB)][edgeA] < 0)
        {
          Add(contact, 3 + edgeA, 3 + edgeB);
        }
      }
    }
    SortAround(contact);
  }

  /// Corners of a polygon that follow each other lie on one edge, and no others do.
  static void SortAround(TriangleContact& contact)
  {
    const auto edgesAt = [](const ContactPoint& point)
    { return EdgesAt(point.First) | (EdgesAt(point.Second) << 3); };
    for (int i = 1; i + 1 < contact.Count; ++i)
    {
      int next = i;
      while (next + 1 < contact.Count &&
        !(edgesAt(contact.Points[i - 1]) & edgesAt(contact.Points[next])))
      {
        ++next;
      }
      std::swap(contact.Points[i], contact.Points[next]);
    }
  }

  static constexpr int Unknown = 2;

  const SeenTriangle& A;
  const SeenTriangle& B;
  SharedCorners SharedOfA;
  SharedCorners SharedOfB = NoSharedCorners;
  std::array<std::array<int, 3>, 3> Turns = { { { Unknown, Unknown, Unknown },
    { Unknown, Unknown, Unknown }, { Unknown, Unknown, Unknown } } };
};

}

/// What two triangles with an area have in common, boundaries included, exactly: no tolerance. See
/// Orient3D.h for the range of coordinates. `shared` only spares work.
inline TriangleContact FindContact(const SeenTriangle& first, const SeenTriangle& second,
  const SharedCorners& shared = NoSharedCorners)
{
  return detail::ContactFinder(first, second, shared).Find();
}

}

#endif
