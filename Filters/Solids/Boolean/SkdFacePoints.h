// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdFacePoints_h
#define SkdFacePoints_h

#include "Solids/Boolean/SkdFaceSets.h"
#include "Solids/Boolean/SkdFacets.h"

namespace skdtree
{
/// New points on flat faces, whose data are those of the triangle that each is in.
class SkdFacePoints
{
public:
  /// `origins` as for SkdJoinPieces.
  SkdFacePoints(
    const SkdMovedTriangles& set, SkdFaceSets& faces, const std::vector<std::uint32_t>& origins)
    : Set(set)
    , Faces(faces)
    , Origins(origins)
  {
  }

  /// A point on the face of a triangle: in this triangle, else in the one of that face that has it,
  /// or has it nearly. O(1), and O(n) for the n triangles of a face, if the first does not have it.
  SkdSplitPoint PointAt(std::uint32_t triangle, const skd::Vector3& x);

private:
  using OfFace = std::pair<std::uint32_t, std::uint32_t>; // face, triangle

  std::uint32_t FaceOf(std::uint32_t triangle) const;
  void List();

  const SkdMovedTriangles& Set;
  SkdFaceSets& Faces;
  const std::vector<std::uint32_t>& Origins;
  std::vector<OfFace> All; // ascending; empty until it is needed
};
}

#endif
