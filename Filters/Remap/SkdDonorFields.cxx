// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdDonorFields.h"

#include "Pipeline/SkdMakeArray.h"
#include "Pipeline/SkdShownElements.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
void ReadValues(
  vtkDataArray* array, const SkdFieldRules& rules, SkdDonorField& field, SkdFieldProblems& problems)
{
  const vtkIdType n = array->GetNumberOfTuples();
  const auto components = static_cast<std::size_t>(field.Components);
  field.Values.resize(static_cast<std::size_t>(n) * components);
  bool hasInfinite = false;
  for (vtkIdType i = 0; i < n; ++i)
  {
    double* tuple = field.Values.data() + static_cast<std::size_t>(i) * components;
    unsigned char& counts = field.Counts[static_cast<std::size_t>(i)];
    array->GetTuple(i, tuple);
    bool isMissing = false;
    for (std::size_t c = 0; c < components; ++c)
    {
      tuple[c] = tuple[c] == rules.MissingValue ? vtkMath::Nan() : tuple[c];
      isMissing = isMissing || std::isnan(tuple[c]);
      hasInfinite = hasInfinite || (counts != 0 && std::isinf(tuple[c]));
    }
    problems.NaNs += isMissing && counts != 0 ? 1 : 0;
    counts = isMissing && rules.Missing == SkdMissingValues::Mask ? 0 : counts;
  }
  if (hasInfinite)
  {
    problems.Infinite.insert(field.Name);
  }
}

bool HasValue(vtkDataArray* array)
{
  std::vector<double> tuple(static_cast<std::size_t>(array->GetNumberOfComponents()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    array->GetTuple(i, tuple.data());
    if (std::none_of(tuple.begin(), tuple.end(), [](double x) { return std::isnan(x); }))
    {
      return true;
    }
  }
  return false;
}

bool IsForUse(vtkDataSetAttributes* data, vtkAbstractArray* array)
{
  if (!array || !array->GetName() || array == data->GetGlobalIds() ||
    array == data->GetPedigreeIds())
  {
    return false;
  }
  const std::string name = array->GetName();
  return name != vtkDataSetAttributes::GhostArrayName() && name != SkdRemapNames::Valid &&
    name != SkdRemapNames::Coverage && name != SkdRemapNames::Fraction &&
    name != SkdRemapNames::Count;
}
}

std::vector<std::string> SkdFieldProblems::GetWarnings(
  SkdMissingValues missing, bool countsNaNs) const
{
  std::vector<std::string> warnings;
  for (const std::string& name : this->NotNumbers)
  {
    warnings.push_back("Source's array " + name + " is left out: it is not of numbers.");
  }
  for (const std::string& name : this->Missing)
  {
    warnings.push_back("Source has no array " + name + " of numbers in all its blocks.");
  }
  for (const std::string& name : this->Empty)
  {
    warnings.push_back("No value of Source's array " + name +
      " counts: all are NaN, missing, masked or of ghosts, and so are its results NaN. Look at "
      "MaskArray and MissingValue.");
  }
  for (const std::string& name : this->Infinite)
  {
    warnings.push_back("Source's array " + name +
      " has infinite values: what has a share of them is infinite or NaN. Let MissingValue or "
      "MaskArray name them.");
  }
  if (this->NaNs > 0 && countsNaNs)
  {
    warnings.push_back(std::to_string(this->NaNs) + " values of Source are NaN or missing: " +
      (missing == SkdMissingValues::Mask
          ? "they do not count. Set MissingValues to let them spread."
          : "what has a share of them is NaN."));
  }
  return warnings;
}

std::vector<unsigned char> SkdFindCounts(vtkDataSet* donor, int type, const SkdFieldRules& rules)
{
  vtkDataSetAttributes* data = donor->GetAttributes(type);
  std::vector<unsigned char> counts =
    type == vtkDataObject::CELL ? SkdFindCounted(donor) : SkdFindShown(donor, type);
  vtkDataArray* mask = rules.Mask.empty() ? nullptr : data->GetArray(rules.Mask.c_str());
  for (std::size_t i = 0; mask && i < counts.size(); ++i)
  {
    const bool isMasked = !(mask->GetComponent(static_cast<vtkIdType>(i), 0) != 0.0);
    counts[i] = isMasked ? 0 : counts[i];
  }
  return counts;
}

std::vector<SkdDonorField> SkdReadDonorFields(
  vtkDataSet* donor, int type, const SkdFieldRules& rules, SkdFieldProblems& problems)
{
  vtkDataSetAttributes* data = donor->GetAttributes(type);
  const vtkIdType n = donor->GetNumberOfElements(type);
  const std::vector<unsigned char> counts = SkdFindCounts(donor, type, rules);
  std::vector<SkdDonorField> fields;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* any = data->GetAbstractArray(i);
    vtkDataArray* array = vtkDataArray::SafeDownCast(any);
    if (!IsForUse(data, any) || rules.Mask == any->GetName())
    {
      continue;
    }
    if (!array)
    {
      problems.NotNumbers.insert(any->GetName());
      continue;
    }
    SkdDonorField field;
    field.Name = array->GetName();
    field.IsOfPoints = type == vtkDataObject::POINT;
    field.Components = array->GetNumberOfComponents();
    field.IsExtensive = rules.Extensive.count(field.Name) > 0;
    field.IsVector = field.Components == 3 &&
      (array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT);
    field.Counts = counts;
    ReadValues(array, rules, field, problems);
    const bool isEmpty =
      std::find(field.Counts.begin(), field.Counts.end(), 1) == field.Counts.end();
    if (n > 0 && isEmpty)
    {
      problems.Empty.insert(field.Name);
    }
    fields.push_back(std::move(field));
  }
  return fields;
}

std::set<std::string> SkdFindEmptyFields(vtkDataSet* donor)
{
  std::set<std::string> names;
  for (const int type : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataSetAttributes* data = donor->GetAttributes(type);
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i);
      if (array && IsForUse(data, array) && array->GetNumberOfTuples() > 0 && !HasValue(array))
      {
        names.insert(array->GetName());
      }
    }
  }
  return names;
}

void SkdBlankValues(vtkDataSet* mesh, int type, const SkdFieldRules& rules)
{
  if (rules.Mask.empty() && std::isnan(rules.MissingValue))
  {
    return;
  }
  SkdFieldProblems problems;
  std::vector<SkdDonorField> fields = SkdReadDonorFields(mesh, type, rules, problems);
  vtkDataSetAttributes* data = mesh->GetAttributes(type);
  data->RemoveArray(rules.Mask.c_str());
  for (SkdDonorField& field : fields)
  {
    const auto components = static_cast<std::size_t>(field.Components);
    for (std::size_t i = 0; i < field.Values.size(); ++i)
    {
      field.Values[i] = field.Counts[i / components] != 0 ? field.Values[i] : vtkMath::Nan();
    }
    data->RemoveArray(field.Name.c_str());
    SkdAddRemapped(data, field, field.Values, false, problems);
  }
}

std::string SkdResultName(vtkDataSetAttributes* to, const std::string& name, bool renamesTaken)
{
  if (!to->HasArray(name.c_str()))
  {
    return name;
  }
  std::string other = renamesTaken ? name + "_Remapped" : "";
  for (int number = 2; !other.empty() && to->HasArray(other.c_str()); ++number)
  {
    other = name + "_Remapped" + std::to_string(number);
  }
  return other;
}

void SkdAddRemapped(vtkDataSetAttributes* to, const SkdDonorField& field,
  const std::vector<double>& values, bool renamesTaken, SkdFieldProblems& problems)
{
  const std::string name = SkdResultName(to, field.Name, renamesTaken);
  if (name.empty())
  {
    problems.Refused.insert(field.Name);
    return;
  }
  const auto n = static_cast<vtkIdType>(values.size()) / std::max(field.Components, 1);
  const auto array = SkdMakeArray<vtkDoubleArray>(name.c_str(), field.Components, n);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  to->AddArray(array);
}
}
