// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeClosestPoint.h"

#include "Bodies/SkdSource.h"
#include "Exchange/SkdFilterInputs.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdInterpolate.h"
#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdReport.h"
#include "Search/Closest/SkdClosestArrays.h"
#include "Search/Closest/SkdRemoteClosest.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <set>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeClosestPoint);

class vtkSkdTreeClosestPoint::Internals
{
public:
  SkdSource Source;
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
      for (vtkIdType i = begin; i < end; ++i)
      {
        double x[3];
        mesh->GetPoint(i, x);
        if (const auto nearest = source.FindNearest(x, maximumDistance))
        {
          answers.Set(i, *nearest, source.IsInside(x));
        }
      }
    });
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

void WarnAbout(vtkSkdTreeClosestPoint* self, const SkdSource& source, const SkdTreeCounts& counts)
{
  if (counts.Cells == 0)
  {
    vtkWarningWithObjectMacro(self, "Source has no cells to search; no closest point is found.");
  }
  else if (self->GetSignedDistance() && !source.HasSides())
  {
    vtkWarningWithObjectMacro(self, "Source has no surface; distances are unsigned.");
  }
  else if (source.GetNumberOfOpenEdges() > 0)
  {
    vtkWarningWithObjectMacro(self,
      "Source is not closed: it has " << source.GetNumberOfOpenEdges()
                                      << " open edges. Signs may be wrong near gaps.");
  }
}

void Report(vtkDataObject* output, const SkdSource& source, const SkdTreeCounts& counts,
  const std::vector<SkdClosestArrays>& answers, double buildSeconds, double querySeconds)
{
  vtkIdType asked = 0;
  vtkIdType found = 0;
  for (const SkdClosestArrays& answer : answers)
  {
    asked += answer.GetNumberOfPoints();
    found += answer.CountFound();
  }
  SkdReport report(output);
  report.AddCount("Points", asked);
  report.AddCount("PointsFound", found);
  report.AddCount("SourceCells", counts.Cells);
  report.AddCount("SourceCellsLeftOut", counts.CellsLeftOut);
  report.AddCount("TreesBuilt", source.GetTreesBuilt());
  report.AddMeasure("Epsilon", counts.Tolerance);
  report.AddMeasureOf("ChordalLength", source.GetChordalLength());
  report.AddMeasure("BuildSeconds", buildSeconds);
  report.AddMeasure("QuerySeconds", querySeconds);
  if (source.HasSides())
  {
    report.AddCount("OpenEdges", source.GetNumberOfOpenEdges());
  }
}
}

vtkSkdTreeClosestPoint::vtkSkdTreeClosestPoint()
  : vtkSkdTreeFacetAlgorithm(SourceUse::Required, { LIKE_INPUT, VTK_POLY_DATA })
  , Impl(new Internals)
{
}

vtkSkdTreeClosestPoint::~vtkSkdTreeClosestPoint() = default;

// Signs need all of the boundary.
bool vtkSkdTreeClosestPoint::CanAskPieces(int port)
{
  return port == 1 && !this->SignedDistance;
}

int vtkSkdTreeClosestPoint::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* sourceData = vtkDataObject::GetData(inputVector[1]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  const std::vector<SkdBlock> blocks = SkdMirror(vtkDataObject::GetData(inputVector[0]), output);
  const SkdSpreadSource* spread = this->Inputs->GetSpread(1);
  SkdStopwatch watch;

  SkdSource& source = this->Impl->Source;
  source.Update(sourceData, this->SignedDistance, this->Epsilon, this->ChordalDeviation);
  const SkdTreeCounts counts = spread ? spread->CountAll(source.GetCounts()) : source.GetCounts();
  WarnAbout(this, source, counts);
  SkdWarnAboutCoarseFaces(this, source.GetNumberOfCoarseFaces(), this->ChordalDeviation);
  const double buildSeconds = watch.Lap();

  std::vector<SkdClosestArrays> answers;
  SkdLoop loop(this, SkdCountPoints(blocks), 0.2, this->InterpolateSourceData ? 0.7 : 1.0);
  std::vector<SkdFoundCell> cells;
  if (spread)
  {
    SkdRemoteClosest closest =
      SkdFindRemoteClosest(blocks, source, *spread, this->MaximumDistance, loop);
    answers = std::move(closest.Answers);
    cells = std::move(closest.Cells);
    SkdReport(output).AddCount("PointsSent", static_cast<vtkIdType>(closest.PointsSent));
  }
  for (std::size_t i = 0; !spread && i < blocks.size(); ++i)
  {
    answers.push_back(FindNearest(blocks[i].Mesh, source, this->MaximumDistance, loop));
  }
  const double querySeconds = watch.Lap();

  const bool isComposite = SkdIsComposite(sourceData);
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    answers[i].AddTo(blocks[i].Mesh->GetPointData(),
      spread ? spread->GetBlocks() : source.GetBlocks(), isComposite);
  }
  if (this->InterpolateSourceData && spread)
  {
    InterpolateFound(this, blocks, SkdFoundCells(*spread, cells), answers);
  }
  else if (this->InterpolateSourceData)
  {
    InterpolateHere(this, blocks, source, answers);
  }
  if (this->GenerateLines)
  {
    SkdConnectClosest(blocks, answers, vtkPolyData::GetData(outputVector, 1));
  }
  Report(output, source, counts, answers, buildSeconds, querySeconds);
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
