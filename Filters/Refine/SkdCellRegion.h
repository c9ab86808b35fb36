// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCellRegion.h
 * @brief The room that a cell of a mesh under refinement takes.
 *
 * Of a volume cell that is what its faces enclose, of four nodes two triangles each. Where a field
 * is looked up on a line or a surface, points and cells count that are beside it, too, across it by
 * half of the cell's radius: so a field on a finer or smoother version of a curved surface is met.
 * Parts must truly meet the cell.
 */

#ifndef SkdCellRegion_h
#define SkdCellRegion_h

#include "Core/Mesh/RefinedMesh.h"
#include "Refine/SkdRegion.h"

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

#endif
