// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_InverseMap_h
#define skd_Geometry_Cells_InverseMap_h

#include "../ForEachAxis.h"
#include "../Tolerances.h"
#include "LinearShapes.h"
#include "TrilinearRoot.h"

namespace skd
{

/// The inverse of a shape's map at one point x. This is that of shapes whose map is trilinear;
/// others have a specialisation.
template <class Shape>
class InverseMap
{
public:
  InverseMap(const Vector3* points, const Vector3& x)
  {
    PaddedVector corners[8];
    Shape::CubeCorners(points, corners);
    const PaddedVector origin(x);
    ForEachAxis<8>([&](int i) { corners[i] = corners[i] - origin; });
    this->Map = TrilinearMap(corners);
  }

  /// Parametric coordinates of x as far as the map is linear; in the domain or not, even NaN.
  Vector3 Guess() const
  {
    const PaddedVector* c = this->Map.Term;
    return FromCube(-1.0 * Matrix3{ { c[1], c[2], c[4] } }.Solve(c[0]));
  }

  /// Parametric coordinates that give x, and are in the domain, both to within rounding. None if x
  /// is not in the cell.
  std::optional<Vector3> Find(const Vector3& guess) const
  {
    const double tolerance = tolerances::Residual * this->Map.Size();
    const auto isInCell = [&](const Vector3& u)
    {
      const Vector3 p = FromCube(u);
      return Shape::InDomain(p) ||
        MaxNorm(this->Map.At(ToCube(Shape::ClampToDomain(p)))) <= tolerance;
    };
    const auto meetsDomain = [](const ParameterBox& box)
    { return Shape::InDomain(Hexahedron::ClampToDomain(FromCube(box.Lowest()))); };

    std::optional<Vector3> root = NewtonRoot(this->Map, ToCube(guess), tolerance);
    if (!root || !isInCell(*root))
    {
      root = SearchRoot(this->Map, tolerance, isInCell, meetsDomain);
    }
    return root ? FromCube(*root) : root;
  }

private:
  static Vector3 FromCube(const Vector3& u)
  {
    return { { 0.5 + 0.5 * u[0], 0.5 + 0.5 * u[1], 0.5 + 0.5 * u[2] } };
  }
  static Vector3 ToCube(const Vector3& p)
  {
    return { { 2.0 * p[0] - 1.0, 2.0 * p[1] - 1.0, 2.0 * p[2] - 1.0 } };
  }

  TrilinearMap Map;
};

}

#endif
