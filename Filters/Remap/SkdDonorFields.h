// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdDonorFields.h
 * @brief The fields of a donor as numbers, with what of them counts.
 */

#ifndef SkdDonorFields_h
#define SkdDonorFields_h

#include "vtkType.h"

#include <limits>
#include <set>
#include <string>
#include <vector>

class vtkDataSet;
class vtkDataSetAttributes;

namespace skdtree
{
/// The arrays that a remapping adds to the target's cells. A donor that has such arrays got them by
/// an earlier one: they are not mapped.
namespace SkdRemapNames
{
constexpr const char* Valid = "SkdValid";
constexpr const char* Coverage = "SkdCoverage";
constexpr const char* Fraction = "SkdFraction";
constexpr const char* Count = "SkdCount";
}

/// What becomes of values that are NaN.
enum class SkdMissingValues
{
  Mask,  ///< they do not count
  Spread ///< all that has a share of them is NaN
};

struct SkdFieldRules
{
  SkdMissingValues Missing = SkdMissingValues::Mask;
  double MissingValue = std::numeric_limits<double>::quiet_NaN(); ///< counts as NaN, too
  std::string Mask;                ///< an array that is 0 where values do not count; "": none
  std::set<std::string> Extensive; ///< amounts a cell, not densities
  bool RenamesTaken = true;        ///< results whose names are in use (SkdResultName)
};

/// One array of points or cells.
struct SkdDonorField
{
  std::string Name;
  bool IsOfPoints = false;
  bool IsExtensive = false;
  bool IsVector = false; ///< three components, no integers
  int Components = 1;
  std::vector<double> Values;        ///< tuple by tuple
  std::vector<unsigned char> Counts; ///< of each tuple, whether it does

  vtkIdType GetNumberOfTuples() const { return static_cast<vtkIdType>(this->Counts.size()); }
  const double* Tuple(vtkIdType i) const
  {
    return this->Values.data() + static_cast<std::size_t>(i * this->Components);
  }
  double Get(vtkIdType i, int component) const { return this->Tuple(i)[component]; }
};

/// What could not be had.
struct SkdFieldProblems
{
  std::set<std::string> NotNumbers; ///< arrays of strings and the like
  std::set<std::string> Refused;    ///< whose names are in use
  std::set<std::string> Missing;    ///< named in the rules, and not there
  std::set<std::string> Empty;      ///< no value of which counts
  std::set<std::string> Infinite;   ///< with values that are
  vtkIdType NaNs = 0;               ///< tuples that are, or that count as such

  /// What to warn of besides names in use, with what to do.
  std::vector<std::string> GetWarnings(SkdMissingValues missing, bool countsNaNs) const;
};

/// Whether each point or cell (vtkDataObject's type) counts by ghost marks and the mask. Points
/// that only hidden cells use do not.
std::vector<unsigned char> SkdFindCounts(vtkDataSet* donor, int type, const SkdFieldRules& rules);

/// The arrays of a mesh's points or cells (vtkDataObject's type) but ghost marks and ids, in their
/// order. Ghosts (duplicate, hidden or refined) do not count.
std::vector<SkdDonorField> SkdReadDonorFields(
  vtkDataSet* donor, int type, const SkdFieldRules& rules, SkdFieldProblems& problems);

/// The arrays without a value that is not NaN, of points and of cells: for those who do not read
/// them.
std::set<std::string> SkdFindEmptyFields(vtkDataSet* donor);

/// Makes the arrays of a mesh's points or cells such that what does not count by the rules is NaN,
/// and takes the mask away: for those who know NaN only. Nothing happens without a mask and without
/// a number that stands for NaN.
void SkdBlankValues(vtkDataSet* mesh, int type, const SkdFieldRules& rules);

/// The name of a result: the field's, or where that is in use the same with "_Remapped" appended,
/// and a number from 2 on if need be. Empty if it is in use and not to be changed.
std::string SkdResultName(vtkDataSetAttributes* to, const std::string& name, bool renamesTaken);

/// Adds a field's values at the target as an array of doubles, unless it has no name.
void SkdAddRemapped(vtkDataSetAttributes* to, const SkdDonorField& field,
  const std::vector<double>& values, bool renamesTaken, SkdFieldProblems& problems);
}

#endif
