// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Kernels/SkdCellWeights.h"

#include "Cells/Kernels/SkdGenericKernel.h"
#include "Cells/Kernels/SkdPolyKernels.h"
#include "Cells/Read/SkdCellFunctions.h"
#include "Cells/Read/SkdCellReader.h"
#include "Cells/Read/SkdFaceReader.h"
#include "Cells/Read/SkdMagnitudes.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkMath.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace skdtree
{
namespace
{
/// Cells to which VTK gives no weights at points outside, as where rounding puts those on a face.
bool IsAlongAxes(int type)
{
  return type == VTK_VOXEL || type == VTK_PIXEL;
}
}

void SkdCellWeights::Load(vtkDataSet* mesh, vtkIdType cellId)
{
  SkdLoadCell(mesh, cellId, this->Cell);
  this->Corners.resize(this->Cell->GetNumberOfPoints());
  for (std::size_t i = 0; i < this->Corners.size(); ++i)
  {
    this->Cell->GetPoints()->GetPoint(static_cast<vtkIdType>(i), this->Corners[i].X);
  }
  this->Weights.assign(this->Corners.size(), 0.0);
}

void SkdCellWeights::EvaluateFrom(const double pcoords[3], const double at[3])
{
  const Vector x{ { at[0], at[1], at[2] } };
  std::copy(pcoords, pcoords + 3, this->PCoords);
  SkdCellFunctions::Interpolate(this->Cell, this->PCoords, this->Weights.data());
  this->Improve(x, 1);
  this->Shift(this->GetResidual(x, this->Weights));
}

void SkdCellWeights::Evaluate(vtkDataSet* mesh, vtkIdType cellId, const double at[3])
{
  const Vector x{ { at[0], at[1], at[2] } };
  this->Load(mesh, cellId);
  const auto isMeasurable = [](const Vector& corner)
  { return SkdIsWithin(corner, SkdMeasurable.Largest); };
  if (!std::all_of(this->Corners.begin(), this->Corners.end(), isMeasurable))
  {
    this->UseCorner(x); // VTK asserts that nothing overflows or is NaN
    return;
  }
  this->EvaluateByCell(x);
  const double sum = std::accumulate(this->Weights.begin(), this->Weights.end(), 0.0);
  if (std::abs(sum - 1.0) < 0.5)
  {
    this->Improve(x, 8);
  }
  else if (!this->UseEdge(x))
  {
    this->UseCorner(x);
  }
}

// A polyhedron's interpolation functions take x itself. Its EvaluatePosition is unreliable in a
// cell object that was another polyhedron before, as is that of a convex point set since VTK 9.3.
// That of cells with shared memory must not be called in threads. A cell that fails leaves its
// weights 0.
void SkdCellWeights::EvaluateByCell(const Vector& x)
{
  std::fill(this->PCoords, this->PCoords + 3, 0.0);
  if (this->Cell->GetCellType() == VTK_POLYHEDRON)
  {
    this->Cell->InterpolateFunctions(x.X, this->Weights.data());
    return;
  }
  if (this->Cell->GetCellType() == VTK_CONVEX_POINT_SET)
  {
    this->EvaluateInHull(x);
    return;
  }
  if (SkdCellFunctions::ShareMemory(this->Cell->GetCellType()))
  {
    const Vector found = SkdGenericKernel::Closest(this->Cell->GetRepresentativeCell(), x).PCoords;
    std::copy(found.X, found.X + 3, this->PCoords);
    SkdCellFunctions::Interpolate(this->Cell, this->PCoords, this->Weights.data());
    return;
  }
  double nearest[3];
  int subId = 0; // a strip without area leaves it, and takes it for its nearest triangle
  double dist2 = std::numeric_limits<double>::max();
  const int status =
    this->Cell->EvaluatePosition(x.X, nearest, subId, this->PCoords, dist2, this->Weights.data());
  if (status == -1 || !(dist2 < std::numeric_limits<double>::max()))
  {
    std::fill(this->Weights.begin(), this->Weights.end(), 0.0);
    return;
  }
  if (status == 0 && IsAlongAxes(this->Cell->GetCellType()))
  {
    SkdCellFunctions::Interpolate(this->Cell, this->PCoords, this->Weights.data());
  }
}

// As the locator does: VTK's own function takes global ids for local ones since 9.3.
void SkdCellWeights::EvaluateInHull(const Vector& x)
{
  const std::vector<std::uint32_t> faces =
    SkdFacesOfHull(this->Corners.data(), this->Corners.size());
  if (!faces.empty())
  {
    SkdCellPoint found;
    found.Point = x;
    SkdPolyKernels::Locate(
      { SkdShape::Polyhedron, this->Corners.data(), static_cast<int>(this->Corners.size()),
        faces.data(), faces.data() + faces.size() },
      found, this->Weights.data());
  }
}

// VTK's cells stop Newton's method early, and approximate a warped quad by its plane. Further
// steps, while they get nearer to x, make the weights exact.
void SkdCellWeights::Improve(const Vector& x, int steps)
{
  Vector residual = this->GetResidual(x, this->Weights);
  const double enough = 4.0 * std::numeric_limits<double>::epsilon() * Norm(x);
  for (int step = 0; step < steps && Norm(residual) > enough; ++step)
  {
    if (!this->MakeStep(residual))
    {
      this->Shift(residual);
      return;
    }
    this->Next.assign(this->Corners.size(), 0.0);
    SkdCellFunctions::Interpolate(this->Cell, this->PCoords, this->Next.data());
    const Vector left = this->GetResidual(x, this->Next);
    if (!(Norm(left) < Norm(residual)))
    {
      return;
    }
    this->Weights.swap(this->Next);
    residual = left;
  }
}

// What is missing from the point that the weights give to x.
SkdCellWeights::Vector SkdCellWeights::GetResidual(
  const Vector& x, const std::vector<double>& weights) const
{
  Vector residual = x;
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    residual = residual - weights[i] * this->Corners[i];
  }
  return residual;
}

// Gauss-Newton: the tangents t_k of the cell give (t_j . t_k) step_k = t_j . residual. False where
// there are no tangents, or no independent ones.
bool SkdCellWeights::MakeStep(const Vector& residual)
{
  const int dimension = this->Cell->GetCellDimension();
  const std::size_t n = this->Corners.size();
  this->Derivatives.assign(3 * n, 0.0);
  SkdCellFunctions::Derive(this->Cell, this->PCoords, this->Derivatives.data());
  Vector tangents[3] = {};
  double matrix[3][3] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };
  double right[3] = { 0.0, 0.0, 0.0 };
  for (int k = 0; k < dimension; ++k)
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      tangents[k] = tangents[k] + this->Derivatives[k * n + i] * this->Corners[i];
    }
    right[k] = Dot(tangents[k], residual);
  }
  for (int j = 0; j < dimension; ++j)
  {
    for (int k = 0; k < dimension; ++k)
    {
      matrix[j][k] = Dot(tangents[j], tangents[k]);
    }
  }
  if (vtkMath::Determinant3x3(matrix) == 0.0)
  {
    return false;
  }
  double step[3];
  vtkMath::LinearSolve3x3(matrix, right, step);
  vtkMath::Add(this->PCoords, step, this->PCoords);
  return true;
}

// Polygons and polyhedra have weights but no tangents, and their weights need not give x. This is
// the least change that makes them do: w_i += d_i . (sum of d d^T)^-1 residual, where d_i are the
// corners seen from their mean. Of a surface the direction across is left out.
void SkdCellWeights::Shift(const Vector& residual)
{
  const std::size_t n = this->Corners.size();
  const Vector mean =
    (1.0 / n) * std::accumulate(this->Corners.begin(), this->Corners.end(), Vector{});
  double matrix[3][3] = {};
  for (const Vector& corner : this->Corners)
  {
    const Vector d = corner - mean;
    for (int j = 0; j < 9; ++j)
    {
      matrix[j / 3][j % 3] += d[j / 3] * d[j % 3];
    }
  }
  double values[3];
  double vectors[3][3]; // one a column
  vtkMath::Diagonalize3x3(matrix, values, vectors);
  int order[3] = { 0, 1, 2 };
  std::sort(order, order + 3, [&](int a, int b) { return values[a] > values[b]; });
  for (int k = 0; k < this->Cell->GetCellDimension(); ++k)
  {
    const int j = order[k];
    const Vector axis{ { vectors[0][j], vectors[1][j], vectors[2][j] } };
    const bool isThin = !(values[j] > std::numeric_limits<double>::epsilon() * values[order[0]]);
    for (std::size_t i = 0; !isThin && i < n; ++i)
    {
      this->Weights[i] += Dot(axis, this->Corners[i] - mean) * Dot(axis, residual) / values[j];
    }
  }
}

bool SkdCellWeights::UseEdge(const Vector& x)
{
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < this->Cell->GetNumberOfEdges(); ++i)
  {
    vtkCell* edge = this->Cell->GetEdge(i);
    double nearest[3];
    double pcoords[3];
    int subId = 0;
    double dist2;
    this->Next.assign(edge->GetNumberOfPoints(), 0.0);
    const int status =
      edge->EvaluatePosition(x.X, nearest, subId, pcoords, dist2, this->Next.data());
    if (status == -1 || !(dist2 < least))
    {
      continue;
    }
    least = dist2;
    std::fill(this->Weights.begin(), this->Weights.end(), 0.0);
    for (std::size_t k = 0; k < this->Next.size(); ++k)
    {
      const vtkIdType corner = this->Cell->GetPointIds()->IsId(edge->GetPointId(k));
      this->Weights[corner] += this->Next[k]; // the edge's ends may be one point
    }
  }
  return std::isfinite(least);
}

void SkdCellWeights::UseCorner(const Vector& x)
{
  const auto distance2 = [&x](const Vector& corner)
  { return IsFinite(corner) ? Distance2(corner, x) : std::numeric_limits<double>::infinity(); };
  const auto nearest = std::min_element(this->Corners.begin(), this->Corners.end(),
    [&](const Vector& a, const Vector& b) { return distance2(a) < distance2(b); });
  std::fill(this->Weights.begin(), this->Weights.end(), 0.0);
  this->Weights[nearest - this->Corners.begin()] = 1.0;
}
}
