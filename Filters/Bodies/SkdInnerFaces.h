// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdInnerFaces.h
 * @brief Which outer faces of the pieces of one mesh are inside the mesh: those between pieces.
 *
 * A face is inside if a face of another piece, seen from the other side, has the same corners. Of
 * images, such as the blocks of AMR data, and of grids of voxels, with the same axes, cells may
 * differ in size: there a face is also inside if smaller faces that are seen from the other side
 * cover it wholly and do not overlap, and so are these. Of their points, that VTK finds by origin
 * and spacing, rounding is no difference.
 */

#ifndef SkdInnerFaces_h
#define SkdInnerFaces_h

#include "Core/Geometry/Rows.h"
#include "Core/Geometry/Vector.h"
#include "Pipeline/SkdVolumeCells.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <optional>
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
  void Add(std::size_t piece, const std::vector<skd::Vector3>& corners, const skd::Vector3& within);

  /// For each face whether it is inside the mesh. O(n log n).
  std::vector<unsigned char> Find();

  ///@{
  /// After Find. The numbers of a face's corners: those of several pieces at one point have one.
  auto GetCorners(std::size_t face) const { return this->Corners[face]; }

  /// Where a corner is, of all pieces the same.
  const skd::Vector3& GetPoint(vtkIdType corner) const
  {
    return this->Points[static_cast<std::size_t>(corner)];
  }
  std::size_t GetNumberOfPoints() const { return this->Points.size(); }

  /// The corners of a face, and between them those of smaller ones that lie on its sides, given
  /// which corners count. O(log n) and what is found.
  void FindAllCorners(std::size_t face, const std::vector<unsigned char>& counts,
    std::vector<vtkIdType>& corners) const;
  ///@}

private:
  /// Where a corner is among the coordinates of corners along a lattice's axes; the lattice is -1
  /// of corners of other cells.
  struct Position
  {
    int Lattice = -1;
    std::array<int, 3> Ranks{};

    /// Of positions on one line along an axis only the last number differs.
    std::array<int, 4> AlongLast(std::size_t axis) const
    {
      return { this->Lattice, this->Ranks[(axis + 1) % 3], this->Ranks[(axis + 2) % 3],
        this->Ranks[axis] };
    }
  };

  struct Rectangle;
  class Numbering;

  int LatticeOf(std::size_t face) const { return this->LatticeOfPiece[this->PieceOf[face]]; }
  const Position& PositionOf(vtkIdType corner) const
  {
    return this->Positions[static_cast<std::size_t>(corner)];
  }
  static std::optional<std::size_t> AxisBetween(const Position& from, const Position& to);
  void FindRanks(int lattice);
  void NumberCorners();
  bool AreOnOppositeSides(std::size_t first, std::size_t second) const;
  void FindEqual(std::vector<unsigned char>& isInner) const;
  bool FindRectangle(std::size_t face, Rectangle& rectangle) const;
  void FindCovered(int lattice, std::vector<unsigned char>& isInner) const;
  void SortCorners();
  void AddCornersBetween(vtkIdType from, vtkIdType to, std::vector<vtkIdType>& corners) const;

  std::vector<SkdVoxelLattice> Lattices; // of different axes
  std::vector<int> LatticeOfPiece;       // -1: none
  std::vector<skd::Vector3> SizeOfPiece; // the least of its voxels
  ///@{
  /// As they were added: the corners of all faces, face by face.
  std::vector<skd::Vector3> Given;
  std::vector<Position> GivenPositions;
  std::vector<std::size_t> FirstGiven = std::vector<std::size_t>(1, 0); // by face, and the end
  std::vector<std::size_t> PieceOf;
  std::vector<skd::Vector3> Within;
  ///@}
  skd::Rows<vtkIdType> Corners; // numbers, by face
  ///@{
  /// By number.
  std::vector<skd::Vector3> Points;
  std::vector<Position> Positions;
  ///@}
  std::array<std::vector<vtkIdType>, 3> OnLines; // corners, along each axis line by line
};
}

#endif
