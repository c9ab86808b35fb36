// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdMessage.h"

#include "Exchange/SkdCompositePieces.h"
#include "Exchange/SkdPackedMesh.h"
#include "vtkCharArray.h"
#include "vtkCommunicator.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkUniformGridAMR.h"

#include <algorithm>

namespace skdtree
{
namespace
{
/// MPI counts in int.
constexpr vtkIdType LargestTransfer = vtkIdType(1) << 30;

const char* const PathName = "path";
const char* const StructureName = "structure";

/// The structure of composite data as bytes: blocks can be no partitioned data sets.
vtkSmartPointer<vtkTable> PackStructure(vtkDataObject* object)
{
  const vtkSmartPointer<vtkDataObject> structure = SkdStructureOf(object);
  auto* amr = vtkUniformGridAMR::SafeDownCast(structure);
  if (!structure ||
    (amr && amr->GetNumberOfLevels() == 0)) // VTK crashes as it writes AMR of no levels
  {
    return nullptr;
  }
  vtkNew<vtkCharArray> bytes;
  bytes->SetName(StructureName);
  vtkCommunicator::MarshalDataObject(structure, bytes);
  vtkNew<vtkTable> table;
  table->GetFieldData()->AddArray(bytes);
  return table;
}

/// Nothing of a mesh.
vtkSmartPointer<vtkDataObject> UnpackStructure(vtkDataObject* table)
{
  return table ? vtkCommunicator::UnMarshalDataObject(vtkCharArray::SafeDownCast(
                   table->GetFieldData()->GetAbstractArray(StructureName)))
               : nullptr;
}

/// The first block is the structure of composite data, the others are the data sets.
void Pack(vtkDataObject* object, vtkCharArray* message)
{
  vtkNew<vtkMultiBlockDataSet> all;
  const std::vector<SkdLeafBlock> leaves = SkdLeafBlocksOf(object);
  all->SetNumberOfBlocks(static_cast<unsigned int>(leaves.size()) + 1);
  all->SetBlock(0, PackStructure(object));
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    const vtkSmartPointer<vtkTable> packed = SkdPack(leaves[i].Mesh);
    vtkNew<vtkIntArray> path;
    path->SetName(PathName);
    path->SetNumberOfValues(static_cast<vtkIdType>(leaves[i].Path.size()));
    std::copy(leaves[i].Path.begin(), leaves[i].Path.end(), path->GetPointer(0));
    packed->GetFieldData()->AddArray(path);
    all->SetBlock(static_cast<unsigned int>(i) + 1, packed);
  }
  vtkCommunicator::MarshalDataObject(all, message);
}

vtkSmartPointer<vtkDataObject> Unpack(vtkCharArray* message)
{
  vtkNew<vtkMultiBlockDataSet> all;
  vtkCommunicator::UnMarshalDataObject(message, all);
  vtkSmartPointer<vtkDataObject> object = UnpackStructure(all->GetBlock(0));
  for (unsigned int i = 1; i < all->GetNumberOfBlocks(); ++i)
  {
    auto* packed = vtkTable::SafeDownCast(all->GetBlock(i));
    auto* path = vtkIntArray::SafeDownCast(packed->GetFieldData()->GetAbstractArray(PathName));
    const int* const first = path->GetPointer(0);
    const SkdBlockPath blockPath(first, first + path->GetNumberOfValues());
    const vtkSmartPointer<vtkDataSet> mesh = SkdUnpack(packed);
    if (object && !blockPath.empty())
    {
      SkdSetBlock(object, blockPath, mesh);
    }
    else
    {
      object = mesh;
    }
  }
  return object;
}

/// Sends a message of one process to all.
void Broadcast(vtkCharArray* message, int sender, vtkMultiProcessController* controller)
{
  vtkIdType size = message->GetNumberOfValues();
  controller->Broadcast(&size, 1, sender);
  if (controller->GetLocalProcessId() != sender)
  {
    message->SetNumberOfValues(size);
  }
  for (vtkIdType sent = 0; sent < size; sent += LargestTransfer)
  {
    controller->Broadcast(
      message->GetPointer(sent), std::min(size - sent, LargestTransfer), sender);
  }
}
}

std::vector<vtkSmartPointer<vtkDataObject>> SkdExchangeAll(
  vtkDataObject* own, vtkMultiProcessController* controller)
{
  std::vector<vtkSmartPointer<vtkDataObject>> objects;
  for (int sender = 0; sender < controller->GetNumberOfProcesses(); ++sender)
  {
    const bool isOwn = sender == controller->GetLocalProcessId();
    vtkNew<vtkCharArray> message;
    if (isOwn)
    {
      Pack(own, message);
    }
    Broadcast(message, sender, controller);
    objects.push_back(isOwn ? vtkSmartPointer<vtkDataObject>(own) : Unpack(message));
  }
  return objects;
}

SkdBytes SkdPackObject(vtkDataObject* object)
{
  vtkNew<vtkCharArray> message;
  Pack(object, message);
  const char* const first = message->GetPointer(0);
  return SkdBytes(first, first + message->GetNumberOfValues());
}

vtkSmartPointer<vtkDataObject> SkdUnpackObject(SkdBytes bytes)
{
  vtkNew<vtkCharArray> message;
  message->SetArray(bytes.data(), static_cast<vtkIdType>(bytes.size()), 1);
  return Unpack(message);
}

void SkdExchangeMeshes(SkdTransport& transport,
  const std::function<vtkSmartPointer<vtkDataSet>(int to)>& make,
  const std::function<void(int from, vtkDataSet* mesh)>& take)
{
  transport.Exchange(
    [&](int to)
    {
      const vtkSmartPointer<vtkDataSet> mesh = make(to);
      if (to == transport.GetRank())
      {
        take(to, mesh);
      }
      return mesh && to != transport.GetRank() ? SkdPackObject(mesh) : SkdBytes();
    },
    [&](int from, SkdBytes message)
    {
      if (from != transport.GetRank())
      {
        const vtkSmartPointer<vtkDataObject> mesh =
          message.empty() ? nullptr : SkdUnpackObject(std::move(message));
        take(from, vtkDataSet::SafeDownCast(mesh));
      }
    });
}
}
