// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdUnfitArrays.h"

#include "vtkAbstractArray.h"
#include "vtkDataSetAttributes.h"

#include <sstream>

namespace skdtree
{
namespace
{
const char* NameOf(vtkAbstractArray* array)
{
  return array->GetName() ? array->GetName() : "without a name";
}

/// Descending, so that those that follow keep their numbers when one is removed.
template <class Visit>
void ForEachUnfit(vtkDataSet* mesh, int type, const Visit& visit)
{
  vtkDataSetAttributes* data = mesh->GetAttributes(type);
  for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (data->GetAbstractArray(i)->GetNumberOfTuples() != mesh->GetNumberOfElements(type))
    {
      visit(data, i);
    }
  }
}
}

SkdFittingMesh SkdLeaveOutUnfitArrays(vtkDataSet* mesh)
{
  SkdFittingMesh fitting{ mesh, {} };
  std::ostringstream text;
  for (const int type : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    const std::string what = type == vtkDataObject::POINT ? "point" : "cell";
    ForEachUnfit(mesh, type,
      [&](vtkDataSetAttributes* data, int i)
      {
        vtkAbstractArray* array = data->GetAbstractArray(i);
        text << (text.tellp() > 0 ? " " : "") << what << " array " << NameOf(array) << " has "
             << array->GetNumberOfTuples() << " tuples for " << mesh->GetNumberOfElements(type)
             << " " << what << "s.";
      });
  }
  fitting.Fault = text.str();
  if (!fitting.Fault.empty())
  {
    fitting.Mesh = vtkSmartPointer<vtkDataSet>::Take(mesh->NewInstance());
    fitting.Mesh->ShallowCopy(mesh);
    for (const int type : { vtkDataObject::POINT, vtkDataObject::CELL })
    {
      ForEachUnfit(
        fitting.Mesh, type, [](vtkDataSetAttributes* data, int i) { data->RemoveArray(i); });
    }
  }
  return fitting;
}
}
