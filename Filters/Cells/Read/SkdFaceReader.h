// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdFaceReader_h
#define SkdFaceReader_h

#include "Core/Geometry/PointArray.h"

#include "vtkType.h"

#include <cstdint>
#include <utility>
#include <vector>

class vtkDataSet;
class vtkGenericCell;
class vtkIdList;

namespace skdtree
{
/// The faces of the convex hull of finite points, outward: of each the number of points, then their
/// numbers. Triangles; of points in a plane their outline and its back; of points on a line the
/// triangle that goes to its end and back; none of points that are all the same.
std::vector<std::uint32_t> SkdFacesOfHull(const skd::Vector3* points, std::size_t size);

/// The faces of a polyhedron as vtkUnstructuredGrid streams them: how many, then of each the number
/// of points and their ids; of a convex point set those of its hull. The cell is for data sets that
/// have no such stream.
void SkdReadFaces(vtkDataSet* data, vtkIdType cellId, vtkGenericCell* cell, vtkIdList* faces);

/// Makes of VTK's faces those that the kernels read: of each face the number of points, then their
/// numbers within the cell. Each starts at its first point in lexicographic order, so that it comes
/// out the same for both of its cells, and all are oriented alike, outward or inward.
class SkdFaceReader
{
public:
  /// Of a cell with these points; `points` are those of all cells. Empty if the
  /// cell has no faces, or one that names a point which is not the cell's.
  std::vector<std::uint32_t> Read(vtkIdList* faces, const std::uint32_t* pointIds,
    std::uint32_t numberOfPoints, const skd::PointArray& points);

private:
  struct Edge
  {
    std::uint32_t Low;
    std::uint32_t High;
    std::uint32_t Face;
    bool IsReversed; ///< the face walks from High to Low
  };

  bool Number(vtkIdList* faces, const std::uint32_t* pointIds, std::uint32_t numberOfPoints);
  void OrientAlike();
  void CollectEdges();
  std::uint32_t RootOf(std::uint32_t face);
  void Join(const Edge& one, const Edge& other);
  void Rotate(const std::uint32_t* pointIds, const skd::PointArray& points);

  std::vector<std::uint32_t> Stream;
  std::vector<std::uint32_t> Starts; // of faces in the stream
  std::vector<std::pair<vtkIdType, std::uint32_t>> Numbers;
  std::vector<Edge> Edges;
  std::vector<std::uint32_t> Parents; // of faces, and whether they are oriented against these
  std::vector<char> Reversals;
};
}

#endif
