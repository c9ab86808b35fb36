// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Adaptation/SkdFieldIntegral.h"

#include "Cells/Read/SkdCellReader.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdLonLat.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <cmath>

namespace skdtree
{
namespace
{
/// So many points are looked for at a time.
constexpr vtkIdType BatchSize = 1 << 17;
}

bool SkdFieldIntegral::CanRead(vtkDataObject* source)
{
  const std::vector<SkdBlock> blocks = SkdBlocksOf(source);
  if (blocks.size() != 1)
  {
    return false;
  }
  vtkDataSet* mesh = blocks.front().Mesh;
  const vtkIdType n = mesh->GetNumberOfCells();
  const SkdCellReader reader(mesh);
  bool areSurfaces = n > 0;
  for (vtkIdType cell = 0; cell < n && areSurfaces; ++cell)
  {
    const int type = reader.TypeOf(cell);
    areSurfaces =
      type == VTK_TRIANGLE || type == VTK_QUAD || type == VTK_PIXEL || type == VTK_POLYGON;
  }
  return areSurfaces;
}

SkdFieldIntegral::SkdFieldIntegral(vtkDataObject* source, const SkdFieldSamples& values,
  const skd::SurfaceShape& shape, bool isInDegrees)
  : Samples(values)
  , Shape(shape)
  , IsInDegrees(isInDegrees)
  , Locator(vtkSmartPointer<vtkSkdTreeCellLocator>::New())
{
  vtkDataSet* mesh = SkdBlocksOf(source).front().Mesh;
  mesh->GetBounds(this->Bounds);
  this->Locator->SetDataSet(mesh);
  this->Locator->BuildLocator();
}

// A longitude is that of the turn that comes nearest to the source's.
skd::Vector3 SkdFieldIntegral::InSource(const skd::Vector3& x) const
{
  if (!this->IsInDegrees)
  {
    return x;
  }
  skd::Vector3 at = SkdLonLatOf(x - this->Shape.Centre);
  const double middle = 0.5 * (this->Bounds[0] + this->Bounds[1]);
  at[0] -= 360.0 * std::round((at[0] - middle) / 360.0);
  at[2] = this->Bounds[4];
  return at;
}

/// The midpoint rule on a triangle, or its four equal parts.
void SkdFieldIntegral::Add(
  const std::array<skd::Vector3, 3>& corners, std::uint32_t cell, Rule& rule) const
{
  const skd::Vector3 middle = (1.0 / 3.0) * (corners[0] + corners[1] + corners[2]);
  const double twice = skd::Norm(skd::Cross(corners[1] - corners[0], corners[2] - corners[0]));
  for (std::size_t i = 0; i < (this->IsInParts ? 4 : 1); ++i)
  {
    const skd::Vector3 x = i > 0 ? 0.5 * (middle + corners[i - 1]) : middle;
    rule.Positions->InsertNextPoint(this->InSource(this->Shape.Put(x)).X);
    rule.Weights.push_back(twice); // which the parts have in common
    rule.Cells.push_back(cell);
  }
}

std::vector<double> SkdFieldIntegral::FindValues(vtkPoints* positions) const
{
  constexpr double anywhere = VTK_DOUBLE_MAX;
  const std::vector<double>& given = this->Samples.Values;
  vtkNew<vtkIdTypeArray> ids; // of cells, or of a cell's points
  vtkNew<vtkDoubleArray> weights;
  if (this->Samples.AreOfPoints)
  {
    this->Locator->FindCellsAndWeights(
      positions->GetData(), nullptr, nullptr, ids, weights, anywhere);
  }
  else
  {
    this->Locator->FindCells(positions->GetData(), ids, nullptr, anywhere);
  }
  std::vector<double> values(static_cast<std::size_t>(positions->GetNumberOfPoints()), 0.0);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    for (int k = 0; k < ids->GetNumberOfComponents(); ++k)
    {
      const vtkIdType id = ids->GetTypedComponent(static_cast<vtkIdType>(i), k);
      const double weight =
        this->Samples.AreOfPoints ? weights->GetTypedComponent(static_cast<vtkIdType>(i), k) : 1.0;
      values[i] += id < 0 ? 0.0 : weight * given[static_cast<std::size_t>(id)];
    }
  }
  return values;
}

std::vector<double> SkdFieldIntegral::GetMeans(const skd::SurfaceMesh& mesh)
{
  std::vector<double> sums(mesh.Cells.size(), 0.0);
  std::vector<double> areas(mesh.Cells.size(), 0.0);
  this->IsInParts =
    !this->Samples.AreOfPoints || this->Samples.Values.size() > 4 * mesh.Cells.size();
  Rule rule;
  rule.Positions = vtkSmartPointer<vtkPoints>::New();
  rule.Positions->SetDataTypeToDouble();
  for (std::uint32_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    const skd::IndexRows::Row corners = mesh.Cells[cell];
    const skd::Vector3 middle = skd::CornerMean(mesh, cell);
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const std::uint32_t next = corners[(i + 1) % corners.size()];
      this->Add({ middle, mesh.Points[corners[i]], mesh.Points[next] }, cell, rule);
    }
    if (rule.Positions->GetNumberOfPoints() < BatchSize && cell + 1 < mesh.Cells.size())
    {
      continue;
    }
    const std::vector<double> values = this->FindValues(rule.Positions);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const bool isKnown = std::isfinite(values[i]);
      sums[rule.Cells[i]] += isKnown ? rule.Weights[i] * values[i] : 0.0;
      areas[rule.Cells[i]] += isKnown ? rule.Weights[i] : 0.0;
    }
    rule.Positions->Reset();
    rule.Weights.clear();
    rule.Cells.clear();
  }
  for (std::size_t cell = 0; cell < sums.size(); ++cell)
  {
    sums[cell] = areas[cell] > 0.0 ? sums[cell] / areas[cell] : vtkMath::Nan();
  }
  return sums;
}
}
