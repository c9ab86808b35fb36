// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeProbe.h"

#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdPointOrder.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdReport.h"
#include "Pipeline/SkdSearchRange.h"
#include "Pipeline/SkdShownElements.h"
#include "Search/Probe/SkdCellFinder.h"
#include "Search/Probe/SkdCellLocations.h"
#include "Search/Probe/SkdLineProbe.h"
#include "Search/Probe/SkdProbedData.h"
#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeProbe);

class vtkSkdTreeProbe::Internals
{
public:
  std::vector<SkdBlock> Blocks; // of the source, those with cells
  SkdSourceTrees Trees;
  SkdCellFinderSource Source{ Trees, Blocks };
  SkdCellFinderRules Rules;
  SkdProbedNames Names;

  /// Returns how many trees were built.
  int Update(vtkDataObject* source, double epsilon)
  {
    this->Blocks = SkdBlocksWithCells(SkdBlocksOf(source));
    const int built = this->Trees.Update(this->Blocks, epsilon);
    this->Source.Update(built);
    this->Names.Refused.clear();
    this->Names.Missing.clear();
    return built;
  }

  SkdCellLocations Probe(vtkDataSet* output, double fill, SkdLoop& loop);
  void WarnAbout(vtkSkdTreeProbe* self) const;
};

namespace
{
void AddName(vtkObject* self, std::set<std::string>& names, const char* name)
{
  if (name && names.insert(name).second)
  {
    self->Modified();
  }
}

void ClearNames(vtkObject* self, std::set<std::string>& names)
{
  names.clear();
  self->Modified();
}

void Report(vtkDataObject* output, const SkdTreeCounts& counts, int built,
  const std::vector<SkdCellLocations>& locations, double buildSeconds, double querySeconds)
{
  const std::vector<SkdBlock> blocks = SkdBlocksOf(output);
  vtkIdType numberOfQueries = 0, found = 0, outside = 0;
  for (std::size_t block = 0; block < blocks.size(); ++block)
  {
    const std::vector<unsigned char> shown = SkdFindShown(blocks[block].Mesh, vtkDataObject::POINT);
    const SkdCellLocations& some = locations[block];
    numberOfQueries += SkdCountShown(shown);
    found += SkdCountShown(shown, [&some](vtkIdType i) { return some.IsValid(i); });
    outside += SkdCountShown(shown, [&some](vtkIdType i) { return some.IsOutside(i); });
  }
  SkdReport report(output);
  report.AddCount("Points", numberOfQueries);
  report.AddCount("PointsFound", found);
  report.AddCount("PointsOutside", outside);
  report.AddCount("SourceCells", counts.Cells);
  report.AddCount("SourceCellsLeftOut", counts.CellsLeftOut);
  report.AddCount("TreesBuilt", built);
  report.AddMeasure("Epsilon", counts.Tolerance);
  report.AddMeasure("BuildSeconds", buildSeconds);
  report.AddMeasure("QuerySeconds", querySeconds);
}
}

// Finds the location of each point and gathers the source's data there, in one go.
SkdCellLocations vtkSkdTreeProbe::Internals::Probe(vtkDataSet* output, double fill, SkdLoop& loop)
{
  const vtkIdType n = output->GetNumberOfPoints();
  SkdProbedData data(output->GetPointData(), n, this->Blocks, this->Names, fill);
  SkdCellLocations locations(n);
  const SkdPointOrder order(output);
  loop.For(n,
    [&](vtkIdType begin, vtkIdType end)
    {
      SkdCellFinder finder(this->Source, this->Rules);
      SkdGradient gradient;
      for (vtkIdType at = begin; at < end; ++at)
      {
        double x[3];
        const vtkIdType i = order.GetPoint(at, x);
        if (finder.Find(x))
        {
          locations.Set(i, finder.GetLocation());
          data.Set(i, x, finder, gradient);
        }
      }
    });
  return locations;
}

void vtkSkdTreeProbe::Internals::WarnAbout(vtkSkdTreeProbe* self) const
{
  if (this->Trees.GetCounts().Cells == 0)
  {
    vtkWarningWithObjectMacro(self, "Source has no cells to search; all points are outside.");
    return;
  }
  SkdWarnAboutRefused(self, this->Names.Refused);
  for (const std::string& name : this->Names.Missing)
  {
    vtkWarningWithObjectMacro(self,
      "Source has no point array " << name << " of numbers in all its blocks; it is ignored.");
  }
}

vtkSkdTreeProbe::vtkSkdTreeProbe()
  : vtkSkdTreeSearchAlgorithm(SourceUse::Required, { LIKE_INPUT, VTK_POLY_DATA, VTK_TABLE })
  , Impl(new Internals)
{
}

vtkSkdTreeProbe::~vtkSkdTreeProbe() = default;

void vtkSkdTreeProbe::AddCategoricalArray(const char* name)
{
  AddName(this, this->Impl->Names.Categorical, name);
}

void vtkSkdTreeProbe::ClearCategoricalArrays()
{
  ClearNames(this, this->Impl->Names.Categorical);
}

void vtkSkdTreeProbe::AddGradientArray(const char* name)
{
  AddName(this, this->Impl->Names.Gradients, name);
}

void vtkSkdTreeProbe::ClearGradientArrays()
{
  ClearNames(this, this->Impl->Names.Gradients);
}

int vtkSkdTreeProbe::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* source = vtkDataObject::GetData(inputVector[1]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  const std::vector<SkdBlock> outputs = SkdMirror(input, output);
  if (!this->PassInputData)
  {
    SkdDropData(outputs);
  }

  Internals& internals = *this->Impl;
  const double radii[3] = { -1.0, VTK_DOUBLE_MAX, this->MaximumDistance };
  internals.Rules = { this->RelativeTolerance, this->AbsoluteTolerance,
    radii[this->OutsidePoints] };
  SkdStopwatch watch;
  const int built = internals.Update(source, this->Epsilon);
  const double buildSeconds = watch.Lap();

  std::vector<SkdCellLocations> locations;
  const double fill = this->UseFillValue ? this->FillValue : vtkMath::Nan();
  SkdLoop loop(this, SkdCountPoints(outputs), 0.2, this->ProbeLines ? 0.5 : 1.0);
  for (const SkdBlock& block : outputs)
  {
    locations.push_back(internals.Probe(block.Mesh, fill, loop));
  }
  const bool isComposite = SkdIsComposite(source);
  for (std::size_t i = 0; i < outputs.size(); ++i)
  {
    locations[i].AddTo(outputs[i].Mesh->GetPointData(), internals.Blocks, isComposite);
  }
  if (this->ProbeLines)
  {
    this->CutLines(input, isComposite, outputVector);
  }
  internals.WarnAbout(this);
  Report(output, internals.Trees.GetCounts(), built, locations, buildSeconds, watch.Lap());
  internals.Blocks.clear();
  return 1;
}

bool vtkSkdTreeProbe::NeedsNearbySource(SkdSearchRange& range)
{
  range.Distance = this->OutsidePoints == NEAREST_CELL_WITHIN_DISTANCE
    ? std::max(this->AbsoluteTolerance, this->MaximumDistance)
    : this->AbsoluteTolerance;
  range.OfDiagonal = this->RelativeTolerance;
  range.WithNearest = this->OutsidePoints == NEAREST_CELL;
  return true;
}

void vtkSkdTreeProbe::CutLines(
  vtkDataObject* input, bool isSourceComposite, vtkInformationVector* outputVector)
{
  Internals& internals = *this->Impl;
  const std::vector<SkdBlock> inputs = SkdBlocksOf(input);
  const std::vector<SkdLinePiece> pieces = SkdPiecesOf(inputs);
  if (pieces.empty())
  {
    vtkWarningMacro("Input has no lines to probe along. Switch ProbeLines off to probe points.");
  }
  SkdLoop loop(this, static_cast<vtkIdType>(pieces.size()), 0.5, 1.0);
  SkdCellFinderRules rules = internals.Rules;
  rules.OutsideRadius = -1.0;
  const std::vector<SkdLineInterval> intervals = SkdCutLines(pieces, internals.Source, rules, loop);
  const SkdLineOutput made{ inputs, internals.Source, pieces, intervals, SkdIsComposite(input),
    isSourceComposite };
  SkdFillIntervals(made, internals.Names.Refused, vtkPolyData::GetData(outputVector, 1));
  SkdFillIntegrals(made, vtkTable::GetData(outputVector, 2));
}

void vtkSkdTreeProbe::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "RelativeTolerance", this->RelativeTolerance, "AbsoluteTolerance",
    this->AbsoluteTolerance, "OutsidePoints", this->OutsidePoints, "MaximumDistance",
    this->MaximumDistance, "UseFillValue", this->UseFillValue, "FillValue", this->FillValue,
    "PassInputData", this->PassInputData, "ProbeLines", this->ProbeLines);
  for (const std::string& name : this->Impl->Names.Categorical)
  {
    SkdPrint(os, indent, "CategoricalArray", name);
  }
  for (const std::string& name : this->Impl->Names.Gradients)
  {
    SkdPrint(os, indent, "GradientArray", name);
  }
}
VTK_ABI_NAMESPACE_END
