// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeCompareSurfaces.h"

#include "Bodies/SkdOuterSurface.h"
#include "Exchange/SkdFilterInputs.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdProcesses.h"
#include "Pipeline/SkdReport.h"
#include "Search/Compare/SkdComparison.h"
#include "Search/Compare/SkdSpreadSides.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeCompareSurfaces);

class vtkSkdTreeCompareSurfaces::Internals
{
public:
  std::array<SkdComparedInput, 2> Inputs;
  std::array<SkdSpreadSides, 2> Sides; // of inputs that are in pieces
};

namespace
{
constexpr const char* PortNames[] = { "Input", "Source" };

/// The first process, of what any of them has.
void WarnAbout(
  vtkSkdTreeCompareSurfaces* self, const SkdComparedInput& input, int port, const SkdReduction& all)
{
  const SkdComparedSet& set = input.Set;
  const auto coarse =
    static_cast<vtkIdType>(all.Largest(static_cast<double>(set.GetNumberOfCoarseFaces())));
  if (all.GetRank() > 0)
  {
    return;
  }
  if (set.IsEmpty())
  {
    vtkWarningWithObjectMacro(
      self, << PortNames[port] << " has no finite point to compare; there are no distances.");
  }
  else if (self->GetSignedDistance() && !set.HasSides())
  {
    vtkWarningWithObjectMacro(
      self, << PortNames[port] << " has no surface; distances to it are unsigned.");
  }
  else if (set.GetNumberOfOpenEdges() > 0)
  {
    vtkWarningWithObjectMacro(self, << PortNames[port] << " is not closed: it has "
                                    << set.GetNumberOfOpenEdges()
                                    << " open edges. Signs may be wrong near gaps.");
  }
  SkdWarnAboutCoarseFaces(self, coarse, self->GetChordalDeviation());
}

/// The diagonal of the bounds of both, and the largest coordinate.
struct Size
{
  double Diagonal = 0.0;
  double Largest = 0.0;

  explicit Size(const std::array<SkdComparedInput, 2>& inputs)
  {
    skd::Vector3 low[2];
    skd::Vector3 high[2];
    for (int i = 0; i < 2; ++i)
    {
      inputs[i].Set.GetBounds(low[i], high[i]);
    }
    const skd::Vector3 least = skd::Least(low[0], low[1]);
    const skd::Vector3 greatest = skd::Greatest(high[0], high[1]);
    if (least[0] <= greatest[0])
    {
      this->Diagonal = skd::Norm(greatest - least);
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Largest =
          std::max({ this->Largest, std::abs(least[axis]), std::abs(greatest[axis]) });
      }
    }
  }
};

/// Of distances.
double RoundingOf(const Size& size)
{
  return 64.0 * std::numeric_limits<double>::epsilon() * size.Largest;
}

SkdHausdorffLimits LimitsOf(vtkSkdTreeCompareSurfaces* self, const Size& size)
{
  return { std::max(self->GetTolerance() * size.Diagonal, RoundingOf(size)),
    self->GetMaximumBisections() };
}

SkdSampling SamplingOf(vtkSkdTreeCompareSurfaces* self, const Size& size)
{
  return { self->GetSampleSpacing() * size.Diagonal,
    { self->GetStatisticsTolerance(), RoundingOf(size) } };
}

void EmptyAll(const std::vector<SkdBlock>& blocks)
{
  for (const SkdBlock& block : blocks)
  {
    block.Mesh->Initialize();
  }
}

/// Half of the progress each. Returns whether it was aborted on no process.
bool Compare(vtkSkdTreeCompareSurfaces* self, SkdComparison& comparison, const Size& size,
  const SkdReduction& all, double first, double last)
{
  const SkdComparedSet& from = comparison.From->Set;
  const SkdComparedSet& to = comparison.To->Set;
  if (all.IsAny(from.IsEmpty() || to.IsEmpty())) // then on all
  {
    return true;
  }
  const double middle = (first + last) / 2.0;
  const SkdHausdorffLimits limits = LimitsOf(self, size);
  comparison.Hausdorff = SkdHausdorffOf(from, to, limits, all, self, first, middle);
  const bool isWhole =
    comparison.Samples.Add(from, to, SamplingOf(self, size), all, self, middle, last);

  const SkdHausdorff& found = comparison.Hausdorff;
  if (found.UpperBound > found.Distance + limits.Tolerance && isWhole && all.GetRank() == 0)
  {
    vtkWarningWithObjectMacro(self,
      "The Hausdorff distance is only known to be between "
        << found.Distance << " and " << found.UpperBound << ": the maximum of " << limits.Bisections
        << " bisections was reached. Increase MaximumBisections or Tolerance.");
  }
  return isWhole;
}

void Report(vtkDataObject* output, const std::array<SkdComparedInput, 2>& inputs,
  const std::array<SkdComparison, 2>& comparisons, double buildSeconds, double querySeconds)
{
  const SkdComparedSet& a = inputs[0].Set;
  const SkdComparedSet& b = inputs[1].Set;
  SkdReport report(output);
  report.AddCount(
    "Bisections", comparisons[0].Hausdorff.Bisections + comparisons[1].Hausdorff.Bisections);
  report.AddMeasure("Epsilon", std::max(a.GetCounts().Tolerance, b.GetCounts().Tolerance));
  report.AddMeasureOf("ChordalLength", std::max(a.GetChordalLength(), b.GetChordalLength()));
  int built = a.GetTreesBuilt() + b.GetTreesBuilt();
  for (const SkdComparedSet* set : { &a, &b })
  {
    built += set->GetSpreadSides() ? set->GetSpreadSides()->GetTreesBuilt() : 0;
  }
  report.AddRun(built, buildSeconds, "QuerySeconds", querySeconds);
  if (a.HasSides() || b.HasSides())
  {
    report.AddCount("OpenEdges", a.GetNumberOfOpenEdges() + b.GetNumberOfOpenEdges());
  }
}
}

vtkSkdTreeCompareSurfaces::vtkSkdTreeCompareSurfaces()
  : vtkSkdTreeFacetAlgorithm(SourceUse::Required, { LIKE_INPUT, LIKE_INPUT, VTK_TABLE })
  , Impl(new Internals)
{
  this->WholeInput = true; // the largest distance may be anywhere in either
  this->Inputs->SetMutual([this](SkdSearchRange& range) { return this->FindRange(range); });
}

vtkSkdTreeCompareSurfaces::~vtkSkdTreeCompareSurfaces() = default;

// The second output is like the Source.
int vtkSkdTreeCompareSurfaces::RequestDataObject(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int done = this->Superclass::RequestDataObject(request, inputVector, outputVector);
  if (vtkDataObject* source = vtkDataObject::GetData(inputVector[1]))
  {
    SkdProvideOutput(outputVector->GetInformationObject(1), source->GetDataObjectType());
  }
  return done;
}

// The nearest to each point of an own face, and that face.
bool vtkSkdTreeCompareSurfaces::FindRange(SkdSearchRange& range)
{
  range.WithOwn = true;
  range.WithNearest = true;
  range.IsOfFaces = true;
  range.IsMutual = true;
  return true;
}

// Returns whether the pieces of both tell sides.
bool vtkSkdTreeCompareSurfaces::UpdateSides(vtkMultiProcessController* controller)
{
  bool areSure = true;
  for (int port = 0; port < 2 && areSure; ++port)
  {
    SkdSpreadSides& sides = this->Impl->Sides[port];
    sides.Update(this->Inputs->GetPiece(port), this->Epsilon, controller);
    areSure = sides.AreSure();
  }
  return areSure;
}

bool vtkSkdTreeCompareSurfaces::AreSidesSure() const
{
  const std::array<SkdSpreadSides, 2>& sides = this->Impl->Sides;
  return sides[0].AreSure() && sides[1].AreSure();
}

// The set of each input that this process has of it, and the output, of its own piece.
std::vector<SkdBlock> vtkSkdTreeCompareSurfaces::Prepare(
  int port, vtkDataObject* data, vtkDataObject* output, bool isInPieces, const SkdReduction& all)
{
  SkdComparedInput& input = this->Impl->Inputs[port];
  vtkDataObject* piece = all.GetNumberOfProcesses() > 1 ? this->Inputs->GetPiece(port) : data;
  input.Blocks = SkdBlocksOf(data);
  input.IsComposite = SkdIsComposite(data);
  input.Set.Update(
    input.Blocks, this->SignedDistance && !isInPieces, this->Epsilon, this->ChordalDeviation, all);
  input.Set.SetSpreadSides(isInPieces ? &this->Impl->Sides[port] : nullptr);
  WarnAbout(this, input, port, all);
  return SkdMirror(piece, output);
}

// Returns false if sides were to be told by pieces, and are not.
bool vtkSkdTreeCompareSurfaces::CompareInputs(const std::array<vtkDataObject*, 2>& data,
  vtkInformationVector* outputVector, bool areInPieces, const SkdReduction& all)
{
  SkdStopwatch watch;
  std::array<SkdComparedInput, 2>& inputs = this->Impl->Inputs;
  std::array<std::vector<SkdBlock>, 2> outputs;
  for (int port = 0; port < 2; ++port)
  {
    outputs[port] =
      this->Prepare(port, data[port], vtkDataObject::GetData(outputVector, port), areInPieces, all);
  }
  const double buildSeconds = watch.Lap();

  const vtkIdType points = SkdCountPoints(outputs[0]) + SkdCountPoints(outputs[1]);
  SkdLoop loop(this, areInPieces ? 2 * points : points, 0.1, 0.3);
  const Size size(inputs);
  std::array<SkdComparison, 2> comparisons{ { { &inputs[0], &inputs[1], {}, {} },
    { &inputs[1], &inputs[0], {}, {} } } };
  const bool isWhole = SkdAddDistances(outputs[0], inputs[1], loop) &&
    SkdAddDistances(outputs[1], inputs[0], loop) &&
    Compare(this, comparisons[0], size, all, 0.3, 0.65) &&
    Compare(this, comparisons[1], size, all, 0.65, 1.0);
  if (areInPieces && !this->AreSidesSure())
  {
    return false;
  }
  if (!all.IsAny(!isWhole || SkdIsAborted(this))) // parts of sums would pass for the whole
  {
    SkdFillComparison(comparisons, all, vtkTable::GetData(outputVector, 2));
  }
  Report(vtkDataObject::GetData(outputVector, 0), inputs, comparisons, buildSeconds, watch.Lap());
  return true;
}

int vtkSkdTreeCompareSurfaces::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  std::array<vtkDataObject*, 2> data{ vtkDataObject::GetData(inputVector[0]),
    vtkDataObject::GetData(inputVector[1]) };
  vtkMultiProcessController* controller = SkdControllerOf(inputVector[0]->GetInformationObject(0));
  if (!controller && SkdIsLaterPiece(outputVector->GetInformationObject(0)))
  {
    for (int port = 0; port < 2; ++port)
    {
      EmptyAll(SkdMirror(data[port], vtkDataObject::GetData(outputVector, port)));
    }
    return 1; // the first piece has it all
  }
  const SkdReduction all(controller);
  const bool areInPieces = this->SignedDistance && controller && !this->Inputs->GetWhole(0);
  if (!areInPieces)
  {
    this->Impl->Sides = {};
    this->CompareInputs(data, outputVector, false, all);
  }
  else if (!this->UpdateSides(controller) || !this->CompareInputs(data, outputVector, true, all))
  {
    this->Impl->Sides = {};
    data = { this->Inputs->GatherNearby(0), this->Inputs->GatherNearby(1) };
    this->CompareInputs(data, outputVector, false, all);
  }
  else
  {
    this->Inputs->AddTraffic(this->Impl->Sides[0].GetTraffic());
    this->Inputs->AddTraffic(this->Impl->Sides[1].GetTraffic());
  }
  for (SkdComparedInput& input : this->Impl->Inputs)
  {
    input.Set.Release();
    input.Blocks.clear();
  }
  return 1;
}

void vtkSkdTreeCompareSurfaces::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "Tolerance", this->Tolerance, "MaximumBisections", this->MaximumBisections,
    "StatisticsTolerance", this->StatisticsTolerance, "SampleSpacing", this->SampleSpacing,
    "SignedDistance", this->SignedDistance);
}
VTK_ABI_NAMESPACE_END
