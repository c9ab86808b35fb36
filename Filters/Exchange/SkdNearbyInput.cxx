// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdNearbyInput.h"

#include "Cells/Read/SkdCellReader.h"
#include "Exchange/SkdMessage.h"
#include "Pipeline/SkdBlocks.h"
#include "vtkDataObjectTree.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>

namespace
{
/// Where a process has something that the cells of another mesh may be near.
std::vector<skd::Box3> BoxesOf(vtkDataObject* object)
{
  std::vector<skd::Box3> boxes;
  for (const SkdBlock& block : SkdBlocksOf(object))
  {
    for (const std::vector<skd::Box3>& some :
      { SkdBoxesOfPoints(block.Mesh), SkdBoxesOfCells(block.Mesh, false) })
    {
      boxes.insert(boxes.end(), some.begin(), some.end());
    }
  }
  return boxes;
}

/// The structure of the object, with examples in the place of its meshes.
vtkSmartPointer<vtkDataObject> ExampleOf(vtkDataObject* object)
{
  vtkSmartPointer<vtkDataObject> example = SkdStructureOf(object);
  for (const SkdPlacedBlock& leaf : SkdPlacedBlocksOf(object))
  {
    const vtkSmartPointer<vtkDataSet> mesh = SkdSpreadBlock::MakeExample(leaf.Mesh);
    if (example && !leaf.Path.empty())
    {
      SkdSetBlock(example, leaf.Path, mesh);
    }
    else
    {
      example = mesh;
    }
  }
  return example;
}

/// Whether there are cells that are three-dimensional, or others.
bool HasCells(vtkDataObject* object, bool ofThreeDimensions)
{
  for (const SkdBlock& block : SkdBlocksOf(object))
  {
    const SkdCellReader reader(block.Mesh);
    std::array<signed char, 256> known;
    known.fill(-1);
    for (vtkIdType id = 0; id < block.Mesh->GetNumberOfCells(); ++id)
    {
      signed char& isOfThree = known[static_cast<unsigned char>(reader.TypeOf(id))];
      if (isOfThree < 0)
      {
        vtkNew<vtkGenericCell> cell;
        cell->SetCellType(reader.TypeOf(id));
        isOfThree = cell->GetCellDimension() == 3 ? 1 : 0;
      }
      if ((isOfThree == 1) == ofThreeDimensions)
      {
        return true;
      }
    }
  }
  return false;
}

bool IsAny(SkdTransport& transport, bool here)
{
  const auto all = SkdGatherRows(transport, std::vector<unsigned char>(1, here ? 1 : 0));
  return std::any_of(all.begin(), all.end(), [](const auto& one) { return one.front() != 0; });
}
}

bool SkdCanBring(vtkDataObject* object)
{
  return !SkdIsComposite(object) || vtkDataObjectTree::SafeDownCast(object) != nullptr;
}

bool SkdIsUnfit(vtkDataObject* piece, vtkDataObject* own, const SkdReach& reach)
{
  return (reach.IsOfFaces && HasCells(piece, true)) ||
    (reach.IsOfVolumes &&
      (SkdIsComposite(piece) || HasCells(piece, false) || HasCells(own, false)));
}

vtkDataObject* SkdNearbyInput::Update(
  SkdTransport& transport, vtkDataObject* piece, vtkDataObject* own, const SkdReach& reach)
{
  SkdStamp newPiece(piece);
  SkdStamp newOwn(own);
  const bool isNewPiece = IsAny(transport, newPiece != this->KnownPiece);
  const bool isNewOwn = IsAny(transport,
    !this->Nearby || newOwn != this->KnownOwn || reach.Distance != this->KnownReach.Distance ||
      reach.OfDiagonal != this->KnownReach.OfDiagonal ||
      reach.WithOwn != this->KnownReach.WithOwn ||
      reach.WithNeighbours != this->KnownReach.WithNeighbours);
  if (isNewPiece)
  {
    this->UpdateBlocks(transport, piece);
  }
  if (isNewPiece || isNewOwn)
  {
    const SkdCut cut(transport, BoxesOf(own));
    this->Bring(
      [&](const SkdSpreadBlock& block) { return block.Bring(transport, cut, reach); }, piece);
  }
  this->KnownPiece = std::move(newPiece);
  this->KnownOwn = std::move(newOwn);
  this->KnownReach = reach;
  this->Traffic = transport.GetTraffic();
  return this->Nearby;
}

// Of composite data, processes may have blocks in different places.
void SkdNearbyInput::UpdateBlocks(SkdTransport& transport, vtkDataObject* piece)
{
  std::map<SkdBlockPath, SkdPieces> examples;
  const std::vector<SkdBytes> all = transport.GatherAll(SkdPackObject(ExampleOf(piece)));
  this->Structure = SkdStructureOf(piece);
  for (std::size_t process = 0; process < all.size(); ++process)
  {
    const vtkSmartPointer<vtkDataObject> example = SkdUnpackObject(all[process]);
    SkdUniteStructures(this->Structure, example);
    for (const SkdPlacedBlock& leaf : SkdPlacedBlocksOf(example))
    {
      examples[leaf.Path].resize(all.size());
      examples[leaf.Path][process] = leaf.Mesh;
    }
  }
  std::map<SkdBlockPath, vtkSmartPointer<vtkDataSet>> own;
  for (const SkdPlacedBlock& leaf : SkdPlacedBlocksOf(piece))
  {
    own[leaf.Path] = leaf.Mesh;
  }
  this->Blocks.clear();
  for (auto& [path, some] : examples)
  {
    vtkSmartPointer<vtkDataSet>& mesh = own[path];
    if (!mesh)
    {
      mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
    }
    this->Blocks[path] = std::make_unique<SkdSpreadBlock>(transport, mesh, std::move(some));
  }
}

vtkDataObject* SkdNearbyInput::UpdateOwn(SkdTransport& transport, vtkDataObject* piece)
{
  SkdStamp newPiece(piece);
  if (IsAny(transport, !this->Nearby || newPiece != this->KnownPiece))
  {
    this->UpdateBlocks(transport, piece);
    this->Bring([&](const SkdSpreadBlock& block) { return block.BringOwn(transport); }, piece);
  }
  this->KnownPiece = std::move(newPiece);
  this->Traffic = transport.GetTraffic();
  return this->Nearby;
}

void SkdNearbyInput::Bring(
  const std::function<vtkSmartPointer<vtkDataSet>(const SkdSpreadBlock&)>& bring,
  vtkDataObject* piece)
{
  if (this->Structure)
  {
    this->Nearby = SkdStructureOf(this->Structure);
  }
  for (const auto& [path, block] : this->Blocks)
  {
    const vtkSmartPointer<vtkDataSet> mesh = bring(*block);
    if (this->Structure && !path.empty())
    {
      SkdSetBlock(this->Nearby, path, mesh);
    }
    else
    {
      this->Nearby = mesh;
    }
  }
  if (this->Structure)
  {
    this->Nearby->GetFieldData()->PassData(piece->GetFieldData());
  }
}
