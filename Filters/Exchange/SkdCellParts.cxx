// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdCellParts.h"

#include "Exchange/SkdMessage.h"
#include "Exchange/SkdRepeatedCells.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdMakeArray.h"
#include "Pipeline/SkdSubset.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace skdtree
{
namespace
{
const char* const CellsName = "SkdJoinedCells";
const char* const PointsName = "SkdJoinedPoints";

vtkSmartPointer<vtkIdTypeArray> TakeArray(vtkDataSet* mesh, const char* name)
{
  vtkSmartPointer<vtkIdTypeArray> array =
    vtkIdTypeArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(name));
  mesh->GetFieldData()->RemoveArray(name);
  return array;
}

template <class Values>
void SetTuple(vtkIdTypeArray* array, std::size_t tuple, const Values& values)
{
  std::copy(
    values.begin(), values.end(), array->GetPointer(static_cast<vtkIdType>(tuple * values.size())));
}

/// Cells of a piece with their data, and which points of it they use, in their order there.
struct Taken
{
  vtkSmartPointer<vtkDataSet> Mesh;
  std::vector<vtkIdType> Points;
};

Taken CopyCells(vtkDataSet* piece, const std::vector<vtkIdType>& cells)
{
  SkdSubset subset(piece);
  subset.SetCells(cells);
  subset.CopyData();
  return { subset.Get(), subset.GetPointIds() };
}

/// Whether these, each once, are all cells of a piece in their order, and they use all its points.
bool AreAll(const std::vector<vtkIdType>& cells, vtkDataSet* piece)
{
  const int type = piece->GetDataObjectType();
  return (type == VTK_POLY_DATA || type == VTK_UNSTRUCTURED_GRID) &&
    static_cast<vtkIdType>(cells.size()) == piece->GetNumberOfCells() &&
    std::is_sorted(cells.begin(), cells.end()) && !SkdHasFreePoints(piece);
}

/// All cells of a piece, which need no copy. The field data are the mesh's own.
Taken Share(vtkDataSet* piece)
{
  auto mesh = vtkSmartPointer<vtkDataSet>::Take(piece->NewInstance());
  mesh->CopyStructure(piece);
  mesh->GetPointData()->ShallowCopy(piece->GetPointData());
  mesh->GetCellData()->ShallowCopy(piece->GetCellData());
  std::vector<vtkIdType> points(static_cast<std::size_t>(piece->GetNumberOfPoints()));
  std::iota(points.begin(), points.end(), vtkIdType(0));
  return { mesh, std::move(points) };
}

/// Most are in order already: the others are sorted, and merged with them.
template <class Item, class Less>
void SortNearlySorted(std::vector<Item>& items, const Less& isLess)
{
  std::vector<Item> late;
  std::size_t kept = 0;
  for (const Item& item : items)
  {
    if (kept > 0 && isLess(item, items[kept - 1]))
    {
      late.push_back(item);
    }
    else
    {
      items[kept++] = item;
    }
  }
  std::sort(late.begin(), late.end(), isLess);
  const auto middle = items.begin() + static_cast<std::ptrdiff_t>(kept);
  std::copy(late.begin(), late.end(), middle);
  std::inplace_merge(items.begin(), middle, items.end(), isLess);
}
}

vtkSmartPointer<vtkDataSet> SkdTakeCells(vtkDataSet* piece, const std::vector<vtkIdType>& cells,
  const SkdPieceNumbers& numbers, bool isSurface)
{
  if (cells.empty())
  {
    return nullptr;
  }
  const Taken taken = AreAll(cells, piece) ? Share(piece) : CopyCells(piece, cells);
  const SkdKinds kinds(isSurface ? vtkPolyData::SafeDownCast(piece) : nullptr);
  const auto ids = SkdMakeArray<vtkIdTypeArray>(CellsName, 2, static_cast<vtkIdType>(cells.size()));
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    SetTuple(ids, i,
      std::array<vtkIdType, 2>{
        numbers.CellIds[static_cast<std::size_t>(cells[i])], kinds.Of(cells[i]) });
  }
  const std::vector<vtkIdType>& used = taken.Points;
  const auto points =
    SkdMakeArray<vtkIdTypeArray>(PointsName, 3, static_cast<vtkIdType>(used.size()));
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    const auto point = static_cast<std::size_t>(used[i]);
    const SkdPointOrigin& origin = numbers.PointOrigins[point];
    SetTuple(
      points, i, std::array<vtkIdType, 3>{ numbers.PointIds[point], origin.Process, origin.Point });
  }
  taken.Mesh->GetFieldData()->AddArray(ids);
  taken.Mesh->GetFieldData()->AddArray(points);
  return taken.Mesh;
}

SkdCellParts::SkdCellParts(
  SkdTransport& transport, const SkdAllFacts& facts, const SkdPieces& examples)
  : Facts(facts)
  , Examples(examples)
  , Parts(static_cast<std::size_t>(transport.GetNumber()))
  , Queries(this->Parts.size())
  , Rank(transport.GetRank())
{
}

void SkdCellParts::Take(int from, vtkDataSet* cells)
{
  if (cells)
  {
    Part& part = this->Parts[static_cast<std::size_t>(from)];
    part.Mesh = cells;
    part.Cells = TakeArray(part.Mesh, CellsName);
    part.Points = TakeArray(part.Mesh, PointsName);
  }
}

// Each joined point that came, where its origin has sent it, if it has.
void SkdCellParts::FindPoints()
{
  std::size_t number = 0;
  for (const Part& part : this->Parts)
  {
    number += part.Points ? static_cast<std::size_t>(part.Points->GetNumberOfTuples()) : 0;
  }
  this->Points.reserve(number);
  for (std::size_t process = 0; process < this->Parts.size(); ++process)
  {
    vtkIdTypeArray* points = this->Parts[process].Points;
    for (vtkIdType i = 0; points && i < points->GetNumberOfTuples(); ++i)
    {
      const vtkIdType* const tuple = points->GetPointer(3 * i);
      const bool isOrigin = tuple[1] == static_cast<vtkIdType>(process);
      const auto numberOfParts = static_cast<int>(this->Parts.size());
      this->Points.push_back(isOrigin
          ? Found{ tuple[0], static_cast<int>(process), i }
          : Found{ tuple[0], numberOfParts + static_cast<int>(tuple[1]), tuple[2] });
    }
  }
  SortNearlySorted(this->Points,
    [](const Found& a, const Found& b) { return a.Id != b.Id ? a.Id < b.Id : a.Piece < b.Piece; });
  this->Points.erase(std::unique(this->Points.begin(), this->Points.end(),
                       [](const Found& a, const Found& b) { return a.Id == b.Id; }),
    this->Points.end());
}

void SkdCellParts::AskForPoints(SkdTransport& transport, vtkDataSet* piece)
{
  this->FindPoints();
  const std::size_t processes = this->Parts.size();
  SkdRowsByProcess<vtkIdType> questions(processes);
  for (Found& found : this->Points)
  {
    const auto at = static_cast<std::size_t>(found.Piece);
    if (at >= processes)
    {
      std::vector<vtkIdType>& numberOfParts = questions[at - processes];
      numberOfParts.push_back(found.Point);
      found.Point = static_cast<vtkIdType>(numberOfParts.size()) - 1;
    }
  }
  const SkdRowsByProcess<vtkIdType> wanted = SkdExchangeRows(transport, questions);
  SkdExchangeMeshes(
    transport,
    [&](int to) -> vtkSmartPointer<vtkDataSet>
    {
      const std::vector<vtkIdType>& points = wanted[static_cast<std::size_t>(to)];
      if (points.empty())
      {
        return nullptr;
      }
      SkdSubset subset(piece);
      subset.SetPoints(points);
      subset.CopyData();
      return subset.Get();
    },
    [&](int from, vtkDataSet* points) { this->Queries[static_cast<std::size_t>(from)] = points; });
}

// Of the points that came with a process's cells. Most follow each other there, too.
std::vector<vtkIdType> SkdCellParts::FindLocalIds(int process) const
{
  std::vector<vtkIdType> local;
  vtkIdTypeArray* points = this->Parts[static_cast<std::size_t>(process)].Points;
  local.reserve(points ? static_cast<std::size_t>(points->GetNumberOfTuples()) : 0);
  auto found = this->Points.begin();
  for (vtkIdType i = 0; points && i < points->GetNumberOfTuples(); ++i)
  {
    const vtkIdType id = points->GetValue(3 * i);
    if (found == this->Points.end() || found->Id != id)
    {
      found = std::lower_bound(this->Points.begin(), this->Points.end(), id,
        [](const Found& a, vtkIdType other) { return a.Id < other; });
    }
    local.push_back(found++ - this->Points.begin());
  }
  return local;
}

// In the order of joined ids.
std::vector<SkdCellParts::Joined> SkdCellParts::SortCells() const
{
  std::vector<Joined> cells;
  const std::vector<int>& processes = this->Facts.GetFull();
  std::size_t number = 0;
  for (const Part& part : this->Parts)
  {
    number += part.Cells ? static_cast<std::size_t>(part.Cells->GetNumberOfTuples()) : 0;
  }
  cells.reserve(number);
  for (std::size_t piece = 0; piece < processes.size(); ++piece)
  {
    vtkIdTypeArray* ids = this->Parts[static_cast<std::size_t>(processes[piece])].Cells;
    for (vtkIdType i = 0; ids && i < ids->GetNumberOfTuples(); ++i)
    {
      cells.push_back({ ids->GetValue(2 * i), { static_cast<int>(piece), i } });
    }
  }
  SortNearlySorted(cells, [](const Joined& a, const Joined& b) { return a.Id < b.Id; });
  return cells;
}

vtkSmartPointer<vtkDataSet> SkdCellParts::Assemble() const
{
  SkdPieces pieces;
  std::vector<int> slots(2 * this->Parts.size(), -1); // in the list, by Found::Piece
  std::vector<std::vector<vtkIdType>> pointIds;
  for (const int process : this->Facts.GetFull())
  {
    const auto at = static_cast<std::size_t>(process);
    slots[at] = static_cast<int>(pieces.size());
    pieces.push_back(this->Parts[at].Mesh ? this->Parts[at].Mesh : this->Examples[at]);
    pointIds.push_back(this->FindLocalIds(process));
  }
  for (std::size_t process = 0; process < this->Queries.size(); ++process)
  {
    if (this->Queries[process]) // as if it had the cell arrays of its piece, too
    {
      this->Queries[process]->GetCellData()->ShallowCopy(this->Examples[process]->GetCellData());
      slots[this->Parts.size() + process] = static_cast<int>(pieces.size());
      pieces.push_back(this->Queries[process]);
    }
  }
  std::vector<SkdPieceTuples> tuples(pieces.size());
  for (std::size_t id = 0; id < this->Points.size(); ++id)
  {
    const Found& found = this->Points[id];
    const int piece = slots[static_cast<std::size_t>(found.Piece)];
    tuples[static_cast<std::size_t>(piece)].Add(found.Point, static_cast<vtkIdType>(id));
  }
  std::vector<SkdPieceCell> cells;
  const std::vector<Joined> sorted = this->SortCells();
  const auto number = static_cast<vtkIdType>(sorted.size());
  const auto ids = SkdMakeArray<vtkIdTypeArray>(SkdJoinedIdsName, 1, number);
  const auto areOwn = SkdMakeArray<vtkUnsignedCharArray>(SkdOwnCellsName, 1, number);
  cells.reserve(sorted.size());
  for (const Joined& cell : sorted)
  {
    const auto at = static_cast<vtkIdType>(cells.size());
    ids->SetValue(at, cell.Id);
    areOwn->SetValue(at, this->ProcessOf(cell.Cell) == this->Rank ? 1 : 0);
    cells.push_back(cell.Cell);
  }
  const SkdMeshParts parts{ pieces, cells, pointIds, tuples,
    static_cast<vtkIdType>(this->Points.size()) };
  const vtkSmartPointer<vtkPointSet> mesh = this->Facts.AreSurfaces()
    ? SkdAssembleSurface(parts, [this](const SkdPieceCell& cell) { return this->KindOf(cell); })
    : SkdAssembleGrid(parts);
  const auto first = static_cast<std::size_t>(this->Facts.GetFull().front());
  mesh->GetFieldData()->PassData(this->Examples[first]->GetFieldData());
  mesh->GetFieldData()->AddArray(ids);
  mesh->GetFieldData()->AddArray(areOwn);
  return mesh;
}

int SkdCellParts::KindOf(const SkdPieceCell& cell) const
{
  const Part& part = this->Parts[static_cast<std::size_t>(this->ProcessOf(cell))];
  return static_cast<int>(part.Cells->GetValue(2 * cell.CellId + 1));
}
}
