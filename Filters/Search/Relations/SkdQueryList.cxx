// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Relations/SkdQueryList.h"

#include "Search/Relations/SkdCellOutline.h"

#include <algorithm>

namespace skdtree
{
//------------------------------------------------------------------------------
void SkdQueryList::Clear()
{
  *this = SkdQueryList();
}

//------------------------------------------------------------------------------
void SkdQueryList::AddBlock(int blockIndex, vtkIdType size)
{
  this->BlockIndices.push_back(blockIndex);
  this->Starts.push_back(this->Starts.back() + size);
}

//------------------------------------------------------------------------------
void SkdQueryList::SetShape(const SkdQueryShape& shape)
{
  this->Clear();
  this->Shape = shape;
  this->AddBlock(0, 1);
}

//------------------------------------------------------------------------------
void SkdQueryList::SetPoints(const std::vector<SkdBlock>& blocks)
{
  this->Clear();
  this->Points = blocks;
  for (const SkdBlock& block : blocks)
  {
    this->AddBlock(block.BlockIndex, block.Mesh->GetNumberOfPoints());
  }
}

//------------------------------------------------------------------------------
void SkdQueryList::SetCells(
  const SkdParts& parts, const std::vector<SkdBlock>& blocks, bool wantsOutlines)
{
  this->Clear();
  this->Joined = SkdJoinedIdsOf(blocks);
  this->Parts = &parts;
  this->WantsOutlines = wantsOutlines;
  const std::vector<int> indices = parts.GetBlockIndices();
  for (std::uint32_t part = 0; part < parts.GetNumberOfParts(); ++part)
  {
    this->AddBlock(indices[part], parts.GetTree(part).Cells().NumberOfCells());
  }
}

//------------------------------------------------------------------------------
vtkIdType SkdQueryList::GetSize() const
{
  return this->Starts.back();
}

//------------------------------------------------------------------------------
std::pair<std::size_t, vtkIdType> SkdQueryList::Find(vtkIdType query) const
{
  const auto next = std::upper_bound(this->Starts.begin(), this->Starts.end(), query);
  const auto block = static_cast<std::size_t>(next - this->Starts.begin()) - 1;
  return { block, query - this->Starts[block] };
}

//------------------------------------------------------------------------------
SkdQueryShape SkdQueryList::Make(vtkIdType query) const
{
  if (this->Shape)
  {
    return *this->Shape;
  }
  const auto [block, index] = this->Find(query);
  if (!this->Parts)
  {
    skd::Vector3 x;
    this->Points[block].Mesh->GetPoint(index, x.X);
    return SkdQueryShape::MakeBall(x, 0.0);
  }
  const auto part = static_cast<std::uint32_t>(block);
  const auto cell = static_cast<std::uint32_t>(index);
  const SkdCellTree& tree = this->Parts->GetTree(part);
  const SkdCellSource source = this->Parts->GetSource(part);
  std::shared_ptr<const SkdCellOutline> outline;
  if (this->WantsOutlines)
  {
    outline = std::make_shared<SkdCellOutline>(source.Load(tree.Cells().IdOf(cell)));
  }
  return SkdQueryShape::MakeCell(tree, cell, source, outline);
}

//------------------------------------------------------------------------------
vtkIdType SkdQueryList::GetId(vtkIdType query) const
{
  const auto [block, index] = this->Find(query);
  return this->Parts
    ? this->Joined[block].Of(this->Parts->GetTree(static_cast<std::uint32_t>(block))
                               .Cells()
                               .IdOf(static_cast<std::uint32_t>(index)))
    : index;
}

//------------------------------------------------------------------------------
int SkdQueryList::GetBlockIndex(vtkIdType query) const
{
  return this->BlockIndices[this->Find(query).first];
}
}
