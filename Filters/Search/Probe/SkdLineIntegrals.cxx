// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Probe/SkdLineProbe.h"

#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdMakeArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkTable.h"

#include <cmath>

namespace skdtree
{
namespace
{
/// The rows: an input line each.
class Rows
{
public:
  explicit Rows(const std::vector<SkdLinePiece>& pieces)
  {
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
      const bool isNew =
        i == 0 || pieces[i].Input != pieces[i - 1].Input || pieces[i].Line != pieces[i - 1].Line;
      if (isNew)
      {
        this->First.push_back(i);
      }
      this->OfPiece.push_back(static_cast<vtkIdType>(this->First.size()) - 1);
    }
  }

  std::vector<std::size_t> First; // piece of each row
  std::vector<vtkIdType> OfPiece; // row of each piece

  vtkIdType Count() const { return static_cast<vtkIdType>(this->First.size()); }
};

bool IsIntegrable(vtkAbstractArray* array)
{
  const std::string name = array->GetName();
  return array->IsNumeric() && name != vtkDataSetAttributes::GhostArrayName();
}

std::vector<vtkDataSetAttributes*> AttributesOf(const std::vector<SkdBlock>& blocks, int type)
{
  std::vector<vtkDataSetAttributes*> sets;
  for (const SkdBlock& block : blocks)
  {
    sets.push_back(block.Mesh->GetAttributes(type));
  }
  return sets;
}

/// Adds columns: the sums of values(i, c) over the intervals of a row.
template <class Values>
void AddSums(const SkdLineOutput& output, const Rows& rows, vtkAbstractArray* like,
  const Values& values, vtkTable* table)
{
  const std::string name = std::string(like->GetName()) + "_Integral";
  const int components = like->GetNumberOfComponents();
  auto sums = SkdMakeArray<vtkDoubleArray>(name.c_str(), components, rows.Count(), 0.0);
  for (std::size_t i = 0; i < output.Intervals.size(); ++i)
  {
    const SkdLineInterval& interval = output.Intervals[i];
    const double length = interval.Exit - interval.Entry;
    const vtkIdType row = rows.OfPiece[interval.Piece];
    for (int c = 0; c < components; ++c)
    {
      sums->SetComponent(row, c, sums->GetComponent(row, c) + length * values(i, c));
    }
  }
  table->AddColumn(sums);
}

void AddPointIntegrals(const SkdLineOutput& output, const Rows& rows, vtkTable* table)
{
  const auto n = static_cast<vtkIdType>(output.Intervals.size());
  const double gauss = 0.5 / std::sqrt(3.0);
  SkdArrayGather gather(AttributesOf(output.Source.Blocks, vtkDataObject::POINT), IsIntegrable);
  gather.Allocate(2 * n, 0.0, true);
  vtkSMPTools::For(0, n,
    [&](vtkIdType begin, vtkIdType end)
    {
      SkdCellFinder finder(output.Source, SkdCellFinderRules());
      for (vtkIdType i = 2 * begin; i < 2 * end; ++i)
      {
        const SkdLineInterval& interval = output.Intervals[i / 2];
        const skd::Vector3 x =
          skd::Lerp(interval.From, interval.To, i % 2 == 0 ? 0.5 - gauss : 0.5 + gauss);
        if (finder.Evaluate(interval.Block, interval.CellId, x.X))
        {
          gather.Interpolate(i, interval.Block, finder.GetPointIds(), finder.GetWeights());
        }
      }
    });
  for (int k = 0; k < gather.GetNumberOfArrays(); ++k)
  {
    auto* at = static_cast<vtkDataArray*>(gather.GetResult(k));
    const auto mean = [&](std::size_t i, int c)
    { return 0.5 * (at->GetComponent(2 * i, c) + at->GetComponent(2 * i + 1, c)); };
    AddSums(output, rows, at, mean, table);
  }
}

void AddCellIntegrals(const SkdLineOutput& output, const Rows& rows, vtkTable* table)
{
  const SkdArrayGather gather(
    AttributesOf(output.Source.Blocks, vtkDataObject::CELL), IsIntegrable);
  for (int k = 0; k < gather.GetNumberOfArrays(); ++k)
  {
    const auto value = [&](std::size_t i, int c)
    {
      const SkdLineInterval& interval = output.Intervals[i];
      auto* source = static_cast<vtkDataArray*>(gather.GetSource(k, interval.Block));
      return source ? source->GetComponent(interval.CellId, c) : 0.0;
    };
    AddSums(output, rows, gather.GetFirst(k), value, table);
  }
}
}

void SkdFillIntegrals(const SkdLineOutput& output, vtkTable* table)
{
  const Rows rows(output.Pieces);
  auto lines = SkdMakeArray<vtkIdTypeArray>("SkdInputCellId", 1, rows.Count(), -1);
  auto inputs = SkdMakeArray<vtkIntArray>("SkdInputBlockIndex", 1, rows.Count(), -1);
  auto lengths = SkdMakeArray<vtkDoubleArray>("SkdLineLength", 1, rows.Count(), 0.0);
  auto within = SkdMakeArray<vtkDoubleArray>("SkdLength", 1, rows.Count(), 0.0);
  for (std::size_t i = 0; i < output.Pieces.size(); ++i)
  {
    const SkdLinePiece& piece = output.Pieces[i];
    const vtkIdType row = rows.OfPiece[i];
    lines->SetValue(row, piece.Line);
    inputs->SetValue(row, output.Inputs[piece.Input].BlockIndex);
    lengths->SetValue(row, piece.Start + std::sqrt(skd::Distance2(piece.From, piece.To)));
  }
  for (const SkdLineInterval& interval : output.Intervals)
  {
    const vtkIdType row = rows.OfPiece[interval.Piece];
    within->SetValue(row, within->GetValue(row) + interval.Exit - interval.Entry);
  }
  table->AddColumn(lines);
  if (output.IsInputComposite)
  {
    table->AddColumn(inputs);
  }
  table->AddColumn(lengths);
  table->AddColumn(within);
  AddPointIntegrals(output, rows, table);
  AddCellIntegrals(output, rows, table);
}
}
