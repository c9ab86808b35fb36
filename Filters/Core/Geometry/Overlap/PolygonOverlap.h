// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Overlap_PolygonOverlap_h
#define skd_Geometry_Overlap_PolygonOverlap_h

#include "PlanarOverlap.h"
#include "SphericalFrame.h"

#include <algorithm>

namespace skd
{

/// Corners of a convex polygon, counter-clockwise, no two of them the same: (x, y, 0) of the plane,
/// or points of the unit sphere, seen from without, less than a hemisphere.
struct PolygonView
{
  const Vector3* Corners;
  int Size;
};

/// What two convex polygons have in common, by cutting `within` by the edges of `around`, in the
/// frame of `within`: a PlanarFrame, or a SphericalFrame, about a point of `within`. Best the
/// smaller one is cut: it keeps its digits, and all that is cut out of it fits together. Sizes add
/// up to ConvexPolygon::Most at most. About 100 to 300 ns, no allocation.
template <class Frame>
ClipResult FindOverlap(
  const Frame& frame, const PolygonView& within, const PolygonView& around, ConvexPolygon& overlap)
{
  overlap.Size = 0;
  double extent = 0.0;
  for (int i = 0; i < within.Size; ++i)
  {
    const Vector3 projected = frame.Projected(within.Corners[i]);
    overlap.Add({ { projected[0] / projected[2], projected[1] / projected[2] } });
    extent = std::max({ extent, std::abs(projected[0]), std::abs(projected[1]) });
  }
  std::array<Vector3, ConvexPolygon::Most> edges;
  for (int i = 0; i < around.Size; ++i)
  {
    edges[i] = frame.Projected(around.Corners[i]);
    extent = std::max({ extent, std::abs(edges[i][0]), std::abs(edges[i][1]) });
  }
  return Clip(overlap, edges.data(), around.Size, extent);
}

}

#endif
