// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Probe/SkdGradient.h"

#include "Cells/Read/SkdCellFunctions.h"
#include "Cells/Read/SkdCellReader.h"

#include "vtkCellType.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
/// Directions with eigenvalues below this are rounding errors, relative to the largest eigenvalue.
constexpr double SmallestEigenvalue = 1e-14;

/// The inverse of a sum of d d^T, on the space that the vectors d span.
class SpannedInverse
{
public:
  void Add(const skd::Vector3& d)
  {
    for (int k = 0; k < 9; ++k)
    {
      this->Matrix[k / 3][k % 3] += d[k / 3] * d[k % 3];
    }
  }

  /// To be called once, after all vectors were added. At most `dimension` directions are kept.
  void Invert(int dimension)
  {
    double values[3], axes[3][3]; // one a column
    vtkMath::Diagonalize3x3(this->Matrix, values, axes);
    int order[3] = { 0, 1, 2 };
    std::sort(order, order + 3, [&](int a, int b) { return values[a] > values[b]; });
    const double least = SmallestEigenvalue * values[order[0]];
    std::fill(&this->Inverse[0][0], &this->Inverse[0][0] + 9, 0.0);
    for (int j = 0; j < dimension && values[order[j]] > least; ++j)
    {
      for (int k = 0; k < 9; ++k)
      {
        this->Inverse[k / 3][k % 3] +=
          axes[k / 3][order[j]] * axes[k % 3][order[j]] / values[order[j]];
      }
    }
  }

  skd::Vector3 Times(const skd::Vector3& d) const
  {
    skd::Vector3 product;
    vtkMath::Multiply3x3(this->Inverse, d.X, product.X);
    return product;
  }

private:
  double Matrix[3][3] = {};
  double Inverse[3][3];
};

/// Cells whose interpolation has no derivatives in closed form.
bool IsFitted(int type)
{
  return type == VTK_POLYGON || type == VTK_POLYHEDRON || type == VTK_QUADRATIC_POLYGON ||
    type == VTK_CONVEX_POINT_SET;
}

bool IsPyramid(int type)
{
  return type == VTK_PYRAMID || type == VTK_QUADRATIC_PYRAMID || type == VTK_TRIQUADRATIC_PYRAMID;
}
}

void SkdGradient::Evaluate(vtkDataSet* mesh, const SkdCellLocation& location)
{
  SkdLoadCell(mesh, location.CellId, this->Cell);
  const auto size = static_cast<std::size_t>(this->Cell->GetNumberOfPoints());
  this->Points.resize(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    this->Cell->GetPoints()->GetPoint(static_cast<vtkIdType>(i), this->Points[i].X);
  }
  this->Vectors.assign(size, skd::Vector3{ { 0.0, 0.0, 0.0 } });
  if (this->Cell->GetCellDimension() > 0 && !this->FitPiece(location))
  {
    this->Differentiate(location);
  }
}

// A piece of a strip or a polyline, or all of a polygon or a polyhedron.
bool SkdGradient::FitPiece(const SkdCellLocation& location)
{
  const int type = this->Cell->GetCellType();
  const auto first = static_cast<std::size_t>(std::max(location.SubId, 0));
  const std::size_t pieceSize = type == VTK_TRIANGLE_STRIP ? 3 : (type == VTK_POLY_LINE ? 2 : 0);
  if (pieceSize > 0 && first + pieceSize <= this->Points.size())
  {
    this->Fit(first, pieceSize);
  }
  else if (IsFitted(type))
  {
    this->Fit(0, this->Points.size());
  }
  return pieceSize > 0 || IsFitted(type);
}

void SkdGradient::Fit(std::size_t first, std::size_t size)
{
  const double share = 1.0 / static_cast<double>(size);
  skd::Vector3 mean{ { 0.0, 0.0, 0.0 } };
  for (std::size_t i = first; i < first + size; ++i)
  {
    mean = mean + share * this->Points[i];
  }
  SpannedInverse inverse;
  for (std::size_t i = first; i < first + size; ++i)
  {
    inverse.Add(this->Points[i] - mean);
  }
  inverse.Invert(this->Cell->GetCellDimension());
  for (std::size_t i = first; i < first + size; ++i)
  {
    this->Vectors[i] = inverse.Times(this->Points[i] - mean);
  }
}

// With the tangents t_k of the cell, the derivatives by its parameters are t_k . gradient.
void SkdGradient::Differentiate(const SkdCellLocation& location)
{
  const int dimension = this->Cell->GetCellDimension();
  const std::size_t size = this->Points.size();
  double pcoords[3] = { location.PCoords[0], location.PCoords[1], location.PCoords[2] };
  if (IsPyramid(this->Cell->GetCellType()))
  {
    pcoords[2] = std::min(pcoords[2], 0.999); // at the apex there is but one tangent
  }
  this->Derivatives.assign(3 * size, 0.0);
  SkdCellFunctions::Derive(this->Cell, pcoords, this->Derivatives.data());
  skd::Vector3 tangents[3] = {};
  SpannedInverse inverse;
  for (int k = 0; k < dimension; ++k)
  {
    for (std::size_t i = 0; i < size; ++i)
    {
      tangents[k] = tangents[k] + this->Derivatives[k * size + i] * this->Points[i];
    }
    inverse.Add(tangents[k]);
  }
  inverse.Invert(dimension);
  for (int k = 0; k < dimension; ++k)
  {
    const skd::Vector3 along = inverse.Times(tangents[k]);
    for (std::size_t i = 0; i < size; ++i)
    {
      this->Vectors[i] = this->Vectors[i] + this->Derivatives[k * size + i] * along;
    }
  }
}

SkdGradientArrays::SkdGradientArrays(const std::vector<SkdBlock>& blocks,
  const std::set<std::string>& names, vtkIdType n, std::set<std::string>& missing)
{
  for (const std::string& name : names)
  {
    Array array;
    for (const SkdBlock& block : blocks)
    {
      vtkDataArray* source = block.Mesh->GetPointData()->GetArray(name.c_str());
      const bool isAlike = source &&
        (array.Sources.empty() ||
          array.Sources[0]->GetNumberOfComponents() == source->GetNumberOfComponents());
      if (isAlike)
      {
        array.Sources.push_back(source);
      }
    }
    if (array.Sources.empty() || array.Sources.size() != blocks.size())
    {
      missing.insert(name);
      continue;
    }
    array.Result = vtkSmartPointer<vtkDoubleArray>::New();
    array.Result->SetName((name + "_Gradient").c_str());
    array.Result->SetNumberOfComponents(3 * array.Sources[0]->GetNumberOfComponents());
    array.Result->SetNumberOfTuples(n);
    array.Result->Fill(vtkMath::Nan());
    this->Arrays.push_back(array);
  }
}

void SkdGradientArrays::AddTo(vtkDataSetAttributes* attributes) const
{
  for (const Array& array : this->Arrays)
  {
    attributes->AddArray(array.Result);
  }
}

void SkdGradientArrays::Set(
  vtkIdType i, int block, vtkIdList* ids, const std::vector<skd::Vector3>& vectors)
{
  for (Array& array : this->Arrays)
  {
    vtkDataArray* source = array.Sources[block];
    for (int c = 0; c < source->GetNumberOfComponents(); ++c)
    {
      skd::Vector3 gradient{ { 0.0, 0.0, 0.0 } };
      for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
      {
        gradient = gradient + source->GetComponent(ids->GetId(k), c) * vectors[k];
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        array.Result->SetComponent(i, 3 * c + axis, gradient[axis]);
      }
    }
  }
}
}
