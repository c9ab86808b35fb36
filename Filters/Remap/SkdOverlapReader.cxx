// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdOverlapReader.h"

#include <algorithm>
#include <iterator>

namespace skdtree
{
namespace
{
using skd::Vector3;
}

//------------------------------------------------------------------------------
SkdOverlapPiece& SkdOverlapReader::Add(const Corner* corners, std::size_t size)
{
  SkdOverlapBlock& block = this->Block;
  block.Pieces.push_back({ static_cast<std::uint32_t>(block.Corners.size()),
    static_cast<std::uint16_t>(size), 1, false, nullptr, {}, 0.0, {} });
  for (std::size_t i = 0; i < size; ++i)
  {
    block.Corners.push_back(corners[i].X);
    if (this->Reading.IntoSimplices)
    {
      block.PointIds.push_back(corners[i].Id);
    }
  }
  return block.Pieces.back();
}

//------------------------------------------------------------------------------
void SkdOverlapReader::Gather(std::uint32_t cell)
{
  const SkdCellStore& store = this->Tree.Cells();
  const std::uint32_t* ids = store.PointIdsOf(cell);
  this->CellPoints.clear();
  for (std::uint32_t i = 0; i < store.SizeOf(cell); ++i)
  {
    this->CellPoints.push_back(
      { this->Surface.Project(store.Point(ids[i])), static_cast<vtkIdType>(ids[i]) });
  }
}

//------------------------------------------------------------------------------
void SkdOverlapReader::Read(std::uint32_t cell)
{
  this->Mark = {};
  this->AddPieces(cell);
  this->Block.Marks.push_back(this->Mark);
}

void SkdOverlapReader::AddPieces(std::uint32_t cell)
{
  const SkdShape shape = this->Tree.Cells().ShapeOf(cell);
  const SkdOverlapSpace space = this->Surface.GetSpace();
  const bool isSurface = SkdHasPolygons(space);
  this->Gather(cell);
  switch (shape)
  {
    case SkdShape::Line:
    case SkdShape::PolyLine:
      for (std::size_t i = 1; i < this->CellPoints.size() && space == SkdOverlapSpace::Line; ++i)
      {
        this->AddSegment(this->CellPoints[i - 1], this->CellPoints[i]);
      }
      return;
    case SkdShape::Pixel:
      std::swap(this->CellPoints[2], this->CellPoints[3]);
      [[fallthrough]];
    case SkdShape::Triangle:
    case SkdShape::Quad:
    case SkdShape::Polygon:
      if (isSurface)
      {
        this->AddWholePolygon();
      }
      return;
    case SkdShape::Tetrahedron:
    case SkdShape::Voxel:
    case SkdShape::Hexahedron:
    case SkdShape::Wedge:
    case SkdShape::Pyramid:
      if (space == SkdOverlapSpace::Volume)
      {
        this->AddFixed(shape);
      }
      return;
    case SkdShape::Polyhedron:
      if (space == SkdOverlapSpace::Volume)
      {
        this->AddPolyhedron(this->Tree.Cells().GatherPoly(cell));
      }
      return;
    case SkdShape::Strip:
      this->ReadSimplices(cell);
      return;
    case SkdShape::Generic:
      this->ReadGeneric(cell);
      return;
    default:
      return;
  }
}

//------------------------------------------------------------------------------
// Of strips: the set has the cell's points in their order.
void SkdOverlapReader::ReadSimplices(std::uint32_t cell)
{
  const SkdOverlapSpace space = this->Surface.GetSpace();
  if (SkdHasPolygons(space))
  {
    this->Tree.GetSimplices(cell, this->Source, this->Simplices);
    this->AddSimplices();
  }
}

// Of the points that were read.
void SkdOverlapReader::AddSimplices()
{
  const skd::SimplexSet& set = this->Simplices;
  for (const auto& simplex : set.Simplices)
  {
    Corners corners{ this->CellPoints[simplex[0]], this->CellPoints[simplex[1]],
      this->CellPoints[simplex[2]] };
    if (set.Dimension == 1)
    {
      this->AddSegment(corners[0], corners[1]);
    }
    else if (set.Dimension == 2)
    {
      this->AddPolygon(corners);
    }
  }
}

//------------------------------------------------------------------------------
std::size_t SkdOverlapReader::NumberOfOwnPoints() const
{
  return this->Block.OwnPoints.size() - this->Block.FirstOwnPoint.back();
}

vtkIdType SkdOverlapReader::AddWeights(const double* weights)
{
  std::vector<double>& all = this->Block.Weights;
  const auto first = static_cast<vtkIdType>(all.size());
  all.insert(all.end(), weights, weights + this->NumberOfOwnPoints());
  return -1 - first;
}

// The points read are the cell's own.
void SkdOverlapReader::TakeOwnPoints()
{
  if (this->NumberOfOwnPoints() == 0)
  {
    std::transform(this->CellPoints.begin(), this->CellPoints.end(),
      std::back_inserter(this->Block.OwnPoints), [](const Corner& corner) { return corner.Id; });
  }
}

vtkIdType SkdOverlapReader::AddMeanOf(const Corners& corners)
{
  this->TakeOwnPoints();
  const auto first =
    this->Block.OwnPoints.begin() + static_cast<std::ptrdiff_t>(this->Block.FirstOwnPoint.back());
  std::vector<double> weights(this->NumberOfOwnPoints(), 0.0);
  const double share = 1.0 / static_cast<double>(corners.size());
  for (const Corner& corner : corners)
  {
    if (corner.Id >= 0)
    {
      const auto at = std::find(first, this->Block.OwnPoints.end(), corner.Id);
      weights[static_cast<std::size_t>(at - first)] += share;
      continue;
    }
    const double* of = this->WeightsOf(corner);
    std::transform(weights.begin(), weights.end(), of, weights.begin(),
      [share](double sum, double weight) { return sum + share * weight; });
  }
  return this->AddWeights(weights.data());
}
}
