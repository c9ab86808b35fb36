// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdRemapPair.h"

#include "Pipeline/SkdJoinedShape.h"
#include "Pipeline/SkdLonLat.h"
#include "Pipeline/SkdPartialArrays.h"
#include "Pipeline/SkdShownElements.h"
#include "Remap/SkdOverlapSurface.h"
#include "Remap/SkdRemapTolerances.h"

#include "vtkAppendFilter.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <map>

namespace skdtree
{
namespace
{
vtkSmartPointer<vtkUnstructuredGrid> Append(const std::vector<vtkDataSet*>& meshes)
{
  vtkNew<vtkAppendFilter> append;
  for (vtkDataSet* mesh : meshes)
  {
    append->AddInputData(mesh);
  }
  append->Update();
  return append->GetOutput();
}

/// A mesh whose points are longitude and latitude in degrees, moved to a sphere about the origin.
/// The arrays are the old ones.
vtkSmartPointer<vtkDataSet> MovedToSphere(vtkDataSet* mesh, double radius)
{
  vtkSmartPointer<vtkUnstructuredGrid> moved = Append({ mesh });
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(moved->GetNumberOfPoints());
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    skd::Vector3 x;
    moved->GetPoint(i, x.X);
    points->SetPoint(i, (radius * SkdDirectionOfLonLat(x)).X);
  }
  moved->SetPoints(points);
  moved->GetFieldData()->PassData(mesh->GetFieldData());
  if (auto whole = SkdJoinedShape::Of(mesh))
  {
    whole->MoveToSphere(radius);
    whole->KeepIn(moved);
  }
  return moved;
}

/// Whether a mesh is flat in z, and x and y may well be longitudes and latitudes in degrees: more
/// than a radian wide, and between the poles.
bool MayBeLonLat(vtkDataSet* mesh)
{
  double bounds[6];
  vtkIdType points = mesh->GetNumberOfPoints();
  mesh->GetBounds(bounds);
  if (const auto whole = SkdJoinedShape::Of(mesh))
  {
    const skd::Box3& box = whole->Bounds;
    points = whole->Points;
    std::copy_n(std::array<double, 6>{ { box.Min[0], box.Max[0], box.Min[1], box.Max[1], box.Min[2],
                                         box.Max[2] } }
                  .begin(),
      6, bounds);
  }
  constexpr double radian = 57.3, halfCircle = 180.0, fullCircle = 360.0;
  const double width = bounds[1] - bounds[0];
  return points > 0 && bounds[4] == bounds[5] && bounds[2] >= -0.5 * halfCircle &&
    bounds[3] <= 0.5 * halfCircle && bounds[0] >= -fullCircle && bounds[1] <= 1.5 * fullCircle &&
    width > radian;
}

/// Whether a donor and all blocks that have cells are in one plane.
bool AreInOnePlane(vtkDataSet* donor, const std::vector<SkdBlock>& blocks)
{
  SkdOverlapSettings settings;
  settings.Space = SkdOverlapSpace::Plane;
  return std::all_of(blocks.begin(), blocks.end(),
    [&](const SkdBlock& block)
    {
      return block.Mesh->GetNumberOfCells() == 0 ||
        SkdOverlapSurface(donor, block.Mesh, settings).GetProblem().empty();
    });
}

/// The space that a mesh is in: by the dimension of its cells, surfaces by their radius.
SkdOverlapSpace SpaceOf(vtkDataSet* mesh)
{
  switch (SkdDimensionOf(mesh))
  {
    case 0:
    case 1:
      return SkdOverlapSpace::Line;
    case 2:
      return SkdRadiusOf(mesh) ? SkdOverlapSpace::Sphere : SkdOverlapSpace::Plane;
    default:
      return SkdOverlapSpace::Volume;
  }
}

bool AreStructured(const std::vector<SkdBlock>& blocks)
{
  if (const auto whole =
        blocks.size() == 1 ? SkdJoinedShape::Of(blocks.front().Mesh) : std::nullopt)
  {
    return whole->IsStructured;
  }
  return !blocks.empty() &&
    std::all_of(blocks.begin(), blocks.end(),
      [](const SkdBlock& block) { return SkdIsStructured(block.Mesh); });
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> SkdJoinBlocks(
  const std::vector<SkdBlock>& blocks, std::set<std::string>& partial)
{
  partial.clear();
  if (blocks.size() == 1)
  {
    return blocks.front().Mesh;
  }
  std::vector<vtkDataSet*> meshes;
  const std::vector<SkdBlock> completed = SkdCompleteArrays(blocks, partial);
  for (const SkdBlock& block : completed)
  {
    meshes.push_back(block.Mesh);
  }
  return meshes.empty() ? vtkSmartPointer<vtkUnstructuredGrid>::New() : Append(meshes);
}

//------------------------------------------------------------------------------
SkdRemapPair::SkdRemapPair(const std::vector<SkdBlock>& donor, const std::vector<SkdBlock>& targets,
  const std::vector<SkdBlock>& outputs, const SkdRemapRequest& request,
  const skd::Processes* processes)
  : Request(request)
  , Targets(targets)
  , Outputs(outputs)
  , Grids{ SkdGridSizesOf(donor), SkdGridSizesOf(targets) }
  , DonorStructured(AreStructured(donor))
{
  this->Donor = SkdJoinBlocks(donor, this->PartialArrays);
  this->TargetRadius = this->FindTargetRadius(processes);
  this->MoveToSphere(processes);
}

// Results are made on the moved mesh, and go to the one that was given.
void SkdRemapPair::MoveToSphere(const skd::Processes* processes)
{
  if (this->Request.IsTargetInDegrees)
  {
    const bool isFree = this->Request.IsDonorInDegrees;
    const double radius = isFree ? 1.0 : SkdRadiusOf(this->Donor).value_or(1.0);
    this->Given = this->Outputs;
    for (std::size_t i = 0; i < this->Outputs.size(); ++i)
    {
      this->Targets[i].Mesh = MovedToSphere(this->Targets[i].Mesh, radius);
      this->Outputs[i].Mesh = MovedToSphere(this->Outputs[i].Mesh, radius);
    }
    this->TargetRadius = this->FindTargetRadius(processes);
  }
  if (this->Request.IsDonorInDegrees)
  {
    const double radius = this->RadiusOfTarget();
    this->Donor = MovedToSphere(this->Donor, radius > 0.0 ? radius : 1.0);
  }
}

//------------------------------------------------------------------------------
void SkdRemapPair::Finish()
{
  for (std::size_t i = 0; i < this->Given.size(); ++i)
  {
    for (const int type : { vtkDataObject::POINT, vtkDataObject::CELL })
    {
      this->Given[i].Mesh->GetAttributes(type)->ShallowCopy(
        this->Outputs[i].Mesh->GetAttributes(type));
    }
  }
}

//------------------------------------------------------------------------------
// It speaks for all.
const SkdBlock* SkdRemapPair::FirstWithCells() const
{
  const auto found = std::find_if(this->Targets.begin(), this->Targets.end(),
    [](const SkdBlock& block) { return block.Mesh->GetNumberOfCells() > 0; });
  return found != this->Targets.end() ? &*found : nullptr;
}

bool SkdRemapPair::HasCells() const
{
  return this->FirstWithCells() != nullptr;
}

// The mean of the radii of all processes' parts, by their points.
double SkdRemapPair::FindTargetRadius(const skd::Processes* processes) const
{
  const SkdBlock* block = this->FirstWithCells();
  const double own = block ? SkdRadiusOf(block->Mesh).value_or(0.0) : 0.0;
  if (!processes)
  {
    return own;
  }
  const double points = own > 0.0 ? static_cast<double>(block->Mesh->GetNumberOfPoints()) : 0.0;
  std::vector<std::vector<double>> all = processes->GatherFromOthers({ points * own, points });
  all.push_back({ points * own, points });
  std::sort(all.begin(), all.end()); // added up alike on all of them
  double sum = 0.0;
  double number = 0.0;
  for (const std::vector<double>& told : all)
  {
    sum += told[0];
    number += told[1];
  }
  return number > 0.0 ? sum / number : 0.0;
}

vtkIdType SkdRemapPair::GetNumberOfTargetCells() const
{
  vtkIdType cells = 0;
  for (const SkdBlock& block : this->Outputs)
  {
    cells += SkdCountShown(SkdFindShown(block.Mesh, vtkDataObject::CELL));
  }
  return cells;
}

// A process's part of a block may have lower cells only.
bool SkdRemapPair::IsOfOneDimension(const skd::Processes* processes) const
{
  std::vector<double> own{ static_cast<double>(SkdDimensionOf(this->Donor)) };
  for (const SkdBlock& block : this->Targets)
  {
    if (block.Mesh->GetNumberOfCells() > 0)
    {
      own.push_back(block.BlockIndex);
      own.push_back(SkdDimensionOf(block.Mesh));
    }
  }
  std::vector<std::vector<double>> all;
  if (processes)
  {
    all = processes->GatherFromOthers(own);
  }
  all.push_back(own);
  double ofDonor = 0.0;
  std::map<double, double> ofBlocks;
  for (const std::vector<double>& told : all)
  {
    ofDonor = std::max(ofDonor, told[0]);
    for (std::size_t i = 1; i < told.size(); i += 2)
    {
      double& dimension = ofBlocks[told[i]];
      dimension = std::max(dimension, told[i + 1]);
    }
  }
  return std::all_of(ofBlocks.begin(), ofBlocks.end(),
    [ofDonor](const auto& block) { return block.second == ofDonor; });
}

//------------------------------------------------------------------------------
SkdOverlapSpace SkdRemapPair::FindSpace() const
{
  constexpr SkdOverlapSpace spaces[] = { SkdOverlapSpace::Line, SkdOverlapSpace::Line,
    SkdOverlapSpace::Plane, SkdOverlapSpace::Sphere, SkdOverlapSpace::Volume,
    SkdOverlapSpace::CurvedSurface };
  if (!this->HasCells())
  {
    return SkdOverlapSpace::Volume;
  }
  if (this->Request.Geometry != SkdRemapGeometry::Automatic)
  {
    return spaces[static_cast<int>(this->Request.Geometry)];
  }
  SkdOverlapSpace space = SkdOverlapSpace::Line;
  for (const SkdBlock& block : this->Targets)
  {
    space = block.Mesh->GetNumberOfCells() > 0 ? std::max(space, SpaceOf(block.Mesh)) : space;
  }
  if (space != SkdOverlapSpace::Sphere && space != SkdOverlapSpace::Plane)
  {
    return space;
  }
  // What is contained goes by directions, whatever the distances of the donor's points.
  const bool isOnSphere = this->Request.IsDonorInDegrees ||
    this->Request.Method == SkdRemapMethod::Contained || SkdRadiusOf(this->Donor);
  if (space == SkdOverlapSpace::Sphere && isOnSphere)
  {
    return space;
  }
  const bool isCurved = this->Request.IsConservative() && SkdDimensionOf(this->Donor) == 2 &&
    this->GetHint().empty() && !AreInOnePlane(this->Donor, this->Targets);
  return isCurved ? SkdOverlapSpace::CurvedSurface : SkdOverlapSpace::Plane;
}

//------------------------------------------------------------------------------
std::string SkdRemapPair::GetHint() const
{
  const auto isLonLat = [](const SkdBlock& block) { return MayBeLonLat(block.Mesh); };
  if (!this->Request.IsTargetInDegrees && SkdRadiusOf(this->Donor) && !this->Targets.empty() &&
    std::all_of(this->Targets.begin(), this->Targets.end(), isLonLat))
  {
    return " Source is on a sphere and Input may be of longitudes and latitudes: if so, set "
           "InputCoordinates.";
  }
  return !this->Request.IsDonorInDegrees && MayBeLonLat(this->Donor) && this->RadiusOfTarget() > 0.0
    ? " Input is on a sphere and Source may be of longitudes and latitudes: if so, set "
      "SourceCoordinates."
    : "";
}
}
