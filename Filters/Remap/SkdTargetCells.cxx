// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdTargetCells.h"

#include "Core/Geometry/Overlap/LonLatOutline.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace skdtree
{
namespace
{
bool IsFlat(int type)
{
  return type == VTK_TRIANGLE || type == VTK_QUAD || type == VTK_PIXEL || type == VTK_POLYGON;
}

constexpr double Rounding = 8.0 * std::numeric_limits<double>::epsilon(); // of angles

/// The rim and, with a cell that has it, the pole are in, whatever the longitude.
bool Holds(const skd::LonLatCell& cell, const skd::Vector3& x)
{
  constexpr double fullCircle = 6.28318530717958647692;
  const double across = std::hypot(x[0], x[1]);
  const double latitude = std::atan2(x[2], across);
  const double away = std::atan2(x[1], x[0]) - cell.MiddleLongitude();
  const bool isPole = across <= Rounding * std::abs(x[2]);
  return latitude >= cell.South - Rounding && latitude <= cell.North + Rounding &&
    (isPole ||
      std::abs(away - fullCircle * std::round(away / fullCircle)) <= 0.5 * cell.Width() + Rounding);
}
}

SkdTargetCells::SkdTargetCells(vtkDataSet* mesh, bool isOnSphere, double tolerance, bool isLonLat)
  : Mesh(mesh)
  , OnSphere(isOnSphere)
  , LonLat(isLonLat)
  , Tolerance(tolerance)
  , Reader(mesh)
  , Ghosts(mesh->GetCellGhostArray())
{
  if (!isOnSphere)
  {
    SkdTreeSettings settings;
    settings.IsBare = true;
    this->InSpace = std::make_unique<SkdCellTree>(mesh, settings);
    this->Tolerance = std::max(tolerance, this->InSpace->Rounding());
  }
  if (mesh->GetNumberOfCells() > 0)
  {
    const auto cell = vtkSmartPointer<vtkGenericCell>::New();
    SkdLoadCell(mesh, 0, cell); // from now on it is thread-safe
  }
}

bool SkdTargetCells::IsOurs(vtkIdType id) const
{
  constexpr int notOurs = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::REFINEDCELL |
    vtkDataSetAttributes::HIDDENCELL;
  return !this->Ghosts || (this->Ghosts->GetValue(id) & notOurs) == 0;
}

vtkIdType SkdTargetCells::CountUnfit() const
{
  vtkIdType count = 0;
  for (vtkIdType id = 0; id < this->GetNumberOfCells() && this->OnSphere; ++id)
  {
    const int type = this->Reader.TypeOf(id);
    count += type != VTK_EMPTY_CELL && !IsFlat(type) && this->IsOurs(id) ? 1 : 0;
  }
  return count;
}

SkdTargetCells::Cell::Cell(const SkdTargetCells& cells)
  : Cells(cells)
  , Scratch(vtkSmartPointer<vtkGenericCell>::New())
  , List(vtkSmartPointer<vtkIdList>::New())
{
}

bool SkdTargetCells::Cell::Load(vtkIdType id)
{
  this->Id = id;
  if (!this->Cells.IsOurs(id))
  {
    return false;
  }
  return this->Cells.OnSphere ? this->LoadOnSphere(id) : this->LoadInSpace(id);
}

void SkdTargetCells::Cell::ReadCorners(vtkIdType id)
{
  this->Corners.clear();
  this->Cells.Reader.VisitPoints(id, this->List,
    [this](const auto* ids, std::size_t size)
    {
      for (std::size_t i = 0; i < size; ++i)
      {
        skd::Vector3 x;
        this->Cells.Mesh->GetPoint(ids[i], x.X);
        this->Corners.push_back(x);
      }
    });
  this->Centre = { { 0.0, 0.0, 0.0 } };
  for (const skd::Vector3& corner : this->Corners)
  {
    const double length = this->Cells.OnSphere ? skd::Norm(corner) : 1.0;
    this->Centre = this->Centre + (1.0 / (length * this->Corners.size())) * corner;
  }
}

bool SkdTargetCells::Cell::LoadOnSphere(vtkIdType id)
{
  const int type = this->Cells.Reader.TypeOf(id);
  if (!IsFlat(type))
  {
    return false;
  }
  this->ReadCorners(id);
  if (type == VTK_PIXEL && this->Corners.size() == 4)
  {
    std::swap(this->Corners[2], this->Corners[3]);
  }
  const bool isCell = this->Sphere.Set(this->Corners);
  this->Box = this->Sphere.GetBox();
  this->LonLat.reset();
  if (isCell && this->Cells.LonLat)
  {
    this->FindLonLat();
  }
  return isCell;
}

void SkdTargetCells::Cell::FindLonLat()
{
  std::vector<skd::Vector3> directions;
  for (const skd::Vector3& corner : this->Corners)
  {
    directions.push_back((1.0 / skd::Norm(corner)) * corner);
  }
  this->LonLat = skd::LonLatOutline(directions).Find();
  if (this->LonLat)
  {
    this->Box = this->LonLat->Bounds().Inflated(4.0 * Rounding);
  }
}

bool SkdTargetCells::Cell::LoadInSpace(vtkIdType id)
{
  const SkdCellTree& cells = *this->Cells.InSpace;
  const std::int64_t at = cells.Cells().CellOfId(id);
  if (at < 0)
  {
    return false;
  }
  this->ReadCorners(id);
  this->Box = cells.SafetyBoxOf(static_cast<std::uint32_t>(at)).Inflated(this->Cells.Tolerance);
  return true;
}

bool SkdTargetCells::Cell::Contains(const skd::Vector3& x) const
{
  if (this->Cells.OnSphere)
  {
    return this->LonLat ? Holds(*this->LonLat, x) : this->Sphere.Contains(x);
  }
  const SkdFoundCell found =
    this->Cells.InSpace->Evaluate(this->Id, x, { this->Cells.Mesh, this->Scratch });
  return found.Id >= 0 && found.Dist2 <= this->Cells.Tolerance * this->Cells.Tolerance;
}
}
