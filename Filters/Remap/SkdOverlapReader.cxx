// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdOverlapReader.h"

#include <algorithm>
#include <map>

namespace
{
using skd::Vector3;
using Faces = std::vector<std::vector<int>>;

/// Turns triangles so that neighbours go along their edge in opposite directions.
void TurnAlike(Faces& triangles)
{
  std::map<std::pair<int, int>, std::vector<std::size_t>> users;
  const auto edgeOf = [&](std::size_t i, int k)
  { return std::make_pair(triangles[i][k], triangles[i][(k + 1) % 3]); };
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto edge = edgeOf(i, k);
      users[std::minmax(edge.first, edge.second)].push_back(i);
    }
  }
  std::vector<bool> isDone(triangles.size());
  for (std::size_t first = 0; first < triangles.size(); ++first)
  {
    std::vector<std::size_t> open{ first };
    isDone[first] = true;
    while (!open.empty())
    {
      const std::size_t at = open.back();
      open.pop_back();
      for (int k = 0; k < 3; ++k)
      {
        const auto edge = edgeOf(at, k);
        for (const std::size_t other : users[std::minmax(edge.first, edge.second)])
        {
          if (isDone[other])
          {
            continue;
          }
          for (int m = 0; m < 3; ++m)
          {
            if (edgeOf(other, m) == edge)
            {
              std::swap(triangles[other][0], triangles[other][1]);
              break;
            }
          }
          isDone[other] = true;
          open.push_back(other);
        }
      }
    }
  }
}
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
  this->Seen.clear();
  for (std::uint32_t i = 0; i < store.SizeOf(cell); ++i)
  {
    this->Seen.push_back(
      { this->Ground.Seen(store.Point(ids[i])), static_cast<vtkIdType>(ids[i]) });
  }
}

//------------------------------------------------------------------------------
void SkdOverlapReader::Read(std::uint32_t cell)
{
  const SkdShape shape = this->Tree.Cells().ShapeOf(cell);
  const SkdOverlapSpace space = this->Ground.GetSpace();
  const bool isSurface = space == SkdOverlapSpace::Plane || space == SkdOverlapSpace::Sphere;
  this->Gather(cell);
  switch (shape)
  {
    case SkdShape::Line:
    case SkdShape::PolyLine:
      for (std::size_t i = 1; i < this->Seen.size() && space == SkdOverlapSpace::Line; ++i)
      {
        this->AddSegment(this->Seen[i - 1], this->Seen[i]);
      }
      return;
    case SkdShape::Pixel:
      std::swap(this->Seen[2], this->Seen[3]);
      [[fallthrough]];
    case SkdShape::Triangle:
    case SkdShape::Quad:
    case SkdShape::Polygon:
      if (isSurface)
      {
        this->AddPolygon(this->Seen);
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
    case SkdShape::Generic:
      this->ReadSimplices(cell);
      return;
    default:
      return;
  }
}

//------------------------------------------------------------------------------
void SkdOverlapReader::ReadSimplices(std::uint32_t cell)
{
  this->Tree.GetSimplices(cell, this->Source, this->Simplices);
  const skd::SimplexSet& set = this->Simplices;
  const int wanted = this->Ground.GetSpace() == SkdOverlapSpace::Volume ? 3
    : this->Ground.GetSpace() == SkdOverlapSpace::Line                  ? 1
                                                                        : 2;
  if (set.Dimension != wanted)
  {
    return;
  }
  this->Seen.clear();
  for (const Vector3& x : set.Points)
  {
    this->Seen.push_back({ this->Ground.Seen(x), -1 });
  }
  if (wanted == 3)
  {
    Faces faces;
    for (const auto& simplex : set.Simplices)
    {
      faces.push_back({ simplex[0], simplex[1], simplex[2] });
    }
    TurnAlike(faces);
    this->AddHull(std::move(faces));
    return;
  }
  for (const auto& simplex : set.Simplices)
  {
    Corners corners{ this->Seen[simplex[0]], this->Seen[simplex[1]], this->Seen[simplex[2]] };
    if (wanted == 1)
    {
      this->AddSegment(corners[0], corners[1]);
    }
    else
    {
      this->AddPolygon(corners);
    }
  }
}
