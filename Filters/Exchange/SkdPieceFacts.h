// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPieceFacts_h
#define SkdPieceFacts_h

#include "Core/Geometry/Box.h"
#include "Exchange/SkdNearPoints.h"
#include "Exchange/SkdTransport.h"
#include "vtkDataSet.h"
#include "vtkType.h"

#include <array>
#include <vector>

namespace skdtree
{
/// What every process knows of each piece of a mesh.
struct SkdPieceFacts
{
  vtkIdType Points = 0;
  vtkIdType Cells = 0;
  int DataObjectType = 0;
  bool IsSurface = false; // vtkPolyData
  bool HasPointIds = false;
  bool HasCellIds = false;
  bool HasDuplicates = false;
  bool IsSingle = false;
  bool IsGrid = false;
  SkdPointMagnitudes Magnitudes;
  skd::Box3 Bounds;                 // of the points that have distances
  std::array<int, 6> Extent{};      // of grids
  std::array<double, 15> Lattice{}; // of images: origin, spacing and directions
};

/// Those of the pieces that are not empty, of which a joined mesh is made.
class SkdAllFacts
{
public:
  /// Of the pieces of all processes, which call it together.
  SkdAllFacts(SkdTransport& transport, vtkDataSet* own);

  const SkdPieceFacts& Of(int process) const
  {
    return this->Pieces[static_cast<std::size_t>(process)];
  }
  bool IsFull(int process) const
  {
    return this->Of(process).Points > 0 || this->Of(process).Cells > 0;
  }

  /// The processes whose pieces are not empty, ascending.
  const std::vector<int>& GetFull() const { return this->Full; }

  /// Whether there is only one piece, and nothing in it is a duplicate: it is the mesh.
  bool IsOnePiece() const;

  bool AreSurfaces() const;
  bool HavePointIds() const;
  bool HaveCellIds() const;

  /// The largest magnitude of a coordinate.
  double GetLargestCoordinate() const;

  /// That of points of different pieces that may be one.
  SkdRounding GetRounding() const;

  /// Whether the pieces are parts of one grid, and fill the box that encloses them: see
  /// SkdJoinGrids.
  bool FillGrid() const;

  /// That box.
  std::array<int, 6> GetGridExtent() const;

private:
  template <class Is>
  bool AreAll(const Is& is) const;
  bool AreOfOneGrid() const;

  std::vector<SkdPieceFacts> Pieces; // by process
  std::vector<int> Full;
};
}

#endif
