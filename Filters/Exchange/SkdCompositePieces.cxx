// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdCompositePieces.h"

#include "Exchange/SkdTransport.h"
#include "Pipeline/SkdBlocks.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

#include <algorithm>
#include <set>

namespace skdtree
{
namespace
{
/// The children of a tree's node, which VTK gives other names in each class.
class Node
{
public:
  explicit Node(vtkDataObject* object)
    : Blocks(vtkMultiBlockDataSet::SafeDownCast(object))
    , Collection(vtkPartitionedDataSetCollection::SafeDownCast(object))
    , Partitions(vtkPartitionedDataSet::SafeDownCast(object))
  {
  }

  int GetNumber() const
  {
    return static_cast<int>(this->Blocks ? this->Blocks->GetNumberOfBlocks()
        : this->Collection               ? this->Collection->GetNumberOfPartitionedDataSets()
        : this->Partitions               ? this->Partitions->GetNumberOfPartitions()
                                         : 0);
  }

  vtkDataObject* Get(int child) const
  {
    const auto i = static_cast<unsigned int>(child);
    return this->Blocks  ? this->Blocks->GetBlock(i)
      : this->Collection ? static_cast<vtkDataObject*>(this->Collection->GetPartitionedDataSet(i))
                         : this->Partitions->GetPartitionAsDataObject(i);
  }

  void Set(int child, vtkDataObject* object) const
  {
    const auto i = static_cast<unsigned int>(child);
    if (this->Blocks)
    {
      this->Blocks->SetBlock(i, object);
    }
    else if (this->Collection)
    {
      this->Collection->SetPartitionedDataSet(i, vtkPartitionedDataSet::SafeDownCast(object));
    }
    else
    {
      this->Partitions->SetPartition(i, object);
    }
  }

  /// At least so many.
  void Grow(int number) const
  {
    const auto n = static_cast<unsigned int>(number);
    if (number <= this->GetNumber())
    {
      return;
    }
    if (this->Blocks)
    {
      this->Blocks->SetNumberOfBlocks(n);
    }
    else if (this->Collection)
    {
      this->Collection->SetNumberOfPartitionedDataSets(n);
    }
    else
    {
      this->Partitions->SetNumberOfPartitions(n);
    }
  }

  void CopyName(int child, const Node& from) const
  {
    const auto i = static_cast<unsigned int>(child);
    vtkInformation* theirs = from.InformationOf(i, false);
    if (theirs && !this->InformationOf(i, false))
    {
      this->InformationOf(i, true)->Copy(theirs);
    }
  }

private:
  vtkInformation* InformationOf(unsigned int i, bool isNew) const
  {
    if (this->Blocks)
    {
      return isNew || this->Blocks->HasMetaData(i) ? this->Blocks->GetMetaData(i) : nullptr;
    }
    if (this->Collection)
    {
      return isNew || this->Collection->HasMetaData(i) ? this->Collection->GetMetaData(i) : nullptr;
    }
    return isNew || this->Partitions->HasMetaData(i) ? this->Partitions->GetMetaData(i) : nullptr;
  }

  vtkMultiBlockDataSet* Blocks;
  vtkPartitionedDataSetCollection* Collection;
  vtkPartitionedDataSet* Partitions;
};

void AddLeavesOf(vtkDataObject* object, SkdBlockPath& path, std::vector<SkdLeafBlock>& leaves)
{
  if (auto* mesh = vtkDataSet::SafeDownCast(object))
  {
    leaves.push_back({ path, mesh });
    return;
  }
  const Node node(object);
  for (int child = 0; child < node.GetNumber(); ++child)
  {
    path.push_back(child);
    AddLeavesOf(node.Get(child), path, leaves);
    path.pop_back();
  }
}

bool IsTree(vtkDataObject* object)
{
  return vtkDataObjectTree::SafeDownCast(object) != nullptr;
}
}

std::vector<SkdLeafBlock> SkdLeafBlocksOf(vtkDataObject* object)
{
  std::vector<SkdLeafBlock> leaves;
  if (SkdIsComposite(object) && !IsTree(object))
  {
    for (const SkdBlock& block : SkdBlocksOf(object))
    {
      leaves.push_back({ { block.BlockIndex }, block.Mesh });
    }
    return leaves;
  }
  SkdBlockPath path;
  AddLeavesOf(object, path, leaves);
  return leaves;
}

vtkSmartPointer<vtkDataObject> SkdStructureOf(vtkDataObject* object)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(object);
  if (!composite)
  {
    return nullptr;
  }
  const auto copy = vtkSmartPointer<vtkCompositeDataSet>::Take(composite->NewInstance());
  copy->CopyStructure(composite);
  return copy;
}

void SkdUniteStructures(vtkDataObject* into, vtkDataObject* from)
{
  if (!IsTree(into) || !IsTree(from))
  {
    return;
  }
  const Node ours(into);
  const Node theirs(from);
  ours.Grow(theirs.GetNumber());
  for (int child = 0; child < theirs.GetNumber(); ++child)
  {
    vtkDataObject* object = theirs.Get(child);
    if (IsTree(object) && !ours.Get(child))
    {
      ours.Set(child, SkdStructureOf(object));
    }
    ours.CopyName(child, theirs);
    SkdUniteStructures(ours.Get(child), object);
  }
}

bool SkdAreNestedAlike(SkdTransport& transport, vtkDataObject* piece)
{
  constexpr int end = -1; // of a path
  std::vector<int> own;
  for (const SkdLeafBlock& leaf : SkdLeafBlocksOf(piece))
  {
    own.insert(own.end(), leaf.Path.begin(), leaf.Path.end());
    own.push_back(end);
  }
  std::set<SkdBlockPath> paths;
  for (const std::vector<int>& some : SkdGatherRows(transport, own))
  {
    for (auto from = some.begin(); from != some.end();)
    {
      const auto to = std::find(from, some.end(), end);
      paths.emplace(from, to);
      from = to + 1;
    }
  }
  const auto isWithin = [](const SkdBlockPath& path, const SkdBlockPath& next)
  { return path.size() < next.size() && std::equal(path.begin(), path.end(), next.begin()); };
  return std::adjacent_find(paths.begin(), paths.end(), isWithin) == paths.end();
}

void SkdSetBlock(vtkDataObject* composite, const SkdBlockPath& path, vtkDataSet* mesh)
{
  if (IsTree(composite))
  {
    for (std::size_t depth = 0; depth + 1 < path.size(); ++depth)
    {
      composite = Node(composite).Get(path[depth]);
    }
    Node(composite).Set(path.back(), mesh);
    return;
  }
  auto* whole = vtkCompositeDataSet::SafeDownCast(composite);
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(whole->NewIterator());
  iterator->SkipEmptyNodesOff();
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    if (static_cast<int>(iterator->GetCurrentFlatIndex()) == path.front())
    {
      whole->SetDataSet(iterator, mesh);
      return;
    }
  }
}
}
