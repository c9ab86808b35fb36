// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeCurveSurfaceIntersection.h"

#include "Curves/SkdCutCurves.h"
#include "Curves/SkdSurfaceHitArrays.h"
#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdMakeArray.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdReport.h"
#include "Pipeline/SkdSearchRange.h"
#include "Pipeline/SkdSetText.h"
#include "Search/InOut/SkdPartList.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>
#include <vector>

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeCurveSurfaceIntersection);

class vtkSkdTreeCurveSurfaceIntersection::Internals
{
public:
  std::vector<SkdBlock> Blocks; // of the Source, while it is looked at
  SkdSurfaceSet Surfaces;
  std::vector<std::vector<int>> Pieces; // of the Source's cells, when they are computed
};

namespace
{
/// The numbers of the intersections along their curves; unselected ones are removed.
void Select(vtkSkdTreeCurveSurfaceIntersection* self, SkdSurfaceHitTable& table)
{
  const bool wantsAll = self->GetHitSelection() == vtkSkdTreeCurveSurfaceIntersection::ALL_HITS;
  const bool wantsFirst = self->GetHitSelection() == vtkSkdTreeCurveSurfaceIntersection::FIRST_HIT;
  const vtkIdType wanted = wantsFirst ? 1 : self->GetHitNumber();
  std::vector<SkdSurfaceIntersection> all;
  all.swap(table.Intersections);
  vtkIdType number = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const bool isNext = i > 0 && all[i].Hit.Curve == all[i - 1].Hit.Curve;
    number = isNext ? number + 1 : 1;
    if (wantsAll || number == wanted)
    {
      table.Intersections.push_back(all[i]);
      table.Numbers.push_back(number);
    }
  }
}

/// Makes `output` the Input, with how often each of its cells is hit.
void CountHits(const SkdSurfaceHitTable& table, vtkDataObject* input, vtkDataObject* output)
{
  std::vector<vtkSmartPointer<vtkIdTypeArray>> counts;
  for (const SkdBlock& block : table.CurveBlocks)
  {
    auto count = SkdMakeArray<vtkIdTypeArray>("SkdNumberOfHits", 1, block.Mesh->GetNumberOfCells());
    count->FillValue(0);
    counts.push_back(count);
  }
  for (const SkdSurfaceIntersection& intersection : table.Intersections)
  {
    const SkdCurve& curve = table.Curves.GetCurves()[intersection.Hit.Curve];
    vtkIdTypeArray* count = counts[static_cast<std::size_t>(curve.Block)];
    count->SetValue(curve.CellId, count->GetValue(curve.CellId) + 1);
  }
  SkdMirror(input, output);
  std::size_t next = 0;
  for (const SkdBlock& mirror : SkdBlocksWithCells(SkdBlocksOf(output)))
  {
    mirror.Mesh->GetCellData()->AddArray(counts[next++]);
    mirror.Mesh->GetCellData()->SetActiveScalars("SkdNumberOfHits");
  }
}

/// Of each block of curves, whether this process lists each cell; nothing: it does.
using Listed = std::vector<std::vector<unsigned char>>;

bool IsListed(const Listed& listed, int block, vtkIdType cell)
{
  const auto at = static_cast<std::size_t>(block);
  return listed.empty() || listed[at].empty() || listed[at][static_cast<std::size_t>(cell)] != 0;
}

/// By block that has cells, as curves are read.
Listed OfBlocksWithCells(Listed all, vtkDataObject* input)
{
  const std::vector<SkdBlock> blocks = SkdBlocksOf(input);
  Listed listed;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (blocks[i].Mesh->GetNumberOfCells() > 0)
    {
      listed.push_back(std::move(all[i]));
    }
  }
  return listed;
}

void KeepListed(const Listed& listed, SkdSurfaceHitTable& table)
{
  const auto isOther = [&](const SkdSurfaceIntersection& intersection)
  {
    const SkdCurve& curve = table.Curves.GetCurves()[intersection.Hit.Curve];
    return !IsListed(listed, curve.Block, curve.CellId);
  };
  table.Intersections.erase(
    std::remove_if(table.Intersections.begin(), table.Intersections.end(), isOther),
    table.Intersections.end());
}

/// Of curves that were cut.
void KeepListed(const Listed& listed, const std::vector<SkdCurve>& curves, vtkPolyData* output)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(output->GetCellData()->GetArray("SkdCurveId"));
  vtkNew<vtkIdList> kept;
  for (vtkIdType cell = 0; ids && cell < output->GetNumberOfCells(); ++cell)
  {
    const SkdCurve& curve = curves[static_cast<std::size_t>(ids->GetValue(cell))];
    if (IsListed(listed, curve.Block, curve.CellId))
    {
      kept->InsertNextId(cell);
    }
  }
  if (!ids || kept->GetNumberOfIds() == output->GetNumberOfCells())
  {
    return;
  }
  vtkNew<vtkPolyData> all;
  all->ShallowCopy(output);
  all->BuildCells();
  output->Initialize();
  vtkNew<vtkPoints> points;
  points->SetDataType(all->GetPoints()->GetDataType());
  output->SetPoints(points);
  output->AllocateProportional(all, 1.0);
  output->GetPointData()->CopyAllOn();
  output->GetPointData()->CopyAllocate(all->GetPointData());
  output->GetCellData()->CopyAllOn();
  output->GetCellData()->CopyAllocate(all->GetCellData());
  output->CopyCells(all, kept);
}

void Report(const SkdSurfaceHitTable& table, double rounding, vtkPolyData* output)
{
  SkdReport report(output);
  report.AddCount("Curves", static_cast<vtkIdType>(table.Curves.GetCurves().size()));
  report.AddCount("CurvePieces", static_cast<vtkIdType>(table.Curves.GetNumberOfPieces()));
  report.AddCount("SurfaceElements", static_cast<vtkIdType>(table.Surfaces.GetElements().size()));
  report.AddCount("Hits", static_cast<vtkIdType>(table.Intersections.size()));
  report.AddMeasure("Epsilon", table.Surfaces.GetAbsoluteEpsilon());
  report.AddMeasure("Rounding", rounding);
}
}

//------------------------------------------------------------------------------
vtkSkdTreeCurveSurfaceIntersection::vtkSkdTreeCurveSurfaceIntersection()
  : vtkSkdTreeCurveAlgorithm(SourceUse::Required, { VTK_POLY_DATA, VTK_POLY_DATA, LIKE_INPUT })
  , Impl(new Internals)
{
}

//------------------------------------------------------------------------------
vtkSkdTreeCurveSurfaceIntersection::~vtkSkdTreeCurveSurfaceIntersection() = default;

//------------------------------------------------------------------------------
int vtkSkdTreeCurveSurfaceIntersection::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* source = vtkDataObject::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  const std::vector<SkdBlock> curveBlocks = SkdBlocksWithCells(SkdBlocksOf(input));
  SkdStopwatch watch;

  const bool wasBuilt = this->UpdateSurfaces(source);
  const SkdSurfaceSet& surfaces = this->Impl->Surfaces;
  const std::vector<SkdBlock>& surfaceBlocks = this->Impl->Blocks;
  SkdCurveSet curves;
  curves.Read(curveBlocks, this->FindPolylineForm());
  this->WarnAboutInput("Input", curves.GetFaults(), curves.GetCurves().empty(), "curves");
  this->WarnAboutInput("Source", surfaces.GetFaults(), surfaces.GetElements().empty(), "surfaces");
  const double delta = curves.GetBounds().Diagonal() * this->FindChordTolerance();
  const double buildSeconds = watch.Lap();

  const SkdSurfaceHitFinder finder(curves, surfaces, delta);
  SkdLoop loop(this, static_cast<vtkIdType>(curves.GetNumberOfPieces()), 0.2, 0.9);
  SkdSurfaceHitTable table{ curves, curveBlocks, surfaces, surfaceBlocks, finder.Find(loop), {} };
  const double querySeconds = watch.Lap();
  const Listed listed = OfBlocksWithCells(this->FindListedCells(outputVector), input);

  if (this->CutCurves)
  {
    SkdCutCurves(
      { curves, curveBlocks, surfaces.GetElements(), finder, SkdIsComposite(input), delta },
      table.Intersections, vtkPolyData::GetData(outputVector, 1));
    KeepListed(listed, curves.GetCurves(), vtkPolyData::GetData(outputVector, 1));
  }
  table.Intersections = finder.UniteAtJoints(std::move(table.Intersections));
  CountHits(table, input, vtkDataObject::GetData(outputVector, 2));
  KeepListed(listed, table);
  Select(this, table);
  this->StoreHits(table, SkdIsComposite(input), SkdIsComposite(source), output);
  Report(table, finder.GetRounding(), output);
  SkdReport report(output);
  report.AddRun(wasBuilt ? 1 : 0, buildSeconds, "QuerySeconds", querySeconds);
  this->Impl->Blocks.clear();
  return 1;
}

//------------------------------------------------------------------------------
// Splines extend beyond the boxes of their points, a connected piece of the Source may be connected
// elsewhere, and what is inside of it depends on all of it.
bool vtkSkdTreeCurveSurfaceIntersection::NeedsNearbySource(SkdSearchRange& range)
{
  range.OfDiagonal = 1e-3; // more than any rounding
  return this->PolylineForm == STRAIGHT && this->Parts != CONNECTED_PIECES && !this->CutCurves;
}

//------------------------------------------------------------------------------
void vtkSkdTreeCurveSurfaceIntersection::SetPartArray(const char* name)
{
  SkdSetText(this, name, this->PartArray);
}

//------------------------------------------------------------------------------
// Whether a tree was built.
bool vtkSkdTreeCurveSurfaceIntersection::UpdateSurfaces(vtkDataObject* source)
{
  Internals& internals = *this->Impl;
  internals.Blocks = SkdBlocksWithCells(SkdBlocksOf(source));
  const bool wasBuilt =
    internals.Surfaces.Update(internals.Blocks, this->VolumeFaces, this->Epsilon);
  const bool lacksArray =
    this->Parts == CELL_ARRAY && !SkdHavePartArray(internals.Blocks, this->PartArray);
  std::vector<std::vector<int>> ids;
  if (lacksArray)
  {
    vtkErrorMacro("Source has no cell array of numbers named \""
      << this->PartArray << "\" in all its blocks; each block is a part instead.");
  }
  for (std::size_t i = 0; this->Parts == CELL_ARRAY && !lacksArray && i < internals.Blocks.size();
       ++i)
  {
    ids.push_back(SkdPartIdsOf(internals.Blocks[i].Mesh, this->PartArray));
  }
  if (this->Parts == CONNECTED_PIECES)
  {
    const bool isKnown = !wasBuilt && internals.Pieces.size() == internals.Blocks.size();
    ids = isKnown ? std::move(internals.Pieces) : SkdConnectedPiecesOf(internals.Blocks);
  }
  internals.Surfaces.AssignParts(internals.Blocks, ids);
  internals.Pieces = this->Parts == CONNECTED_PIECES ? std::move(ids) : decltype(ids)();
  return wasBuilt;
}

//------------------------------------------------------------------------------
void vtkSkdTreeCurveSurfaceIntersection::StoreHits(
  const SkdSurfaceHitTable& table, bool hasCurveBlocks, bool hasSurfaceBlocks, vtkPolyData* output)
{
  SkdStoreSurfaceHits(table, output);
  if (hasCurveBlocks)
  {
    SkdStoreCurveBlocks(table, output);
  }
  if (hasSurfaceBlocks)
  {
    SkdStoreSurfaceBlocks(table, output);
  }
  if (this->InterpolateData)
  {
    SkdWarnAboutRefused(this, SkdStoreDataAtHits(table, output));
  }
}

//------------------------------------------------------------------------------
void vtkSkdTreeCurveSurfaceIntersection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "VolumeFaces", this->VolumeFaces, "Parts", this->Parts, "PartArray",
    this->PartArray, "HitSelection", this->HitSelection, "HitNumber", this->HitNumber, "CutCurves",
    this->CutCurves);
}
VTK_ABI_NAMESPACE_END
