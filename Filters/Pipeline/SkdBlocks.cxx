// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdBlocks.h"

#include "Pipeline/SkdMakeArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkUniformGridAMR.h"

#include <algorithm>

namespace skdtree
{
namespace
{
vtkSmartPointer<vtkCompositeDataIterator> IteratorOf(vtkCompositeDataSet* composite)
{
  vtkSmartPointer<vtkCompositeDataIterator> iterator;
  iterator.TakeReference(composite->NewIterator());
  return iterator;
}

/// The flat indices of the pieces of one mesh.
struct PieceRange
{
  int First;
  int Last;
};

std::vector<PieceRange> PieceRangesOf(vtkCompositeDataSet* composite)
{
  std::vector<PieceRange> ranges;
  const auto add = [&ranges](vtkDataObject* object, unsigned int flatIndex)
  {
    if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(object))
    {
      const unsigned int last = flatIndex + partitions->GetNumberOfPartitions();
      ranges.push_back({ static_cast<int>(flatIndex) + 1, static_cast<int>(last) });
    }
  };
  if (vtkUniformGridAMR::SafeDownCast(composite))
  {
    ranges.push_back({ 0, VTK_INT_MAX });
  }
  add(composite, 0);
  if (auto* tree = vtkDataObjectTree::SafeDownCast(composite))
  {
    vtkSmartPointer<vtkDataObjectTreeIterator> iterator;
    iterator.TakeReference(tree->NewTreeIterator());
    iterator->VisitOnlyLeavesOff();
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      add(iterator->GetCurrentDataObject(), iterator->GetCurrentFlatIndex());
    }
  }
  return ranges;
}

/// Both are in the order of flat indices.
void FindFirstPieces(const std::vector<PieceRange>& ranges, std::vector<SkdBlock>& blocks)
{
  auto range = ranges.begin();
  for (SkdBlock& block : blocks)
  {
    range = std::find_if(range, ranges.end(),
      [&block](const PieceRange& pieces) { return block.BlockIndex <= pieces.Last; });
    const bool isPiece = range != ranges.end() && range->First <= block.BlockIndex;
    block.FirstPiece = isPiece ? range->First : -1;
  }
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

bool SkdIsComposite(vtkDataObject* object)
{
  return vtkCompositeDataSet::SafeDownCast(object) != nullptr;
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
    FindFirstPieces(PieceRangesOf(composite), blocks);
  }
  return blocks;
}

SkdLeafNumbers SkdLeafNumbersOf(vtkDataObject* object)
{
  vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(object);
  if (!composite)
  {
    return { { 0 }, 1 };
  }
  SkdLeafNumbers numbers;
  auto iterator = IteratorOf(composite);
  iterator->SkipEmptyNodesOff();
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    if (vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject()))
    {
      numbers.Of.push_back(numbers.Count);
    }
    ++numbers.Count;
  }
  return numbers;
}

std::vector<SkdBlock> SkdBlocksWithCells(std::vector<SkdBlock> blocks)
{
  const auto isEmpty = [](const SkdBlock& block) { return block.Mesh->GetNumberOfCells() == 0; };
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(), isEmpty), blocks.end());
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

vtkSmartPointer<vtkIntArray> SkdMakeBlockIndices(
  const char* name, const std::vector<int>& positions, const std::vector<SkdBlock>& blocks)
{
  auto indices = SkdMakeArray<vtkIntArray>(name, 1, static_cast<vtkIdType>(positions.size()));
  std::transform(positions.begin(), positions.end(), indices->GetPointer(0),
    [&](int position)
    { return position >= 0 ? blocks[static_cast<std::size_t>(position)].BlockIndex : -1; });
  return indices;
}

void SkdDropData(const std::vector<SkdBlock>& blocks)
{
  for (const SkdBlock& block : blocks)
  {
    for (int type : { vtkDataObject::POINT, vtkDataObject::CELL })
    {
      vtkDataSetAttributes* data = block.Mesh->GetAttributes(type);
      vtkSmartPointer<vtkDataArray> ghosts = data->GetArray(vtkDataSetAttributes::GhostArrayName());
      data->Initialize();
      data->AddArray(ghosts);
    }
  }
}

bool SkdIsStructured(vtkDataSet* mesh)
{
  const int type = mesh->GetDataObjectType();
  return type == VTK_IMAGE_DATA || type == VTK_UNIFORM_GRID || type == VTK_RECTILINEAR_GRID ||
    type == VTK_STRUCTURED_GRID || type == VTK_STRUCTURED_POINTS;
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

void SkdTouchCells(vtkDataSet* mesh)
{
  if (mesh->GetNumberOfCells() > 0)
  {
    vtkNew<vtkGenericCell> cell;
    vtkNew<vtkIdList> ids;
    double bounds[6];
    mesh->GetCell(0, cell);
    mesh->GetCellPoints(0, ids);
    mesh->GetCellBounds(0, bounds);
  }
}
}
