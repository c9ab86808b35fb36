// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeBooleanOperation.h"

#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdOuterSurface.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdReport.h"
#include "Surfaces/SkdBooleanSurface.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cmath>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeBooleanOperation);

namespace
{
/// An input of the filter.
struct Surface
{
  const char* Name;
  std::vector<SkdBlock> Blocks;
  bool IsComposite;
  SkdTriangleSet Set;

  Surface(const char* name, vtkDataObject* data, double chordalDeviation)
    : Name(name)
    , Blocks(SkdBlocksOf(data))
    , IsComposite(SkdIsComposite(data))
  {
    this->Set.Update(this->Blocks, chordalDeviation);
    this->Set.Complete();
  }
};

bool IsLaterPiece(vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  return output->Has(Pipeline::UPDATE_PIECE_NUMBER()) &&
    output->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0;
}

std::string TextOf(const skd::Vector3& x)
{
  std::ostringstream text;
  text << "(" << x[0] << ", " << x[1] << ", " << x[2] << ")";
  return text.str();
}

/// Whether a surface bounds a solid. If not, an error tells why.
bool IsClosed(vtkSkdTreeBooleanOperation* self, const Surface& surface)
{
  const auto& triangles = surface.Set.GetTriangles();
  const SkdBadEdges bad = SkdFindBadEdges(triangles.data(), triangles.size());
  if (bad.Count > 0)
  {
    const auto& points = surface.Set.GetPoints();
    vtkErrorWithObjectMacro(self, << surface.Name << " is not a closed, consistently oriented "
                                  << "surface: " << bad.Count
                                  << " edges are open or between faces turned against each "
                                  << "other, the first from " << TextOf(points[bad.First.first])
                                  << " to " << TextOf(points[bad.First.second])
                                  << ". There is no output. Close gaps (Fill Holes) or "
                                  << "orient the faces (Surface Normals with Consistency) before.");
  }
  return bad.Count == 0;
}

void WarnOfOwnContacts(vtkSkdTreeBooleanOperation* self, const Surface& surface, SkdLoop& loop)
{
  const SkdPlacement alone = SkdMakePlacement(surface.Set, nullptr, std::nullopt);
  const SkdPairSearch search{ SkdPairSearch::LowestOnly, 0.0 };
  const auto pairs = SkdTrianglePairs(alone).FindByTrees(search, loop);
  if (!pairs.empty())
  {
    const auto cellOf = [&](std::uint32_t triangle)
    { return surface.Set.GetCells()[surface.Set.GetCellOf(triangle)].Id; };
    vtkWarningWithObjectMacro(self,
      << surface.Name << " touches or intersects itself, first in "
      << "cells " << cellOf(pairs[0].First) << " and " << cellOf(pairs[0].Second) << ". What it "
      << "covers twice counts as its faces say, and the volume of the output may be wrong there. "
      << "Intersections are shown by Surface Intersection without a Source.");
  }
}

void WarnOfBadEdges(vtkSkdTreeBooleanOperation* self, const SkdBadEdges& bad, vtkPolyData* output)
{
  double a[3];
  output->GetPoint(bad.First.first, a);
  vtkWarningWithObjectMacro(
    self, << "The output is not closed: " << bad.Count << " edges are open, the first at "
          << TextOf({ { a[0], a[1], a[2] } })
          << ". The inputs have triangles without area or intersect themselves there.");
}

double SixVolumesOf(const SkdBooleanResult& result)
{
  double sum = 0.0;
  for (const SkdBooleanPiece& piece : result.Pieces)
  {
    const skd::Vector3& origin = result.Points[0].Position;
    const auto at = [&](int i) { return result.Points[piece.Corners[i]].Position - origin; };
    sum += Dot(at(0), Cross(at(1), at(2)));
  }
  return sum;
}

SkdBadEdges BadEdgesOf(const SkdBooleanResult& result)
{
  std::vector<SkdTriangleSet::Corners> triangles;
  for (const SkdBooleanPiece& piece : result.Pieces)
  {
    triangles.push_back(piece.Corners);
  }
  return SkdFindBadEdges(triangles.data(), triangles.size());
}

void ReportSolids(vtkSkdTreeBooleanOperation* self, const SkdPlacement& placement,
  const SkdBooleanResult& result, vtkPolyData* output, SkdReport& report)
{
  const SkdBadEdges bad = BadEdgesOf(result);
  if (bad.Count > 0)
  {
    WarnOfBadEdges(self, bad, output);
  }
  const double cube = 6.0 * placement.Scale * placement.Scale * placement.Scale;
  report.AddMeasure("InputVolume", std::abs(SkdSixVolumes(placement.First)) / cube);
  report.AddMeasure("SourceVolume", std::abs(SkdSixVolumes(placement.GetSecond())) / cube);
  report.AddMeasure("Volume", SixVolumesOf(result) / cube);
  report.AddCount("BadEdges", bad.Count);
}
}

vtkSkdTreeBooleanOperation::vtkSkdTreeBooleanOperation()
  : vtkSkdTreeSourceAlgorithm(SourceUse::Required, { VTK_POLY_DATA })
{
  this->WholeInput = true; // all of it bounds the solid
}

vtkSkdTreeBooleanOperation::~vtkSkdTreeBooleanOperation() = default;

int vtkSkdTreeBooleanOperation::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (IsLaterPiece(outputVector->GetInformationObject(0)))
  {
    return 1; // the first piece has all
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  SkdStopwatch watch;
  const Surface first("Input", vtkDataObject::GetData(inputVector[0]), this->ChordalDeviation);
  const Surface second("Source", vtkDataObject::GetData(inputVector[1]), this->ChordalDeviation);
  for (const Surface* surface : { &first, &second })
  {
    SkdWarnAboutCoarseFaces(this, surface->Set.GetNumberOfCoarseFaces(), this->ChordalDeviation);
    if (!IsClosed(this, *surface))
    {
      return 1;
    }
  }
  SkdLoop own(this, 0, 0.2, 0.4, 8);
  WarnOfOwnContacts(this, first, own);
  WarnOfOwnContacts(this, second, own);

  const SkdPlacement placement = SkdMakePlacement(first.Set, &second.Set, std::nullopt);
  SkdLoop loop(this, 0, 0.4, 0.6, 8);
  const auto pairs = SkdTrianglePairs(placement).FindByTrees({ SkdPairSearch::All, 0.0 }, loop);
  if (SkdIsAborted(this))
  {
    return 1;
  }
  const SkdContactPoints contacts(placement, pairs);
  const SkdSplitSegments segments(placement, pairs, contacts);
  const std::array<SkdSplitResult, 2> split{ SkdSplitTriangles(segments, 0),
    SkdSplitTriangles(segments, 1) };
  this->UpdateProgress(0.8);
  const SkdBooleanResult result = SkdCombine(
    placement, pairs, contacts, segments, split, static_cast<SkdBooleanOperation>(this->Operation));
  std::set<std::string> refused;
  SkdFillBooleanSurface(placement, split, result,
    { { &first.Blocks, &second.Blocks }, first.IsComposite || second.IsComposite }, output,
    refused);
  for (const char* own : { SkdBooleanNames::Input, SkdBooleanNames::Cell, SkdBooleanNames::Block })
  {
    refused.erase(own); // of an operation before: its ids are of other inputs
  }
  SkdWarnAboutRefused(this, refused);

  SkdReport report(output);
  ReportSolids(this, placement, result, output, report);
  report.AddCount("TrianglesSplit", split[0].NumberSplit + split[1].NumberSplit);
  report.AddMeasure("Seconds", watch.Lap());
  return 1;
}

void vtkSkdTreeBooleanOperation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "Operation", this->Operation, "ChordalDeviation", this->ChordalDeviation);
}
VTK_ABI_NAMESPACE_END
