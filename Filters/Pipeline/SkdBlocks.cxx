// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdBlocks.h"

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
    vtkDataObject* block = iterator->GetCurrentDataObject();
    vtkSmartPointer<vtkDataObject> copy;
    copy.TakeReference(block->NewInstance());
    copy->ShallowCopy(block);
    output->SetDataSet(iterator, copy);
  }
}
}

std::vector<SkdBlock> SkdBlocksOf(vtkDataObject* object)
{
  std::vector<SkdBlock> blocks;
  if (vtkDataSet* mesh = vtkDataSet::SafeDownCast(object))
  {
    blocks.push_back({ mesh, 0 });
  }
  if (vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(object))
  {
    auto iterator = IteratorOf(composite);
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      if (vtkDataSet* mesh = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject()))
      {
        blocks.push_back({ mesh, static_cast<int>(iterator->GetCurrentFlatIndex()) });
      }
    }
  }
  return blocks;
}

std::vector<SkdBlock> SkdMirror(vtkDataObject* input, vtkDataObject* output)
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
  return SkdBlocksOf(output);
}

vtkIdType SkdCountPoints(const std::vector<SkdBlock>& blocks)
{
  vtkIdType points = 0;
  for (const SkdBlock& block : blocks)
  {
    points += block.Mesh->GetNumberOfPoints();
  }
  return points;
}
