// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdBlockPoints.h"

#include <algorithm>
#include <map>

namespace skdtree
{
SkdBlockPoints::SkdBlockPoints(const SkdReadMesh& read, const SkdReadMesh::Block& block)
  : Read(read)
  , Block(block)
  , OldPoints(static_cast<vtkIdType>(block.NodeOfPoint.size()))
  , IdOfNode(read.Mesh.NumberOfNodes(), Unknown)
{
  for (std::size_t i = 0; i < block.NodeOfPoint.size(); ++i)
  {
    vtkIdType& id = this->IdOfNode[block.NodeOfPoint[i]];
    id = id == Unknown ? static_cast<vtkIdType>(i) : Seam;
  }
}

vtkIdType SkdBlockPoints::IdOf(std::uint32_t node)
{
  if (this->IdOfNode[node] >= 0)
  {
    return this->IdOfNode[node];
  }
  if (node < this->Read.NumberOfPointNodes)
  {
    return *std::find_if(this->CellPoints->begin(), this->CellPoints->end(),
      [&](vtkIdType id) { return this->Block.NodeOfPoint[static_cast<std::size_t>(id)] == node; });
  }
  bool isOnSeam = false;
  std::vector<vtkIdType> makers;
  for (const std::uint32_t maker : this->Read.Mesh.MakersOf(node))
  {
    makers.push_back(this->IdOf(maker));
    isOnSeam = isOnSeam || this->IdOfNode[maker] == Seam;
  }
  // The middle of a cell of more corners is that cell's alone.
  if (isOnSeam && makers.size() <= 4)
  {
    this->IdOfNode[node] = Seam;
    return this->IdOnSeam(node, makers);
  }
  return this->IdOfNode[node] = this->AddPoint(node, makers);
}

vtkIdType SkdBlockPoints::IdOnSeam(std::uint32_t node, const std::vector<vtkIdType>& makers)
{
  constexpr std::uint32_t none = skd::RefinedMesh::None;
  skd::TupleNumbers<4>::Tuple tuple{ none, none, none, none };
  std::copy(makers.begin(), makers.end(), tuple.begin());
  const std::uint32_t number = this->Makers.FindOrAdd(tuple);
  if (number == this->IdOfMakers.size())
  {
    this->IdOfMakers.push_back(this->AddPoint(node, makers));
  }
  return this->IdOfMakers[number];
}

vtkIdType SkdBlockPoints::AddPoint(std::uint32_t node, const std::vector<vtkIdType>& makers)
{
  std::map<vtkIdType, double> weights;
  const double share = 1.0 / static_cast<double>(makers.size());
  for (const vtkIdType maker : makers)
  {
    if (maker < this->OldPoints)
    {
      weights[maker] += share;
      continue;
    }
    const Recipe& recipe = this->Recipes[static_cast<std::size_t>(maker - this->OldPoints)];
    for (std::size_t i = 0; i < recipe.Ids.size(); ++i)
    {
      weights[recipe.Ids[i]] += share * recipe.Weights[i];
    }
  }
  Recipe recipe;
  for (const auto& [id, weight] : weights)
  {
    recipe.Ids.push_back(id);
    recipe.Weights.push_back(weight);
  }
  this->NewNodes.push_back(node);
  this->Recipes.push_back(std::move(recipe));
  return this->GetNumberOfPoints() - 1;
}
}
