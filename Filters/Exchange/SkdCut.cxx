// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdCut.h"

#include "Cells/Read/SkdCellReader.h"
#include "Cells/Read/SkdShape.h"
#include "Cells/Read/SkdVisitPoints.h"
#include "Cells/Search/SkdCellStore.h"
#include "Core/Search/Tree/CoverByBoxes.h"
#include "Core/Search/Tree/PackedRTree.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
template <class Id>
skd::Box3 BoxOf(const skd::PointArray& points, const Id* ids, std::size_t number)
{
  skd::Vector3 low = points.At(static_cast<std::size_t>(ids[0]));
  skd::Vector3 high = low;
  for (std::size_t i = 1; i < number; ++i)
  {
    const skd::Vector3 x = points.At(static_cast<std::size_t>(ids[i]));
    low = skd::Least(low, x);
    high = skd::Greatest(high, x);
  }
  return { low, high };
}

int LevelsOf(int processes)
{
  int levels = 6;
  for (int covered = 8; covered < processes && levels > 2; covered *= 2)
  {
    --levels;
  }
  return levels;
}

/// Whether all points are such as a SkdCellStore may have.
bool AreComparable(vtkDataSet* mesh)
{
  double largest = 0.0;
  bool are = true;
  SkdVisitPoints(mesh,
    [&](vtkIdType, const skd::Vector3& x)
    {
      are = are && SkdHasDistances(x);
      largest = std::max({ largest, std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) });
    });
  return are && (largest == 0.0 || largest >= SkdComparable.Least);
}

/// Without a copy of the cells, if all of them are to be searched, and none is curved; false if
/// not.
bool ReadBoxes(vtkDataSet* mesh, std::vector<skd::Box3>& boxes)
{
  const skd::PointArray points = SkdStoredPointsOf(mesh);
  if (!(points.Floats || points.Doubles) || mesh->GetCellGhostArray() ||
    mesh->GetPointGhostArray() || !AreComparable(mesh))
  {
    return false;
  }
  boxes.reserve(static_cast<std::size_t>(mesh->GetNumberOfCells()));
  const SkdCellReader reader(mesh);
  vtkNew<vtkIdList> list;
  int known = -1;
  std::size_t size = 0; // 0: of any number
  bool areStraight = true;
  reader.VisitCells(0, mesh->GetNumberOfCells(), list,
    [&](vtkIdType cell, const auto* ids, std::size_t number)
    {
      const int type = reader.TypeOf(cell);
      if (type != known)
      {
        const SkdShape shape = SkdShapeOfCellType(type);
        areStraight = areStraight && shape < SkdShape::Generic;
        size = static_cast<std::size_t>(SkdNumberOfPoints(shape));
        known = type;
      }
      areStraight = areStraight && number > 0 && (size == 0 || number == size);
      boxes.push_back(areStraight ? BoxOf(points, ids, number) : skd::Box3());
    });
  return areStraight;
}
}

std::vector<skd::Box3> SkdBoxesOfCells(vtkDataSet* mesh, bool skipGhosts)
{
  std::vector<skd::Box3> straight;
  if (ReadBoxes(mesh, straight))
  {
    return straight;
  }
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
    this->Tree = std::make_shared<skd::PackedRTree>(this->Boxes);
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
