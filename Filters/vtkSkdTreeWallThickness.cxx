// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeWallThickness.h"

#include "Cells/Read/SkdForEach.h"
#include "Exchange/SkdFilterInputs.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdMakeArray.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdReport.h"
#include "Pipeline/SkdVolumeCells.h"
#include "Search/Rays/SkdHitCells.h"
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
#include <optional>
#include <string>

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeWallThickness);

namespace
{
/// Makes cells of the meshes of trees thread-safe to read.
void TouchAll(const SkdSourceTrees& trees, std::size_t blocks)
{
  for (std::size_t block = 0; block < blocks; ++block)
  {
    SkdTouchCells(trees.GetMesh(static_cast<int>(block)));
  }
}
}

class vtkSkdTreeWallThickness::Internals
{
public:
  SkdSurfaceBlocks Surfaces;
  SkdSourceTrees Trees;
  SkdSourceTrees HitTrees; // of the cells that rays hit, where the Source stays in its pieces
  std::unique_ptr<SkdBodyExit> Exits; // of these

  /// Brings the cells that rays hit, instead of those of the own piece, and builds their
  /// trees. Returns false after an abort on any process. All processes must call it together.
  bool BringHits(vtkSkdTreeWallThickness* self, const std::vector<SkdRayStarts>& starts,
    const SkdRayLimits& limits, const SkdThicknessRule& rule, vtkIdType numberOfSamples,
    const SkdSpreadSource& spread, std::vector<SkdBlock>& source, SkdReport& report);

  /// Updates all to the blocks that have cells. Returns the number of trees built.
  int Update(const std::vector<SkdBlock>& source, double epsilon, double tolerance);
};

// What is known of open edges is kept with the trees.
int vtkSkdTreeWallThickness::Internals::Update(
  const std::vector<SkdBlock>& source, double epsilon, double tolerance)
{
  const int built = this->Trees.Update(source, epsilon);
  TouchAll(this->Trees, source.size());
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
  SkdRayAim inward;
  inward.IsReversed = !self->GetReversed();
  return SkdMakeRayStarts(
    blocks, IsAtPoints(self) ? SkdQueryPoints::At::Points : SkdQueryPoints::At::Middles, inward);
}

/// cellOf(block, cell) is the id of a cell that was found.
template <class CellOf>
void AddArrays(vtkDataSetAttributes* data, const std::vector<SkdThickness>& answers,
  const std::vector<SkdBlock>& source, const CellOf& cellOf, bool isComposite)
{
  const auto n = static_cast<vtkIdType>(answers.size());
  auto values = SkdMakeArray<vtkDoubleArray>("SkdThickness", 1, n, vtkMath::Nan());
  auto points = SkdMakeArray<vtkDoubleArray>("SkdOppositePoint", 3, n, vtkMath::Nan());
  auto cells = SkdMakeArray<vtkIdTypeArray>("SkdOppositeCellId", 1, n, -1);
  std::vector<int> numberOfSamples(answers.size(), -1);
  SkdForEach(n,
    [&](vtkIdType i)
    {
      const SkdThickness& answer = answers[static_cast<std::size_t>(i)];
      if (answer.Block >= 0)
      {
        values->SetValue(i, answer.Value);
        points->SetTypedTuple(i, answer.Opposite.X);
        cells->SetValue(i, cellOf(answer.Block, answer.CellId));
        numberOfSamples[static_cast<std::size_t>(i)] = answer.Block;
      }
    });
  data->AddArray(values);
  data->AddArray(points);
  data->AddArray(cells);
  if (isComposite)
  {
    data->AddArray(SkdMakeBlockIndices("SkdOppositeBlockIndex", numberOfSamples, source));
  }
  data->SetActiveScalars("SkdThickness");
}

/// How many starting points there are, how many are hidden, how many of the others on the surface,
/// how many of these have no ray, and how many of the others a thickness.
struct Numbers
{
  vtkIdType Samples = 0;
  vtkIdType Hidden = 0;
  vtkIdType Requested = 0;
  vtkIdType WithoutRay = 0;
  vtkIdType Found = 0;
};

Numbers CountStarts(const std::vector<SkdRayStarts>& starts)
{
  Numbers numbers;
  for (const SkdRayStarts& start : starts)
  {
    numbers.Samples += start.GetNumber();
    numbers.Hidden += start.CountHidden();
    numbers.Requested += start.GetNumber() - start.Inner - start.CountHidden();
    numbers.WithoutRay += start.CountWithoutRay();
  }
  return numbers;
}

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
  const vtkIdType alone = numbers.Requested - numbers.WithoutRay - numbers.Found;
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
      self, << alone + numbers.WithoutRay << " of " << numbers.Requested
            << (IsAtPoints(self) ? " points" : " cells") << " have no thickness. "
            << (numbers.WithoutRay > 0 ? without + (alone > 0 ? "; " : ".") : "")
            << (alone > 0 ? nothing : ""));
  }
}

/// What measures thickness against a surface, given its trees.
struct Target
{
  SkdRayCaster Caster;
  SkdTiedNearest Nearest;
  SkdThicknessMeasure Measure;

  Target(const SkdSourceTrees& trees, const std::vector<SkdBlock>& blocks,
    const SkdRayLimits& limits, const SkdBodyExit* exits, const SkdThicknessRule& rule)
    : Caster(trees, static_cast<int>(blocks.size()), limits)
    , Nearest(trees, static_cast<int>(blocks.size()))
    , Measure(this->Nearest, this->Caster, exits, rule)
  {
  }
};

bool HasVolumeCells(const SkdSpreadSource& spread)
{
  return SkdMostOf(spread.GetTransport(), SkdHasVolumeCells(spread.GetBlocks()) ? 1 : 0) == 1;
}

/// The cells that the rays of a measure hit, given the trees of the own piece. In rounds, because a
/// start may have many rays. All processes must call it together.
SkdHitCells FindHitCells(const std::vector<SkdRayStarts>& all, const SkdThicknessMeasure& measure,
  const SkdSourceTrees& trees, const SkdSpreadSource& spread, const SkdRayLimits& limits,
  SkdLoop& loop)
{
  SkdRayCaster::Vectors points;
  SkdRayCaster::Vectors inward;
  for (const SkdRayStarts& starts : all)
  {
    points.insert(points.end(), starts.Points.begin(), starts.Points.end());
    inward.insert(inward.end(), starts.Directions.begin(), starts.Directions.end());
  }
  constexpr vtkIdType round = 4096;
  const auto n = static_cast<vtkIdType>(points.size());
  SkdHitCells found;
  found.IsWhole = true;
  SkdRayCaster::Vectors starts;
  SkdRayCaster::Vectors rays;
  vtkIdType begin = 0;
  while (found.IsWhole && SkdMostOf(spread.GetTransport(), begin < n ? 1 : 0) == 1)
  {
    const vtkIdType end = std::min(n, begin + round);
    measure.ListRays(points, inward, begin, end, starts, rays);
    const SkdHitCells some = SkdFindHitCells(starts, rays, trees, spread, limits, loop);
    found.Cells.insert(found.Cells.end(), some.Cells.begin(), some.Cells.end());
    found.RaysSent += some.RaysSent;
    found.IsWhole = some.IsWhole;
    begin = end;
  }
  return found;
}

/// The length that no ray needs to exceed, nor any sphere's diameter.
double LargestOf(const std::vector<SkdBlock>& source, const std::vector<SkdBlock>& input)
{
  return 4.0 * (SkdRayTolerance(1.0, source, {}) + SkdRayTolerance(1.0, input, {}));
}
}

bool vtkSkdTreeWallThickness::Internals::BringHits(vtkSkdTreeWallThickness* self,
  const std::vector<SkdRayStarts>& starts, const SkdRayLimits& limits, const SkdThicknessRule& rule,
  vtkIdType numberOfSamples, const SkdSpreadSource& spread, std::vector<SkdBlock>& source,
  SkdReport& report)
{
  const Target own(this->Trees, source, limits, nullptr, rule);
  SkdLoop loop(self, numberOfSamples, 0.2, 0.6, 8192);
  const SkdHitCells hits = FindHitCells(starts, own.Measure, this->Trees, spread, limits, loop);
  report.AddCount("RaysSent", static_cast<vtkIdType>(hits.RaysSent));
  source = SkdFoundCells(spread, hits.Cells).GetBlocks();
  this->HitTrees.Update(source, self->GetEpsilon());
  TouchAll(this->HitTrees, source.size());
  return hits.IsWhole;
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

// Spheres need all of the surface about them.
bool vtkSkdTreeWallThickness::CanAskPieces(int port)
{
  return port == 1 && this->GetNumberOfInputConnections(1) > 0 && this->Method == RAYS;
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
  const SkdSpreadSource* spread = this->Inputs->GetSpread(1);
  if (spread && HasVolumeCells(*spread))
  {
    given = this->Inputs->GatherSpread(1);
    spread = nullptr;
  }
  vtkDataObject* against = given ? given : input;
  SkdSurfaceBlocks& surfaces = this->Impl->Surfaces;
  std::vector<SkdBlock> source =
    surfaces.Update(spread ? spread->GetBlocks() : SkdBlocksWithCells(SkdBlocksOf(against)));
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  const std::vector<SkdBlock> blocks = SkdMirror(input, output);
  SkdStopwatch watch;
  const double tolerance = SkdRayTolerance(this->Tolerance, source, blocks);
  const int built = this->Impl->Update(source, this->Epsilon, tolerance);
  const double buildSeconds = watch.Lap();
  const std::vector<SkdRayStarts> starts = FindStarts(this, blocks);
  const double maximum = std::min(this->MaximumThickness, LargestOf(source, blocks));
  const SkdRayLimits limits{ tolerance, tolerance, maximum, false };
  const SkdThicknessRule rule = RuleOf(this, maximum, SkdRayTolerance(0.0, source, blocks));
  Numbers numbers = CountStarts(starts);
  SkdReport report(output);
  const SkdSourceTrees& own = this->Impl->Trees;
  const auto counts = spread ? spread->CountAll(own.GetCounts()) : own.GetCounts();
  const bool isWhole = !spread ||
    this->Impl->BringHits(this, starts, limits, rule, numbers.Samples, *spread, source, report);
  const std::vector<SkdJoinedIds> ids = SkdJoinedIdsOf(source);
  const auto cellOf = [&](int block, vtkIdType cell)
  {
    return spread ? ids[static_cast<std::size_t>(block)].Of(cell) : surfaces.GetCellId(block, cell);
  };
  const Target target(spread ? this->Impl->HitTrees : own, source, limits,
    given || this->Reversed ? nullptr : this->Impl->Exits.get(), rule);
  SkdLoop loop(this, numbers.Samples, spread ? 0.6 : 0.2, 1.0, 8192);
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    const auto answers = isWhole
      ? target.Measure.Measure(starts[i].Points, starts[i].Directions, loop)
      : std::vector<SkdThickness>(starts[i].Points.size());
    numbers.Found += std::count_if(
      answers.begin(), answers.end(), [](const SkdThickness& answer) { return answer.Block >= 0; });
    const auto at = IsAtPoints(this) ? vtkDataObject::POINT : vtkDataObject::CELL;
    AddArrays(blocks[i].Mesh->GetAttributes(at), answers, source, cellOf, SkdIsComposite(against));
  }
  report.AddCount("Points", numbers.Samples - numbers.Hidden);
  report.AddCount("PointsFound", numbers.Found);
  WarnAbout(this, starts, numbers);
  report.AddMeasure("Epsilon", counts.Tolerance);
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
