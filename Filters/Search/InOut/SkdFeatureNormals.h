// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdFeatureNormals_h
#define SkdFeatureNormals_h

#include "Bodies/SkdTriangulation.h"

#include <vector>

namespace skdtree
{
/// Pseudonormals of the triangles, edges and vertices of a surface: a point is outside exactly if
/// it is in front of the normal of its nearest feature: J. A. Baerentzen, H. Aanaes, "Signed
/// distance computation using the angle weighted pseudonormal", IEEE Trans. Vis. Comput. Graph. 11
/// (2005) 243-253. Constant once made; 100 bytes a triangle.
class SkdFeatureNormals
{
public:
  /// `isReversed` marks triangles whose normals are reversed; none if it is empty.
  SkdFeatureNormals(vtkPolyData* surface, const std::vector<bool>& isReversed);

  struct Normal
  {
    skd::Vector3 Direction; // of any length
    bool IsOpen;            // of an edge that an odd number of triangles has
  };

  /// The normal of the feature that contains a point of a triangle, given its parametric
  /// coordinates.
  Normal At(vtkIdType triangle, const double pcoords[3]) const;

private:
  struct Edge
  {
    vtkIdType Least;
    vtkIdType Most;
    skd::Vector3 Sum;
    int Faces;
  };
  const Edge& EdgeOf(vtkIdType a, vtkIdType b) const;

  std::vector<SkdTriangleIds> Triangles;
  std::vector<skd::Vector3> FaceNormals;  // of length 1, or 0
  std::vector<skd::Vector3> PointNormals; // weighted by angle
  std::vector<Edge> Edges;                // by (least, most)
};
}

#endif
