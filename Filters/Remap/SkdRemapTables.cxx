// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdRemapTables.h"

#include "Pipeline/SkdReport.h"
#include "vtkIntArray.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

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
}

void SkdRemapTally::Add(const SkdDonorField& field, const std::vector<SkdRemapIntegrals>& integrals)
{
  for (std::size_t c = 0; c < integrals.size(); ++c)
  {
    const std::string name =
      integrals.size() > 1 ? field.Name + " " + std::to_string(c) : field.Name;
    SkdRemapIntegrals& row = this->Rows[name];
    // Of cells over the whole donor, the same for every block; of points over what a block covers.
    row.Source = field.IsOfPoints ? row.Source + integrals[c].Source : integrals[c].Source;
    row.Absolute = field.IsOfPoints ? row.Absolute + integrals[c].Absolute : integrals[c].Absolute;
    row.Overlap += integrals[c].Overlap;
    row.Target += integrals[c].Target;
    row.Covered += integrals[c].Covered;
    row.Whole += integrals[c].Whole;
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
  for (const auto& [name, row] : this->Rows)
  {
    names->InsertNextValue(name);
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

void SkdAppendWeights(const SkdOverlapWeights& weights, SkdNormalization normalization,
  int blockIndex, bool isComposite, vtkTable* table)
{
  auto* rows = ColumnOf<vtkIdTypeArray>(table, "Row");
  auto* columns = ColumnOf<vtkIdTypeArray>(table, "Column");
  auto* weight = ColumnOf<vtkDoubleArray>(table, "Weight");
  auto* measures = ColumnOf<vtkDoubleArray>(table, "Measure");
  auto* moments = ColumnOf<vtkDoubleArray>(table, "Moment", 3);
  auto* blocks = isComposite ? ColumnOf<vtkIntArray>(table, "RowBlockIndex") : nullptr;
  const SkdOverlapTable& found = weights.GetTable();
  for (std::size_t row = 0; row + 1 < found.Rows.size(); ++row)
  {
    const double by = normalization == SkdNormalization::Whole ? weights.GetTarget().Measures[row]
                                                               : weights.GetTarget().Covered[row];
    for (std::size_t k = found.Rows[row]; k < found.Rows[row + 1]; ++k)
    {
      rows->InsertNextValue(static_cast<vtkIdType>(row));
      columns->InsertNextValue(found.Columns[k]);
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
