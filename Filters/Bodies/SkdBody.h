// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBody_h
#define SkdBody_h

#include "Bodies/SkdBoundary.h"
#include "Bodies/SkdOpenSolid.h"
#include "Bodies/SkdSolid.h"
#include "Pipeline/SkdSourceTrees.h"
#include "vtkSkdTreeCellLocator.h"

#include <memory>
#include <optional>
#include <vector>

namespace skdtree
{
/// The nearest of the faces of a boundary, given their tree, as the cell that it is of; ties go to
/// the first. Thread-safe.
std::optional<SkdNearest> SkdFindNearestFace(vtkSkdTreeCellLocator* faces,
  const std::vector<SkdBoundary::Origin>& origins, const double x[3], double maximumDistance);

/// What blocks enclose: their boundary, the trees of its triangles, and what decides which points
/// are inside. See SkdBoundary for the difference between its faces and its surface.
class SkdBody
{
public:
  SkdBody() = default;

  /// The boundary, with curved faces as facets within a length. Trees are not built yet.
  SkdBody(const std::vector<SkdBlock>& blocks, double chordalLength);

  /// Builds the trees unless they have this tolerance already, and for a boundary that is open,
  /// what decides there if it is wanted. Returns the number of trees built.
  int Build(double epsilon, bool wantsOpenSolid);

  bool HasBoundary() const { return this->Faces != nullptr; }
  const SkdBoundary& GetBoundary() const { return this->Boundary; }
  vtkSkdTreeCellLocator* GetFaces() const { return this->Faces; }
  vtkSkdTreeCellLocator* GetSurface() const { return this->Surface; } ///< often that of the faces

  /// @{ The first for a closed boundary, the second for an open one if it was wanted; else nullptr.
  const SkdSolid* GetSolid() const { return this->Solid.get(); }
  const SkdOpenSolid* GetOpenSolid() const { return this->OpenSolid.get(); }
  /// @}

  /// See SkdFindNearestFace.
  std::optional<SkdNearest> FindNearest(const double x[3], double maximumDistance) const
  {
    return SkdFindNearestFace(this->Faces, this->Boundary.Origins, x, maximumDistance);
  }

private:
  SkdBoundary Boundary;
  vtkSmartPointer<vtkSkdTreeCellLocator> Faces;
  vtkSmartPointer<vtkSkdTreeCellLocator> Surface;
  bool IsBuilt = false;
  std::unique_ptr<SkdSolid> Solid;
  std::unique_ptr<SkdOpenSolid> OpenSolid;
};
}

#endif
