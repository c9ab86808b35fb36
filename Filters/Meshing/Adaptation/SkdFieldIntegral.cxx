// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Adaptation/SkdFieldIntegral.h"

#include "Cells/Read/SkdCellReader.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdLonLat.h"
#include "Pipeline/SkdShownElements.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace skdtree
{
namespace
{
/// So many points are looked for at a time.
constexpr vtkIdType BatchSize = 1 << 17;

/// The counted cells of a mesh, which CanRead, as polygons in the order of the positions of their
/// corners.
class CellsByPosition
{
public:
  explicit CellsByPosition(vtkPointSet* mesh);

  /// `values` of all cells decide between those with the same corners; it may be empty. The new
  /// mesh, and the old id of each of its cells.
  vtkSmartPointer<vtkPolyData> Sort(
    const std::vector<double>& values, std::vector<vtkIdType>& oldIds) const;

private:
  skd::Vector3 PositionOf(vtkIdType point) const
  {
    skd::Vector3 x;
    this->Mesh->GetPoint(point, x.X);
    constexpr double last = std::numeric_limits<double>::max(); // of numbers that can be compared
    return skd::IsFinite(x) ? x : skd::Vector3{ { last, last, last } };
  }
  int Compare(vtkIdType a, vtkIdType b) const;

  vtkPointSet* Mesh;
  std::vector<vtkIdType> Ids;     // of the cells
  std::vector<vtkIdType> Corners; // cell after cell
  std::vector<std::size_t> Firsts;
};

CellsByPosition::CellsByPosition(vtkPointSet* mesh)
  : Mesh(mesh)
  , Firsts(1, 0)
{
  const std::vector<unsigned char> counted = SkdFindCounted(mesh);
  const SkdCellReader reader(mesh);
  vtkNew<vtkIdList> list;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    if (counted[static_cast<std::size_t>(cell)] == 0)
    {
      continue;
    }
    this->Ids.push_back(cell);
    reader.VisitPoints(cell, list,
      [this](const auto* ids, std::size_t size)
      { this->Corners.insert(this->Corners.end(), ids, ids + size); });
    if (reader.TypeOf(cell) == VTK_PIXEL)
    {
      std::swap(this->Corners.end()[-1], this->Corners.end()[-2]);
    }
    this->Firsts.push_back(this->Corners.size());
  }
}

/// Less than 0, 0, or more than 0.
int CellsByPosition::Compare(vtkIdType a, vtkIdType b) const
{
  const std::size_t* const first = this->Firsts.data() + a;
  const std::size_t* const second = this->Firsts.data() + b;
  const std::size_t common = std::min(first[1] - first[0], second[1] - second[0]);
  for (std::size_t i = 0; i < common; ++i)
  {
    const skd::Vector3 x = this->PositionOf(this->Corners[first[0] + i]);
    const skd::Vector3 y = this->PositionOf(this->Corners[second[0] + i]);
    if (!(x == y))
    {
      return x < y ? -1 : 1;
    }
  }
  return static_cast<int>(first[1] - first[0] > common) -
    static_cast<int>(second[1] - second[0] > common);
}

vtkSmartPointer<vtkPolyData> CellsByPosition::Sort(
  const std::vector<double>& values, std::vector<vtkIdType>& oldIds) const
{
  const auto valueOf = [&](vtkIdType i)
  {
    const auto cell = static_cast<std::size_t>(this->Ids[static_cast<std::size_t>(i)]);
    const double value = values.empty() ? 0.0 : values[cell];
    return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  };
  oldIds.resize(this->Firsts.size() - 1);
  std::iota(oldIds.begin(), oldIds.end(), vtkIdType(0));
  std::stable_sort(oldIds.begin(), oldIds.end(),
    [&](vtkIdType a, vtkIdType b)
    {
      const int order = this->Compare(a, b);
      return order < 0 || (order == 0 && valueOf(a) < valueOf(b));
    });
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(
    static_cast<vtkIdType>(oldIds.size()), static_cast<vtkIdType>(this->Corners.size()));
  for (vtkIdType& cell : oldIds)
  {
    const std::size_t* const first = this->Firsts.data() + cell;
    cells->InsertNextCell(
      static_cast<vtkIdType>(first[1] - first[0]), this->Corners.data() + first[0]);
    cell = this->Ids[static_cast<std::size_t>(cell)];
  }
  auto sorted = vtkSmartPointer<vtkPolyData>::New();
  sorted->SetPoints(this->Mesh->GetPoints());
  sorted->SetPolys(cells);
  return sorted;
}

bool HasCellsInAnyOrder(vtkDataSet* mesh)
{
  return vtkPolyData::SafeDownCast(mesh) || vtkUnstructuredGrid::SafeDownCast(mesh);
}
}

bool SkdFieldIntegral::CanRead(vtkDataObject* source)
{
  const std::vector<SkdBlock> blocks = SkdBlocksOf(source);
  if (blocks.size() != 1)
  {
    return false;
  }
  vtkDataSet* mesh = blocks.front().Mesh;
  const std::vector<unsigned char> counted = SkdFindCounted(mesh);
  const SkdCellReader reader(mesh);
  std::size_t surfaces = 0;
  for (std::size_t cell = 0; cell < counted.size(); ++cell)
  {
    const int type = reader.TypeOf(static_cast<vtkIdType>(cell));
    const bool isSurface =
      type == VTK_TRIANGLE || type == VTK_QUAD || type == VTK_PIXEL || type == VTK_POLYGON;
    if (counted[cell] != 0 && !isSurface)
    {
      return false;
    }
    surfaces += counted[cell];
  }
  return surfaces > 0;
}

SkdFieldIntegral::SkdFieldIntegral(vtkDataObject* source, const SkdFieldSamples& values,
  const skd::SurfaceShape& shape, bool isInDegrees)
  : Samples(values)
  , Shape(shape)
  , IsInDegrees(isInDegrees)
  , Locator(vtkSmartPointer<vtkSkdTreeCellLocator>::New())
{
  vtkSmartPointer<vtkDataSet> mesh = SkdBlocksOf(source).front().Mesh;
  mesh->GetBounds(this->Bounds);
  if (HasCellsInAnyOrder(mesh)) // of cells that a point is in, the first counts
  {
    const CellsByPosition cells(vtkPointSet::SafeDownCast(mesh));
    const std::vector<double> nothing;
    mesh = cells.Sort(values.AreOfPoints ? nothing : values.Values, this->OldCells);
  }
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
  const bool areSorted = !this->Samples.AreOfPoints && !this->OldCells.empty();
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
      if (id >= 0)
      {
        const auto at = static_cast<std::size_t>(id);
        values[i] += weight * given[areSorted ? static_cast<std::size_t>(this->OldCells[at]) : at];
      }
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
