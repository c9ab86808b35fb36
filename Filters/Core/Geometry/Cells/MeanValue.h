// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Interpolation weights of a polyhedron, exact for linear fields: T. Ju, S. Schaefer, J. Warren,
/// "Mean value coordinates for closed triangular meshes", ACM Trans. Graphics 24 (2005) 561-566, on
/// the triangles of the faces; the weight of a face's middle is shared by its points.
///
/// For each triangle T, seen from x on the unit sphere, the mean vector m of the spherical triangle
/// is half the sum of its arcs, each as long as its angle and across it. These sum to 0 over a
/// closed surface, so that m = sum of w_k u_k over the corners' directions u_k gives x as a mean of
/// corners.
#ifndef skd_Geometry_Cells_MeanValue_h
#define skd_Geometry_Cells_MeanValue_h

#include "ClosestPointOnPolyhedron.h"

namespace skd
{
namespace detail
{

/// A corner as seen from x.
struct CornerDirection
{
  Vector3 Direction;
  double Distance;

  CornerDirection(const Vector3& corner, const Vector3& x)
    : Direction(corner - x)
    , Distance(Norm(this->Direction))
  {
    this->Direction = (1.0 / this->Distance) * this->Direction;
  }
};

/// Across the arc from a to b, as long as its angle. 0 where x is on the edge.
inline Vector3 ArcBetween(const CornerDirection& a, const CornerDirection& b)
{
  const Vector3 across = Cross(a.Direction, b.Direction);
  const double sine = Norm(across);
  const double angle = std::atan2(sine, Dot(a.Direction, b.Direction));
  return sine > 0.0 ? (angle / sine) * across : across;
}

/// The weights of a triangle's corners.
struct TriangleShares
{
  double Weights[3] = { 0.0, 0.0, 0.0 };

  /// `mean` is twice the mean vector. A triangle that is seen edge-on weighs nothing: what rounding
  /// left of its mean vector would be noise.
  TriangleShares(const CornerDirection& a, const CornerDirection& b, const CornerDirection& c,
    const Vector3& mean)
  {
    constexpr double noise = 1e5 * std::numeric_limits<double>::epsilon();
    const Vector3 acrossA = Cross(b.Direction, c.Direction);
    const double volume = Dot(a.Direction, acrossA);
    if (!(Norm2(mean) > noise * noise) || volume == 0.0)
    {
      return;
    }
    this->Weights[0] = Dot(mean, acrossA) / (volume * a.Distance);
    this->Weights[1] = Dot(mean, Cross(c.Direction, a.Direction)) / (volume * b.Distance);
    this->Weights[2] = Dot(mean, Cross(a.Direction, b.Direction)) / (volume * c.Distance);
  }
};

inline void AddTriangleFace(const PolyhedronFace& face, const Vector3& x, double* weights)
{
  const CornerDirection a(face[0], x), b(face[1], x), c(face[2], x);
  const TriangleShares shares(a, b, c, ArcBetween(a, b) + ArcBetween(b, c) + ArcBetween(c, a));
  for (int i = 0; i < 3; ++i)
  {
    weights[face.Ids[i]] += shares.Weights[i];
  }
}

inline void AddFanFace(const PolyhedronFace& face, const Vector3& x, double* weights)
{
  const CornerDirection middle(MeanOfPoints(face, face.Size), x);
  CornerDirection from(face[0], x);
  Vector3 spoke = ArcBetween(middle, from);
  double middleWeight = 0.0;
  for (int i = 0; i < face.Size; ++i)
  {
    const int next = i + 1 == face.Size ? 0 : i + 1;
    const CornerDirection to(face[next], x);
    const Vector3 nextSpoke = ArcBetween(middle, to);
    const TriangleShares shares(middle, from, to, spoke + ArcBetween(from, to) - nextSpoke);
    middleWeight += shares.Weights[0];
    weights[face.Ids[i]] += shares.Weights[1];
    weights[face.Ids[next]] += shares.Weights[2];
    from = to;
    spoke = nextSpoke;
  }
  for (int i = 0; i < face.Size; ++i)
  {
    weights[face.Ids[i]] += middleWeight / face.Size;
  }
}

}

/// The weights of the polyhedron's points at x, that is inside and not on a face. Its faces must be
/// oriented alike, all outward or all inward. They sum to 1. False where there are none.
inline bool MeanValueWeights(const PolyhedronView& cell, const Vector3& x, double* weights)
{
  std::fill(weights, weights + cell.Size, 0.0);
  cell.ForEachFace(
    [&](const PolyhedronFace& face)
    {
      if (face.Size == 3)
      {
        detail::AddTriangleFace(face, x, weights);
      }
      else if (face.Size > 3)
      {
        detail::AddFanFace(face, x, weights);
      }
    });
  double sum = 0.0;
  std::for_each(weights, weights + cell.Size, [&sum](double weight) { sum += weight; });
  if (!(std::abs(sum) > 0.0) || !std::isfinite(sum))
  {
    return false;
  }
  std::for_each(weights, weights + cell.Size, [sum](double& weight) { weight /= sum; });
  return true;
}

/// The weights at a point of one of the triangles of a face.
inline void FaceWeights(const PolyhedronView& cell, const NearestTriangle& at, double* weights)
{
  std::fill(weights, weights + cell.Size, 0.0);
  const double parts[3] = { 1.0 - at.Nearest.R - at.Nearest.S, at.Nearest.R, at.Nearest.S };
  for (int i = 0; i < 3; ++i)
  {
    const int corner = at.Triangle.Corners[i];
    if (corner != FaceTriangle::Middle)
    {
      weights[at.Face.Ids[corner]] += parts[i];
      continue;
    }
    for (int k = 0; k < at.Face.Size; ++k)
    {
      weights[at.Face.Ids[k]] += parts[i] / at.Face.Size;
    }
  }
}

}

#endif
