// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdSpreadOutput.h"

#include "Exchange/SkdPieceNumbers.h"
#include "Pipeline/SkdReport.h"
#include "Solids/Boolean/SkdBooleanNames.h"
#include "Solids/Boolean/SkdEdgeSums.h"
#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <tuple>

namespace skdtree
{
namespace
{
/// Where a face first occurs among those of all processes.
struct FirstOfFace
{
  int Input;
  vtkIdType Cell;   // in the whole
  vtkIdType Number; // as this process has counted it

  bool operator<(const FirstOfFace& other) const
  {
    return std::tie(this->Input, this->Cell, this->Number) <
      std::tie(other.Input, other.Cell, other.Number);
  }
};

/// By the process that counts them: each has a range of the inputs' cells.
SkdRowsByProcess<FirstOfFace> ListFaces(
  int processes, const std::array<vtkIdType, 2>& cells, vtkPolyData* part)
{
  vtkCellData* data = part->GetCellData();
  auto* inputs = vtkIntArray::SafeDownCast(data->GetArray(SkdBooleanNames::Input));
  auto* ids = vtkIdTypeArray::SafeDownCast(data->GetArray(SkdBooleanNames::Cell));
  auto* faces = vtkIdTypeArray::SafeDownCast(data->GetArray(SkdBooleanNames::Face));
  SkdRowsByProcess<FirstOfFace> rows(static_cast<std::size_t>(processes));
  const vtkIdType all = std::max<vtkIdType>(1, cells[0] + cells[1]);
  vtkIdType count = 0;
  for (vtkIdType i = 0; faces && i < faces->GetNumberOfValues(); ++i)
  {
    if (faces->GetValue(i) == count) // they are numbered as they occur
    {
      const int input = inputs->GetValue(i);
      const vtkIdType at = ids->GetValue(i) + (input == 0 ? 0 : cells[0]);
      const auto process = static_cast<std::size_t>(at * processes / all);
      rows[process].push_back({ input, ids->GetValue(i), count++ });
    }
  }
  return rows;
}

/// The place of each among those that came from all processes.
SkdRowsByProcess<vtkIdType> Ranked(const SkdRowsByProcess<FirstOfFace>& rows)
{
  std::vector<std::tuple<FirstOfFace, std::size_t, std::size_t>> order;
  SkdRowsByProcess<vtkIdType> ranks(rows.size());
  for (std::size_t process = 0; process < rows.size(); ++process)
  {
    ranks[process].resize(rows[process].size());
    for (std::size_t i = 0; i < rows[process].size(); ++i)
    {
      order.emplace_back(rows[process][i], process, i);
    }
  }
  std::sort(order.begin(), order.end(),
    [](const auto& a, const auto& b) { return std::get<0>(a) < std::get<0>(b); });
  for (std::size_t rank = 0; rank < order.size(); ++rank)
  {
    const auto& [face, process, i] = order[rank];
    ranks[process][i] = static_cast<vtkIdType>(rank);
  }
  return ranks;
}
}

bool SkdIsClosedOverAll(SkdTransport& transport, vtkPolyData* part)
{
  SkdEdgeSums all;
  for (const std::vector<SkdEdgeSums>& told :
    SkdGatherRows(transport, std::vector<SkdEdgeSums>{ SkdSumEdges(part) }))
  {
    all.Add(told.front());
  }
  return all.AreZero();
}

void SkdNumberFacesOverAll(
  SkdTransport& transport, const std::array<vtkIdType, 2>& cells, vtkPolyData* part)
{
  const SkdRowsByProcess<FirstOfFace> faces = ListFaces(transport.GetNumber(), cells, part);
  const SkdRowsByProcess<FirstOfFace> counted = SkdExchangeRows(transport, faces);
  vtkIdType number = 0;
  for (const std::vector<FirstOfFace>& some : counted)
  {
    number += static_cast<vtkIdType>(some.size());
  }
  const vtkIdType before = SkdSumOver(transport, { number }).front().Before;
  SkdRowsByProcess<vtkIdType> ranks = Ranked(counted);
  for (std::vector<vtkIdType>& some : ranks)
  {
    std::transform(
      some.begin(), some.end(), some.begin(), [before](vtkIdType rank) { return rank + before; });
  }
  ranks = SkdExchangeRows(transport, ranks);
  auto* array = vtkIdTypeArray::SafeDownCast(part->GetCellData()->GetArray(SkdBooleanNames::Face));
  if (!array)
  {
    return;
  }
  std::vector<vtkIdType> newNumbers(static_cast<std::size_t>(array->GetNumberOfValues()));
  for (std::size_t process = 0; process < faces.size(); ++process)
  {
    for (std::size_t i = 0; i < faces[process].size(); ++i)
    {
      newNumbers[static_cast<std::size_t>(faces[process][i].Number)] = ranks[process][i];
    }
  }
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    array->SetValue(i, newNumbers[static_cast<std::size_t>(array->GetValue(i))]);
  }
}

void SkdSumReports(SkdTransport& transport, vtkPolyData* part)
{
  vtkFieldData* field = part->GetFieldData();
  for (const char* name : { "InputVolume", "InputArea", "SourceVolume", "SourceArea", "Volume",
         "Area", "TrianglesSplit", "TrianglesFolded" })
  {
    vtkDataArray* array = field->GetArray((std::string("SkdReport") + name).c_str());
    const double own = array ? array->GetTuple1(0) : 0.0;
    double sum = 0.0;
    for (const std::vector<double>& told : SkdGatherRows(transport, std::vector<double>{ own }))
    {
      sum += told.front();
    }
    if (array)
    {
      array->SetTuple1(0, sum);
    }
    else // of a process that has no part
    {
      SkdReport(part).AddMeasure(name, sum);
    }
  }
}
}
