// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Curved/SkdCurvedSimplices.h"

#include "Cells/Kernels/SkdParametricCell.h"
#include "Core/Geometry/Cells/LinearShapes.h"

#include "vtkCell.h"

namespace skdtree
{
namespace
{
using skd::SimplexSet;
using skd::Vector3;

/// A curved cell on a lattice of integer parameters, so that faces share the points of their edges.
class CurvedCell
{
public:
  static constexpr int Parts = 8;
  using GridPoint = std::array<int, 3>;

  CurvedCell(vtkCell* cell, const skd::Box3& bounds, SimplexSet& set, std::vector<Vector3>* found)
    : Origin(bounds.Centroid())
    , Cell(cell, this->Origin)
    , Set(set)
    , Found(found)
  {
  }

  void Read()
  {
    const skd::ParameterDomain& domain = this->Cell.Domain();
    this->Set.Clear(domain.Dimension);
    if (domain.Dimension == 1)
    {
      this->AddCurve();
    }
    else if (domain.Dimension == 2)
    {
      this->AddPatch({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, domain.Size == 3);
    }
    else if (&domain == &skd::UnitCube)
    {
      this->AddFaces<skd::Hexahedron>();
    }
    else if (&domain == &skd::UnitPrism)
    {
      this->AddFaces<skd::Wedge>();
    }
    else
    {
      this->AddFaces<skd::Tetrahedron>();
    }
  }

private:
  void AddCurve()
  {
    for (int i = 0; i < Parts; ++i)
    {
      const int a = this->At({ i, 0, 0 });
      const int b = this->At({ i + 1, 0, 0 });
      this->Set.AddSimplex(a, b, b);
    }
  }

  /// The faces of these domains are triangles and parallelograms.
  template <class Shape>
  void AddFaces()
  {
    for (const auto& face : Shape::Faces)
    {
      const bool isTriangle = face[3] < 0;
      const double* corners[3] = { Shape::Corners[face[0]], Shape::Corners[face[1]],
        Shape::Corners[isTriangle ? face[2] : face[3]] };
      GridPoint first, alongR, alongS;
      for (int axis = 0; axis < 3; ++axis)
      {
        const auto from = static_cast<int>(corners[0][axis]);
        first[axis] = Parts * from;
        alongR[axis] = static_cast<int>(corners[1][axis]) - from;
        alongS[axis] = static_cast<int>(corners[2][axis]) - from;
      }
      this->AddPatch(first, alongR, alongS, isTriangle);
    }
  }

  void AddPatch(
    const GridPoint& first, const GridPoint& alongR, const GridPoint& alongS, bool isTriangle)
  {
    const auto at = [&](int r, int s)
    {
      GridPoint gridPoint;
      for (int axis = 0; axis < 3; ++axis)
      {
        gridPoint[axis] = first[axis] + r * alongR[axis] + s * alongS[axis];
      }
      return this->At(gridPoint);
    };
    for (int r = 0; r < Parts; ++r)
    {
      const int last = isTriangle ? Parts - r : Parts;
      for (int s = 0; s < last; ++s)
      {
        this->Set.AddSimplex(at(r, s), at(r + 1, s), at(r, s + 1));
        if (!isTriangle || s + 1 < last)
        {
          this->Set.AddSimplex(at(r + 1, s), at(r + 1, s + 1), at(r, s + 1));
        }
      }
    }
  }

  int At(const GridPoint& gridPoint)
  {
    int& number = this->Numbers[gridPoint[0]][gridPoint[1]][gridPoint[2]];
    if (number == 0)
    {
      constexpr double part = 1.0 / Parts;
      const Vector3 parameters{ { part * gridPoint[0], part * gridPoint[1], part * gridPoint[2] } };
      number = this->Set.Add(this->Origin + this->Cell.Value(parameters)) + 1;
      if (this->Found)
      {
        this->Found->push_back(parameters);
      }
    }
    return number - 1;
  }

  Vector3 Origin;
  SkdParametricCell Cell;
  SimplexSet& Set;
  std::vector<Vector3>* Found;                       // parameters of points
  int Numbers[Parts + 1][Parts + 1][Parts + 1] = {}; // of points that are there, from 1
};
}

//------------------------------------------------------------------------------
void SkdReadCurved(skd::SimplexSet& set, vtkCell* cell, const skd::Box3& bounds,
  std::vector<skd::Vector3>* parameters)
{
  CurvedCell(cell, bounds, set, parameters).Read();
}
}
