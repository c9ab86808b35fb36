// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdArrayGather.h"

#include "Pipeline/SkdHeldNumbers.h"
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

/// Of arrays that lie in memory as they are written, as all results of numbers do.
template <typename Value>
Value* TupleOf(vtkAbstractArray* array, vtkIdType tuple)
{
  using Plain = vtkAOSDataArrayTemplate<Value>;
  return static_cast<Plain*>(array)->GetPointer(tuple * array->GetNumberOfComponents());
}

/// Calls visit(a value of the array's type) if the array is one of numbers.
template <class Visit>
void VisitType(vtkAbstractArray* array, const Visit& visit)
{
  switch (array->GetDataType())
  {
    vtkTemplateMacro(visit(VTK_TT{}));
    default:
      break;
  }
}

/// Tuples of the nearest number that the array can hold; of integers 0 for NaN.
void FillTuples(vtkAbstractArray* result, vtkIdType first, vtkIdType n, double fill)
{
  VisitType(result,
    [&](auto value)
    {
      using Value = decltype(value);
      std::fill_n(TupleOf<Value>(result, first), n * result->GetNumberOfComponents(),
        SkdNearestNumber<Value>(fill));
    });
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
  if (fill)
  {
    FillTuples(result, 0, n, *fill);
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

bool IsOfReals(vtkAbstractArray* array)
{
  return array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
}

/// Of any numbers, into those of this type; before VTK 9.2 arrays themselves do not, and long
/// integers overflow.
template <typename Value>
void InterpolateNumbers(
  vtkAbstractArray* result, vtkIdType to, vtkAbstractArray* source, vtkIdList* ids, double* weights)
{
  auto* from = static_cast<vtkDataArray*>(source);
  const vtkIdType n = ids->GetNumberOfIds();
  for (int c = 0; c < from->GetNumberOfComponents(); ++c)
  {
    const auto realOf = [&](vtkIdType i) { return from->GetComponent(ids->GetId(i), c); };
    const auto numberOf = [&](vtkIdType i) { return SkdNumberAt<Value>(from, ids->GetId(i), c); };
    TupleOf<Value>(result, to)[c] = !SkdIsLong<Value> || IsOfReals(from)
      ? SkdNearestNumber<Value>(SkdInterpolated<double>(n, weights, realOf))
      : SkdInterpolated<Value>(n, weights, numberOf);
  }
}

template <typename Value>
void TakeNumbers(vtkAbstractArray* result, vtkIdType to, vtkAbstractArray* source, vtkIdType from)
{
  for (int c = 0; c < result->GetNumberOfComponents(); ++c)
  {
    TupleOf<Value>(result, to)[c] = SkdNumberAt<Value>(static_cast<vtkDataArray*>(source), from, c);
  }
}

/// Of arrays that lie in memory as they are written, and have the type of the result.
template <typename Value>
void InterpolatePlain(
  vtkAbstractArray* result, vtkIdType to, vtkAbstractArray* source, vtkIdList* ids, double* weights)
{
  const int components = source->GetNumberOfComponents();
  const Value* from = TupleOf<Value>(source, 0);
  Value* into = TupleOf<Value>(result, to);
  const vtkIdType n = ids->GetNumberOfIds();
  const vtkIdType* id = ids->GetPointer(0);
  for (int c = 0; c < components; ++c)
  {
    into[c] =
      SkdInterpolated<Value>(n, weights, [&](vtkIdType i) { return from[id[i] * components + c]; });
  }
}

template <typename Value>
void TakePlain(vtkAbstractArray* result, vtkIdType to, vtkAbstractArray* source, vtkIdType from)
{
  std::copy_n(
    TupleOf<Value>(source, from), source->GetNumberOfComponents(), TupleOf<Value>(result, to));
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
  array.Interpolate = &InterpolateAny;
  array.Take = &TakeAny;
  VisitType(array.Result,
    [&](auto value)
    {
      using Value = decltype(value);
      const bool isPlain = std::all_of(array.Sources.begin(), array.Sources.end(),
        [](vtkAbstractArray* source) { return !source || IsPlain<Value>(source); });
      array.Interpolate = isPlain ? &InterpolatePlain<Value> : &InterpolateNumbers<Value>;
      array.Take = isPlain ? &TakePlain<Value> : &TakeNumbers<Value>;
    });
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
    FillTuples(array.Result, to, 1, vtkMath::Nan());
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
