// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdBlockArrays.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"

SkdArrayGather SkdGatherInto(vtkDataSetAttributes* target, vtkIdType n,
  const std::vector<SkdBlock>& blocks, int type, std::set<std::string>& refused)
{
  return SkdGatherInto(
    target, n, blocks, type, refused, vtkMath::Nan(), [](const std::string&) { return true; });
}

SkdArrayGather SkdGatherInto(vtkDataSetAttributes* target, vtkIdType n,
  const std::vector<SkdBlock>& blocks, int type, std::set<std::string>& refused, double fill,
  const std::function<bool(const std::string&)>& isNamed)
{
  std::vector<vtkDataSetAttributes*> sets;
  for (const SkdBlock& block : blocks)
  {
    sets.push_back(block.Mesh->GetAttributes(type));
  }
  const auto isWanted = [&](vtkAbstractArray* array)
  {
    vtkDataSetAttributes* first = sets.front();
    const bool isOfPoints = type == vtkDataObject::POINT &&
      (array == first->GetGlobalIds() || array == first->GetPedigreeIds() ||
        array == first->GetRationalWeights());
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
  SkdArrayGather gather(sets, isWanted);
  gather.Allocate(n, fill);
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
