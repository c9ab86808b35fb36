// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Relations/SkdRelationOutputs.h"

#include "Cells/Read/SkdForEach.h"
#include "Pipeline/SkdMakeArray.h"
#include "Pipeline/SkdSubset.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
/// A column, whose row i is value(i).
template <typename Array, typename Value>
void AddColumn(vtkTable* table, const char* name, vtkIdType n, const Value& value)
{
  const auto array = SkdMakeArray<Array>(name, 1, n);
  SkdForEach(n, [&](vtkIdType i) { array->SetValue(i, value(i)); });
  table->AddColumn(array);
}

vtkSmartPointer<vtkIdTypeArray> IdsOf(
  const std::vector<SkdChosenCell>& chosen, const std::vector<vtkIdType>& joined = {})
{
  auto ids = SkdMakeArray<vtkIdTypeArray>("SkdCellId", 1, static_cast<vtkIdType>(chosen.size()));
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    ids->SetValue(static_cast<vtkIdType>(i), SkdJoinedIdOf(joined, chosen[i].CellId));
  }
  return ids;
}
}

//------------------------------------------------------------------------------
std::vector<std::vector<SkdChosenCell>> SkdChooseCells(
  const SkdRelatedCells& pairs, std::size_t parts)
{
  std::vector<std::vector<SkdChosenCell>> chosen(parts);
  if (parts == 1)
  {
    chosen.front().reserve(pairs.size());
  }
  std::vector<char> areUnique(parts, 1); // each once, as those of one shape are
  for (const SkdRelatedCell& pair : pairs)
  {
    const double distance = std::isnan(pair.OfCells.Min) ? pair.OfBoxes.Min : pair.OfCells.Min;
    std::vector<SkdChosenCell>& cells = chosen[pair.Part];
    areUnique[pair.Part] &= cells.empty() || cells.back().CellId < pair.CellId;
    cells.push_back({ pair.CellId, 1, distance });
  }
  for (std::size_t part = 0; part < parts; ++part)
  {
    if (areUnique[part])
    {
      continue;
    }
    std::vector<SkdChosenCell>& cells = chosen[part];
    const auto isBefore = [](const SkdChosenCell& a, const SkdChosenCell& b)
    { return a.CellId < b.CellId || (a.CellId == b.CellId && a.Distance < b.Distance); };
    std::sort(cells.begin(), cells.end(), isBefore);
    std::size_t retained = 0;
    for (const SkdChosenCell& cell : cells)
    {
      if (retained > 0 && cells[retained - 1].CellId == cell.CellId)
      {
        ++cells[retained - 1].QueryCount;
        continue;
      }
      cells[retained++] = cell;
    }
    cells.resize(retained);
  }
  return chosen;
}

//------------------------------------------------------------------------------
void SkdExtractCells(vtkDataSet* mesh, const std::vector<SkdChosenCell>& chosen,
  const std::vector<vtkIdType>& joined, vtkUnstructuredGrid* output)
{
  std::vector<vtkIdType> ids;
  ids.reserve(chosen.size());
  for (const SkdChosenCell& cell : chosen)
  {
    ids.push_back(cell.CellId);
  }
  SkdSubset subset(mesh);
  subset.SetCells(ids);
  subset.CopyData();
  output->ShallowCopy(subset.Get());
  output->GetFieldData()->PassData(mesh->GetFieldData());
  const auto n = static_cast<vtkIdType>(chosen.size());
  const auto counts = SkdMakeArray<vtkIdTypeArray>("SkdQueryCount", 1, n);
  const auto distances = SkdMakeArray<vtkDoubleArray>("SkdDistance", 1, n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const SkdChosenCell& cell = chosen[static_cast<std::size_t>(i)];
    counts->SetValue(i, cell.QueryCount);
    distances->SetValue(i, cell.Distance);
  }
  vtkCellData* data = output->GetCellData();
  data->AddArray(IdsOf(chosen, joined));
  data->AddArray(counts);
  data->AddArray(distances);
}

//------------------------------------------------------------------------------
void SkdFillSelection(const std::vector<std::vector<SkdChosenCell>>& chosen,
  const SkdRelationRows& answers, int process, vtkSelection* selection)
{
  for (std::size_t part = 0; part < chosen.size(); ++part)
  {
    if (chosen[part].empty())
    {
      continue;
    }
    vtkNew<vtkSelectionNode> node;
    node->SetContentType(vtkSelectionNode::INDICES);
    node->SetFieldType(vtkSelectionNode::CELL);
    node->SetSelectionList(IdsOf(chosen[part]));
    vtkInformation* properties = node->GetProperties();
    if (answers.IsMeshComposite)
    {
      properties->Set(vtkSelectionNode::COMPOSITE_INDEX(), answers.BlockIndices[part]);
    }
    if (process >= 0)
    {
      properties->Set(vtkSelectionNode::PROCESS_ID(), process);
    }
    selection->AddNode(node);
  }
}

//------------------------------------------------------------------------------
void SkdFillPairs(const SkdRelationRows& answers, vtkTable* table)
{
  const SkdRelatedCells& pairs = answers.Pairs;
  const auto n = static_cast<vtkIdType>(pairs.size());
  const auto pair = [&](vtkIdType i) -> const SkdRelatedCell&
  { return pairs[static_cast<std::size_t>(i)]; };
  AddColumn<vtkIdTypeArray>(
    table, "SkdQueryId", n, [&](vtkIdType i) { return answers.Queries.GetId(pair(i).Query); });
  if (answers.IsSourceComposite)
  {
    AddColumn<vtkIntArray>(table, "SkdQueryBlockIndex", n,
      [&](vtkIdType i) { return answers.Queries.GetBlockIndex(pair(i).Query); });
  }
  AddColumn<vtkIdTypeArray>(table, "SkdCellId", n,
    [&](vtkIdType i) { return SkdJoinedIdOf(answers.JoinedIds[pair(i).Part], pair(i).CellId); });
  if (answers.IsMeshComposite)
  {
    AddColumn<vtkIntArray>(
      table, "SkdBlockIndex", n, [&](vtkIdType i) { return answers.BlockIndices[pair(i).Part]; });
  }
  AddColumn<vtkDoubleArray>(
    table, "SkdOptimisticDistance", n, [&](vtkIdType i) { return pair(i).OfBoxes.Min; });
  AddColumn<vtkDoubleArray>(
    table, "SkdPessimisticDistance", n, [&](vtkIdType i) { return pair(i).OfBoxes.Max; });
  if (answers.IsExact)
  {
    AddColumn<vtkDoubleArray>(
      table, "SkdMinimumDistance", n, [&](vtkIdType i) { return pair(i).OfCells.Min; });
    AddColumn<vtkDoubleArray>(
      table, "SkdMaximumDistance", n, [&](vtkIdType i) { return pair(i).OfCells.Max; });
  }
}
}
