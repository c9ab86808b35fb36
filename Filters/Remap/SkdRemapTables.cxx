// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdRemapTables.h"

#include "Pipeline/SkdCompensatedSum.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdReport.h"
#include "vtkIntArray.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>

namespace skdtree
{
namespace
{
template <typename Array>
Array* ColumnOf(vtkTable* table, const char* name, int components = 1)
{
  if (!table->GetColumnByName(name))
  {
    vtkNew<Array> column;
    column->SetName(name);
    column->SetNumberOfComponents(components);
    table->AddColumn(column);
  }
  return Array::SafeDownCast(table->GetColumnByName(name));
}

using Numbers = std::vector<double>;

/// One number of each process; a process that has read no field sends nothing.
Numbers Each(const std::vector<Numbers>& processes, std::size_t at)
{
  Numbers numbers;
  for (const Numbers& told : processes)
  {
    numbers.push_back(at < told.size() ? told[at] : 0.0);
  }
  return numbers;
}

/// Added in the same order on all of them.
double SumOf(const std::vector<Numbers>& processes, std::size_t at)
{
  return SkdSumOfProcesses(Each(processes, at));
}

/// Of numbers that are the same on all processes but those that have no cells and do not know.
double AnyOf(const std::vector<Numbers>& processes, std::size_t at)
{
  const Numbers numbers = Each(processes, at);
  const auto known =
    std::find_if(numbers.begin(), numbers.end(), [](double number) { return number != 0.0; });
  return known != numbers.end() ? *known : 0.0;
}
}

SkdRemapTally::Row& SkdRemapTally::RowOf(const SkdDonorField& field, std::size_t component)
{
  const std::string name =
    field.Components > 1 ? field.Name + " " + std::to_string(component) : field.Name;
  return this->Rows[{ name, field.IsOfPoints }];
}

void SkdRemapTally::Expect(const SkdDonorField& field)
{
  for (int c = 0; c < field.Components; ++c)
  {
    this->RowOf(field, static_cast<std::size_t>(c));
  }
}

void SkdRemapTally::Add(const SkdDonorField& field, const std::vector<SkdRemapIntegrals>& integrals)
{
  for (std::size_t c = 0; c < integrals.size(); ++c)
  {
    Row& row = this->RowOf(field, c);
    row.Source = integrals[c].Source; // over the whole donor, the same for every block
    row.Absolute = integrals[c].Absolute;
    row.Overlap += integrals[c].Overlap;
    row.Target += integrals[c].Target;
    row.Covered += integrals[c].Covered;
    row.Whole += integrals[c].Whole;
  }
}

void SkdRemapTally::AddOthers(const skd::Processes& processes, bool isSpread)
{
  Numbers own;
  for (const auto& [key, row] : this->Rows)
  {
    own.insert(
      own.end(), { row.Source, row.Absolute, row.Overlap, row.Target, row.Covered, row.Whole });
  }
  std::vector<Numbers> all = processes.GatherFromOthers(own);
  all.push_back(own);
  std::size_t at = 0;
  for (auto& [key, row] : this->Rows)
  {
    row.Source = isSpread ? SumOf(all, at) : AnyOf(all, at);
    row.Absolute = isSpread ? SumOf(all, at + 1) : AnyOf(all, at + 1);
    row.Overlap = SumOf(all, at + 2);
    row.Target = SumOf(all, at + 3);
    row.Covered = SumOf(all, at + 4);
    row.Whole = SumOf(all, at + 5);
    at += 6;
  }
}

void SkdRemapTally::AddTo(vtkDataObject* output) const
{
  if (this->Rows.empty())
  {
    return;
  }
  vtkNew<vtkStringArray> names;
  names->SetName("SkdReportArray");
  std::vector<double> source, overlap, target, error, coverage;
  for (const auto& [key, row] : this->Rows)
  {
    const bool isOfBoth = key.second && this->Rows.count({ key.first, false }) > 0;
    names->InsertNextValue(key.first + (isOfBoth ? " (points)" : ""));
    source.push_back(row.Source);
    overlap.push_back(row.Overlap);
    target.push_back(row.Target);
    error.push_back(row.GetError());
    coverage.push_back(row.Whole > 0.0 ? row.Covered / row.Whole : 0.0);
  }
  output->GetFieldData()->AddArray(names);
  SkdReport report(output);
  report.AddMeasures("SourceIntegral", source);
  report.AddMeasures("OverlapIntegral", overlap);
  report.AddMeasures("TargetIntegral", target);
  report.AddMeasures("ConservationError", error);
  report.AddMeasures("Coverage", coverage);
}

void SkdAppendWeights(const SkdOverlapWeights& weights, vtkDataSet* donor,
  SkdNormalization normalization, int blockIndex, bool isComposite, vtkTable* table)
{
  const SkdJoinedIds ids(donor);
  auto* rows = ColumnOf<vtkIdTypeArray>(table, "Row");
  auto* columns = ColumnOf<vtkIdTypeArray>(table, "Column");
  auto* weight = ColumnOf<vtkDoubleArray>(table, "Weight");
  auto* measures = ColumnOf<vtkDoubleArray>(table, "Measure");
  auto* moments = ColumnOf<vtkDoubleArray>(table, "Moment", 3);
  auto* blocks = isComposite ? ColumnOf<vtkIntArray>(table, "RowBlockIndex") : nullptr;
  const SkdOverlapTable& found = weights.GetTable();
  for (std::size_t row = 0; row + 1 < found.Rows.size(); ++row)
  {
    if (!weights.GetTarget().IsCounted(row))
    {
      continue; // another process lists it
    }
    const double by = normalization == SkdNormalization::Whole ? weights.GetTarget().Measures[row]
                                                               : weights.GetTarget().Covered[row];
    for (std::size_t k = found.Rows[row]; k < found.Rows[row + 1]; ++k)
    {
      rows->InsertNextValue(static_cast<vtkIdType>(row));
      columns->InsertNextValue(ids.Of(found.Columns[k]));
      weight->InsertNextValue(found.Measures[k] / by);
      measures->InsertNextValue(found.Measures[k]);
      moments->InsertNextTuple(found.Moments[k].X);
      if (blocks)
      {
        blocks->InsertNextValue(blockIndex);
      }
    }
  }
}
}
