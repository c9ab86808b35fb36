// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdArrayGather.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkStringArray.h"

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

vtkSmartPointer<vtkAbstractArray> MakeResult(vtkAbstractArray* like, vtkIdType n)
{
  const int type = like->GetDataType() == VTK_BIT ? VTK_UNSIGNED_CHAR : like->GetDataType();
  vtkSmartPointer<vtkAbstractArray> result;
  result.TakeReference(vtkAbstractArray::CreateArray(type));
  result->SetName(like->GetName());
  result->SetNumberOfComponents(like->GetNumberOfComponents());
  result->CopyComponentNames(like);
  result->SetNumberOfTuples(n);
  if (vtkDataArray* numbers = vtkDataArray::SafeDownCast(result))
  {
    numbers->Fill(type == VTK_FLOAT || type == VTK_DOUBLE ? vtkMath::Nan() : 0.0);
  }
  return result;
}
}

SkdArrayGather::SkdArrayGather(const std::vector<vtkDataSetAttributes*>& sets,
  const std::function<bool(vtkAbstractArray*)>& isWanted)
{
  const int candidates = sets.empty() ? 0 : sets.front()->GetNumberOfArrays();
  for (int i = 0; i < candidates; ++i)
  {
    vtkAbstractArray* first = sets.front()->GetAbstractArray(i);
    if (!IsGatherable(first) || !isWanted(first))
    {
      continue;
    }
    Array array;
    for (vtkDataSetAttributes* set : sets)
    {
      vtkAbstractArray* source = set->GetAbstractArray(first->GetName());
      if (IsAlike(source, first))
      {
        array.Sources.push_back(source);
      }
    }
    if (array.Sources.size() == sets.size())
    {
      this->Arrays.push_back(array);
    }
  }
}

void SkdArrayGather::Allocate(vtkIdType n)
{
  for (Array& array : this->Arrays)
  {
    array.Result = MakeResult(array.Sources.front(), n);
  }
}

void SkdArrayGather::Interpolate(vtkIdType to, int set, vtkIdList* ids, double* weights)
{
  for (Array& array : this->Arrays)
  {
    array.Result->InterpolateTuple(to, ids, array.Sources[set], weights);
  }
}

void SkdArrayGather::Take(vtkIdType to, int set, vtkIdType from)
{
  for (Array& array : this->Arrays)
  {
    array.Result->SetTuple(to, from, array.Sources[set]);
  }
}

void SkdArrayGather::AddTo(vtkDataSetAttributes* attributes) const
{
  for (const Array& array : this->Arrays)
  {
    attributes->AddArray(array.Result);
  }
}
