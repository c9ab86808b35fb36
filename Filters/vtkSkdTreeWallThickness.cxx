// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeWallThickness.h"

#include "Cells/Read/SkdForEach.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdMakeArray.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdReport.h"
#include "Search/Rays/SkdRayStarts.h"
#include "Search/Rays/SkdSurfaceBlocks.h"
#include "Search/Rays/SkdThickness.h"
#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <algorithm>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeWallThickness);

class vtkSkdTreeWallThickness::Internals
{
public:
  SkdSurfaceBlocks Surfaces;
  SkdSourceTrees Trees;
  std::unique_ptr<SkdBodyExit> Exits; // of these

  /// Updates all to the blocks that have cells. Returns the number of trees built.
  int Update(const std::vector<SkdBlock>& source, double epsilon, double tolerance);
};

// What is known of open edges is kept with the trees.
int vtkSkdTreeWallThickness::Internals::Update(
  const std::vector<SkdBlock>& source, double epsilon, double tolerance)
{
  const int built = this->Trees.Update(source, epsilon);
  for (std::size_t block = 0; block < source.size(); ++block)
  {
    SkdTouchCells(this->Trees.GetMesh(static_cast<int>(block)));
  }
  if (!this->Exits || built > 0 || !this->Exits->IsOf(source.size(), tolerance))
  {
    this->Exits = std::make_unique<SkdBodyExit>(
      this->Trees, static_cast<int>(source.size()), tolerance, this->Surfaces.GetChordalLength());
  }
  return built;
}

namespace
{
using Filter = vtkSkdTreeWallThickness;

bool IsAtPoints(Filter* self)
{
  return self->GetStart() == Filter::POINTS;
}

SkdThicknessRule RuleOf(Filter* self, double maximum, double rounding)
{
  SkdThicknessRule rule;
  rule.Rays = self->GetNumberOfRays();
  rule.ConeAngle = vtkMath::RadiansFromDegrees(self->GetConeAngle());
  rule.AreSpheres = self->GetMethod() == Filter::SPHERES;
  rule.Separation = vtkMath::RadiansFromDegrees(self->GetSeparationAngle());
  rule.Maximum = maximum;
  rule.Rounding = rounding;
  return rule;
}

/// The starts of all blocks; directions are inward.
std::vector<SkdRayStarts> FindStarts(Filter* self, const std::vector<SkdBlock>& blocks)
{
  std::vector<SkdRayStarts> starts;
  SkdRayAim inward;
  inward.IsReversed = !self->GetReversed();
  for (const SkdBlock& block : blocks)
  {
    starts.emplace_back(block.Mesh,
      IsAtPoints(self) ? SkdQueryPoints::At::Points : SkdQueryPoints::At::Middles, inward);
  }
  return starts;
}

void AddArrays(vtkDataSetAttributes* data, const std::vector<SkdThickness>& answers,
  const std::vector<SkdBlock>& source, const SkdSurfaceBlocks& surfaces, bool isComposite)
{
  const auto n = static_cast<vtkIdType>(answers.size());
  auto values = SkdMakeArray<vtkDoubleArray>("SkdThickness", 1, n, vtkMath::Nan());
  auto points = SkdMakeArray<vtkDoubleArray>("SkdOppositePoint", 3, n, vtkMath::Nan());
  auto cells = SkdMakeArray<vtkIdTypeArray>("SkdOppositeCellId", 1, n, -1);
  std::vector<int> places(answers.size(), -1);
  SkdForEach(n,
    [&](vtkIdType i)
    {
      const SkdThickness& answer = answers[static_cast<std::size_t>(i)];
      if (answer.Block >= 0)
      {
        values->SetValue(i, answer.Value);
        points->SetTypedTuple(i, answer.Opposite.X);
        cells->SetValue(i, surfaces.GetCellId(answer.Block, answer.CellId));
        places[static_cast<std::size_t>(i)] = answer.Block;
      }
    });
  data->AddArray(values);
  data->AddArray(points);
  data->AddArray(cells);
  if (isComposite)
  {
    data->AddArray(SkdMakeBlockIndices("SkdOppositeBlockIndex", places, source));
  }
  data->SetActiveScalars("SkdThickness");
}

/// How many places there are on the surface, how many of these have no ray, and how many of the
/// others a thickness.
struct Numbers
{
  vtkIdType Asked = 0;
  vtkIdType WithoutRay = 0;
  vtkIdType Found = 0;
};

/// One message about what has no thickness.
void WarnAbout(Filter* self, const std::vector<SkdRayStarts>& starts, const Numbers& numbers)
{
  for (const SkdRayStarts& start : starts)
  {
    if (!start.Fault.empty())
    {
      vtkErrorWithObjectMacro(self, << start.Fault);
      return;
    }
  }
  const vtkIdType alone = numbers.Asked - numbers.WithoutRay - numbers.Found;
  if (alone + numbers.WithoutRay > 0 && !SkdIsAborted(self))
  {
    const std::string without = std::to_string(numbers.WithoutRay) +
      " have no normal (no surface cell, or no outer face of a volume cell, has them) or "
      "are "
      "not finite";
    const std::string nothing = std::to_string(alone) +
      " have nothing opposite to them: is the surface closed, and do its normals point outwards "
      "(see "
      "Reversed)?";
    vtkWarningWithObjectMacro(
      self, << alone + numbers.WithoutRay << " of " << numbers.Asked
            << (IsAtPoints(self) ? " points" : " cells") << " have no thickness. "
            << (numbers.WithoutRay > 0 ? without + (alone > 0 ? "; " : ".") : "")
            << (alone > 0 ? nothing : ""));
  }
}

/// The length that no ray needs to exceed, nor any sphere's diameter.
double LargestOf(const std::vector<SkdBlock>& source, const std::vector<SkdBlock>& input)
{
  return 4.0 * (SkdRayTolerance(1.0, source, {}) + SkdRayTolerance(1.0, input, {}));
}
}

vtkSkdTreeWallThickness::vtkSkdTreeWallThickness()
  : vtkSkdTreeSourceAlgorithm(SourceUse::Optional, { LIKE_INPUT })
  , Impl(new Internals)
{
}

vtkSkdTreeWallThickness::~vtkSkdTreeWallThickness() = default;

bool vtkSkdTreeWallThickness::NeedsWhole(int port)
{
  return IsAtPoints(this) || this->Superclass::NeedsWhole(port);
}

int vtkSkdTreeWallThickness::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* given = vtkDataObject::GetData(inputVector[1]);
  if (this->IsLeftToFirst(outputVector))
  {
    return 1;
  }
  vtkDataObject* against = given ? given : input;
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  SkdSurfaceBlocks& surfaces = this->Impl->Surfaces;
  const std::vector<SkdBlock> source = surfaces.Update(SkdBlocksWithCells(SkdBlocksOf(against)));
  const std::vector<SkdBlock> blocks = SkdMirror(input, output);
  SkdStopwatch watch;
  SkdSourceTrees& trees = this->Impl->Trees;
  const double tolerance = SkdRayTolerance(this->Tolerance, source, blocks);
  const int built = this->Impl->Update(source, this->Epsilon, tolerance);
  const double buildSeconds = watch.Lap();

  const std::vector<SkdRayStarts> starts = FindStarts(this, blocks);
  const double maximum = std::min(this->MaximumThickness, LargestOf(source, blocks));
  const SkdRayCaster caster(
    trees, static_cast<int>(source.size()), { tolerance, tolerance, maximum, false });
  const SkdTiedNearest nearest(trees, static_cast<int>(source.size()));
  const SkdThicknessMeasure measure(nearest, caster,
    given || this->Reversed ? nullptr : this->Impl->Exits.get(),
    RuleOf(this, maximum, SkdRayTolerance(0.0, source, blocks)));
  Numbers numbers;
  vtkIdType places = 0;
  for (const SkdRayStarts& start : starts)
  {
    places += start.GetNumber();
    numbers.Asked += start.GetNumber() - start.Inner;
    numbers.WithoutRay += start.CountWithoutRay();
  }
  SkdLoop loop(this, places, 0.2, 1.0, 8192);
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    const auto answers = measure.Measure(starts[i].Points, starts[i].Directions, loop);
    numbers.Found += std::count_if(
      answers.begin(), answers.end(), [](const SkdThickness& answer) { return answer.Block >= 0; });
    AddArrays(IsAtPoints(this) ? static_cast<vtkDataSetAttributes*>(blocks[i].Mesh->GetPointData())
                               : blocks[i].Mesh->GetCellData(),
      answers, source, surfaces, SkdIsComposite(against));
  }
  SkdReport report(output);
  report.AddCount("Points", places);
  report.AddCount("PointsFound", numbers.Found);
  WarnAbout(this, starts, numbers);
  report.AddMeasure("Epsilon", trees.GetCounts().Tolerance);
  report.AddRun(built, buildSeconds, "QuerySeconds", watch.Lap());
  return 1;
}

void vtkSkdTreeWallThickness::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "Start", this->Start, "Method", this->Method, "NumberOfRays",
    this->NumberOfRays, "ConeAngle", this->ConeAngle, "SeparationAngle", this->SeparationAngle,
    "Reversed", this->Reversed, "MaximumThickness", this->MaximumThickness, "Tolerance",
    this->Tolerance, "Epsilon", this->Epsilon);
}
VTK_ABI_NAMESPACE_END
