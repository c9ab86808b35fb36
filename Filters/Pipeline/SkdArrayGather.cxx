// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdArrayGather.h"

#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdMakeArray.h"
#include "Pipeline/SkdPartialArrays.h"
#include "vtkAOSDataArrayTemplate.h"
#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace skdtree
{
namespace
{
bool IsGatherable(vtkAbstractArray* array)
{
  return array && array->GetName() &&
    (vtkDataArray::SafeDownCast(array) || vtkStringArray::SafeDownCast(array));
}

bool IsAlike(vtkAbstractArray* array, vtkAbstractArray* first)
{
  return IsGatherable(array) && array->GetNumberOfComponents() == first->GetNumberOfComponents() &&
    array->IsNumeric() == first->IsNumeric();
}

/// The nearest number that an array can hold; of integers 0 for NaN.
double HeldBy(vtkDataArray* numbers, double value)
{
  const int type = numbers->GetDataType();
  if (type == VTK_FLOAT || type == VTK_DOUBLE)
  {
    return value;
  }
  const double least = numbers->GetDataTypeMin();
  const double most = numbers->GetDataTypeMax();
  return std::isnan(value) ? 0.0 : std::max(least, std::min(most, std::round(value)));
}

vtkSmartPointer<vtkAbstractArray> MakeResult(
  vtkAbstractArray* like, vtkIdType n, std::optional<double> fill, bool isDouble)
{
  const int ownType = like->GetDataType() == VTK_BIT ? VTK_UNSIGNED_CHAR : like->GetDataType();
  const int type = isDouble && like->IsNumeric() ? VTK_DOUBLE : ownType;
  vtkSmartPointer<vtkAbstractArray> result;
  result.TakeReference(vtkAbstractArray::CreateArray(type));
  result->SetName(like->GetName());
  result->SetNumberOfComponents(like->GetNumberOfComponents());
  result->CopyComponentNames(like);
  result->SetNumberOfTuples(n);
  vtkDataArray* const numbers = vtkDataArray::SafeDownCast(result);
  if (numbers && fill)
  {
    numbers->Fill(HeldBy(numbers, *fill));
  }
  return result;
}

void InterpolateAny(
  vtkAbstractArray* result, vtkIdType to, vtkAbstractArray* source, vtkIdList* ids, double* weights)
{
  result->InterpolateTuple(to, ids, source, weights);
}

void TakeAny(vtkAbstractArray* result, vtkIdType to, vtkAbstractArray* source, vtkIdType from)
{
  result->SetTuple(to, from, source);
}

/// Of any numbers, into those of another type; before VTK 9.2 arrays themselves do not.
void InterpolateNumbers(
  vtkAbstractArray* result, vtkIdType to, vtkAbstractArray* source, vtkIdList* ids, double* weights)
{
  auto* from = static_cast<vtkDataArray*>(source);
  auto* into = static_cast<vtkDataArray*>(result);
  for (int c = 0; c < from->GetNumberOfComponents(); ++c)
  {
    double sum = 0.0;
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      sum += weights[i] * from->GetComponent(ids->GetId(i), c);
    }
    into->SetComponent(to, c, HeldBy(into, sum));
  }
}

void TakeNumbers(vtkAbstractArray* result, vtkIdType to, vtkAbstractArray* source, vtkIdType from)
{
  auto* into = static_cast<vtkDataArray*>(result);
  for (int c = 0; c < into->GetNumberOfComponents(); ++c)
  {
    into->SetComponent(
      to, c, HeldBy(into, static_cast<vtkDataArray*>(source)->GetComponent(from, c)));
  }
}

/// Of arrays that lie in memory as they are written, and have the type of the result.
template <typename Value>
void InterpolatePlain(
  vtkAbstractArray* result, vtkIdType to, vtkAbstractArray* source, vtkIdList* ids, double* weights)
{
  using Plain = vtkAOSDataArrayTemplate<Value>;
  const int components = source->GetNumberOfComponents();
  const Value* from = static_cast<Plain*>(source)->GetPointer(0);
  Value* into = static_cast<Plain*>(result)->GetPointer(to * components);
  const vtkIdType n = ids->GetNumberOfIds();
  const vtkIdType* id = ids->GetPointer(0);
  for (int c = 0; c < components; ++c)
  {
    double sum = 0.0;
    for (vtkIdType i = 0; i < n; ++i)
    {
      sum += weights[i] * static_cast<double>(from[id[i] * components + c]);
    }
    vtkMath::RoundDoubleToIntegralIfNecessary(sum, into + c);
  }
}

template <typename Value>
void TakePlain(vtkAbstractArray* result, vtkIdType to, vtkAbstractArray* source, vtkIdType from)
{
  using Plain = vtkAOSDataArrayTemplate<Value>;
  const int components = source->GetNumberOfComponents();
  const Value* first = static_cast<Plain*>(source)->GetPointer(from * components);
  std::copy_n(first, components, static_cast<Plain*>(result)->GetPointer(to * components));
}

template <typename Value>
bool IsPlain(vtkAbstractArray* array)
{
  return vtkArrayDownCast<vtkAOSDataArrayTemplate<Value>>(array) != nullptr;
}
}

SkdArrayGather::SkdArrayGather(const std::vector<vtkDataSetAttributes*>& sets,
  const std::function<bool(vtkAbstractArray*)>& isWanted)
{
  std::set<std::string> known;
  for (vtkDataSetAttributes* set : sets)
  {
    for (int i = 0; set && i < set->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = set->GetAbstractArray(i);
      if (IsGatherable(array) && known.insert(array->GetName()).second && isWanted(array))
      {
        this->Arrays.push_back(Find(sets, array));
      }
    }
  }
}

SkdArrayGather::Array SkdArrayGather::Find(
  const std::vector<vtkDataSetAttributes*>& sets, vtkAbstractArray* first)
{
  Array array;
  array.First = first;
  for (vtkDataSetAttributes* set : sets)
  {
    vtkAbstractArray* source = set ? set->GetAbstractArray(first->GetName()) : nullptr;
    array.Sources.push_back(IsAlike(source, first) ? source : nullptr);
    array.IsPartial = array.IsPartial || (set && !array.Sources.back());
  }
  return array;
}

void SkdArrayGather::ChooseFunctions(Array& array)
{
  const bool isConverted = array.Result->IsNumeric() &&
    std::any_of(array.Sources.begin(), array.Sources.end(),
      [&array](vtkAbstractArray* source)
      { return source && source->GetDataType() != array.Result->GetDataType(); });
  array.Interpolate = isConverted ? &InterpolateNumbers : &InterpolateAny;
  array.Take = isConverted ? &TakeNumbers : &TakeAny;
  const auto choose = [&](auto value)
  {
    using Value = decltype(value);
    const bool isPlain = IsPlain<Value>(array.Result) &&
      std::all_of(array.Sources.begin(), array.Sources.end(),
        [](vtkAbstractArray* source) { return !source || IsPlain<Value>(source); });
    if (isPlain)
    {
      array.Interpolate = &InterpolatePlain<Value>;
      array.Take = &TakePlain<Value>;
    }
  };
  switch (array.Result->GetDataType())
  {
    vtkTemplateMacro(choose(VTK_TT{}));
    default:
      break;
  }
}

void SkdArrayGather::Allocate(vtkIdType n, double fill, bool isDouble)
{
  for (Array& array : this->Arrays)
  {
    array.Result = MakeResult(array.First, n, fill, isDouble);
    AllocateMarks(array, n);
  }
}

void SkdArrayGather::AllocateUnfilled(vtkIdType n)
{
  for (Array& array : this->Arrays)
  {
    const auto fill = array.IsPartial ? std::make_optional(vtkMath::Nan()) : std::nullopt;
    array.Result = MakeResult(array.First, n, fill, false);
    AllocateMarks(array, n);
  }
}

void SkdArrayGather::AllocateMarks(Array& array, vtkIdType n)
{
  ChooseFunctions(array);
  if (array.IsPartial)
  {
    const std::string name = std::string(SkdPartialMarkPrefix) + array.First->GetName();
    array.Marks = SkdMakeArray<vtkUnsignedCharArray>(name.c_str(), 1, n, 0);
  }
}

void SkdArrayGather::Clear(vtkIdType to)
{
  for (const Array& array : this->Arrays)
  {
    vtkDataArray* const numbers = vtkDataArray::SafeDownCast(array.Result);
    for (int c = 0; numbers && c < numbers->GetNumberOfComponents(); ++c)
    {
      numbers->SetComponent(to, c, HeldBy(numbers, vtkMath::Nan()));
    }
  }
}

// nullptr if there is none; else marks that there is a value.
vtkAbstractArray* SkdArrayGather::SourceOf(const Array& array, vtkIdType to, int set)
{
  vtkAbstractArray* source = array.Sources[set];
  if (source && array.Marks)
  {
    array.Marks->SetValue(to, 1);
  }
  return source;
}

void SkdArrayGather::Interpolate(vtkIdType to, int set, vtkIdList* ids, double* weights)
{
  for (Array& array : this->Arrays)
  {
    if (vtkAbstractArray* source = SourceOf(array, to, set))
    {
      array.Interpolate(array.Result, to, source, ids, weights);
    }
  }
}

void SkdArrayGather::Take(vtkIdType to, int set, vtkIdType from)
{
  for (Array& array : this->Arrays)
  {
    if (vtkAbstractArray* source = SourceOf(array, to, set))
    {
      array.Take(array.Result, to, source, from);
    }
  }
}

void SkdArrayGather::AddTo(vtkDataSetAttributes* attributes) const
{
  for (const Array& array : this->Arrays)
  {
    attributes->AddArray(array.Result);
    if (array.Marks && !attributes->HasArray(array.Marks->GetName()))
    {
      attributes->AddArray(array.Marks);
    }
  }
}

SkdArrayGather SkdGatherInto(vtkDataSetAttributes* target, vtkIdType n,
  const std::vector<SkdBlock>& blocks, int type, std::set<std::string>& refused)
{
  return SkdGatherInto(
    target, n, blocks, type, refused, vtkMath::Nan(), [](const std::string&) { return true; });
}

namespace
{
/// The gather of arrays to be added to a target, not yet allocated.
SkdArrayGather FindArrays(vtkDataSetAttributes* target, const std::vector<SkdBlock>& blocks,
  int type, std::set<std::string>& refused, const std::function<bool(const std::string&)>& isNamed)
{
  std::vector<vtkDataSetAttributes*> sets;
  for (const SkdBlock& block : blocks)
  {
    // Of a mesh in pieces that has none here other processes have some.
    const bool isEmpty =
      block.Mesh->GetNumberOfElements(type) == 0 && !SkdJoinedIds(block.Mesh).HasOwn();
    sets.push_back(isEmpty ? nullptr : block.Mesh->GetAttributes(type));
  }
  const auto isWanted = [&](vtkAbstractArray* array)
  {
    const bool isOfPoints = type == vtkDataObject::POINT &&
      std::any_of(sets.begin(), sets.end(),
        [array](vtkDataSetAttributes* set)
        {
          return set &&
            (array == set->GetGlobalIds() || array == set->GetPedigreeIds() ||
              array == set->GetRationalWeights());
        });
    const std::string name = array->GetName();
    if (isOfPoints || name == vtkDataSetAttributes::GhostArrayName() || !isNamed(name))
    {
      return false;
    }
    if (target->HasArray(name.c_str()))
    {
      refused.insert(name);
      return false;
    }
    return true;
  };
  return SkdArrayGather(sets, isWanted);
}
}

SkdArrayGather SkdGatherInto(vtkDataSetAttributes* target, vtkIdType n,
  const std::vector<SkdBlock>& blocks, int type, std::set<std::string>& refused, double fill,
  const std::function<bool(const std::string&)>& isWanted)
{
  SkdArrayGather gather = FindArrays(target, blocks, type, refused, isWanted);
  gather.Allocate(n, fill);
  gather.AddTo(target);
  return gather;
}

SkdArrayGather SkdGatherUnfilled(vtkDataSetAttributes* target, vtkIdType n,
  const std::vector<SkdBlock>& blocks, int type, std::set<std::string>& refused)
{
  SkdArrayGather gather =
    FindArrays(target, blocks, type, refused, [](const std::string&) { return true; });
  gather.AllocateUnfilled(n);
  gather.AddTo(target);
  return gather;
}

void SkdWarnAboutRefused(vtkAlgorithm* self, const std::set<std::string>& refused)
{
  for (const std::string& name : refused)
  {
    vtkWarningWithObjectMacro(self,
      "The array "
        << name
        << " is not passed on: the output already has an array of that name. Rename one of them.");
  }
}
}
