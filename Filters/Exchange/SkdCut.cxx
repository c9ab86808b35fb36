// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdCut.h"

#include "Cells/Search/SkdCellStore.h"
#include "Core/Search/Tree/CoverByBoxes.h"
#include "vtkDataSet.h"

#include <algorithm>

namespace skdtree
{
namespace
{
int LevelsOf(int processes)
{
  int levels = 6;
  for (int covered = 8; covered < processes && levels > 2; covered *= 2)
  {
    --levels;
  }
  return levels;
}
}

std::vector<skd::Box3> SkdBoxesOfCells(vtkDataSet* mesh, bool skipGhosts)
{
  const SkdCellStore cells(mesh, skipGhosts, SkdComparable);
  std::vector<skd::Box3> boxes(static_cast<std::size_t>(mesh->GetNumberOfCells()));
  for (std::uint32_t cell = 0; cell < cells.NumberOfCells(); ++cell)
  {
    boxes[static_cast<std::size_t>(cells.IdOf(cell))] = cells.ExtentOf(cell);
  }
  return boxes;
}

std::vector<skd::Box3> SkdBoxesOfPoints(vtkDataSet* mesh)
{
  std::vector<skd::Box3> boxes(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (std::size_t id = 0; id < boxes.size(); ++id)
  {
    boxes[id] = SkdBoxOfPoint(mesh, static_cast<vtkIdType>(id));
  }
  return boxes;
}

skd::Box3 SkdBoxOfPoint(vtkDataSet* mesh, vtkIdType point)
{
  skd::Vector3 x;
  mesh->GetPoint(point, x.X);
  return SkdHasDistances(x) ? skd::Box3(x, x) : skd::Box3();
}

std::vector<skd::Box3> SkdCoverOf(std::vector<skd::Box3> boxes, int levels)
{
  return skd::CoverByBoxes<3>::Of(std::move(boxes), levels);
}

SkdCut::SkdCut(SkdTransport& transport, std::vector<skd::Box3> own)
{
  const SkdRowsByProcess<skd::Box3> all =
    SkdGatherRows(transport, SkdCoverOf(std::move(own), LevelsOf(transport.GetNumber())));
  this->Bounds.resize(all.size());
  for (std::size_t process = 0; process < all.size(); ++process)
  {
    this->Firsts.push_back(this->Boxes.size());
    for (const skd::Box3& box : all[process])
    {
      this->Boxes.push_back(box);
      this->Owners.push_back(static_cast<int>(process));
      this->Bounds[process].Add(box);
    }
  }
  this->Firsts.push_back(this->Boxes.size());
  if (!this->Boxes.empty())
  {
    this->Tree = std::make_unique<skd::PackedRTree>(this->Boxes);
  }
}

void SkdCut::FindOverlapping(const skd::Box3& box, std::vector<int>& processes) const
{
  processes.clear();
  if (!this->Tree || box.IsEmpty())
  {
    return;
  }
  this->Tree->ForEachOverlapping(box,
    [&](std::size_t i)
    {
      if (this->Boxes[i].Overlaps(box))
      {
        processes.push_back(this->Owners[i]);
      }
    });
  std::sort(processes.begin(), processes.end());
  processes.erase(std::unique(processes.begin(), processes.end()), processes.end());
}
}
