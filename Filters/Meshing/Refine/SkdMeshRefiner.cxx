// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdMeshRefiner.h"

#include "Core/Meshing/Mesh/MeshLayers.h"
#include "Core/Meshing/Mesh/RegularCuts.h"
#include "Meshing/Refine/SkdCellRegion.h"
#include "Meshing/Refine/SkdShowEstimate.h"
#include "Pipeline/SkdLoop.h"

#include <cmath>

namespace skdtree
{
SkdMeshRefiner::SkdMeshRefiner(vtkAlgorithm* algorithm, double first, double last,
  skd::RefinedMesh& mesh, const SkdParts& parts, const SkdMeshSettings& settings)
  : Algorithm(algorithm)
  , First(first)
  , Last(last)
  , Mesh(mesh)
  , Parts(parts)
  , Settings(settings)
{
}

/// On any process.
bool SkdMeshRefiner::IsAny(bool here) const
{
  const skd::SharedCuts* shared = this->Settings.Shared;
  return shared ? shared->GetProcesses().IsAny(here) : here;
}

/// The leaves of all processes, those of each one alone do.
bool SkdMeshRefiner::FitTogether() const
{
  const skd::SharedCuts* shared = this->Settings.Shared;
  return !shared ||
    shared->GetProcesses().SumOf(this->Mesh.NumberOfLeaves()) <=
    static_cast<double>(this->Settings.CellLimit);
}

SkdMeshOutcome SkdMeshRefiner::Refine()
{
  std::uint32_t examined = 0;
  this->LeavesAfter.push_back(this->Mesh.NumberOfLeaves());
  for (;;)
  {
    const std::uint32_t begin = examined;
    examined = this->Mesh.NumberOfCells();
    const std::vector<std::uint32_t> wanted = this->FindWanted(begin);
    this->Outcome.IsAborted = this->IsAny(this->Outcome.IsAborted);
    if (!this->IsAny(!wanted.empty()) || this->Outcome.IsAborted)
    {
      break;
    }
    this->TellSize();
    const int level = this->LeastLevelOf(wanted);
    if (!this->Cut(wanted))
    {
      this->Outcome.IsStopped = true;
      this->Outcome.StoppedAtLevel = level;
      break;
    }
    ++this->Outcome.Rounds;
    this->LeavesAfter.push_back(this->Mesh.NumberOfLeaves());
  }
  this->Algorithm->SetProgressText(nullptr);
  const bool isCutShort = this->Outcome.IsStopped || this->Outcome.IsAborted;
  this->Outcome.CellsEstimated = isCutShort ? this->Estimate() : this->LeavesAfter.back();
  return this->Outcome;
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> SkdMeshRefiner::FindWanted(std::uint32_t begin)
{
  const auto count = static_cast<vtkIdType>(this->Mesh.NumberOfCells() - begin);
  std::vector<char> marks(static_cast<std::size_t>(count), 0);
  const double before = this->Done;
  this->Done = std::max(before, std::min(1.0, this->LeavesAfter.back() / this->Estimate()));
  const double length = this->Last - this->First;
  SkdLoop loop(
    this->Algorithm, count, this->First + before * length, this->First + this->Done * length);
  const bool isDone = loop.For(count,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        marks[static_cast<std::size_t>(i)] = this->IsWanted(begin + static_cast<std::uint32_t>(i));
      }
    });
  this->Outcome.IsAborted = !isDone;
  std::vector<std::uint32_t> wanted;
  for (std::uint32_t i = 0; i < marks.size(); ++i)
  {
    if (marks[i])
    {
      wanted.push_back(begin + i);
    }
  }
  return wanted;
}

bool SkdMeshRefiner::IsWanted(std::uint32_t cell) const
{
  const skd::RefinedMesh::Cell& at = this->Mesh[cell];
  const int level = at.Level();
  if (!at.IsLeaf() || at.IsFixed || level >= this->Settings.MaximumLevel)
  {
    return false;
  }
  if (level < this->Settings.MinimumLevel)
  {
    return true;
  }
  const SkdCellRegion region(this->Mesh, cell);
  return this->Settings.IsWantedByParts(level, region, this->Parts) ||
    this->Settings.IsWantedByOthers(level, region, this->Parts);
}

bool SkdMeshRefiner::Cut(const std::vector<std::uint32_t>& wanted)
{
  const std::vector<std::uint32_t> cells =
    skd::WithLayers(this->Mesh, wanted, this->Settings.Layers,
      [this](std::vector<int>& levels)
      {
        if (this->Settings.Shared)
        {
          this->Settings.Shared->ShareLevels(levels);
        }
      });
  const skd::RefinedMesh::State before = this->Mesh.GetState();
  const bool fits = this->Settings.IsConforming
    ? this->Bisect(cells)
    : skd::RegularCuts(
        this->Mesh, this->Settings.CellLimit, this->Settings.Balance, this->Settings.Shared)
        .Refine(cells);
  const bool fitsTogether = fits && this->FitTogether();
  if (!fitsTogether)
  {
    this->Mesh.GoBackTo(before);
  }
  return fitsTogether;
}

/// The mesh must be taken back if it does not fit.
bool SkdMeshRefiner::Bisect(const std::vector<std::uint32_t>& cells)
{
  skd::Bisection bisection(this->Mesh, this->Settings.CellLimit);
  const bool fits = bisection.Refine(cells);
  return this->Settings.Shared ? this->Settings.Shared->Exchange(bisection, fits) : fits;
}

/// How much it will be, if it goes on like this, before it is made.
void SkdMeshRefiner::TellSize() const
{
  const double cells = this->Estimate();
  const double bytes =
    static_cast<double>(this->Mesh.MemorySize()) / this->LeavesAfter.back() * cells;
  SkdShowEstimate(this->Algorithm, cells, bytes);
}

//------------------------------------------------------------------------------
int SkdMeshRefiner::LeastLevelOf(const std::vector<std::uint32_t>& cells) const
{
  int least = this->Settings.MaximumLevel;
  for (const std::uint32_t cell : cells)
  {
    least = std::min(least, this->Mesh[cell].Level());
  }
  const skd::SharedCuts* shared = this->Settings.Shared;
  return shared ? static_cast<int>(shared->GetProcesses().LeastOf(least)) : least;
}

/// The number of leaves after the remaining rounds, extrapolated from the last ones, and at most as
/// if all were cut each time.
double SkdMeshRefiner::Estimate() const
{
  const double perLevel = this->Settings.IsConforming ? 2.0 : 1.0;
  const double left = std::max(0.0, perLevel * this->Settings.MaximumLevel - this->Outcome.Rounds);
  const std::size_t size = this->LeavesAfter.size();
  const double growth =
    size < 2 ? 1.5 : this->LeavesAfter.back() / std::max(1.0, this->LeavesAfter[size - 2]);
  return std::max(1.0, this->LeavesAfter.back() * std::pow(growth, left));
}
}
