// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdInnerFaces.h
 * @brief Which outer faces of the pieces of one mesh are inside the mesh: those between pieces.
 *
 * A face is inside if a face of another piece, seen from the other side, has the same corners. Of
 * images, such as the blocks of AMR data, and of grids of voxels along the axes, cells may differ
 * in size: there a face is also inside if smaller faces that are seen from the other side cover it
 * wholly, and so are these. Of points that VTK finds by origin and spacing of several images,
 * rounding is no difference.
 */

#ifndef SkdInnerFaces_h
#define SkdInnerFaces_h

#include "Bodies/SkdWeld.h"
#include "Core/Geometry/Rows.h"
#include "Core/Geometry/Vector.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <vector>

class vtkDataSet;

namespace skdtree
{
class SkdInnerFaces
{
public:
  explicit SkdInnerFaces(const std::vector<vtkDataSet*>& pieces);

  /// Adds an outer face of a piece, given its corners and a point within its cell. Faces are
  /// numbered in the order in which they are added.
  void Add(const std::vector<skd::Vector3>& corners, const skd::Vector3& within);

  /// For each face whether it is inside the mesh. O(n log n).
  std::vector<unsigned char> Find();

  /// The numbers of a face's corners: those of several pieces at one point have one.
  auto GetCorners(std::size_t face) const { return this->Corners[face]; }

  /// Where a corner is, of all pieces the same.
  const skd::Vector3& GetPoint(vtkIdType corner) const
  {
    return this->Points[static_cast<std::size_t>(corner)];
  }
  std::size_t GetNumberOfPoints() const { return this->Points.size(); }

  /// The corners of a face, and between them those of smaller ones that lie on its sides, given
  /// which corners count; after Find. O(log n) and what is found.
  void FindAllCorners(std::size_t face, const std::vector<unsigned char>& counts,
    std::vector<vtkIdType>& corners) const;

private:
  skd::Vector3 KeyOf(const skd::Vector3& x) const;
  const skd::Vector3& GetKey(vtkIdType corner) const
  {
    return this->Weld.GetPoints()[static_cast<std::size_t>(corner)];
  }
  bool AreOnOppositeSides(std::size_t first, std::size_t second) const;
  void FindEqual(std::vector<unsigned char>& isInner) const;
  void FindCovered(std::vector<unsigned char>& isInner) const;
  void SortCorners();
  void AddCornersBetween(vtkIdType from, vtkIdType to, std::vector<vtkIdType>& corners) const;

  bool IsLattice = false; // pieces are images or voxels
  skd::Vector3 Origin{};  // of the lattice
  skd::Vector3 Spacing{};
  SkdWeld Weld; // of corners, on the lattice
  std::vector<skd::Vector3> Points;
  std::array<std::vector<vtkIdType>, 3> OnLines; // corners, along each axis line by line
  skd::Rows<vtkIdType> Corners;
  std::vector<skd::Vector3> Within;
};
}

#endif
