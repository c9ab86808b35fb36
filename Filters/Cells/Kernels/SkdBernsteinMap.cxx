// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Kernels/SkdBernsteinMap.h"

#include "Cells/Kernels/SkdParametricCell.h"
#include "Cells/Read/SkdCellFunctions.h"
#include "Cells/Read/SkdTolerances.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkHigherOrderQuadrilateral.h"
#include "vtkHigherOrderWedge.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>

namespace skdtree
{
namespace
{
using skd::BernsteinLayout;
using skd::BernsteinWeights;

int SimplexAxesOf(const skd::ParameterDomain& domain)
{
  return &domain == &skd::UnitTetrahedron                         ? 3
    : &domain == &skd::UnitTriangle || &domain == &skd::UnitPrism ? 2
                                                                  : 0;
}

/// The least degree of a triangle or a tetrahedron that has so many points.
int SimplexDegree(int axes, int size)
{
  int degree = 1;
  const auto count = [axes](int n)
  { return axes == 2 ? (n + 1) * (n + 2) / 2 : (n + 1) * (n + 2) * (n + 3) / 6; };
  while (count(degree) < size)
  {
    ++degree;
  }
  return degree;
}

/// Calls visit(offset, index) for each coefficient.
template <class Visit>
void ForEachCoefficient(const BernsteinLayout& layout, const Visit& visit)
{
  layout.ForEachRow(0,
    [&](int offset, int degree, const int(&start)[3])
    {
      int index[3] = { start[0], start[1], start[2] };
      for (int i = 0; i <= degree; ++i)
      {
        index[0] = i;
        visit(offset + i, index);
      }
    });
}

skd::Vector3 LatticePoint(const BernsteinLayout& layout, const int (&index)[3])
{
  skd::Vector3 p{};
  for (int axis = 0; axis < layout.Dimension; ++axis)
  {
    p[axis] = static_cast<double>(index[axis]) / layout.Degree[axis];
  }
  return p;
}

/// The functions of a cell's type: of a rational cell, whose own weights may be zero, those with
/// all weights 1, which it has as long as this lives.
class CellFunctions
{
public:
  /// `patch`: parameters are those of one of the cell's patches, unless nullptr.
  CellFunctions(vtkCell* cell, const SkdPatch* patch)
    : Cell(cell)
    , Patch(patch)
    , Weights(SkdCellFunctions::RationalWeights(cell))
  {
    if (this->Weights)
    {
      this->CellsOwn.assign(this->Weights, this->Weights + cell->GetNumberOfPoints());
      std::fill_n(this->Weights, this->CellsOwn.size(), 1.0);
    }
  }
  ~CellFunctions() { std::copy(this->CellsOwn.begin(), this->CellsOwn.end(), this->Weights); }
  CellFunctions(const CellFunctions&) = delete;
  CellFunctions& operator=(const CellFunctions&) = delete;

  void Evaluate(const skd::Vector3& p, double* values) const
  {
    const skd::Vector3 at = this->Patch ? this->Patch->At(p[0], p[1]) : p;
    const skd::Vector3 pcoords = SkdParametricCell::ToVTK(this->Cell->GetCellType(), at);
    SkdCellFunctions::Interpolate(this->Cell, pcoords.X, values);
  }

private:
  vtkCell* Cell;
  const SkdPatch* Patch;
  double* Weights;
  std::vector<double> CellsOwn;
};

/// Values on the lattice of a simplex or an axis become coefficients.
class LatticeInverse
{
public:
  explicit LatticeInverse(const BernsteinLayout& layout)
  {
    ForEachCoefficient(
      layout, [this](int offset, const int(&)[3]) { this->Offsets.push_back(offset); });
    const std::size_t size = this->Offsets.size();
    ForEachCoefficient(layout,
      [&](int, const int(&at)[3])
      {
        const BernsteinWeights weights(layout, LatticePoint(layout, at));
        std::vector<long double> row;
        ForEachCoefficient(
          layout, [&](int, const int(&index)[3]) { row.push_back(weights.Value(index)); });
        row.resize(2 * size, 0.0L);
        row[size + this->Rows.size()] = 1.0L;
        this->Rows.push_back(std::move(row));
      });
    this->Eliminate();
  }

  /// Of the values at the offsets times stride from `first`, which are rows of a matrix.
  void Apply(double* first, int stride, std::size_t columns) const
  {
    const std::size_t size = this->Rows.size();
    std::vector<double> values(size * columns);
    const auto rowAt = [&](std::size_t i)
    { return first + static_cast<std::size_t>(this->Offsets[i] * stride) * columns; };
    for (std::size_t i = 0; i < size; ++i)
    {
      std::copy_n(rowAt(i), columns, values.data() + i * columns);
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      double* row = rowAt(i);
      std::fill_n(row, columns, 0.0);
      for (std::size_t j = 0; j < size; ++j)
      {
        const double factor = static_cast<double>(this->Rows[i][size + j]);
        for (std::size_t k = 0; k < columns && factor != 0.0; ++k)
        {
          row[k] += factor * values[j * columns + k];
        }
      }
    }
  }

private:
  /// Gauss and Jordan's elimination, with the largest pivot.
  void Eliminate()
  {
    const std::size_t size = this->Rows.size();
    for (std::size_t column = 0; column < size; ++column)
    {
      const auto pivot =
        std::max_element(this->Rows.begin() + static_cast<std::ptrdiff_t>(column), this->Rows.end(),
          [column](const auto& a, const auto& b)
          { return std::abs(a[column]) < std::abs(b[column]); });
      std::iter_swap(this->Rows.begin() + static_cast<std::ptrdiff_t>(column), pivot);
      const long double divisor = this->Rows[column][column];
      for (long double& entry : this->Rows[column])
      {
        entry /= divisor;
      }
      for (std::size_t row = 0; row < size; ++row)
      {
        const long double factor = row == column ? 0.0L : this->Rows[row][column];
        for (std::size_t k = column; k < 2 * size && factor != 0.0L; ++k)
        {
          this->Rows[row][k] -= factor * this->Rows[column][k];
        }
      }
    }
  }

  std::vector<int> Offsets;
  std::vector<std::vector<long double>> Rows;
};

/// The cell's functions on the lattice, a row for each of its points and a column for each of the
/// cell's, become those functions' coefficients.
void ToBernstein(const BernsteinLayout& layout, std::size_t columns, double* matrix)
{
  if (layout.SimplexAxes > 0)
  {
    const LatticeInverse inverse({ layout.SimplexAxes, layout.SimplexAxes, layout.Degree });
    for (int i = 0; i <= (layout.SimplexAxes == 2 ? layout.Degree[2] : 0); ++i)
    {
      inverse.Apply(matrix + static_cast<std::size_t>(i * layout.Stride[2]) * columns, 1, columns);
    }
  }
  for (int axis = layout.SimplexAxes; axis < layout.Dimension; ++axis)
  {
    const LatticeInverse inverse({ 1, 0, { layout.Degree[axis], 0, 0 } });
    layout.ForEachRow(axis,
      [&](int offset, int, const int(&)[3])
      {
        inverse.Apply(
          matrix + static_cast<std::size_t>(offset) * columns, layout.Stride[axis], columns);
      });
  }
}

/// Whether the coefficients give the cell's functions elsewhere, too.
bool IsSame(const CellFunctions& functions, const BernsteinLayout& layout,
  const std::vector<double>& matrix, std::size_t columns)
{
  constexpr skd::Vector3 somewhere[] = { { { 0.137, 0.291, 0.413 } }, { { 0.613, 0.229, 0.071 } },
    { { 0.053, 0.713, 0.179 } }, { { 0.31, 0.11, 0.57 } } };
  std::vector<double> expected(columns);
  for (skd::Vector3 p : somewhere)
  {
    for (int axis = layout.Dimension; axis < 3; ++axis)
    {
      p[axis] = 0.0;
    }
    functions.Evaluate(p, expected.data());
    const BernsteinWeights weights(layout, p);
    ForEachCoefficient(layout,
      [&](int offset, const int(&index)[3])
      {
        for (std::size_t i = 0; i < columns; ++i)
        {
          expected[i] -=
            weights.Value(index) * matrix[static_cast<std::size_t>(offset) * columns + i];
        }
      });
    if (!std::all_of(expected.begin(), expected.end(),
          [](double rest) { return std::abs(rest) <= SkdTolerances::SameFunction; }))
    {
      return false;
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
bool SkdBernsteinMap::Key::operator==(const Key& other) const
{
  return this->Type == other.Type && this->Size == other.Size && this->Patch == other.Patch &&
    std::equal(this->Order, this->Order + 3, other.Order);
}

//------------------------------------------------------------------------------
SkdBernsteinMap::Key SkdBernsteinMap::KeyOf(vtkCell* cell)
{
  Key key;
  key.Type = cell->GetCellType();
  key.Size = static_cast<int>(cell->GetNumberOfPoints());
  const auto copy = [&key](const int* order, int axes) { std::copy_n(order, axes, key.Order); };
  auto* generic = vtkGenericCell::SafeDownCast(cell);
  cell = generic ? generic->GetRepresentativeCell() : cell;
  switch (key.Type)
  {
    case VTK_LAGRANGE_QUADRILATERAL:
    case VTK_BEZIER_QUADRILATERAL:
      copy(static_cast<vtkHigherOrderQuadrilateral*>(cell)->GetOrder(), 2);
      break;
    case VTK_LAGRANGE_HEXAHEDRON:
    case VTK_BEZIER_HEXAHEDRON:
      copy(static_cast<vtkHigherOrderHexahedron*>(cell)->GetOrder(), 3);
      break;
    case VTK_LAGRANGE_WEDGE:
    case VTK_BEZIER_WEDGE:
      copy(static_cast<vtkHigherOrderWedge*>(cell)->GetOrder(), 3);
      break;
    default:
      break;
  }
  return key;
}

//------------------------------------------------------------------------------
const SkdBernsteinMap* SkdBernsteinMap::Of(
  vtkCell* cell, const skd::ParameterDomain& domain, int patch)
{
  thread_local const SkdBernsteinMap* lastOf[1 + SkdPatches::Most] = {};
  Key key = KeyOf(cell);
  key.Patch = domain.Dimension < 3 ? NoPatch : patch;
  const SkdBernsteinMap*& last = lastOf[1 + key.Patch];
  if (!last || !(last->TheKey == key))
  {
    last = &Make(cell, domain, key);
  }
  return last->IsUsable ? last : nullptr;
}

//------------------------------------------------------------------------------
const SkdBernsteinMap& SkdBernsteinMap::Make(
  vtkCell* cell, const skd::ParameterDomain& domain, const Key& key)
{
  static std::mutex mutex;
  static std::vector<std::unique_ptr<SkdBernsteinMap>> maps;
  const std::lock_guard<std::mutex> lock(mutex);
  const auto known =
    std::find_if(maps.begin(), maps.end(), [&key](const auto& map) { return map->TheKey == key; });
  if (known != maps.end())
  {
    return **known;
  }
  auto map = std::make_unique<SkdBernsteinMap>();
  map->TheKey = key;
  map->FitAny(cell, domain);
  maps.push_back(std::move(map));
  return *maps.back();
}

//------------------------------------------------------------------------------
void SkdBernsteinMap::FitAny(vtkCell* cell, const skd::ParameterDomain& domain)
{
  const SkdPatch* patch =
    this->TheKey.Patch == NoPatch ? nullptr : SkdPatches::Of(domain).First + this->TheKey.Patch;
  const skd::ParameterDomain& used = patch ? *patch->Domain : domain;
  int ofCell[3] = { 0, 0, 0 };
  int degree[3] = { 0, 0, 0 };
  this->FindDegrees(domain, ofCell);
  for (int axis = 0; axis < used.Dimension; ++axis)
  {
    degree[axis] = ofCell[axis];
    for (int i = 0; patch && i < 3; ++i)
    {
      degree[axis] = patch->Axes[axis][i] > 0.0 ? ofCell[i] : degree[axis];
    }
  }
  // Some types have functions of a higher degree than that of their order.
  constexpr int most = 2;
  for (int more = 0; more <= most && !this->IsUsable; ++more)
  {
    const bool isLow = *std::max_element(degree, degree + 3) <= skd::HighestMapDegree &&
      *std::min_element(degree, degree + used.Dimension) > 0;
    const bool isSmall = used.Dimension < 3 || this->TheKey.Size <= MostPoints;
    this->IsUsable =
      isLow && isSmall && this->Fit(cell, patch, { used.Dimension, SimplexAxesOf(used), degree });
    std::for_each(degree, degree + used.Dimension, [](int& n) { ++n; });
  }
}

//------------------------------------------------------------------------------
void SkdBernsteinMap::FindDegrees(const skd::ParameterDomain& domain, int (&degree)[3]) const
{
  const int simplexAxes = SimplexAxesOf(domain);
  for (int axis = 0; axis < domain.Dimension; ++axis)
  {
    degree[axis] = domain.Dimension == 1 ? this->TheKey.Size - 1
      : this->TheKey.Order[axis] > 0     ? this->TheKey.Order[axis]
      : simplexAxes == domain.Dimension  ? SimplexDegree(simplexAxes, this->TheKey.Size)
                                         : 2;
  }
}

//------------------------------------------------------------------------------
bool SkdBernsteinMap::Fit(vtkCell* cell, const SkdPatch* patch, const BernsteinLayout& layout)
{
  const CellFunctions functions(cell, patch);
  const auto columns = static_cast<std::size_t>(cell->GetNumberOfPoints());
  std::vector<double> matrix(static_cast<std::size_t>(layout.Size) * columns, 0.0);
  ForEachCoefficient(layout,
    [&](int offset, const int(&index)[3])
    {
      functions.Evaluate(
        LatticePoint(layout, index), matrix.data() + static_cast<std::size_t>(offset) * columns);
    });
  ToBernstein(layout, columns, matrix.data());
  if (!IsSame(functions, layout, matrix, columns))
  {
    return false;
  }
  this->Form = skd::DistanceForm(layout);
  this->Compress(matrix);
  return true;
}

//------------------------------------------------------------------------------
void SkdBernsteinMap::Compress(const std::vector<double>& matrix)
{
  const auto columns = static_cast<std::size_t>(this->TheKey.Size);
  this->Begins.assign(1, 0);
  for (std::size_t at = 0; at < matrix.size(); at += columns)
  {
    double size = 0.0;
    for (std::size_t i = 0; i < columns; ++i)
    {
      if (std::abs(matrix[at + i]) > SkdTolerances::NoTerm)
      {
        this->Terms.push_back({ static_cast<int>(i), matrix[at + i] });
        size += std::abs(matrix[at + i]);
      }
    }
    this->TheAmplification = std::max(this->TheAmplification, size);
    this->Begins.push_back(static_cast<int>(this->Terms.size()));
  }
}

//------------------------------------------------------------------------------
void SkdBernsteinMap::Convert(const skd::Vector3* points, const skd::Vector3& origin,
  const double* weights, double* const (&controls)[3], double* controlWeights) const
{
  const int size = this->Form.GetLayout().Size;
  for (int i = 0; i < size; ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    skd::Vector3 sum{};
    double weightSum = 0.0;
    for (int k = this->Begins[at]; k < this->Begins[at + 1]; ++k)
    {
      const Term& term = this->Terms[static_cast<std::size_t>(k)];
      const double weight = weights ? term.Factor * weights[term.Point] : term.Factor;
      sum = sum + weight * (points[term.Point] - origin);
      weightSum += weight;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      controls[axis][i] = sum[axis];
    }
    if (weights)
    {
      controlWeights[i] = weightSum;
    }
  }
}
}
