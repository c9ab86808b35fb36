// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdGridRefiner.h"

#include "Core/Geometry/Resolution.h"
#include "Pipeline/SkdLoop.h"

#include <cmath>

namespace skdtree
{
namespace
{
constexpr std::uint32_t BatchSize = 128; // cells that a thread takes at once

/// Takes back marks until there are `most`, evenly.
void Thin(std::vector<char>& marks, std::size_t all, std::size_t most)
{
  std::size_t examined = 0;
  for (char& mark : marks)
  {
    if (mark)
    {
      mark = (examined + 1) * most / all > examined * most / all;
      ++examined;
    }
  }
}
}

SkdGridRefiner::SkdGridRefiner(vtkAlgorithm* algorithm, double first, double last, SkdGrid& grid,
  const SkdParts& parts, const SkdRefineSettings& settings)
  : Algorithm(algorithm)
  , First(first)
  , Last(last)
  , Grid(grid)
  , Parts(parts)
  , Settings(settings)
{
  if (settings.KnownLayers >= 0)
  {
    std::vector<char> own(grid.Forest.NumberOfCells(0), 0);
    std::fill(own.begin() + grid.FirstOwn, own.begin() + grid.LastOwn, 1);
    this->IsNear = skd::Grown(grid.Forest, 0, own, settings.KnownLayers);
  }
}

/// On any process.
bool SkdGridRefiner::IsAny(bool here) const
{
  return this->Settings.Processes ? this->Settings.Processes->IsAny(here) : here;
}

bool SkdGridRefiner::Refine()
{
  std::vector<char> marks;
  for (int level = 0;; ++level)
  {
    marks.clear(); // others may go on where there are no more cells
    const bool isDone = level >= this->Grid.Forest.NumberOfLevels() ||
      (this->ExamineLevel(level) && this->MarkLevel(level, marks));
    if (this->IsAny(!isDone))
    {
      return false;
    }
    const bool isAnyMarked = std::count(marks.begin(), marks.end(), 1) > 0;
    if (!this->IsAny(isAnyMarked) || !this->HasRoomFor(level, marks))
    {
      break;
    }
    this->RefineMarked(level, marks);
  }
  this->Balance();
  return true;
}

std::vector<double> SkdGridRefiner::RefineSample(std::size_t most)
{
  std::vector<double> wanted;
  std::vector<char> marks;
  double weight = 1.0;
  for (int level = 0; this->ExamineLevel(level) && this->MarkLevel(level, marks); ++level)
  {
    const auto all = static_cast<std::size_t>(std::count(marks.begin(), marks.end(), 1));
    if (all == 0)
    {
      break;
    }
    wanted.push_back(weight * static_cast<double>(all));
    if (all > most)
    {
      Thin(marks, all, most);
      weight *= static_cast<double>(all) / static_cast<double>(most);
    }
    this->RefineMarked(level, marks);
  }
  return wanted;
}

//------------------------------------------------------------------------------
/// Calls body(begin, end) in parallel for ranges of the cells of a level, aligned to batches. The
/// time that levels take is about that of the cells on a surface: it grows by the square of the
/// branch. The last level is at 1.
template <class Body>
bool SkdGridRefiner::ForCells(int level, double share, const Body& body)
{
  const auto cells = static_cast<vtkIdType>(this->Grid.Forest.NumberOfCells(level));
  const auto batches = (cells + BatchSize - 1) / BatchSize;
  const int branch =
    *std::max_element(this->Grid.Lattice.GetBranch().begin(), this->Grid.Lattice.GetBranch().end());
  const double done = std::pow(branch, 2.0 * (level + share - this->Settings.MaximumLevel - 1));
  const double before =
    std::pow(branch, 2.0 * (level + share - 0.5 - this->Settings.MaximumLevel - 1));
  const double length = this->Last - this->First;
  SkdLoop loop(this->Algorithm, batches, this->First + std::min(before, 1.0) * length,
    this->First + std::min(done, 1.0) * length);
  return loop.For(batches,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType batch = first; batch < last; ++batch)
      {
        const vtkIdType begin = batch * BatchSize;
        body(static_cast<std::uint32_t>(begin),
          static_cast<std::uint32_t>(std::min<vtkIdType>(cells, begin + BatchSize)));
      }
    });
}

//------------------------------------------------------------------------------
SkdGridRefiner::Finding SkdGridRefiner::Examine(const skd::Box3& box,
  const SkdCandidateLists& above, std::size_t position, SkdCandidateLists& below) const
{
  Finding finding;
  for (const SkdCandidateLists::Span& span : above.Of(position))
  {
    const SkdCandidateRange range{ above.GetLanes() + span.First, above.GetLanes() + span.Last };
    const std::size_t first = below.GetSize();
    if (this->Parts.GetTree(span.Part).NarrowCandidates(
          range, box, this->Settings.Test, below.GetOpenSpan()))
    {
      below.EndSpan(span.Part, first);
      finding.Part = finding.Part < 0 ? static_cast<std::int32_t>(span.Part) : finding.Part;
      finding.LevelWanted = std::max(finding.LevelWanted, this->Settings.PartLevels[span.Part]);
    }
  }
  below.EndBox();
  return finding;
}

std::int32_t SkdGridRefiner::Count(
  const skd::Box3& box, const SkdCandidateLists& lists, std::size_t position) const
{
  std::uint32_t count = 0;
  for (const SkdCandidateLists::Span& span : lists.Of(position))
  {
    const SkdCandidateRange range{ lists.GetLanes() + span.First, lists.GetLanes() + span.Last };
    count += this->Parts.GetTree(span.Part).CountListed(range, box, this->Settings.Test);
  }
  return static_cast<std::int32_t>(count);
}

//------------------------------------------------------------------------------
bool SkdGridRefiner::ExamineLevel(int level)
{
  const skd::Forest& forest = this->Grid.Forest;
  const SkdCandidateLists above =
    level == 0 ? SkdCandidateLists::OfAll(this->Parts.GetNumberOfParts()) : std::move(this->Lists);
  std::vector<Batch> batches((forest.NumberOfCells(level) + BatchSize - 1) / BatchSize);
  const bool isDone = this->ForCells(level, 0.5,
    [&](std::uint32_t begin, std::uint32_t end)
    {
      Batch& batch = batches[begin / BatchSize];
      for (std::uint32_t cell = begin; cell < end; ++cell)
      {
        const std::size_t position = level == 0 ? 0 : forest.Parent(level, cell);
        batch.Findings.push_back(
          this->Examine(this->Grid.BoxOf(level, cell), above, position, batch.Lists));
      }
    });
  this->KeepFindings(level, batches);
  return isDone;
}

void SkdGridRefiner::KeepFindings(int level, const std::vector<Batch>& batches)
{
  this->Lists = SkdCandidateLists();
  this->Findings.clear();
  for (const Batch& batch : batches)
  {
    this->Lists.Append(batch.Lists);
    this->Findings.insert(this->Findings.end(), batch.Findings.begin(), batch.Findings.end());
  }
  if (level == static_cast<int>(this->Grid.Levels.size()))
  {
    this->Grid.Levels.emplace_back();
  }
  SkdGrid::Level& known = this->Grid.Levels[level];
  known.Resize(this->Grid.Forest.NumberOfCells(level));
  for (std::size_t cell = 0; cell < this->Findings.size(); ++cell)
  {
    known.Part[cell] = this->Findings[cell].Part;
    known.Cut[cell] = this->Findings[cell].Part >= 0;
  }
}

//------------------------------------------------------------------------------
/// Nothing below a base cell that is left alone is ever looked at.
bool SkdGridRefiner::IsLeftAlone(int level, std::uint32_t cell) const
{
  return level == 0 && !this->IsNear.empty() && !this->IsNear[cell];
}

bool SkdGridRefiner::IsWanted(int level, std::uint32_t cell) const
{
  const SkdBoxRegion box(this->Grid.BoxOf(level, cell));
  return this->IsWantedByParts(level, cell, box.GetBox()) ||
    this->Settings.IsWantedByOthers(level, box, this->Parts);
}

bool SkdGridRefiner::IsWantedByParts(int level, std::uint32_t cell, const skd::Box3& box) const
{
  if (this->Findings[cell].LevelWanted <= level)
  {
    return false;
  }
  if (!(this->Settings.NormalDeviation >= 0.0) || level < this->Settings.MinimumSurfaceLevel)
  {
    return true;
  }
  const auto spans = this->Lists.Of(cell);
  return std::any_of(spans.begin(), spans.end(),
    [&](const SkdCandidateLists::Span& span)
    {
      const SkdCandidateRange range{ this->Lists.GetLanes() + span.First,
        this->Lists.GetLanes() + span.Last };
      return this->Settings.PartLevels[span.Part] > level &&
        this->Parts.GetTree(span.Part).FindNormalDeviation(range, box, this->Settings.Test) >
        this->Settings.NormalDeviation;
    });
}

/// Unmarks cells whose children would be too small for their corners to differ.
void SkdGridRefiner::LeaveOutIndivisible(int level, std::vector<char>& marks)
{
  const auto& branch = this->Grid.Lattice.GetBranch();
  for (std::uint32_t cell = 0; cell < marks.size(); ++cell)
  {
    const skd::Box3 box = marks[cell] ? this->Grid.BoxOf(level, cell) : skd::Box3();
    for (int axis = 0; marks[cell] && axis < 3; ++axis)
    {
      const double largest = std::max(std::abs(box.Min[axis]), std::abs(box.Max[axis]));
      marks[cell] = branch[axis] == 1 || skd::IsResolved(box.Length(axis) / branch[axis], largest);
      const bool isFirst = !marks[cell] && this->Grid.ResolvedLevel < 0;
      this->Grid.ResolvedLevel = isFirst ? level : this->Grid.ResolvedLevel;
    }
  }
}

/// Finds the cells to refine, and counts what meets those of the others that are cut.
bool SkdGridRefiner::MarkLevel(int level, std::vector<char>& marks)
{
  marks.assign(this->Grid.Forest.NumberOfCells(level), 0);
  if (level < this->Settings.MaximumLevel)
  {
    const bool isDone = this->ForCells(level, 0.75,
      [&](std::uint32_t begin, std::uint32_t end)
      {
        for (std::uint32_t cell = begin; cell < end; ++cell)
        {
          marks[cell] = !this->IsLeftAlone(level, cell) && this->IsWanted(level, cell);
        }
      });
    if (!isDone)
    {
      return false;
    }
    marks = skd::Grown(this->Grid.Forest, level, marks, this->Settings.Layers);
    this->LeaveOutIndivisible(level, marks);
  }
  return this->ForCells(level, 1.0,
    [&](std::uint32_t begin, std::uint32_t end)
    {
      for (std::uint32_t cell = begin; cell < end; ++cell)
      {
        if (!marks[cell] && !this->IsLeftAlone(level, cell))
        {
          this->Grid.Levels[level].Candidates[cell] =
            this->Count(this->Grid.BoxOf(level, cell), this->Lists, cell);
        }
      }
    });
}

//------------------------------------------------------------------------------
bool SkdGridRefiner::HasRoomFor(int level, std::uint64_t families)
{
  return this->HasRoomFor(
    level, families, this->Grid.Forest.NumberOfCells() + families * this->Grid.Forest.FamilySize());
}

/// Each cell counts once, with the process that it is given out by.
bool SkdGridRefiner::HasRoomFor(int level, const std::vector<char>& marks)
{
  const auto families = static_cast<std::uint64_t>(std::count(marks.begin(), marks.end(), 1));
  if (!this->Settings.Processes)
  {
    return this->HasRoomFor(level, families);
  }
  for (std::uint32_t cell = 0; cell < marks.size(); ++cell)
  {
    this->OwnFamilies += marks[cell] && this->Grid.IsOwn(level, cell);
  }
  const double all = this->Settings.Processes->SumOf(static_cast<double>(this->OwnFamilies));
  const bool hasRoom = this->HasRoomFor(level, families,
    this->Grid.Forest.NumberOfCells(0) +
      static_cast<std::uint64_t>(all) * this->Grid.Forest.FamilySize());
  return !this->IsAny(!hasRoom);
}

/// If that would make so many cells.
bool SkdGridRefiner::HasRoomFor(int level, std::uint64_t families, std::uint64_t cells)
{
  const bool hasNumbers = families < skd::Forest::None / this->Grid.Forest.FamilySize();
  if (cells <= this->Settings.CellLimit && hasNumbers)
  {
    return true;
  }
  this->Grid.IsStopped = true;
  this->Grid.StoppedAtLevel = level;
  this->Grid.CellsWanted = cells;
  return false;
}

void SkdGridRefiner::RefineMarked(int level, const std::vector<char>& marks)
{
  for (std::uint32_t cell = 0; cell < marks.size(); ++cell)
  {
    if (marks[cell])
    {
      this->Grid.Forest.Refine(level, cell);
    }
  }
}

//------------------------------------------------------------------------------
void SkdGridRefiner::Balance()
{
  skd::MakeBalanced(this->Grid.Forest, this->Settings.Balance,
    [this](int level, std::uint32_t cell) { return this->RefineForBalance(level, cell); });
}

/// Most of these cells intersect no part, and neither do their children. The candidate lists of the
/// others are no longer available: their few children start with all candidates.
bool SkdGridRefiner::RefineForBalance(int level, std::uint32_t cell)
{
  if (!this->HasRoomFor(level, 1))
  {
    return false;
  }
  skd::Forest& forest = this->Grid.Forest;
  forest.Refine(level, cell);
  SkdGrid::Level& children = this->Grid.Levels[level + 1];
  children.Resize(forest.NumberOfCells(level + 1));
  this->Grid.Levels[level].Candidates[cell] = -1;
  const std::uint32_t first = forest.FirstChild(level, cell);
  const SkdCandidateLists all = SkdCandidateLists::OfAll(this->Parts.GetNumberOfParts());
  for (std::uint32_t child = first; child < first + forest.FamilySize(); ++child)
  {
    children.Candidates[child] = 0;
    if (this->Grid.Levels[level].Cut[cell])
    {
      const skd::Box3 box = this->Grid.BoxOf(level + 1, child);
      SkdCandidateLists lists;
      const Finding finding = this->Examine(box, all, 0, lists);
      children.Part[child] = finding.Part;
      children.Cut[child] = finding.Part >= 0;
      children.Candidates[child] = this->Count(box, lists, 0);
    }
  }
  return true;
}
}
