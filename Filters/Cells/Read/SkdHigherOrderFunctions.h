// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdHigherOrderFunctions_h
#define SkdHigherOrderFunctions_h

#include <array>
#include <cstdint>
#include <vector>

class vtkCell;

namespace skdtree
{
/// The interpolation functions of Lagrange and Bezier triangles, tetrahedra and wedges but for
/// rational weights: of each point a product of one factor for each barycentric coordinate, from a
/// table. VTK's own take far longer: those of Bezier cells are by a recursion that branches at each
/// degree, and take milliseconds of a tetrahedron of order 5. Equal to VTK's but for rounding.
class SkdHigherOrderFunctions
{
public:
  /// Those of a cell, which is not a vtkGenericCell; nullptr of other types, of a number of points
  /// that makes no order, and of an order above 24. Valid until the thread's next call.
  static const SkdHigherOrderFunctions* Of(vtkCell* cell);

  /// Sets as many values as the cell has points.
  void Evaluate(const double pcoords[3], double* values) const;

private:
  static constexpr int Coordinates = 6;
  static constexpr int HighestDegree = 24;

  /// The type, the degree of its triangle or tetrahedron and that along a wedge, and the number of
  /// points.
  struct Key
  {
    int Type = -1;
    int Degree = 0;
    int Along = 0;
    int Size = 0;
    bool operator==(const Key& other) const;
  };
  /// Where a point is on the lattice: along up to three axes of a triangle or tetrahedron, what
  /// these leave of its degree, along a wedge, and what that leaves.
  using Powers = std::array<std::uint8_t, Coordinates>;

  static Key KeyOf(vtkCell* cell);
  void Set(const Key& key);
  bool IsBezier() const;
  /// The factors of a coordinate, by how far on the lattice a point is along it.
  void Fill(double x, int degree, double (&factors)[HighestDegree + 1]) const;

  Key TheKey;
  int SimplexAxes = 0;
  bool IsUsable = false;
  double Scale = 1.0; ///< of all values: what factors are divided by
  std::vector<Powers> PowersOf;
};
}

#endif
