// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/InOut/SkdPartList.h"

#include "Bodies/SkdWeld.h"
#include "Core/Geometry/DisjointSets.h"
#include "Pipeline/SkdSubset.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

namespace skdtree
{
std::vector<std::vector<int>> SkdConnectedPiecesOf(const std::vector<SkdBlock>& blocks)
{
  SkdWeld weld;
  skd::DisjointSets<vtkIdType> pieces(0);
  std::vector<std::vector<vtkIdType>> firstPoints(blocks.size());
  vtkNew<vtkIdList> ids;
  for (std::size_t block = 0; block < blocks.size(); ++block)
  {
    vtkDataSet* mesh = blocks[block].Mesh;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      mesh->GetCellPoints(cell, ids);
      vtkIdType first = -1;
      for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      {
        double x[3];
        mesh->GetPoint(ids->GetId(i), x);
        const vtkIdType point = weld.GetId(x);
        if (static_cast<std::size_t>(point) == pieces.Size())
        {
          pieces.Add();
        }
        first = first < 0 ? point : first;
        pieces.Unite(first, point);
      }
      firstPoints[block].push_back(first);
    }
  }
  std::unordered_map<vtkIdType, int> numbers;
  std::vector<std::vector<int>> found(blocks.size());
  for (std::size_t block = 0; block < blocks.size(); ++block)
  {
    for (const vtkIdType point : firstPoints[block])
    {
      const vtkIdType root = point < 0 ? -1 : pieces.Find(point);
      found[block].push_back(numbers.emplace(root, static_cast<int>(numbers.size())).first->second);
    }
  }
  return found;
}

bool SkdHavePartArray(const std::vector<SkdBlock>& blocks, const std::string& array)
{
  return std::all_of(blocks.begin(), blocks.end(),
    [&](const SkdBlock& block)
    { return block.Mesh->GetCellData()->GetArray(array.c_str()) != nullptr; });
}

std::vector<int> SkdPartIdsOf(vtkDataSet* mesh, const std::string& array)
{
  std::vector<int> ids;
  if (vtkDataArray* values = mesh->GetCellData()->GetArray(array.c_str()))
  {
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      const double value = std::round(values->GetComponent(cell, 0));
      const bool fits = value >= VTK_INT_MIN && value <= VTK_INT_MAX;
      ids.push_back(fits ? static_cast<int>(value) : -1);
    }
  }
  return ids;
}

int SkdPartList::Update(const std::vector<SkdBlock>& blocks, SkdPartsBy by,
  const std::string& array, const SkdPartSettings& settings)
{
  Key key{ by, settings, {}, {} };
  for (const SkdBlock& block : blocks)
  {
    key.BlockIndices.push_back(block.BlockIndex);
    if (by == SkdPartsBy::CellArray)
    {
      key.Ids.push_back(SkdPartIdsOf(block.Mesh, array));
    }
  }
  const bool isSameMesh = this->Meshes.AreSameAs(blocks);
  if (by == SkdPartsBy::ConnectedPieces)
  {
    key.Ids = isSameMesh && this->Last.By == by ? this->Last.Ids : SkdConnectedPiecesOf(blocks);
  }
  if (isSameMesh && key == this->Last)
  {
    return 0;
  }
  this->Last = key;
  this->Parts.clear();
  this->Meshes.Keep(blocks);
  if (by != SkdPartsBy::Blocks)
  {
    this->MakeByIds(blocks);
    return static_cast<int>(this->Parts.size());
  }
  for (const SkdBlock& block : blocks)
  {
    this->Parts.emplace_back(block.BlockIndex, std::vector<SkdBlock>{ block }, settings);
  }
  return static_cast<int>(this->Parts.size());
}

void SkdPartList::MakeByIds(const std::vector<SkdBlock>& blocks)
{
  std::map<int, std::map<std::size_t, std::vector<vtkIdType>>> cells; // by id, then block
  for (std::size_t block = 0; block < blocks.size(); ++block)
  {
    vtkUnsignedCharArray* ghosts = blocks[block].Mesh->GetCellGhostArray();
    for (std::size_t cell = 0; cell < this->Last.Ids[block].size(); ++cell)
    {
      const auto id = static_cast<vtkIdType>(cell);
      if (!ghosts || !ghosts->GetValue(id))
      {
        cells[this->Last.Ids[block][cell]][block].push_back(id);
      }
    }
  }
  for (const auto& [id, some] : cells)
  {
    std::vector<SkdBlock> parts;
    for (const auto& [block, ids] : some)
    {
      SkdSubset subset(blocks[block].Mesh);
      subset.SetCells(ids);
      subset.CopyShaping();
      parts.push_back({ subset.Get(), blocks[block].BlockIndex });
    }
    this->Parts.emplace_back(id, parts, this->Last.Settings);
  }
}
}
