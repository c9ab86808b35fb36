// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCurvedFacePoints.h
 * @brief Points on curved faces, and the normals of the faces themselves there.
 *
 * Curved faces are the curved surface cells of a mesh and the outer faces of its curved volume
 * cells. Each of their points stands for the point of the face at its parameters: for the points of
 * Bezier cells are control points, which are not on the face.
 */
#ifndef SkdCurvedFacePoints_h
#define SkdCurvedFacePoints_h

#include "Core/Geometry/Vector.h"
#include "vtkType.h"

#include <functional>
#include <optional>
#include <vector>

class vtkDataSet;

namespace skdtree
{
/// A point on a face.
struct SkdCurvedFacePoint
{
  skd::Vector3 Point;
  skd::Vector3 Normal; ///< of length 1, outward of volume cells; 0 where there is none
  double Angle;        ///< of the face around the point: at a corner that between its sides
};

/// Calls visit(point id, point on the face) for each point of each curved face, by ascending cell
/// and face.
void SkdVisitCurvedFacePoints(
  vtkDataSet* mesh, const std::function<void(vtkIdType, const SkdCurvedFacePoint&)>& visit);

/// The point in the middle of a curved surface cell by its parameters; nothing of another cell.
/// Thread-safe after SkdTouchCells(), like the next one.
std::optional<SkdCurvedFacePoint> SkdMiddleOfCurvedCell(vtkDataSet* mesh, vtkIdType cell);

/// The point nearest to x on a curved surface cell.
std::optional<SkdCurvedFacePoint> SkdNearestOnCurvedCell(
  vtkDataSet* mesh, vtkIdType cell, const skd::Vector3& x);

/// Replaces control points, among all points of the mesh, by points on curved faces.
void SkdPutControlPointsOnFaces(vtkDataSet* mesh, std::vector<skd::Vector3>& points);
}

#endif
