// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdReport_h
#define SkdReport_h

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkTimerLog.h"

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace skdtree
{
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
    this->Add<vtkIdTypeArray>(what, std::initializer_list<vtkIdType>{ count });
  }

  void AddMeasure(const std::string& what, double measure)
  {
    this->Add<vtkDoubleArray>(what, std::initializer_list<double>{ measure });
  }

  /// For optional values: nothing is added if it is 0.
  void AddMeasureOf(const std::string& what, double measure)
  {
    if (measure > 0.0)
    {
      this->AddMeasure(what, measure);
    }
  }

  /// The number of trees that were built, and the seconds for building and for their use.
  void AddRun(vtkIdType treesBuilt, double buildSeconds, const char* other, double seconds)
  {
    this->AddCount("TreesBuilt", treesBuilt);
    this->AddMeasure("BuildSeconds", buildSeconds);
    this->AddMeasure(other, seconds);
  }

  ///@{
  /// One value a row, for example for levels 0, 1, ...
  void AddCounts(const std::string& what, const std::vector<vtkIdType>& counts)
  {
    this->Add<vtkIdTypeArray>(what, counts);
  }
  void AddMeasures(const std::string& what, const std::vector<double>& measures)
  {
    this->Add<vtkDoubleArray>(what, measures);
  }
  ///@}

private:
  template <typename Array, typename Values>
  void Add(const std::string& what, const Values& values)
  {
    vtkNew<Array> array;
    array->SetName(("SkdReport" + what).c_str());
    for (const auto value : values)
    {
      array->InsertNextValue(value);
    }
    this->Field->AddArray(array);
  }

  vtkFieldData* Field;
};

/// What could not be read, one line each: the counts that are not 0, each before its words.
inline std::vector<std::string> SkdFaultsOf(
  std::initializer_list<std::pair<vtkIdType, const char*>> counts)
{
  std::vector<std::string> faults;
  for (const auto& [count, words] : counts)
  {
    if (count > 0)
    {
      faults.push_back(std::to_string(count) + words);
    }
  }
  return faults;
}

/// Seconds between laps.
class SkdStopwatch
{
public:
  double Lap()
  {
    const double now = vtkTimerLog::GetUniversalTime();
    return now - std::exchange(this->Last, now);
  }

private:
  double Last = vtkTimerLog::GetUniversalTime();
};
}

#endif
