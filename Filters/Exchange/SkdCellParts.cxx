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
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>

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
  vtkIdType component = 0;
  for (const vtkIdType value : values)
  {
    array->SetValue(static_cast<vtkIdType>(tuple * values.size()) + component++, value);
  }
}
}

vtkSmartPointer<vtkDataSet> SkdTakeCells(vtkDataSet* piece, const std::vector<vtkIdType>& cells,
  const SkdPieceNumbers& numbers, bool isSurface)
{
  if (cells.empty())
  {
    return nullptr;
  }
  SkdSubset subset(piece);
  subset.SetCells(cells);
  subset.CopyData();
  auto* surface = isSurface ? vtkPolyData::SafeDownCast(piece) : nullptr;
  const auto ids = SkdMakeArray<vtkIdTypeArray>(CellsName, 2, static_cast<vtkIdType>(cells.size()));
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const vtkIdType kind = surface ? SkdKindOf(surface, cells[i]) : 0;
    SetTuple(ids, i,
      std::array<vtkIdType, 2>{ numbers.CellIds[static_cast<std::size_t>(cells[i])], kind });
  }
  const std::vector<vtkIdType>& used = subset.GetPointIds();
  const auto points =
    SkdMakeArray<vtkIdTypeArray>(PointsName, 3, static_cast<vtkIdType>(used.size()));
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    const auto point = static_cast<std::size_t>(used[i]);
    const SkdPointOrigin& origin = numbers.PointOrigins[point];
    SetTuple(
      points, i, std::array<vtkIdType, 3>{ numbers.PointIds[point], origin.Process, origin.Point });
  }
  subset.Get()->GetFieldData()->AddArray(ids);
  subset.Get()->GetFieldData()->AddArray(points);
  return subset.Get();
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
  std::sort(this->Points.begin(), this->Points.end(),
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

// Of the points that came with a process's cells.
std::vector<vtkIdType> SkdCellParts::FindLocalIds(int process) const
{
  std::vector<vtkIdType> local;
  vtkIdTypeArray* points = this->Parts[static_cast<std::size_t>(process)].Points;
  for (vtkIdType i = 0; points && i < points->GetNumberOfTuples(); ++i)
  {
    const auto found = std::lower_bound(this->Points.begin(), this->Points.end(),
      points->GetValue(3 * i), [](const Found& a, vtkIdType id) { return a.Id < id; });
    local.push_back(found - this->Points.begin());
  }
  return local;
}

// In the order of joined ids.
std::vector<SkdCellParts::Joined> SkdCellParts::SortCells() const
{
  std::vector<Joined> cells;
  const std::vector<int>& processes = this->Facts.GetFull();
  for (std::size_t piece = 0; piece < processes.size(); ++piece)
  {
    vtkIdTypeArray* ids = this->Parts[static_cast<std::size_t>(processes[piece])].Cells;
    for (vtkIdType i = 0; ids && i < ids->GetNumberOfTuples(); ++i)
    {
      cells.push_back({ ids->GetValue(2 * i), { static_cast<int>(piece), i } });
    }
  }
  std::sort(
    cells.begin(), cells.end(), [](const Joined& a, const Joined& b) { return a.Id < b.Id; });
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
  const auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetName(SkdJoinedIdsName);
  const auto areOwn = vtkSmartPointer<vtkUnsignedCharArray>::New();
  areOwn->SetName(SkdOwnCellsName);
  for (const Joined& cell : this->SortCells())
  {
    cells.push_back(cell.Cell);
    ids->InsertNextValue(cell.Id);
    areOwn->InsertNextValue(this->ProcessOf(cell.Cell) == this->Rank ? 1 : 0);
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
