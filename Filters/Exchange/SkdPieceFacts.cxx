// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdPieceFacts.h"

#include "Cells/Read/SkdMagnitudes.h"
#include "Cells/Read/SkdVisitPoints.h"
#include "Exchange/SkdGridLattice.h"
#include "Exchange/SkdPieceArrays.h"
#include "Pipeline/SkdBlocks.h"
#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace skdtree
{
namespace
{
using Extent = std::array<int, 6>;

SkdPieceFacts FactsOf(vtkDataSet* mesh)
{
  SkdPieceFacts facts;
  facts.Points = mesh->GetNumberOfPoints();
  facts.Cells = mesh->GetNumberOfCells();
  facts.DataObjectType = mesh->GetDataObjectType();
  facts.IsSurface = vtkPolyData::SafeDownCast(mesh) != nullptr;
  facts.HasPointIds = facts.Points == 0 || mesh->GetPointData()->GetGlobalIds();
  facts.HasCellIds = facts.Cells == 0 || mesh->GetCellData()->GetGlobalIds();
  facts.HasDuplicates = SkdHasDuplicates(mesh);
  facts.IsSingle = SkdIsSingle(mesh);
  facts.IsGrid = SkdIsStructured(mesh);
  facts.Magnitudes = SkdMagnitudesOf(mesh);
  SkdVisitPoints(mesh,
    [&facts](vtkIdType, const skd::Vector3& x)
    {
      if (SkdHasDistances(x))
      {
        facts.Bounds.Add(x);
      }
    });
  if (facts.IsGrid)
  {
    facts.Extent = SkdExtentOf(mesh);
    facts.Lattice = SkdLatticeOfImage(mesh);
  }
  return facts;
}

/// What of some boxes of points another one does not cover. Boxes of a grid's points that share a
/// side fill a box together: the cells, too.
std::vector<Extent> Without(const std::vector<Extent>& boxes, const Extent& cover)
{
  std::vector<Extent> rest;
  for (Extent box : boxes)
  {
    bool isApart = false;
    for (int axis = 0; axis < 6; axis += 2)
    {
      isApart = isApart || cover[axis] > box[axis + 1] || cover[axis + 1] < box[axis];
    }
    for (int axis = 0; axis < 6 && !isApart; axis += 2)
    {
      if (box[axis] < cover[axis])
      {
        rest.push_back(box);
        rest.back()[axis + 1] = cover[axis] - 1;
        box[axis] = cover[axis];
      }
      if (box[axis + 1] > cover[axis + 1])
      {
        rest.push_back(box);
        rest.back()[axis] = cover[axis + 1] + 1;
        box[axis + 1] = cover[axis + 1];
      }
    }
    if (isApart)
    {
      rest.push_back(box);
    }
  }
  return rest;
}

/// The box of the cells, of one with points up to `extent`: along a flat axis one layer.
Extent CellsOf(const Extent& extent)
{
  Extent cells = extent;
  for (int axis = 0; axis < 6; axis += 2)
  {
    cells[axis + 1] = std::max(extent[axis], extent[axis + 1] - 1);
  }
  return cells;
}
}

SkdAllFacts::SkdAllFacts(SkdTransport& transport, vtkDataSet* own)
{
  for (const std::vector<SkdPieceFacts>& facts :
    SkdGatherRows(transport, std::vector<SkdPieceFacts>{ FactsOf(own) }))
  {
    this->Pieces.push_back(facts.front());
    if (this->IsFull(static_cast<int>(this->Pieces.size()) - 1))
    {
      this->Full.push_back(static_cast<int>(this->Pieces.size()) - 1);
    }
  }
}

template <class Is>
bool SkdAllFacts::AreAll(const Is& is) const
{
  return std::all_of(
    this->Full.begin(), this->Full.end(), [&](int process) { return is(this->Of(process)); });
}

bool SkdAllFacts::IsOnePiece() const
{
  return this->Full.size() == 1 && !this->Of(this->Full.front()).HasDuplicates;
}

bool SkdAllFacts::AreSurfaces() const
{
  return this->AreAll([](const SkdPieceFacts& piece) { return piece.IsSurface; });
}

bool SkdAllFacts::HavePointIds() const
{
  return this->AreAll([](const SkdPieceFacts& piece) { return piece.HasPointIds; });
}

bool SkdAllFacts::HaveCellIds() const
{
  return this->AreAll([](const SkdPieceFacts& piece) { return piece.HasCellIds; });
}

double SkdAllFacts::GetLargestCoordinate() const
{
  double largest = 0.0;
  for (const int process : this->Full)
  {
    largest = std::max(largest, this->Of(process).Magnitudes.Largest);
  }
  return largest;
}

SkdRounding SkdAllFacts::GetRounding() const
{
  const bool isSingle = !this->AreAll([](const SkdPieceFacts& piece) { return !piece.IsSingle; });
  std::vector<SkdPointMagnitudes> magnitudes;
  for (const int process : this->Full)
  {
    magnitudes.push_back(this->Of(process).Magnitudes);
  }
  return { isSingle, magnitudes };
}

bool SkdAllFacts::AreOfOneGrid() const
{
  const SkdPieceFacts& first = this->Of(this->Full.front());
  return this->AreAll(
    [&first](const SkdPieceFacts& piece)
    {
      return piece.IsGrid && piece.DataObjectType == first.DataObjectType &&
        piece.Lattice == first.Lattice;
    });
}

Extent SkdAllFacts::GetGridExtent() const
{
  Extent all = this->Of(this->Full.front()).Extent;
  for (const int process : this->Full)
  {
    SkdUniteExtents(all, this->Of(process).Extent);
  }
  return all;
}

bool SkdAllFacts::FillGrid() const
{
  if (this->Full.empty() || !this->AreOfOneGrid())
  {
    return false;
  }
  std::vector<Extent> points{ this->GetGridExtent() };
  std::vector<Extent> cells{ CellsOf(points.front()) };
  for (const int process : this->Full)
  {
    points = Without(points, this->Of(process).Extent);
    cells = Without(cells, CellsOf(this->Of(process).Extent));
  }
  return points.empty() && cells.empty();
}
}
