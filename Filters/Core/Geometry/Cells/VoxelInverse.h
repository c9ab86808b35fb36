// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_VoxelInverse_h
#define skd_Geometry_Cells_VoxelInverse_h

#include "../Tolerances.h"
#include "InverseMap.h"
#include "LinearShapes.h"

namespace skd
{

/// The inverse of an affine map.
template <>
class InverseMap<Voxel>
{
public:
  InverseMap(const Vector3* points, const Vector3& x)
    : FromOrigin(x - points[0])
    , Edges{ { points[1] - points[0], points[2] - points[0], points[4] - points[0] } }
  {
  }

  Vector3 Guess() const { return this->Edges.Solve(this->FromOrigin); }

  std::optional<Vector3> Find(const Vector3& guess) const
  {
    const PaddedVector* edges = this->Edges.Columns;
    const double tolerance = tolerances::Residual *
      (MaxNorm(edges[0]) + MaxNorm(edges[1]) + MaxNorm(edges[2]) + MaxNorm(this->FromOrigin));
    const Vector3 refined = guess + this->Edges.Solve(this->Residual(guess));
    for (const Vector3& p : { guess, refined })
    {
      if (MaxNorm(this->Residual(Voxel::ClampToDomain(p))) <= tolerance)
      {
        return p;
      }
    }
    return std::nullopt;
  }

private:
  PaddedVector Residual(const Vector3& p) const
  {
    const PaddedVector* edges = this->Edges.Columns;
    return this->FromOrigin - p[0] * edges[0] - p[1] * edges[1] - p[2] * edges[2];
  }

  Vector3 FromOrigin;
  Matrix3 Edges;
};

}

#endif
