// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeRays.h"

#include "Exchange/SkdFilterInputs.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdInterpolate.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdReport.h"
#include "Pipeline/SkdSetText.h"
#include "Search/Rays/SkdHitCells.h"
#include "Search/Rays/SkdRayOutputs.h"
#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <optional>

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeRays);

class vtkSkdTreeRays::Internals
{
public:
  SkdSourceTrees Trees;
  SkdSourceTrees HitTrees; // of the cells that may be hit, where the Source stays in its pieces
};

namespace
{
bool IsAtPoints(vtkSkdTreeRays* self)
{
  return self->GetStart() == vtkSkdTreeRays::POINTS;
}

vtkDataSetAttributes* DataOf(vtkSkdTreeRays* self, const SkdBlock& block)
{
  return IsAtPoints(self) ? static_cast<vtkDataSetAttributes*>(block.Mesh->GetPointData())
                          : block.Mesh->GetCellData();
}

SkdRayAim AimOf(vtkSkdTreeRays* self, const SkdSourceTrees& trees)
{
  SkdRayAim aim;
  aim.Mode = static_cast<SkdRayAim::Along>(self->GetAlong());
  aim.Array = self->GetDirectionArray();
  const double* vector =
    self->GetAlong() == vtkSkdTreeRays::TO_POINT ? self->GetTargetPoint() : self->GetDirection();
  std::copy_n(vector, 3, aim.Vector.X);
  aim.Source = &trees;
  aim.IsReversed = self->GetReversed();
  return aim;
}

SkdRayLimits LimitsOf(vtkSkdTreeRays* self, double tolerance)
{
  return { tolerance, self->GetIncludeStart() ? -tolerance : tolerance, self->GetMaximumLength(),
    self->GetBothWays() };
}

std::vector<SkdCastRays> FindStarts(
  vtkSkdTreeRays* self, const std::vector<SkdBlock>& blocks, const SkdSourceTrees& trees)
{
  std::vector<SkdCastRays> rays;
  const auto at = IsAtPoints(self) ? SkdQueryPoints::At::Points : SkdQueryPoints::At::Middles;
  for (SkdRayStarts& starts : SkdMakeRayStarts(blocks, at, AimOf(self, trees)))
  {
    rays.push_back({ std::move(starts), {} });
  }
  return rays;
}

/// Unless all cells are there that rays may hit, no ray hits any.
void Cast(vtkSkdTreeRays* self, const SkdRayTarget& target, const SkdRayLimits& limits,
  double progress, bool isWhole, std::vector<SkdCastRays>& rays)
{
  const SkdRayCaster caster(target.Trees, static_cast<int>(target.Blocks.size()), limits);
  SkdLoop loop(self, SkdCountStarts(rays, true), progress, 0.8, 32768);
  for (SkdCastRays& cast : rays)
  {
    if (!isWhole)
    {
      cast.Lists.AddEmpty(cast.Starts.Points.size());
      continue;
    }
    cast.Lists = self->GetHits() == vtkSkdTreeRays::FIRST_HIT
      ? caster.FindFirst(cast.Starts.Points, cast.Starts.Directions, loop)
      : caster.FindAll(cast.Starts.Points, cast.Starts.Directions, loop);
  }
}

/// One message about starts that have no ray.
void WarnAbout(
  vtkSkdTreeRays* self, const std::vector<SkdCastRays>& rays, const SkdTreeCounts& counts)
{
  vtkIdType without = 0;
  for (const SkdCastRays& cast : rays)
  {
    if (!cast.Starts.Fault.empty())
    {
      vtkErrorWithObjectMacro(self, << cast.Starts.Fault);
      return;
    }
    without += cast.Starts.CountWithoutRay();
  }
  if (counts.Cells == 0)
  {
    vtkWarningWithObjectMacro(self, "Source has no cells to hit; no ray hits anything.");
  }
  else if (without > 0)
  {
    vtkWarningWithObjectMacro(self,
      << without << (IsAtPoints(self) ? " points" : " cells")
      << " have no ray: their position or direction is not finite, or their direction is zero, or "
         "they have no normal.");
  }
}

void InterpolateSource(vtkSkdTreeRays* self, const std::vector<SkdBlock>& blocks,
  const std::vector<SkdCastRays>& rays, const SkdRayTarget& target)
{
  const auto meshOf = [&](int block) { return target.Trees.GetMesh(block); };
  std::set<std::string> refused;
  SkdLoop loop(self, SkdCountStarts(rays, true), 0.8, 1.0);
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    const SkdCastRays& cast = rays[i];
    const auto locationOf = [&](vtkIdType ray)
    {
      thread_local skd::Vector3 location;
      const SkdRayHit* hit = cast.Lists.GetFirst(ray);
      location = hit ? cast.PointOf(ray, *hit) : skd::Vector3{};
      return hit ? SkdSourceLocation{ hit->Block, hit->CellId, location.X }
                 : SkdSourceLocation{ -1, -1, nullptr };
    };
    SkdInterpolateInto(DataOf(self, blocks[i]), cast.Starts.GetNumber(), target.Blocks, meshOf,
      locationOf, refused, loop);
  }
  SkdWarnAboutRefused(self, refused);
}

void Report(
  vtkDataObject* output, const std::vector<SkdCastRays>& rays, const SkdTreeCounts& counts)
{
  vtkIdType hits = 0;
  vtkIdType withHits = 0;
  for (const SkdCastRays& cast : rays)
  {
    hits += cast.Lists.GetNumberOfHits();
    for (vtkIdType ray = 0; ray < cast.Starts.GetNumber(); ++ray)
    {
      withHits += cast.Lists.GetNumberOfHits(ray) > 0 ? 1 : 0;
    }
  }
  SkdReport report(output);
  report.AddCount("Rays", SkdCountStarts(rays, false));
  report.AddCount("RaysWithHits", withHits);
  report.AddCount("Hits", hits);
  report.AddCount("SourceCells", counts.Cells);
  report.AddCount("SourceCellsLeftOut", counts.CellsLeftOut);
  report.AddMeasure("Epsilon", counts.Tolerance);
}

void FillOutputs(vtkSkdTreeRays* self, const std::vector<SkdBlock>& blocks,
  const std::vector<SkdCastRays>& rays, const std::vector<std::vector<unsigned char>>& listed,
  const SkdRayTarget& target, vtkPolyData* hits)
{
  std::vector<vtkDataSetAttributes*> data;
  for (const SkdBlock& block : blocks)
  {
    data.push_back(DataOf(self, block));
  }
  const bool hasHits = self->GetHits() != vtkSkdTreeRays::COUNTS;
  if (hasHits)
  {
    const bool areLines = self->GetGenerateLines();
    listed.empty() ? SkdFillHits(hits, rays, data, target, areLines)
                   : SkdFillHits(hits, SkdListedRays(rays, listed), data, target, areLines);
  }
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    if (self->GetHits() != vtkSkdTreeRays::FIRST_HIT)
    {
      SkdAddHitCounts(data[i], rays[i]);
    }
    if (hasHits)
    {
      SkdAddFirstHits(data[i], rays[i], target);
    }
  }
  if (hasHits && self->GetInterpolateSourceData())
  {
    InterpolateSource(self, blocks, rays, target);
  }
}
}

vtkSkdTreeRays::vtkSkdTreeRays()
  : vtkSkdTreeSourceAlgorithm(SourceUse::Required, { LIKE_INPUT, VTK_POLY_DATA })
  , Impl(new Internals)
{
}

vtkSkdTreeRays::~vtkSkdTreeRays() = default;

void vtkSkdTreeRays::SetDirectionArray(const char* name)
{
  SkdSetText(this, name, this->DirectionArray);
}

bool vtkSkdTreeRays::NeedsWhole(int port)
{
  return (this->Along == NORMALS && this->Start == POINTS) || this->Superclass::NeedsWhole(port);
}

// The nearest point that a ray goes to is found before it is cast.
bool vtkSkdTreeRays::CanAskPieces(int port)
{
  return port == 1 && this->Along != TO_NEAREST;
}

int vtkSkdTreeRays::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->IsLeftToFirst(outputVector))
  {
    return 1;
  }
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  const std::vector<SkdBlock> blocks = SkdMirror(vtkDataObject::GetData(inputVector[0]), output);
  vtkDataObject* sourceData = vtkDataObject::GetData(inputVector[1]);
  const SkdSpreadSource* spread = this->Inputs->GetSpread(1);
  const std::vector<SkdBlock> source =
    spread ? spread->GetBlocks() : SkdBlocksWithCells(SkdBlocksOf(sourceData));
  SkdStopwatch watch;
  SkdSourceTrees& trees = this->Impl->Trees;
  const int built = trees.Update(source, this->Epsilon);
  const double buildSeconds = watch.Lap();

  std::vector<SkdCastRays> rays = FindStarts(this, blocks, trees);
  const SkdTreeCounts counts = spread ? spread->CountAll(trees.GetCounts()) : trees.GetCounts();
  WarnAbout(this, rays, counts);
  const double tolerance = SkdRayTolerance(this->Tolerance, source, blocks);
  const SkdRayLimits limits = LimitsOf(this, tolerance);
  SkdReport report(output);
  std::optional<SkdFoundCells> found;
  bool isWhole = true;
  if (spread)
  {
    SkdLoop loop(this, SkdCountStarts(rays, true), 0.2, 0.5, 32768);
    const SkdHitCells hits =
      SkdFindHitCells(this, rays, trees, *spread, limits, this->Hits != FIRST_HIT, loop);
    report.AddCount("RaysSent", static_cast<vtkIdType>(hits.RaysSent));
    found.emplace(*spread, hits.Cells);
    isWhole = hits.IsWhole;
    this->Impl->HitTrees.Update(found->GetBlocks(), this->Epsilon);
  }
  const bool isComposite = SkdIsComposite(sourceData);
  const SkdRayTarget target = found
    ? SkdRayTarget{ this->Impl->HitTrees, found->GetBlocks(), isComposite }
    : SkdRayTarget{ trees, source, isComposite };
  target.Touch();
  Cast(this, target, limits, found ? 0.5 : 0.2, isWhole, rays);
  report.AddMeasure("Tolerance", tolerance);
  report.AddRun(built, buildSeconds, "QuerySeconds", watch.Lap());
  Report(output, rays, counts);
  std::vector<std::vector<unsigned char>> listed;
  if (this->Hits != COUNTS)
  {
    listed = this->Start == CELL_CENTERS ? this->FindListedCells(outputVector)
                                         : this->FindListedPoints(outputVector);
  }
  FillOutputs(this, blocks, rays, listed, target, vtkPolyData::GetData(outputVector, 1));
  return 1;
}

void vtkSkdTreeRays::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "Start", this->Start, "Along", this->Along, "DirectionArray",
    this->DirectionArray, "Direction", this->Direction, "TargetPoint", this->TargetPoint,
    "Reversed", this->Reversed, "BothWays", this->BothWays, "Hits", this->Hits, "MaximumLength",
    this->MaximumLength, "Tolerance", this->Tolerance, "IncludeStart", this->IncludeStart,
    "InterpolateSourceData", this->InterpolateSourceData, "GenerateLines", this->GenerateLines,
    "Epsilon", this->Epsilon);
}
VTK_ABI_NAMESPACE_END
