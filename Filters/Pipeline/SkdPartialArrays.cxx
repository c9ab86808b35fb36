// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdPartialArrays.h"

#include "Pipeline/SkdMakeArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <cstring>
#include <map>

namespace skdtree
{
namespace
{
/// An array of numbers that may be completed, by its name and number of components.
using Kind = std::pair<std::string, int>;

bool IsOfData(vtkDataSetAttributes* data, vtkDataArray* array)
{
  return array && array->GetName() && array != data->GetGlobalIds() &&
    array != data->GetRationalWeights() && array != data->GetHigherOrderDegrees() &&
    std::strcmp(array->GetName(), vtkDataSetAttributes::GhostArrayName()) != 0;
}

/// How many of the blocks have an array, and of which types it is there.
struct Owners
{
  std::size_t Count = 0;
  std::set<int> Types;
};

std::map<Kind, Owners> FindOwners(const std::vector<SkdBlock>& blocks, int type)
{
  std::map<Kind, Owners> owners;
  for (const SkdBlock& block : blocks)
  {
    vtkDataSetAttributes* data = block.Mesh->GetAttributes(type);
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i);
      if (IsOfData(data, array))
      {
        Owners& own = owners[{ array->GetName(), array->GetNumberOfComponents() }];
        ++own.Count;
        own.Types.insert(array->GetDataType());
      }
    }
  }
  return owners;
}

/// The values in double, or NaN.
void Complete(vtkDataSet* mesh, int type, const Kind& kind)
{
  vtkDataSetAttributes* data = mesh->GetAttributes(type);
  vtkDataArray* own = data->GetArray(kind.first.c_str());
  const bool has = own && own->GetNumberOfComponents() == kind.second;
  auto array = SkdMakeArray<vtkDoubleArray>(
    kind.first.c_str(), kind.second, mesh->GetNumberOfElements(type), vtkMath::Nan());
  if (has)
  {
    array->CopyComponentNames(own);
    array->InsertTuples(0, own->GetNumberOfTuples(), 0, own);
  }
  if (has || !data->GetAbstractArray(kind.first.c_str()))
  {
    data->AddArray(array);
  }
}

void AddMarked(vtkDataSetAttributes* data, std::set<std::string>& names)
{
  const std::size_t length = std::strlen(SkdPartialMarkPrefix);
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const std::string name = data->GetArrayName(i) ? data->GetArrayName(i) : "";
    if (name.compare(0, length, SkdPartialMarkPrefix) == 0)
    {
      names.insert(name.substr(length));
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<SkdBlock> SkdCompleteArrays(
  const std::vector<SkdBlock>& blocks, std::set<std::string>& partial)
{
  std::vector<SkdBlock> filled;
  for (const SkdBlock& block : blocks)
  {
    if (block.Mesh->GetNumberOfPoints() > 0)
    {
      filled.push_back(
        { vtkSmartPointer<vtkDataSet>::Take(block.Mesh->NewInstance()), block.BlockIndex });
      filled.back().Mesh->ShallowCopy(block.Mesh);
    }
  }
  for (const int type : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    for (const auto& [kind, owners] : FindOwners(filled, type))
    {
      const bool isPartial = owners.Count < filled.size();
      for (const SkdBlock& block : filled)
      {
        if (isPartial || owners.Types.size() > 1)
        {
          Complete(block.Mesh, type, kind);
        }
      }
      if (isPartial)
      {
        partial.insert(kind.first);
      }
    }
  }
  return filled;
}

//------------------------------------------------------------------------------
void SkdReportPartialArrays(const std::set<std::string>& names, vtkDataObject* output)
{
  if (names.empty())
  {
    return;
  }
  vtkNew<vtkStringArray> list;
  list->SetName("SkdReportPartialArrays");
  for (const std::string& name : names)
  {
    list->InsertNextValue(name);
  }
  output->GetFieldData()->AddArray(list);
}

//------------------------------------------------------------------------------
void SkdReportPartialArrays(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    if (vtkDataObject* output = vtkDataObject::GetData(outputs, port))
    {
      std::set<std::string> names;
      for (const SkdBlock& block : SkdBlocksOf(output))
      {
        AddMarked(block.Mesh->GetAttributes(vtkDataObject::POINT), names);
        AddMarked(block.Mesh->GetAttributes(vtkDataObject::CELL), names);
      }
      SkdReportPartialArrays(names, output);
    }
  }
}
}
