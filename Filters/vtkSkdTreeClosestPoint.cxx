// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeClosestPoint.h"

#include "Bodies/SkdSource.h"
#include "Exchange/SkdFilterInputs.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdCoherentSource.h"
#include "Pipeline/SkdInterpolate.h"
#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdReport.h"
#include "Pipeline/SkdShownElements.h"
#include "Search/Closest/SkdClosestArrays.h"
#include "Search/Closest/SkdRemoteClosest.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <set>

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeClosestPoint);

namespace
{
/// What is told of the Source.
struct SourceFacts
{
  SkdTreeCounts Counts;
  int TreesBuilt = 0;
  bool HasSides = false;
  vtkIdType OpenEdges = 0;
  vtkIdType CoarseFaces = 0;
  double ChordalLength = 0.0;
};

struct Found
{
  SkdRemoteClosest Closest;
  SourceFacts Source;
  double BuildSeconds = 0.0;
  double QuerySeconds = 0.0;
  bool IsDone = false;
};

}

class vtkSkdTreeClosestPoint::Internals
{
public:
  SkdSource Source;
  SkdSpreadBody Body; // of a Source that stays in its pieces, with signs

  void Find(vtkSkdTreeClosestPoint* self, const std::vector<SkdBlock>& blocks,
    vtkDataObject* sourceData, const SkdSpreadSource* spread, SkdLoop& loop, Found& found);

  /// With signs. Nothing is done if there is no surface. Returns false if the source must be
  /// gathered.
  bool FindInPieces(vtkSkdTreeClosestPoint* self, const std::vector<SkdBlock>& blocks,
    const SkdSpreadSource& spread, SkdLoop& loop, Found& found);
};

namespace
{
SkdClosestArrays FindNearest(
  vtkDataSet* mesh, const SkdSource& source, double maximumDistance, SkdLoop& loop)
{
  SkdClosestArrays answers(mesh->GetNumberOfPoints());
  loop.For(mesh->GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      SkdCoherentSource coherent(source);
      for (vtkIdType i = begin; i < end; ++i)
      {
        double x[3];
        mesh->GetPoint(i, x);
        if (const auto nearest = coherent.FindNearest(x, maximumDistance))
        {
          answers.Set(i, *nearest, source.IsInside(x));
        }
      }
    });
  return answers;
}

std::vector<SkdClosestArrays> FindNearest(const std::vector<SkdBlock>& blocks,
  const SkdSource& source, double maximumDistance, SkdLoop& loop)
{
  std::vector<SkdClosestArrays> answers;
  for (const SkdBlock& block : blocks)
  {
    answers.push_back(FindNearest(block.Mesh, source, maximumDistance, loop));
  }
  return answers;
}

/// meshOf(block) is the mesh of one of the Source's blocks, cellOf(block, id) a cell in it.
template <class MeshOf, class CellOf>
void InterpolateSource(vtkSkdTreeClosestPoint* self, const std::vector<SkdBlock>& outputs,
  const std::vector<SkdBlock>& source, const MeshOf& meshOf, const CellOf& cellOf,
  const std::vector<SkdClosestArrays>& answers)
{
  std::set<std::string> refused;
  SkdLoop loop(self, SkdCountPoints(outputs), 0.7, 1.0);
  for (std::size_t i = 0; i < outputs.size(); ++i)
  {
    const SkdClosestArrays& answer = answers[i];
    const auto locationOf = [&](vtkIdType k)
    {
      const int block = answer.GetBlock(k);
      const vtkIdType cell = block < 0 ? -1 : cellOf(block, answer.GetCellId(k));
      return SkdSourceLocation{ block, cell, answer.GetPoint(k) };
    };
    SkdInterpolateInto(outputs[i].Mesh->GetPointData(), answer.GetNumberOfPoints(), source, meshOf,
      locationOf, refused, loop);
  }
  SkdWarnAboutRefused(self, refused);
}

void InterpolateHere(vtkSkdTreeClosestPoint* self, const std::vector<SkdBlock>& outputs,
  const SkdSource& source, const std::vector<SkdClosestArrays>& answers)
{
  const auto meshOf = [&](int block) { return source.GetMesh(block); };
  for (std::size_t block = 0; block < source.GetBlocks().size(); ++block)
  {
    SkdTouchCells(meshOf(static_cast<int>(block)));
  }
  InterpolateSource(
    self, outputs, source.GetBlocks(), meshOf, [](int, vtkIdType id) { return id; }, answers);
}

/// From cells of all processes.
void InterpolateFound(vtkSkdTreeClosestPoint* self, const std::vector<SkdBlock>& outputs,
  const SkdFoundCells& found, const std::vector<SkdClosestArrays>& answers)
{
  InterpolateSource(
    self, outputs, found.GetBlocks(), [&](int block) { return found.GetMesh(block); },
    [&](int block, vtkIdType id) { return found.CellOf(block, id); }, answers);
}

void WarnAbout(vtkSkdTreeClosestPoint* self, const SourceFacts& source)
{
  if (source.Counts.Cells == 0)
  {
    vtkWarningWithObjectMacro(self, "Source has no cells to search; no closest point is found.");
  }
  else if (self->GetSignedDistance() && !source.HasSides)
  {
    vtkWarningWithObjectMacro(self, "Source has no surface; distances are unsigned.");
  }
  else if (source.OpenEdges > 0)
  {
    vtkWarningWithObjectMacro(self,
      "Source is not closed: it has " << source.OpenEdges
                                      << " open edges. Signs may be wrong near gaps.");
  }
  SkdWarnAboutCoarseFaces(self, source.CoarseFaces, self->GetChordalDeviation());
}

void Report(vtkDataObject* output, const Found& search)
{
  const SourceFacts& source = search.Source;
  const std::vector<SkdBlock> blocks = SkdBlocksOf(output);
  vtkIdType numberOfQueries = 0;
  vtkIdType found = 0;
  for (std::size_t block = 0; block < blocks.size(); ++block)
  {
    const std::vector<unsigned char> shown = SkdFindShown(blocks[block].Mesh, vtkDataObject::POINT);
    const SkdClosestArrays& answers = search.Closest.Answers[block];
    numberOfQueries += SkdCountShown(shown);
    found += SkdCountShown(shown, [&answers](vtkIdType i) { return answers.GetBlock(i) >= 0; });
  }
  SkdReport report(output);
  report.AddCount("Points", numberOfQueries);
  report.AddCount("PointsFound", found);
  report.AddCount("SourceCells", source.Counts.Cells);
  report.AddCount("SourceCellsLeftOut", source.Counts.CellsLeftOut);
  report.AddCount("TreesBuilt", source.TreesBuilt);
  report.AddMeasure("Epsilon", source.Counts.Tolerance);
  report.AddMeasureOf("ChordalLength", source.ChordalLength);
  report.AddMeasure("BuildSeconds", search.BuildSeconds);
  report.AddMeasure("QuerySeconds", search.QuerySeconds);
  if (source.HasSides)
  {
    report.AddCount("OpenEdges", source.OpenEdges);
  }
}
}

void vtkSkdTreeClosestPoint::Internals::Find(vtkSkdTreeClosestPoint* self,
  const std::vector<SkdBlock>& blocks, vtkDataObject* sourceData, const SkdSpreadSource* spread,
  SkdLoop& loop, Found& found)
{
  SkdStopwatch watch;
  this->Body.Clear();
  const SkdSource& source = this->Source;
  const bool wantsSide = self->GetSignedDistance() && !spread;
  this->Source.Update(sourceData, wantsSide, self->GetEpsilon(), self->GetChordalDeviation());
  found.Source = { spread ? spread->CountAll(source.GetCounts()) : source.GetCounts(),
    source.GetTreesBuilt(), source.HasSides(), source.GetNumberOfOpenEdges(),
    source.GetNumberOfCoarseFaces(), source.GetChordalLength() };
  found.BuildSeconds = watch.Lap();
  const double distance = self->GetMaximumDistance();
  if (spread)
  {
    found.Closest = SkdFindRemoteClosest(blocks, source, *spread, distance, loop);
  }
  else
  {
    found.Closest.Answers = FindNearest(blocks, source, distance, loop);
  }
  found.QuerySeconds = watch.Lap();
}

bool vtkSkdTreeClosestPoint::Internals::FindInPieces(vtkSkdTreeClosestPoint* self,
  const std::vector<SkdBlock>& blocks, const SkdSpreadSource& spread, SkdLoop& loop, Found& found)
{
  SkdStopwatch watch;
  const int built = this->Body.Update(spread, self->GetEpsilon());
  if (this->Body.GetNumberOfFaces() == 0)
  {
    return true;
  }
  found.Source = { this->Body.GetCounts(), built, true };
  found.BuildSeconds = watch.Lap();
  auto closest = this->Body.IsFit()
    ? SkdFindRemoteSigned(blocks, this->Body, spread, self->GetMaximumDistance(), loop)
    : std::nullopt;
  found.QuerySeconds = watch.Lap();
  found.IsDone = closest.has_value();
  if (found.IsDone)
  {
    found.Closest = std::move(*closest);
    this->Source = SkdSource();
  }
  return found.IsDone;
}

vtkSkdTreeClosestPoint::vtkSkdTreeClosestPoint()
  : vtkSkdTreeFacetAlgorithm(SourceUse::Required, { LIKE_INPUT, VTK_POLY_DATA })
  , Impl(new Internals)
{
}

vtkSkdTreeClosestPoint::~vtkSkdTreeClosestPoint() = default;

bool vtkSkdTreeClosestPoint::CanAskPieces(int port)
{
  return port == 1;
}

int vtkSkdTreeClosestPoint::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* sourceData = vtkDataObject::GetData(inputVector[1]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  const std::vector<SkdBlock> blocks = SkdMirror(vtkDataObject::GetData(inputVector[0]), output);
  const SkdSpreadSource* spread = this->Inputs->GetSpread(1);
  const double last = this->InterpolateSourceData ? 0.7 : 1.0;
  Found found;
  if (spread && this->SignedDistance)
  {
    SkdLoop loop(this, 2 * SkdCountPoints(blocks), 0.2, last);
    if (!this->Impl->FindInPieces(this, blocks, *spread, loop, found))
    {
      sourceData = this->Inputs->GatherSpread(1);
      spread = nullptr;
    }
  }
  SkdSource& source = this->Impl->Source;
  if (!found.IsDone)
  {
    SkdLoop loop(this, SkdCountPoints(blocks), 0.2, last);
    this->Impl->Find(this, blocks, sourceData, spread, loop, found);
  }
  WarnAbout(this, found.Source);

  std::vector<SkdClosestArrays>& answers = found.Closest.Answers;
  const bool isComposite = SkdIsComposite(sourceData);
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    answers[i].AddTo(blocks[i].Mesh->GetPointData(),
      spread ? spread->GetBlocks() : source.GetBlocks(), isComposite);
  }
  if (this->InterpolateSourceData && spread)
  {
    InterpolateFound(this, blocks, SkdFoundCells(*spread, found.Closest.Cells), answers);
  }
  else if (this->InterpolateSourceData)
  {
    InterpolateHere(this, blocks, source, answers);
  }
  if (this->GenerateLines)
  {
    SkdConnectClosest(
      blocks, answers, this->FindListedPoints(outputVector), vtkPolyData::GetData(outputVector, 1));
  }
  if (spread)
  {
    SkdReport(output).AddCount("PointsSent", static_cast<vtkIdType>(found.Closest.PointsSent));
  }
  Report(output, found);
  source.Release();
  return 1;
}

void vtkSkdTreeClosestPoint::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "MaximumDistance", this->MaximumDistance, "SignedDistance",
    this->SignedDistance, "InterpolateSourceData", this->InterpolateSourceData, "GenerateLines",
    this->GenerateLines);
}
VTK_ABI_NAMESPACE_END
