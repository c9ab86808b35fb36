// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Intersection_TriangleContact_h
#define skd_Geometry_Intersection_TriangleContact_h

#include "NeighbourTriangles.h"
#include "ProjectedTriangle.h"
#include "TriangleFeature.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace skd
{

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
inline TriangleFeature FeatureOf(const std::array<int, 3>& sides)
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
    return static_cast<TriangleFeature>(sum == 1 ? 1 : (sum == 2 ? 0 : 2)); // edges 0 1, 0 2, 1 2
  }
  return static_cast<TriangleFeature>(zeros == 1 ? 3 + sum : TriangleInside);
}

using Sides = std::array<int, 3>;

/// On which side of a plane the corners of a triangle lie, 0 also where rounding could matter.
inline Sides SureSidesOf(const std::array<Vector3, 3>& corners, const FloatingPlane& plane)
{
  return { plane.SureSideOf(corners[0]), plane.SureSideOf(corners[1]),
    plane.SureSideOf(corners[2]) };
}

inline bool AreOnOneSide(const Sides& sides)
{
  return sides[0] != 0 && sides[0] == sides[1] && sides[1] == sides[2];
}

inline bool HasZero(const Sides& sides)
{
  return sides[0] == 0 || sides[1] == 0 || sides[2] == 0;
}

/// Whether two triangles surely have nothing in common, seen from above the first one: found in a
/// fraction of the time of exact signs, and so of most that planar faces side by side have.
inline bool AreApartFromAbove(const TriangleInPlane& first, const std::array<Vector3, 3>& second)
{
  const std::array<Vector3, 3>& a = first.Corners;
  return AreApartAlong(first.Plane.DominantAxis(), { &a[0], &a[1], &a[2] }, 0u,
    { &second[0], &second[1], &second[2] }, 0u);
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
  using Corners = std::array<Vector3, 3>;

  /// `sidesOfFirst` and `sidesOfSecond`: by SureSidesOf(), not all on one side.
  ContactFinder(const Corners& first, const Corners& second, const SharedCorners& shared,
    const Sides& sidesOfFirst, const Sides& sidesOfSecond)
    : A(first)
    , B(second)
    , SidesOfA(sidesOfFirst)
    , SidesOfB(sidesOfSecond)
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
    if (HasZero(this->SidesOfA) || HasZero(this->SidesOfB))
    {
      this->FindExactly(contact);
    }
    else if (!this->AreApartOnLine())
    {
      this->AddCrossings(contact);
    }
    return contact;
  }

private:
  static void Add(TriangleContact& contact, int first, int second)
  {
    if (first >= 0 && second >= 0)
    {
      contact.Add(static_cast<TriangleFeature>(first), static_cast<TriangleFeature>(second));
    }
  }

  static bool HasBothSides(const Sides& sides)
  {
    return (sides[0] > 0 || sides[1] > 0 || sides[2] > 0) &&
      (sides[0] < 0 || sides[1] < 0 || sides[2] < 0);
  }

  /// Determines exactly, where that is still open, on which sides of the plane of `of` corners lie.
  static void Complete(
    Sides& sides, const Corners& corners, const SharedCorners& shared, const Corners& of)
  {
    for (int i = 0; i < 3; ++i)
    {
      if (sides[i] == 0 && shared[i] < 0)
      {
        sides[i] = Orient3D(of[0], of[1], of[2], corners[i]);
      }
    }
  }

  /// Triangles without an area have no contact.
  void FindExactly(TriangleContact& contact)
  {
    this->AxisOfA = ProjectedTriangle::FindAxis(this->A);
    this->AxisOfB = ProjectedTriangle::FindAxis(this->B);
    Complete(this->SidesOfA, this->A, this->SharedOfA, this->B);
    const auto zeros = std::count(this->SidesOfA.begin(), this->SidesOfA.end(), 0);
    const auto shared = 3 - std::count(this->SharedOfA.begin(), this->SharedOfA.end(), -1);
    const bool isCrossed = HasBothSides(this->SidesOfA);
    if (this->AxisOfA < 0 || this->AxisOfB < 0 || (zeros == 0 && !isCrossed))
    {
      return;
    }
    if (zeros == 3)
    {
      contact.IsFlat = true;
      this->AddFlat(contact);
      return;
    }
    this->AddCornersOfA(contact);
    if (isCrossed || (zeros > 1 && zeros > shared))
    {
      Complete(this->SidesOfB, this->B, this->SharedOfB, this->A);
      this->AddCornersOfB(contact);
      this->AddCrossings(contact);
    } // else those corners at most
  }

  /// The two edges of a triangle that cross the other's plane, in their order along the line of
  /// both planes: from left to right, seen from where the normal points to and the other's normal
  /// being up. The first goes down, the second up.
  static std::array<int, 2> CrossingEdges(const Sides& sides)
  {
    const int alone = sides[0] == sides[1] ? 2 : (sides[0] == sides[2] ? 1 : 0);
    const int before = alone == 0 ? 2 : alone - 1;
    return sides[alone] > 0 ? std::array<int, 2>{ alone, before }
                            : std::array<int, 2>{ before, alone };
  }

  /// Whether the intervals of two triangles on the line of their planes have no point in common,
  /// all corners being off these: P. Guigue and O. Devillers, "Fast and Robust Triangle-Triangle
  /// Overlap Test Using Orientation Predicates", Journal of Graphics Tools 8 (2003) 25-32.
  bool AreApartOnLine()
  {
    const std::array<int, 2> a = CrossingEdges(this->SidesOfA); // the other way round than b
    const std::array<int, 2> b = CrossingEdges(this->SidesOfB);
    return this->Orientation(a[0], b[0]) > 0 || this->Orientation(a[1], b[1]) < 0;
  }

  /// On which side of the edges of `of` a point of its plane lies.
  static Sides SidesInPlane(const Vector3& x, const Corners& of, int axis)
  {
    Sides sides;
    for (int edge = 0; edge < 3; ++edge)
    {
      sides[edge] = Orient2D(of[edge], of[NextCorner(edge)], x, axis);
    }
    return sides;
  }

  void AddCornersOfA(TriangleContact& contact) const
  {
    for (int i = 0; i < 3; ++i)
    {
      if (this->SidesOfA[i] == 0)
      {
        Add(contact, i,
          this->SharedOfA[i] >= 0 ? this->SharedOfA[i]
                                  : FeatureOf(SidesInPlane(this->A[i], this->B, this->AxisOfB)));
      }
    }
  }

  void AddCornersOfB(TriangleContact& contact) const
  {
    for (int i = 0; i < 3; ++i)
    {
      if (this->SidesOfB[i] == 0)
      {
        Add(contact,
          this->SharedOfB[i] >= 0 ? this->SharedOfB[i]
                                  : FeatureOf(SidesInPlane(this->B[i], this->A, this->AxisOfA)),
          i);
      }
    }
  }

  /// How an edge of the first triangle turns about one of the second; 0 if their lines meet.
  int Orientation(int edgeA, int edgeB)
  {
    int& orientation = this->Orientations[edgeA][edgeB];
    if (orientation == Unknown)
    {
      const int nextA = NextCorner(edgeA);
      const int nextB = NextCorner(edgeB);
      const auto isShared = [&](int corner)
      { return this->SharedOfA[corner] == edgeB || this->SharedOfA[corner] == nextB; };
      orientation = isShared(edgeA) || isShared(nextA)
        ? 0
        : Orient3D(this->A[edgeA], this->A[nextA], this->B[edgeB], this->B[nextB]);
    }
    return orientation;
  }

  /// Where edges that have their ends on different sides of the other triangle's plane cross it.
  void AddCrossings(TriangleContact& contact)
  {
    for (int edge = 0; edge < 3; ++edge)
    {
      if (this->SidesOfA[edge] * this->SidesOfA[NextCorner(edge)] < 0)
      {
        const Sides orientations = { this->Orientation(edge, 0), this->Orientation(edge, 1),
          this->Orientation(edge, 2) };
        Add(contact, 3 + edge, FeatureOf(orientations));
      }
    }
    for (int edge = 0; edge < 3; ++edge)
    {
      if (this->SidesOfB[edge] * this->SidesOfB[NextCorner(edge)] < 0)
      {
        const Sides orientations = { this->Orientation(0, edge), this->Orientation(1, edge),
          this->Orientation(2, edge) };
        Add(contact, FeatureOf(orientations), 3 + edge);
      }
    }
  }

  void AddFlat(TriangleContact& contact) const
  {
    std::array<Sides, 3> ofA;
    std::array<Sides, 3> ofB;
    for (int i = 0; i < 3; ++i)
    {
      ofA[i] = SidesInPlane(this->A[i], this->B, this->AxisOfB);
      ofB[i] = SidesInPlane(this->B[i], this->A, this->AxisOfB);
      Add(contact, i, FeatureOf(ofA[i]));
    }
    for (int i = 0; i < 3; ++i)
    {
      Add(contact, FeatureOf(ofB[i]), i);
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

  const Corners& A;
  const Corners& B;
  Sides SidesOfA; // of the plane of B; 0 also if not determined
  Sides SidesOfB;
  int AxisOfA = -1; // those that they are seen along, when it was looked
  int AxisOfB = -1;
  SharedCorners SharedOfA;
  SharedCorners SharedOfB = NoSharedCorners;
  std::array<std::array<int, 3>, 3> Orientations = { { { Unknown, Unknown, Unknown },
    { Unknown, Unknown, Unknown }, { Unknown, Unknown, Unknown } } };
};

}

/// What two triangles have in common, boundaries included, exactly: no tolerance. See Orient3D.h
/// for the range of coordinates. A triangle whose corners lie on one line has nothing in common
/// with any. `shared` only spares work.
inline TriangleContact FindContact(const TriangleInPlane& first,
  const std::array<Vector3, 3>& second, const SharedCorners& shared = NoSharedCorners)
{
  // Most pairs have no contact, and for most of these floating-point arithmetic decides.
  const detail::Sides sidesOfSecond = detail::SureSidesOf(second, first.Plane);
  if (detail::AreOnOneSide(sidesOfSecond))
  {
    return {};
  }
  const FloatingPlane planeOfSecond(second[0], second[1], second[2]);
  const detail::Sides sidesOfFirst = detail::SureSidesOf(first.Corners, planeOfSecond);
  if (detail::AreOnOneSide(sidesOfFirst))
  {
    return {};
  }
  if (shared == NoSharedCorners &&
    (detail::HasZero(sidesOfFirst) || detail::HasZero(sidesOfSecond)) &&
    detail::AreApartFromAbove(first, second))
  {
    return {};
  }
  return detail::ContactFinder(first.Corners, second, shared, sidesOfFirst, sidesOfSecond).Find();
}
inline TriangleContact FindContact(const std::array<Vector3, 3>& first,
  const std::array<Vector3, 3>& second, const SharedCorners& shared = NoSharedCorners)
{
  return FindContact(TriangleInPlane(first), second, shared);
}

}

#endif
