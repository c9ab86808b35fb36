// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeCurveSurfaceIntersection.h"

#include "Curves/SkdCutCurves.h"
#include "Curves/SkdSurfaceHitArrays.h"
#include "Exchange/SkdFilterInputs.h"
#include "Exchange/SkdTransport.h"
#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdMakeArray.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdProcesses.h"
#include "Pipeline/SkdReport.h"
#include "Pipeline/SkdSearchRange.h"
#include "Pipeline/SkdSetText.h"
#include "Search/InOut/SkdPartList.h"
#include "vtkCellData.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <numeric>
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
  bool IsInputGathered = false;         // which lies in pieces
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

/// Calls visit(number of the curve, curve) for those that this process outputs.
template <class Visit>
void VisitOwn(const SkdCurveSet& curves, const std::vector<SkdBlock>& blocks, const Visit& visit)
{
  std::vector<std::vector<unsigned char>> own;
  for (const SkdBlock& block : blocks)
  {
    own.push_back(SkdOwnCellsOf(block.Mesh));
  }
  for (std::size_t number = 0; number < curves.GetCurves().size(); ++number)
  {
    const SkdCurve& curve = curves.GetCurves()[number];
    const std::vector<unsigned char>& ofBlock = own[static_cast<std::size_t>(curve.Block)];
    if (ofBlock.empty() || ofBlock[static_cast<std::size_t>(curve.CellId)] != 0)
    {
      visit(number, curve);
    }
  }
}

/// The number of each curve among those of all processes; -1: another one outputs it. Without a
/// transport all are there.
std::vector<vtkIdType> NumberCurves(
  const SkdCurveSet& curves, const std::vector<SkdBlock>& blocks, SkdTransport* transport)
{
  std::vector<vtkIdType> numbers(curves.GetCurves().size());
  if (!transport)
  {
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
  }
  const std::vector<SkdJoinedIds> joined = SkdJoinedIdsOf(blocks);
  std::vector<std::vector<vtkIdType>> ids(blocks.size());
  VisitOwn(curves, blocks,
    [&](std::size_t, const SkdCurve& curve)
    {
      const auto block = static_cast<std::size_t>(curve.Block);
      ids[block].push_back(joined[block].Of(curve.CellId));
    });
  ids = SkdRankOverProcesses(*transport, ids);
  std::fill(numbers.begin(), numbers.end(), -1);
  std::vector<std::size_t> next(blocks.size(), 0);
  VisitOwn(curves, blocks,
    [&](std::size_t number, const SkdCurve& curve)
    {
      const auto block = static_cast<std::size_t>(curve.Block);
      numbers[number] = ids[block][next[block]++];
    });
  return numbers;
}

/// How often each cell of the blocks of curves is hit.
std::vector<std::vector<vtkIdType>> CountHits(const SkdSurfaceHitTable& table)
{
  std::vector<std::vector<vtkIdType>> counts;
  for (const SkdBlock& block : table.CurveBlocks)
  {
    counts.emplace_back(static_cast<std::size_t>(block.Mesh->GetNumberOfCells()), 0);
  }
  for (const SkdSurfaceIntersection& intersection : table.Intersections)
  {
    const SkdCurve& curve = table.Curves.GetCurves()[intersection.Hit.Curve];
    ++counts[static_cast<std::size_t>(curve.Block)][static_cast<std::size_t>(curve.CellId)];
  }
  return counts;
}

/// Makes `output` the Input, with these counts of the cells of those of its blocks that have any.
void StoreCounts(
  std::vector<std::vector<vtkIdType>> counts, vtkDataObject* input, vtkDataObject* output)
{
  counts.erase(std::remove(counts.begin(), counts.end(), std::vector<vtkIdType>()), counts.end());
  SkdMirror(input, output);
  std::size_t next = 0;
  for (const SkdBlock& mirror : SkdBlocksWithCells(SkdBlocksOf(output)))
  {
    const std::vector<vtkIdType>& ofBlock = counts[next++];
    auto count =
      SkdMakeArray<vtkIdTypeArray>("SkdNumberOfHits", 1, mirror.Mesh->GetNumberOfCells());
    std::copy(ofBlock.begin(), ofBlock.end(), count->GetPointer(0));
    mirror.Mesh->GetCellData()->AddArray(count);
    mirror.Mesh->GetCellData()->SetActiveScalars("SkdNumberOfHits");
  }
}

/// Leaves out those of curves that other processes output.
void KeepOwn(SkdSurfaceHitTable& table)
{
  const auto isOther = [&](const SkdSurfaceIntersection& intersection)
  { return table.CurveNumbers[intersection.Hit.Curve] < 0; };
  table.Intersections.erase(
    std::remove_if(table.Intersections.begin(), table.Intersections.end(), isOther),
    table.Intersections.end());
}

void Report(const SkdSurfaceHitTable& table, double rounding, vtkPolyData* output)
{
  SkdReport report(output);
  vtkIdType curves = 0;
  std::size_t pieces = 0;
  VisitOwn(table.Curves, table.CurveBlocks,
    [&](std::size_t, const SkdCurve& curve)
    {
      ++curves;
      pieces += curve.LastPiece - curve.FirstPiece;
    });
  report.AddCount("Curves", curves);
  report.AddCount("CurvePieces", static_cast<vtkIdType>(pieces));
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
  if (this->IsLeftToFirst(outputVector))
  {
    return 1; // the first piece has all
  }
  vtkInformation* information = outputVector->GetInformationObject(0);
  const std::unique_ptr<SkdTransport> transport = // between pieces of the Input
    this->NeedsWhole(0) ? nullptr : SkdMakeTransport(SkdControllerOf(information));
  vtkDataObject* const around = transport ? this->Inputs->BringAround(*transport) : input;
  if (!around)
  {
    return 0;
  }
  const std::vector<SkdBlock> curveBlocks = // on all processes the same
    transport ? SkdBlocksOf(around) : SkdBlocksWithCells(SkdBlocksOf(input));
  SkdStopwatch watch;

  const bool wasBuilt = this->UpdateSurfaces(source);
  const SkdSurfaceSet& surfaces = this->Impl->Surfaces;
  const std::vector<SkdBlock>& surfaceBlocks = this->Impl->Blocks;
  SkdCurveSet curves;
  curves.Read(
    curveBlocks, this->FindPolylineForm(), transport ? SkdProcessesOf(information).get() : nullptr);
  const std::vector<vtkIdType> numbers = NumberCurves(curves, curveBlocks, transport.get());
  this->WarnAboutInput("Input", curves.GetFaults(), curves.GetCurves().empty(), "curves");
  this->WarnAboutInput("Source", surfaces.GetFaults(), surfaces.GetElements().empty(), "surfaces");
  const double delta = curves.GetBounds().Diagonal() * this->FindChordTolerance();
  const double buildSeconds = watch.Lap();

  const SkdSurfaceHitFinder finder(curves, surfaces, delta);
  SkdLoop loop(this, static_cast<vtkIdType>(curves.GetNumberOfPieces()), 0.2, 0.9);
  SkdSurfaceHitTable table{ curves, curveBlocks, surfaces, surfaceBlocks, finder.Find(loop), {},
    numbers };
  const double querySeconds = watch.Lap();

  if (this->CutCurves)
  {
    SkdCutCurves({ curves, curveBlocks, surfaces.GetElements(), finder, SkdIsComposite(input),
                   delta, numbers },
      table.Intersections, vtkPolyData::GetData(outputVector, 1));
  }
  table.Intersections = finder.UniteAtJoints(std::move(table.Intersections));
  this->StoreCountsOf(table, input, transport.get(), outputVector);
  KeepOwn(table);
  Select(this, table);
  this->StoreHits(table, SkdIsComposite(input), SkdIsComposite(source), output);
  Report(table, finder.GetRounding(), output);
  SkdReport report(output);
  report.AddRun(wasBuilt ? 1 : 0, buildSeconds, "QuerySeconds", querySeconds);
  this->Impl->Blocks.clear();
  return 1;
}

//------------------------------------------------------------------------------
// Of cells that several processes have all tell how often they are hit.
void vtkSkdTreeCurveSurfaceIntersection::StoreCountsOf(const SkdSurfaceHitTable& table,
  vtkDataObject* input, SkdTransport* transport, vtkInformationVector* outputs)
{
  std::vector<std::vector<vtkIdType>> counts = CountHits(table);
  if (transport)
  {
    counts = this->Inputs->GetAround().TakeBack(
      counts, input, this->Inputs->FindIds(outputs->GetInformationObject(0), transport));
    this->Inputs->AddTraffic(transport->GetTraffic());
  }
  StoreCounts(std::move(counts), input, vtkDataObject::GetData(outputs, 2));
}

//------------------------------------------------------------------------------
// Whether curves go on in each other cannot be found out from pieces that cannot be brought.
vtkTypeBool vtkSkdTreeCurveSurfaceIntersection::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    vtkInformation* output = outputVector->GetInformationObject(0);
    const auto processes = SkdProcessesOf(output);
    this->Impl->IsInputGathered = processes &&
      processes->IsAny(!SkdCanBring(vtkDataObject::GetData(inputVector[0])) ||
        !SkdMakeTransport(SkdControllerOf(output)));
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
bool vtkSkdTreeCurveSurfaceIntersection::NeedsWhole(int port)
{
  return this->Impl->IsInputGathered || this->Superclass::NeedsWhole(port);
}

//------------------------------------------------------------------------------
// Splines extend beyond the boxes of their points, a connected piece of the Source may be connected
// elsewhere, and what is inside of it depends on all of it.
bool vtkSkdTreeCurveSurfaceIntersection::NeedsNearbySource(SkdSearchRange& range)
{
  range.OfDiagonal = 1e-3; // more than any rounding
  range.IsOfOuterFaces = this->VolumeFaces;
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
