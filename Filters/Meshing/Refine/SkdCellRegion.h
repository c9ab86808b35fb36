// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCellRegion.h
 * @brief The region of a cell of a mesh under refinement.
 *
 * For a volume cell it is enclosed by its faces, those of four nodes as two triangles each. On
 * lines and surfaces, field points and cells within half of the cell's radius are included, so that
 * a field on a finer or smoother version of a curved surface is found. Parts must intersect the
 * cell itself.
 */

#ifndef SkdCellRegion_h
#define SkdCellRegion_h

#include "Core/Meshing/Mesh/RefinedMesh.h"
#include "Meshing/Refine/SkdRegion.h"

namespace skdtree
{
class SkdCellRegion : public SkdRegion
{
public:
  SkdCellRegion(const skd::RefinedMesh& mesh, std::uint32_t cell);

  const skd::SimplexSet& GetSet(skd::SimplexSet&) const override { return this->Set; }
  int GetNumberOfSamples() const override { return static_cast<int>(this->Set.Points.size()) + 1; }
  skd::Vector3 GetSample(int i) const override
  {
    return i == 0 ? this->Middle : this->Set.Points[static_cast<std::size_t>(i) - 1];
  }
  bool Contains(const skd::Vector3& x) const override;
  bool Meets(const SkdCellTree& tree, std::uint32_t cell, SkdOverlapTest test) const override;

private:
  void AddSelf();
  void AddFaces(skd::CellKind kind);
  bool IsBeside(const skd::Vector3& x, const skd::SimplexSet::Simplex& simplex) const;

  skd::SimplexSet Set;
  bool IsVolume;
};
}

#endif
