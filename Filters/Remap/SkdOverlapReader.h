// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdOverlapReader.h
 * @brief Cuts cells into convex pieces.
 */

#ifndef SkdOverlapReader_h
#define SkdOverlapReader_h

#include "Cells/Curved/SkdCurvedSides.h"
#include "Cells/Kernels/SkdCellWeights.h"
#include "Cells/Search/SkdCellTree.h"
#include "Core/Geometry/Overlap/LonLatCell.h"
#include "Core/Geometry/Simplices/SimplexSet.h"
#include "Remap/SkdOverlapBlock.h"
#include "Remap/SkdOverlapSurface.h"

namespace skdtree
{
/// Reads cells into a block, one after the other; one a thread.
class SkdOverlapReader
{
public:
  SkdOverlapReader(const SkdCellTree& tree, const SkdCellSource& source,
    const SkdOverlapSurface& surface, const SkdOverlapReading& reading, SkdOverlapBlock& block)
    : Tree(tree)
    , Source(source)
    , Surface(surface)
    , Reading(reading)
    , Block(block)
  {
  }

  /// Adds the pieces of a cell, none of one that has no extent, or another dimension, and its mark.
  void Read(std::uint32_t cell);

private:
  struct Corner
  {
    skd::Vector3 X;
    vtkIdType Id; ///< negative of one that is no point of the mesh (SkdOverlapBlock::PointIds)
  };
  using Corners = std::vector<Corner>;

  void AddPieces(std::uint32_t cell);
  void Gather(std::uint32_t cell);
  void ReadSimplices(std::uint32_t cell);
  void AddSimplices();

  ///@{
  /// SkdOverlapCurved.cxx: cells that VTK's own class knows
  void ReadGeneric(std::uint32_t cell);
  void AddPrism(std::uint32_t cell, vtkCell* loaded);
  void AddQuadraticPolygon();
  void AddCurved(std::uint32_t cell, vtkCell* loaded);
  void AddCurvedSolid(vtkCell* loaded);
  ///@}

  ///@{
  /// SkdOverlapCurved.cxx: corners that are no points of the mesh
  void WeighCorners(int cellType, const std::vector<skd::Vector3>& parameters);
  void WeighSides(Corners& corners);
  vtkIdType WeighMiddle(const Corners& corners);
  const double* WeightsOf(const Corner& corner) const;
  const double* WeightsAt(const skd::Vector3& pcoords, const skd::Vector3& x);
  ///@}

  ///@{
  /// Weights of the cell's points, as corners have them that are no points.
  vtkIdType AddWeights(const double* weights);
  vtkIdType AddMeanOf(const Corners& corners);
  void TakeOwnPoints();
  std::size_t NumberOfOwnPoints() const;
  ///@}

  ///@{
  /// SkdOverlapPolygons.cxx
  void AddSegment(const Corner& a, const Corner& b);
  void AddWholePolygon();
  void AddPolygon(Corners& corners);
  void AddFacets(Corners& corners);
  void Reverse(Corners& corners);
  bool AddLonLat(const Corners& corners);
  void AddLonLatPieces(const skd::LonLatCell& whole);
  void AddLarge(Corners& corners);
  void AddSplit(const Corners& corners, std::int8_t sign);
  template <class Frame>
  void AddPiece(const Corners& corners, std::int8_t sign);
  template <class Frame>
  void AddVisible(const Frame& frame, Corners& corners);
  ///@}

  ///@{
  /// SkdOverlapSolids.cxx
  void AddFixed(SkdShape shape);
  void AddSolid(const skd::SolidTopology& topology, bool isOwn);
  void AddPolyhedron(const SkdPolyCell& cell);
  void AddHull(std::vector<std::vector<int>> faces);
  bool AreFlat(const std::vector<std::vector<int>>& faces) const;
  void AddTetrahedra(const std::vector<std::vector<int>>& faces);
  void AddTetrahedron(const Corner (&corners)[4], std::int8_t sign);
  void AddSigned(const Corner& apex, const Corner& a, const Corner& b, const Corner& c);
  ///@}

  SkdOverlapPiece& Add(const Corner* corners, std::size_t size);

  const SkdCellTree& Tree;
  const SkdCellSource& Source;
  const SkdOverlapSurface& Surface;
  const SkdOverlapReading& Reading;
  SkdOverlapBlock& Block;
  SkdPolygonMark Mark;            ///< of the cell
  Corners CellPoints;             ///< the cell's points, on the surface
  std::vector<skd::Vector3> Flat; ///< a polygon's corners in its frame
  skd::SimplexSet Simplices;
  SkdCurvedSides Sides;
  SkdCellWeights Functions;
};
}

#endif
