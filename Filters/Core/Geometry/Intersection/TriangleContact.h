// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Intersection_TriangleContact_h
#define skd_Geometry_Intersection_TriangleContact_h

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

  static bool HasZero(const Sides& sides)
  {
    return sides[0] == 0 || sides[1] == 0 || sides[2] == 0;
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

/// Three corners, where they are stored. Masks of corners have a bit for each.
using CornerPointers = std::array<const Vector3*, 3>;

namespace detail
{

struct CornerPair
{
  std::uint8_t First;
  std::uint8_t Second;
};

/// Of each mask of corners two that are not in it, the same twice if there is only one.
inline constexpr CornerPair CornersOutside[8] = { { 0, 1 }, { 1, 2 }, { 0, 2 }, { 2, 2 }, { 0, 1 },
  { 1, 1 }, { 0, 0 }, { 0, 0 } };

/// Whether a mask has two corners.
inline constexpr bool IsEdgeMask[8] = { false, false, false, true, false, true, true, false };

}

/// Whether the corners of a triangle but those shared (in the mask) with a plane's triangle are
/// surely on one side of the plane: if so, the triangles surely have nothing but these in common.
inline bool AreOthersOnOneSide(
  const FloatingPlane& plane, const CornerPointers& corners, unsigned shared)
{
  const detail::CornerPair others = detail::CornersOutside[shared];
  constexpr unsigned all = 7;
  const int side = plane.SureSideOfBoth(*corners[others.First], *corners[others.Second]);
  return side != 0 && shared != all && (shared != 0 || plane.SureSideOf(*corners[2]) == side);
}

namespace detail
{

/// The sign of an area seen along an axis, as Orient2D; 0 also where rounding could matter.
inline int SureOrient2D(const Vector3& a, const Vector3& b, const Vector3& c, int axis)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const double left = (b[u] - a[u]) * (c[v] - a[v]);
  const double right = (b[v] - a[v]) * (c[u] - a[u]);
  const double rounding = Orient2DBound * (std::abs(left) + std::abs(right));
  return (left - right > rounding) - (left - right < -rounding);
}

/// Whether a plane through the common edge of two triangles, parallel to an axis, surely has the
/// one before it and the other behind it: also if they lie in one plane.
inline bool AreApartAtEdge(const CornerPointers& first, unsigned sharedOfFirst,
  const CornerPointers& second, unsigned sharedOfSecond)
{
  if (!IsEdgeMask[sharedOfFirst] || !IsEdgeMask[sharedOfSecond])
  {
    return false;
  }
  const std::size_t apex = CornersOutside[sharedOfFirst].First;
  const std::size_t other = CornersOutside[sharedOfSecond].First;
  const Vector3& from = *first[apex == 2 ? 0 : apex + 1];
  const Vector3& to = *first[apex == 0 ? 2 : apex - 1];
  for (int axis = 0; axis < 3; ++axis)
  {
    if (SureOrient2D(from, to, *first[apex], axis) * SureOrient2D(from, to, *second[other], axis) <
      0)
    {
      return true;
    }
  }
  return false;
}

}

/// Whether two triangles that share one or two corners (those in the masks) surely have nothing
/// else in common, since they are on either side of their common edge, or the other corners of one
/// are on one side of the other's plane: true of most pairs of neighbours in a surface, and
/// found in a fraction of the time that FindContact() takes.
inline bool HaveOnlyCornersInCommon(const CornerPointers& first, unsigned sharedOfFirst,
  const CornerPointers& second, unsigned sharedOfSecond)
{
  return detail::AreApartAtEdge(first, sharedOfFirst, second, sharedOfSecond) ||
    AreOthersOnOneSide({ *first[0], *first[1], *first[2] }, second, sharedOfSecond) ||
    AreOthersOnOneSide({ *second[0], *second[1], *second[2] }, first, sharedOfFirst);
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
  return detail::ContactFinder(first.Corners, second, shared, sidesOfFirst, sidesOfSecond).Find();
}
inline TriangleContact FindContact(const std::array<Vector3, 3>& first,
  const std::array<Vector3, 3>& second, const SharedCorners& shared = NoSharedCorners)
{
  return FindContact(TriangleInPlane(first), second, shared);
}

}

#endif
