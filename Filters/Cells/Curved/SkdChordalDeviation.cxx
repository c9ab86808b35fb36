// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Curved/SkdChordalDeviation.h"

#include "Cells/Kernels/SkdParametricCell.h"
#include "Cells/Read/SkdCellFunctions.h"
#include "Cells/Read/SkdTolerances.h"
#include "Core/Geometry/Box.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skdtree
{
namespace
{
bool IsPyramid(int cellType)
{
  return cellType == VTK_QUADRATIC_PYRAMID || cellType == VTK_TRIQUADRATIC_PYRAMID;
}

/// The weights of the corners of a straight cell. Returns their number.
int StraightWeights(
  const SkdParametricCell& cell, bool isPyramid, const skd::Vector3& p, double (&weights)[8])
{
  const skd::ParameterDomain& domain = cell.Domain();
  const bool isSimplex = &domain == &skd::UnitTriangle || &domain == &skd::UnitPrism;
  const double base[4] = { isSimplex ? 1.0 - p[0] - p[1] : (1.0 - p[0]) * (1.0 - p[1]),
    isSimplex ? p[0] : p[0] * (1.0 - p[1]), isSimplex ? p[1] : p[0] * p[1], (1.0 - p[0]) * p[1] };
  const int size = isSimplex ? 3 : 4;
  if (&domain == &skd::UnitTetrahedron)
  {
    const double simplex[4] = { 1.0 - p[0] - p[1] - p[2], p[0], p[1], p[2] };
    std::copy_n(simplex, 4, weights);
    return 4;
  }
  if (domain.Dimension < 3)
  {
    std::copy_n(base, size, weights);
    return domain.Dimension == 1 ? 2 : size;
  }
  for (int i = 0; i < size; ++i)
  {
    weights[i] = (1.0 - p[2]) * base[i];
    weights[size + i] = p[2] * base[i];
  }
  weights[4] = isPyramid ? p[2] : weights[4];
  return isPyramid ? 5 : 2 * size;
}

/// The largest sum of magnitudes of the weights from a first point on, over the domain: the best of
/// a lattice, improved by ever smaller steps, and a little more for safety.
class LargestSum
{
public:
  LargestSum(const SkdParametricCell& cell, vtkCell* source, int first)
    : Cell(cell)
    , Source(source)
    , First(first)
    , Weights(static_cast<std::size_t>(cell.NumberOfPoints()))
  {
  }

  double Find()
  {
    constexpr int coarse[4] = { 0, 16, 8, 6 };
    constexpr int fine[4] = { 0, 256, 48, 16 };
    const bool isQuadratic = this->Cell.NumberOfPoints() <= 27;
    const int n = (isQuadratic ? coarse : fine)[this->Cell.Domain().Dimension];
    this->Look({ { 0.5, 0.5, 0.5 } }, 0.5 / n, n);
    for (double step = 0.5 / n; step > SkdTolerances::DeviationStep; step *= 0.5)
    {
      this->Look(this->Where, step, 1);
    }
    return 1.02 * this->Largest;
  }

private:
  /// (2 n + 1)^dimension points around a middle.
  void Look(const skd::Vector3 middle, double step, int n)
  {
    const int dimension = this->Cell.Domain().Dimension;
    const int n1 = dimension > 1 ? n : 0;
    const int n2 = dimension > 2 ? n : 0;
    for (int i = -n; i <= n; ++i)
    {
      for (int j = -n1; j <= n1; ++j)
      {
        for (int k = -n2; k <= n2; ++k)
        {
          this->Try({ { middle[0] + i * step, dimension > 1 ? middle[1] + j * step : 0.0,
            dimension > 2 ? middle[2] + k * step : 0.0 } });
        }
      }
    }
  }

  void Try(const skd::Vector3& point)
  {
    const skd::Vector3 p = skd::Clamped(this->Cell.Domain(), point);
    SkdCellFunctions::Interpolate(this->Source, this->Cell.ToVTK(p).X, this->Weights.data());
    double sum = 0.0;
    for (auto i = static_cast<std::size_t>(this->First); i < this->Weights.size(); ++i)
    {
      sum += std::abs(this->Weights[i]);
    }
    if (sum > this->Largest)
    {
      this->Largest = sum;
      this->Where = p;
    }
  }

  const SkdParametricCell& Cell;
  vtkCell* Source;
  int First;
  std::vector<double> Weights;
  skd::Vector3 Where{ { 0.5, 0.5, 0.5 } };
  double Largest = 0.0;
};
}

//------------------------------------------------------------------------------
SkdChordalDeviation::SkdChordalDeviation(vtkDataSet* data)
  : Data(data)
  , Degrees(data->GetCellData()->GetHigherOrderDegrees())
{
}

//------------------------------------------------------------------------------
SkdChordalDeviation::~SkdChordalDeviation() = default;

//------------------------------------------------------------------------------
SkdChordalDeviation::Kind SkdChordalDeviation::MakeKind(vtkCell* cell)
{
  const SkdParametricCell map(cell, { { 0.0, 0.0, 0.0 } });
  const bool isPyramid = IsPyramid(cell->GetCellType());
  Kind kind;
  double weights[8];
  kind.Corners = StraightWeights(map, isPyramid, { { 0.0, 0.0, 0.0 } }, weights);
  for (int i = kind.Corners; i < map.NumberOfPoints(); ++i)
  {
    StraightWeights(map, isPyramid, map.ParametersOfPoint(i), weights);
    kind.Straight.insert(kind.Straight.end(), weights, weights + kind.Corners);
  }
  kind.Sum = LargestSum(map, cell, kind.Corners).Find();
  return kind;
}

//------------------------------------------------------------------------------
const SkdChordalDeviation::Kind& SkdChordalDeviation::KindOf(
  vtkIdType cellId, int cellType, int size)
{
  std::vector<int> key = { cellType, size };
  for (int i = 0; this->Degrees && i < this->Degrees->GetNumberOfComponents(); ++i)
  {
    key.push_back(static_cast<int>(this->Degrees->GetComponent(cellId, i)));
  }
  auto found = this->Kinds.find(key);
  if (found == this->Kinds.end())
  {
    this->Data->GetCell(cellId, this->Scratch);
    found = this->Kinds.emplace(key, MakeKind(this->Scratch->GetRepresentativeCell())).first;
  }
  return found->second;
}

//------------------------------------------------------------------------------
double SkdChordalDeviation::FactorOf(const Kind& kind, const skd::Vector3* points, int size)
{
  skd::Vector3 largest{ { 0.0, 0.0, 0.0 } };
  skd::Box3 corners;
  skd::Box3 all;
  const double* weight = kind.Straight.data();
  for (int i = 0; i < size; ++i)
  {
    all.Add(points[i]);
    if (i < kind.Corners)
    {
      corners.Add(points[i]);
      continue;
    }
    skd::Vector3 straight{ { 0.0, 0.0, 0.0 } };
    for (int corner = 0; corner < kind.Corners; ++corner)
    {
      straight = straight + *weight++ * (points[corner] - points[i]);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      largest[axis] = std::max(largest[axis], std::abs(straight[axis]));
    }
  }
  double factor = 1.0;
  const skd::Vector3 centre = all.Centroid();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double half = 0.5 * (all.Max[axis] - all.Min[axis]);
    const double bound = kind.Sum * largest[axis] +
      std::max(corners.Max[axis] - centre[axis], centre[axis] - corners.Min[axis]);
    factor = half > 0.0 ? std::max(factor, bound / half) : factor;
  }
  return factor;
}

//------------------------------------------------------------------------------
double SkdChordalDeviation::FactorOf(
  vtkIdType cellId, int cellType, const skd::Vector3* points, int size)
{
  const bool isBezier = cellType >= VTK_BEZIER_CURVE && cellType <= VTK_BEZIER_PYRAMID;
  if (isBezier || !SkdParametricCell::DomainOf(cellType))
  {
    return 1.0;
  }
  constexpr double rounding = 1.0 + 64.0 * std::numeric_limits<double>::epsilon();
  const double factor = FactorOf(this->KindOf(cellId, cellType, size), points, size);
  return factor > rounding ? factor : 1.0;
}
}
