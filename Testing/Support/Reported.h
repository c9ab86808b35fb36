// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Reported.h
 * @brief Figures that filters report in the field data of their output
 */
#ifndef skdtest_Reported_h
#define skdtest_Reported_h

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"

#include <limits>
#include <string>
#include <vector>

namespace skdtest
{

/// All values of a row of the report; none if there is no such row.
inline std::vector<double> ReportedRow(vtkDataObject* output, const std::string& what)
{
  vtkDataArray* array = output->GetFieldData()->GetArray(("SkdReport" + what).c_str());
  std::vector<double> row;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    row.push_back(array->GetComponent(i, 0));
  }
  return row;
}

/// A number of the report, or the first one of a row; NaN if there is none.
inline double Reported(vtkDataObject* output, const std::string& what)
{
  const std::vector<double> row = ReportedRow(output, what);
  return row.empty() ? std::numeric_limits<double>::quiet_NaN() : row[0];
}

///@{
/// Of the first output of a filter.
inline std::vector<double> ReportedRow(vtkAlgorithm* filter, const std::string& what)
{
  return ReportedRow(filter->GetOutputDataObject(0), what);
}
inline double Reported(vtkAlgorithm* filter, const std::string& what)
{
  return Reported(filter->GetOutputDataObject(0), what);
}
///@}

}

#endif
