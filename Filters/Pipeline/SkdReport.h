// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdReport_h
#define SkdReport_h

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"

#include <string>
#include <vector>

/// The report of a filter on its run: field data arrays, mostly of one value, named SkdReport...
class SkdReport
{
public:
  explicit SkdReport(vtkDataObject* output)
    : Field(output->GetFieldData())
  {
  }

  void AddCount(const std::string& what, vtkIdType count)
  {
    this->Add<vtkIdTypeArray>(what, count);
  }

  void AddMeasure(const std::string& what, double measure)
  {
    this->Add<vtkDoubleArray>(what, measure);
  }

  /// For optional values: nothing is added if it is 0.
  void AddMeasureOf(const std::string& what, double measure)
  {
    measure > 0.0 ? this->AddMeasure(what, measure) : void();
  }

  /// One value a row, for example for levels 0, 1, ...
  void AddCounts(const std::string& what, const std::vector<vtkIdType>& counts)
  {
    vtkNew<vtkIdTypeArray> array;
    array->SetName(("SkdReport" + what).c_str());
    for (const vtkIdType count : counts)
    {
      array->InsertNextValue(count);
    }
    this->Field->AddArray(array);
  }

private:
  template <typename Array, typename Value>
  void Add(const std::string& what, Value value)
  {
    vtkNew<Array> array;
    array->SetName(("SkdReport" + what).c_str());
    array->InsertNextValue(value);
    this->Field->AddArray(array);
  }

  vtkFieldData* Field;
};

#endif
