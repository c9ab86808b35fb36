// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdLeaves.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"

namespace
{
vtkSmartPointer<vtkCompositeDataIterator> IteratorOf(vtkCompositeDataSet* composite)
{
  vtkSmartPointer<vtkCompositeDataIterator> iterator;
  iterator.TakeReference(composite->NewIterator());
  return iterator;
}

void MirrorComposite(vtkCompositeDataSet* input, vtkCompositeDataSet* output)
{
  output->CopyStructure(input);
  output->GetFieldData()->PassData(input->GetFieldData());
  auto iterator = IteratorOf(input);
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkDataObject* leaf = iterator->GetCurrentDataObject();
    vtkSmartPointer<vtkDataObject> copy;
    copy.TakeReference(leaf->NewInstance());
    copy->ShallowCopy(leaf);
    output->SetDataSet(iterator, copy);
  }
}
}

std::vector<SkdLeaf> SkdLeavesOf(vtkDataObject* object)
{
  std::vector<SkdLeaf> leaves;
  if (vtkDataSet* mesh = vtkDataSet::SafeDownCast(object))
  {
    leaves.push_back({ mesh, 0 });
  }
  if (vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(object))
  {
    auto iterator = IteratorOf(composite);
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      if (vtkDataSet* mesh = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject()))
      {
        leaves.push_back({ mesh, static_cast<int>(iterator->GetCurrentFlatIndex()) });
      }
    }
  }
  return leaves;
}

std::vector<SkdLeaf> SkdMirror(vtkDataObject* input, vtkDataObject* output)
{
  vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (composite)
  {
    MirrorComposite(composite, vtkCompositeDataSet::SafeDownCast(output));
  }
  else
  {
    output->ShallowCopy(input);
  }
  return SkdLeavesOf(output);
}

vtkIdType SkdCountPoints(const std::vector<SkdLeaf>& leaves)
{
  vtkIdType points = 0;
  for (const SkdLeaf& leaf : leaves)
  {
    points += leaf.Mesh->GetNumberOfPoints();
  }
  return points;
}
