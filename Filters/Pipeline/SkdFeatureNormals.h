// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdFeatureNormals_h
#define SkdFeatureNormals_h

#include "Core/Geometry/Vector.h"
#include "vtkType.h"

#include <array>
#include <vector>

class vtkPolyData;

/// A triangle of a surface: its points' ids.
using SkdTriangleIds = std::array<vtkIdType, 3>;

/// The triangles of a surface that has no other cells, and its points.
std::vector<SkdTriangleIds> SkdTrianglesOf(vtkPolyData* surface);
std::vector<skd::Vector3> SkdPointsOf(vtkPolyData* surface);

/// A normal for each triangle, edge and corner of a surface, such that a point is outside exactly
/// when it is in front of the normal of the feature that is nearest to it: J. A. Baerentzen,
/// H. Aanaes, "Signed distance computation using the angle weighted pseudonormal", IEEE Trans. Vis.
/// Comput. Graph. 11 (2005) 243-253. Constant once made; 100 bytes a triangle.
class SkdFeatureNormals
{
public:
  /// `isTurned` names triangles whose normals are to be turned around; none if it is empty.
  SkdFeatureNormals(vtkPolyData* surface, const std::vector<bool>& isTurned);

  struct Normal
  {
    skd::Vector3 Direction; // of any length
    bool IsOpen;            // of an edge that an odd number of triangles has
  };

  /// Of what a point of a triangle is on, given its parametric coordinates there.
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

#endif
