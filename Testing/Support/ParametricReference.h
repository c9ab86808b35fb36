// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ParametricReference.h
 * @brief the nearest point of a curved cell, sought in its parametric coordinates
 *
 * A curved cell is what its interpolation (vtkCell::EvaluateLocation) makes of its parametric
 * domain. That of Bezier simplices and wedges is by SkdCellFunctions, which
 * TestHigherOrderFunctions compares with VTK's: this takes milliseconds a point.
 */
#ifndef skdtest_ParametricReference_h
#define skdtest_ParametricReference_h

#include "Cells/Read/SkdCellFunctions.h"
#include "Support/CellZoo.h"

namespace skdtest
{

enum class Domain
{
  None, // cells that have no coordinates of their own
  Cube, // of the cell's dimension
  Simplex,
  Prism,
  Pyramid // its base at a height of 0.5, its tip at (0.5, 0.5, 1)
};

inline Domain DomainOf(int type)
{
  switch (type)
  {
    case VTK_QUADRATIC_TRIANGLE:
    case VTK_BIQUADRATIC_TRIANGLE:
    case VTK_QUADRATIC_TETRA:
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_LAGRANGE_TETRAHEDRON:
    case VTK_BEZIER_TRIANGLE:
    case VTK_BEZIER_TETRAHEDRON:
      return Domain::Simplex;
    case VTK_QUADRATIC_WEDGE:
    case VTK_QUADRATIC_LINEAR_WEDGE:
    case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
    case VTK_LAGRANGE_WEDGE:
    case VTK_BEZIER_WEDGE:
      return Domain::Prism;
    case VTK_TRIQUADRATIC_PYRAMID:
      return Domain::Pyramid;
    case VTK_QUADRATIC_POLYGON:
      return Domain::None;
    default:
      return type >= VTK_QUADRATIC_EDGE && type != VTK_CONVEX_POINT_SET && type != VTK_POLYHEDRON
        ? Domain::Cube
        : Domain::None;
  }
}

class ParametricCell
{
public:
  explicit ParametricCell(vtkCell* cell)
    : Cell(cell)
    , Weights(cell->GetNumberOfPoints())
    , Lowest(cell->GetCellType() == VTK_CUBIC_LINE ? -1.0 : 0.0)
  {
  }

  int Dimension() const { return this->Cell->GetCellDimension(); }

  Point At(const Point& pcoords)
  {
    switch (this->Cell->GetCellType())
    {
      case VTK_BEZIER_TRIANGLE:
      case VTK_BEZIER_TETRAHEDRON:
      case VTK_BEZIER_WEDGE:
        return this->ByFunctions(pcoords);
      default:
        return this->ByVtk(pcoords);
    }
  }

  bool Contains(const Point& p) const
  {
    const double low = this->Lowest;
    const double sum = p[0] + p[1];
    switch (DomainOf(this->Cell->GetCellType()))
    {
      case Domain::Simplex:
        return std::min({ p[0], p[1], p[2] }) >= 0 && sum + p[2] <= 1;
      case Domain::Prism:
        return std::min({ p[0], p[1], p[2] }) >= 0 && sum <= 1 && p[2] <= 1;
      case Domain::Pyramid:
        return p[2] >= 0.5 && std::max(std::abs(p[0] - 0.5), std::abs(p[1] - 0.5)) <= 1 - p[2];
      default:
        return p[0] >= low && std::min(p[1], p[2]) >= 0 && std::max({ p[0], p[1], p[2] }) <= 1;
    }
  }

  /// From the best of a lattice of samples to ever nearer ones. An upper bound, and sharp but for
  /// cells that are bent so much that the wrong valley is descended.
  double DistanceTo(const Point& x)
  {
    const Point middle = { 0.5 * (1 + this->Lowest), 0.5, 0.5 };
    const double* first = this->Cell->GetParametricCoords();
    Point best = { first[0], first[1], first[2] };
    double least = Distance(this->At(best), x);
    this->Improve(x, best, least, middle, 1.0 / 8, 4);
    for (double step = 1.0 / 8; step > 1e-8; step *= 0.5)
    {
      for (int turn = 0; turn < 20 && this->Improve(x, best, least, best, step, 1); ++turn)
      {
      }
    }
    return least;
  }

private:
  Point ByVtk(const Point& pcoords)
  {
    Point x;
    int subId = 0;
    this->Cell->EvaluateLocation(subId, pcoords.data(), x.data(), this->Weights.data());
    return x;
  }

  Point ByFunctions(const Point& pcoords)
  {
    skdtree::SkdCellFunctions::Interpolate(this->Cell, pcoords.data(), this->Weights.data());
    Point sum{ 0.0, 0.0, 0.0 };
    for (std::size_t i = 0; i < this->Weights.size(); ++i)
    {
      Point point;
      this->Cell->GetPoints()->GetPoint(static_cast<vtkIdType>(i), point.data());
      sum = sum + this->Weights[i] * point;
    }
    return sum;
  }

  /// The best of (2 n + 1)^dimension points around a middle. True if it is better than before.
  bool Improve(const Point& x, Point& best, double& least, const Point& middle, double step, int n)
  {
    const int dimension = this->Cell->GetCellDimension();
    const double before = least;
    const int ns[3] = { n, dimension > 1 ? n : 0, dimension > 2 ? n : 0 };
    const double width = 1 - this->Lowest;
    for (int i = -ns[0]; i <= ns[0]; ++i)
    {
      for (int j = -ns[1]; j <= ns[1]; ++j)
      {
        for (int k = -ns[2]; k <= ns[2]; ++k)
        {
          Point p = middle + step * Point{ width * i, double(j), double(k) };
          p[1] = dimension > 1 ? p[1] : 0.0;
          p[2] = dimension > 2 ? p[2] : 0.0;
          const double distance = this->Contains(p) ? Distance(this->At(p), x) : least;
          if (distance < least)
          {
            least = distance;
            best = p;
          }
        }
      }
    }
    return least < before;
  }

  vtkCell* Cell;
  std::vector<double> Weights;
  double Lowest;
};

}

#endif
