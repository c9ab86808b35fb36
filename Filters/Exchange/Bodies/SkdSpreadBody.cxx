// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/Bodies/SkdSpreadBody.h"

#include "Cells/Curved/SkdCurvedFaces.h"
#include "Exchange/SkdAskOthers.h"
#include "Pipeline/SkdJoinedIds.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"

#include <array>
#include <cmath>
#include <limits>

namespace skdtree
{
namespace
{
using Origins = std::vector<SkdBoundary::Origin>;
using IsOwn = std::function<bool(const SkdBoundary::Origin&)>;

std::vector<unsigned char> MarksOf(const Origins& origins, const IsOwn& isOwn)
{
  std::vector<unsigned char> marks;
  for (const SkdBoundary::Origin& origin : origins)
  {
    marks.push_back(isOwn(origin) ? 1 : 0);
  }
  return marks;
}

/// The marked triangles of a surface, with its points.
vtkSmartPointer<vtkPolyData> TakeMarked(
  vtkPolyData* surface, const std::vector<unsigned char>& marks)
{
  const std::vector<SkdTriangleIds> triangles = SkdSurfaceTriangles(surface);
  vtkNew<vtkCellArray> cells;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    if (marks[i] != 0)
    {
      cells->InsertNextCell(3, triangles[i].data());
    }
  }
  auto marked = vtkSmartPointer<vtkPolyData>::New();
  marked->SetPoints(surface->GetPoints());
  marked->SetPolys(cells);
  return marked;
}

/// Sums over all processes.
template <std::size_t N>
std::array<vtkIdType, N> SumOverAll(SkdTransport& transport, const std::array<vtkIdType, N>& own)
{
  std::array<vtkIdType, N> sums{};
  for (const auto& told : SkdGatherRows(transport, std::vector<std::array<vtkIdType, N>>{ own }))
  {
    for (std::size_t i = 0; i < N; ++i)
    {
      sums[i] += told.front()[i];
    }
  }
  return sums;
}

/// Whether the faces of some blocks are those of the whole: curved ones depend on the bounds of
/// all, those of structured grids are divided in another way than those of their cells alone.
bool ArePlain(const SkdSpreadSource& spread)
{
  bool arePlain = true;
  for (const SkdBlock& block : spread.GetBlocks())
  {
    arePlain = arePlain && !SkdHasCurvedCells(block.Mesh);
  }
  spread.VisitBlocks([&](const SkdSpreadBlock& block) { arePlain = arePlain && !block.IsGrid(); });
  return arePlain;
}
}

//------------------------------------------------------------------------------
SkdSpreadBody::SkdSpreadBody(
  const SkdSpreadSource& spread, const std::vector<SkdBlock>& touching, double epsilon)
  : Spread(&spread)
{
  this->Make(touching);
  this->Build(epsilon, true);
}

int SkdSpreadBody::Update(const SkdSpreadSource& spread, double epsilon)
{
  this->Spread = &spread;
  this->NumberOfRequests = 0;
  const bool isNew = this->Known != spread.GetOwn();
  if (isNew)
  {
    this->Make(spread.BringTouching());
    this->Known = spread.GetOwn();
  }
  return this->Build(epsilon, isNew);
}

int SkdSpreadBody::Build(double epsilon, bool isNew)
{
  int built = SkdBuildLocator(this->Faces, epsilon, isNew);
  if (this->Surface != this->Faces)
  {
    built += SkdBuildLocator(this->Surface, epsilon, isNew);
  }
  this->Counts = this->Spread->CountAll(
    { 0, this->Faces->GetNumberOfCellsLeftOut(), this->Faces->GetAbsoluteEpsilon() });
  this->Counts.Cells = this->NumberOfFaces - this->Counts.CellsLeftOut;
  return built;
}

void SkdSpreadBody::Make(const std::vector<SkdBlock>& blocks)
{
  SkdTransport& transport = this->Spread->GetTransport();
  std::vector<std::vector<unsigned char>> own;
  for (const SkdBlock& block : blocks)
  {
    own.push_back(SkdOwnCellsOf(block.Mesh));
  }
  const IsOwn isOwn = [&own](const SkdBoundary::Origin& origin)
  {
    return own[static_cast<std::size_t>(origin.Block)][static_cast<std::size_t>(origin.CellId)] !=
      0;
  };
  const SkdSharedBlocks shared{ isOwn,
    [&transport](vtkIdType number) { return SumOverAll<1>(transport, { number })[0]; } };
  const SkdBoundary boundary = SkdBoundaryOf(blocks, 0.0, &shared);
  this->SetFaces(boundary, blocks, isOwn);

  const bool hasRepeats = !boundary.Repeats.empty();
  const auto sums = SumOverAll<3>(transport,
    { this->Faces->GetDataSet()->GetNumberOfCells(), hasRepeats ? 1 : 0,
      ArePlain(*this->Spread) ? 0 : 1 });
  this->NumberOfFaces = sums[0];
  this->HasRepeats = sums[1] > 0;
  this->OpenEdges = boundary.OpenEdges;
  this->FindBounds();
  this->Fit = this->OpenEdges == 0 && sums[2] == 0;
  if (this->Fit)
  {
    this->Shells = SkdFindSpreadShells(transport, SkdSurfacePoints(boundary.Surface),
      SkdSurfaceTriangles(boundary.Surface), MarksOf(boundary.SurfaceOrigins, isOwn),
      { { this->Bounds[0], this->Bounds[2], this->Bounds[4] } });
    this->Fit = this->Shells.AreSure;
  }
}

void SkdSpreadBody::SetFaces(
  const SkdBoundary& boundary, const std::vector<SkdBlock>& blocks, const IsOwn& isOwn)
{
  const std::vector<SkdJoinedIds> ids = SkdJoinedIdsOf(blocks);
  this->Origins.clear();
  for (const SkdBoundary::Origin& origin : boundary.Origins)
  {
    if (isOwn(origin))
    {
      this->Origins.push_back(
        { origin.Block, ids[static_cast<std::size_t>(origin.Block)].Of(origin.CellId) });
    }
  }
  this->Faces = SkdMakeLocator(TakeMarked(boundary.Faces, MarksOf(boundary.Origins, isOwn)));
  this->Surface = boundary.Surface == boundary.Faces
    ? this->Faces
    : SkdMakeLocator(TakeMarked(boundary.Surface, MarksOf(boundary.SurfaceOrigins, isOwn)));
}

// Of the faces of all processes.
void SkdSpreadBody::FindBounds()
{
  constexpr double none = std::numeric_limits<double>::max();
  std::array<double, 6> own{ none, -none, none, -none, none, -none };
  auto* faces = vtkPolyData::SafeDownCast(this->Faces->GetDataSet());
  if (faces->GetNumberOfCells() > 0)
  {
    faces->GetCellsBounds(own.data());
  }
  for (const auto& told :
    SkdGatherRows(this->Spread->GetTransport(), std::vector<std::array<double, 6>>{ own }))
  {
    for (std::size_t i = 0; i < own.size(); i += 2)
    {
      own[i] = std::min(own[i], told.front()[i]);
      own[i + 1] = std::max(own[i + 1], told.front()[i + 1]);
    }
  }
  std::copy(own.begin(), own.end(), this->Bounds);
}

//------------------------------------------------------------------------------
bool SkdSpreadBody::BoundsHold(const double x[3]) const
{
  return x[0] >= this->Bounds[0] && x[0] <= this->Bounds[1] && x[1] >= this->Bounds[2] &&
    x[1] <= this->Bounds[3] && x[2] >= this->Bounds[4] && x[2] <= this->Bounds[5];
}

SkdSpreadBody::Line SkdSpreadBody::SegmentOutOf(const skd::Vector3& x) const
{
  const SkdRayEnd direction = SkdRayEndsAlongAxes(this->Bounds, x.X)[0];
  return { x, { { x[0] + direction[0], x[1] + direction[1], x[2] + direction[2] } } };
}

SkdSpreadBody::Passes SkdSpreadBody::CountHere(const Line& line) const
{
  vtkIdType sum;
  const vtkIdType number =
    this->Surface->CountPasses(line.From.X, line.To.X, this->Shells.Reversed, sum);
  return { static_cast<int>(number), static_cast<int>(sum) };
}

std::vector<SkdSpreadBody::Pass> SkdSpreadBody::FindHere(const Line& line) const
{
  thread_local vtkNew<vtkDoubleArray> parameters;
  thread_local vtkNew<vtkIdTypeArray> triangles;
  thread_local vtkNew<vtkIdTypeArray> directions;
  const vtkIdType n =
    this->Surface->FindPasses(line.From.X, line.To.X, parameters, triangles, directions);
  vtkUnsignedCharArray* reversed = this->Shells.Reversed;
  std::vector<Pass> passes;
  for (vtkIdType i = 0; i < n; ++i)
  {
    const bool isReversed = reversed && reversed->GetValue(triangles->GetValue(i)) != 0;
    const int direction = static_cast<int>(directions->GetValue(i));
    passes.push_back({ parameters->GetValue(i), isReversed ? -direction : direction });
  }
  return passes;
}

// As SkdSolid does. Where several coincide only what is around after all of them counts.
std::vector<SkdPassAlong> SkdSpreadBody::InOrder(std::vector<Pass> passes) const
{
  std::stable_sort(
    passes.begin(), passes.end(), [](const Pass& a, const Pass& b) { return a.At < b.At; });
  std::vector<SkdPassAlong> along;
  int around = 0;
  for (const Pass& pass : passes)
  {
    around -= pass.Ray;
    along.push_back({ pass.At, this->IsClear({ 2, around }) ? around : 2 });
  }
  return along;
}

// As SkdSolid does.
bool SkdSpreadBody::IsClear(const Passes& passes) const
{
  if (passes.Number < 2)
  {
    return true;
  }
  const bool isClear = passes.Sum == 0 ? !this->HasRepeats : std::abs(passes.Sum) == 1;
  return isClear && !this->Shells.HasOneSided;
}

SkdSpreadResult SkdSpreadBody::Decide(std::vector<Open>& points, SkdLoop& loop)
{
  const bool isWhole = loop.For(static_cast<vtkIdType>(points.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        Open& point = points[static_cast<std::size_t>(i)];
        point.Found = this->CountHere(point.Ray);
      }
    });
  this->AskOthers(points);
  if (!isWhole)
  {
    return SkdSpreadResult::Aborted;
  }
  const bool isClear = std::all_of(
    points.begin(), points.end(), [this](const Open& point) { return this->IsClear(point.Found); });
  return isClear ? SkdSpreadResult::Done : SkdSpreadResult::Undecided;
}

void SkdSpreadBody::ListProcesses(const Line& line, std::vector<int>& processes) const
{
  const skd::Vector3 direction = line.To - line.From;
  const double length = skd::Norm(direction);
  std::vector<SkdNearProcess> near;
  this->Spread->ListAlong(line.From, (1.0 / length) * direction, 0.0, length, 0.0, near);
  for (const SkdNearProcess& other : near)
  {
    processes.push_back(other.Process);
  }
}

void SkdSpreadBody::AskOthers(std::vector<Open>& points)
{
  this->NumberOfRequests += SkdAskOthers<Line, Passes>(
    this->Spread->GetTransport(), points.size(),
    [&](std::size_t i, std::vector<int>& processes)
    { this->ListProcesses(points[i].Ray, processes); },
    [&](std::size_t i) { return points[i].Ray; },
    [this](const std::vector<Line>& lines, std::vector<SkdNumberedAnswer<Passes>>& answers)
    {
      answers.resize(lines.size());
      SkdForEach(lines.size(),
        [&](std::size_t i) {
          answers[i] = { static_cast<std::uint32_t>(i), this->CountHere(lines[i]) };
        });
      answers.erase(std::remove_if(answers.begin(), answers.end(),
                      [](const auto& answer) { return answer.TheAnswer.Number == 0; }),
        answers.end());
    },
    [&](std::size_t i, const Passes& passes, int) { points[i].Found.Add(passes); });
}

SkdSpreadBody::PassesOfLines SkdSpreadBody::FindOfAll(const std::vector<Line>& lines)
{
  const auto findHere = [this](const std::vector<Line>& some)
  {
    PassesOfLines found(some.size());
    SkdForEach(some.size(), [&](std::size_t i) { found[i] = this->FindHere(some[i]); });
    return found;
  };
  PassesOfLines found = findHere(lines);
  this->NumberOfRequests += SkdAskOthers<Line, Pass>(
    this->Spread->GetTransport(), lines.size(),
    [&](std::size_t i, std::vector<int>& processes) { this->ListProcesses(lines[i], processes); },
    [&](std::size_t i) { return lines[i]; },
    [&](const std::vector<Line>& some, std::vector<SkdNumberedAnswer<Pass>>& answers)
    {
      const PassesOfLines theirs = findHere(some);
      for (std::size_t i = 0; i < theirs.size(); ++i)
      {
        for (const Pass& pass : theirs[i])
        {
          answers.push_back({ static_cast<std::uint32_t>(i), pass });
        }
      }
    },
    [&](std::size_t i, const Pass& pass, int) { found[i].push_back(pass); });
  return found;
}
}
