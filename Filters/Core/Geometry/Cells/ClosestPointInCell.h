// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The nearest point of a volume cell: x itself inside, else one of its faces.
///
/// In the order of what they cost: one linear solve says where x is if the cell is not warped. If
/// that is outside, a plane along the face which it is beyond most often shows that the whole cell
/// is too far. Only then the map is inverted in earnest, and only after that faces are measured,
/// each only if it may be nearer than what is known.
#ifndef skd_Geometry_Cells_ClosestPointInCell_h
#define skd_Geometry_Cells_ClosestPointInCell_h

#include "../Tolerances.h"
#include "Brick.h"
#include "CellFaces.h"
#include "ParametricCoordinates.h"
#include "VolumePoint.h"

#include <type_traits>

namespace skd
{

/// A lower bound of the squared distance of x from the cell, 0 if it may be inside: the gap between
/// x and the nearest of the points across a direction, less what rounding may have added to it.
template <class Shape>
double GapAlong(const Vector3* points, const Vector3& x, const Vector3& direction)
{
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  double size2 = 0.0;
  for (int i = 0; i < Shape::Size; ++i)
  {
    const Vector3 fromX = points[i] - x;
    const double height = Dot(direction, fromX);
    least = std::min(least, height);
    most = std::max(most, height);
    size2 = std::max(size2, Norm2(fromX));
  }
  const double gap = std::max(least, -most);
  const double gap2 = gap * gap / Norm2(direction) - tolerances::CellGap2 * size2;
  return gap > 0.0 && gap2 > 0.0 ? gap2 : 0.0;
}

/// Whether a face has points nearer to x than the given one: not if all its corners are on the far
/// side of the plane through that point, across the line from x.
template <class Shape>
bool MayBeNearer(const CellFace<Shape>& face, const Vector3& x, const VolumePoint& known)
{
  const Vector3 direction = known.Point - x;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < face.Size; ++i)
  {
    least = std::min(least, Dot(direction, face.Points[i] - x));
  }
  return !(least >= known.Dist2);
}

/// The nearest point of the faces, beginning with that which is most likely to have it.
template <class Shape>
VolumePoint ClosestPointOnFaces(
  const Vector3* points, const Vector3& x, double limit2, int firstFace)
{
  VolumePoint nearest = VolumePoint::Nowhere(x);
  for (int i = 0; i < Shape::NumberOfFaces; ++i)
  {
    const int index = (firstFace + i) % Shape::NumberOfFaces;
    const CellFace<Shape> face(points, index);
    if (i > 0 && !MayBeNearer(face, x, nearest))
    {
      continue;
    }
    const PatchPoint found = face.ClosestPoint(x, std::min(limit2, nearest.Dist2));
    if (found.Dist2 < nearest.Dist2)
    {
      nearest = { found.Point, PCoordsOnFace<Shape>(index, found.R, found.S), found.Dist2 };
    }
  }
  return nearest;
}

/// The nearest point of the cell when x has parametric coordinates that are outside of the domain,
/// but by no more than rounding: these put back into it, or a face if that is nearer still.
template <class Shape>
VolumePoint ClosestPointOnBorder(
  const Vector3* points, const Vector3& x, const Vector3& found, int face)
{
  const Vector3 pcoords = Shape::ClampToDomain(found);
  const Vector3 rest = Evaluate<Shape>(points, pcoords, x);
  const VolumePoint inside{ x + rest, pcoords, Norm2(rest) };
  const double ulp = std::numeric_limits<double>::epsilon() * (MaxNorm(x) + MaxNorm(points[0]));
  if (inside.Dist2 <= ulp * ulp)
  {
    return inside;
  }
  const VolumePoint onFace = ClosestPointOnFaces<Shape>(points, x, inside.Dist2, face);
  return onFace.Dist2 < inside.Dist2 ? onFace : inside;
}

/// The nearest point of a Tetrahedron, Voxel, Hexahedron, Wedge or Pyramid, for any points: warped,
/// inverted or collapsed. When no point is within sqrt(limit2), Dist2 may be infinite instead (the
/// rest is then nothing). Lengths may range over 1e-50 to 1e50. A NaN gives Dist2 = NaN or
/// infinity.
template <class Shape>
VolumePoint ClosestPointInCell(const Vector3* points, const Vector3& x, double limit2)
{
  if (!IsFinite(x))
  {
    return VolumePoint::Nowhere(x);
  }
  if constexpr (std::is_same_v<Shape, Voxel>)
  {
    const Brick brick(points);
    if (brick.IsRectangular())
    {
      return brick.ClosestPoint(x);
    }
  }
  const InverseMap<Shape> inverse(points, x);
  const Vector3 guess = inverse.Guess();
  int face = 0;
  double gap2 = 0.0;
  if (!Shape::InDomain(guess))
  {
    face = Shape::FaceBeyond(guess);
    gap2 = GapAlong<Shape>(points, x, FaceNormal<Shape>(points, face));
    if (gap2 > limit2)
    {
      return VolumePoint::Nowhere(x);
    }
  }
  if (gap2 == 0.0)
  {
    const std::optional<Vector3> found = inverse.Find(guess);
    if (found)
    {
      return Shape::InDomain(*found) ? VolumePoint{ x, *found, 0.0 }
                                     : ClosestPointOnBorder<Shape>(points, x, *found, face);
    }
  }
  return ClosestPointOnFaces<Shape>(points, x, limit2, face);
}

}

#endif
