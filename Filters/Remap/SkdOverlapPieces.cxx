// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdOverlapPieces.h"

#include "Core/Geometry/Overlap/LonLatCell.h"
#include "Pipeline/SkdLoop.h"
#include "Remap/SkdDonorFields.h"
#include "Remap/SkdFacetOverlap.h"
#include "Remap/SkdOverlapReader.h"
#include "Remap/SkdRemapTolerances.h"

#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"

#include <algorithm>

namespace skdtree
{
namespace
{
/// Between two reports of progress; each is of 1024 cells.
constexpr vtkIdType FewestBlocks = 8;

/// Adds the box of a piece's corners, and what of the piece lies outside of it.
/// On the unit sphere a point p of the piece is q / |q|, q in the corners' convex hull. All corners
/// are within Reach = 2 sin(a / 2) of the reference r, so q.r >= cos(a), and p is no farther from q
/// than 1 - |q| <= 1 - cos(a) = Reach^2 / 2.
/// Of a curved surface it is as far as the other surface may be.
void AddBounds(const SkdOverlapBlock& block, const SkdOverlapPiece& piece,
  const SkdOverlapSurface& surface, skd::Box3& box)
{
  const bool isSphere = surface.GetSpace() == SkdOverlapSpace::Sphere;
  const skd::Vector3* corners = block.Corners.data() + piece.FirstCorner;
  if (piece.IsLonLat)
  {
    const skd::LonLatCell cell{ corners[0][0], corners[0][1], corners[1][0], corners[1][1] };
    box.Add(cell.Bounds().Inflated(remap_tolerances::LonLatBox));
    return;
  }
  skd::Box3 own;
  for (int i = 0; i < piece.Size; ++i)
  {
    own.Add(corners[i]);
  }
  const bool isCurved = surface.GetSpace() == SkdOverlapSpace::CurvedSurface;
  const double room = isCurved ? surface.GetFacetRules().DistanceFor(piece.Radius, piece.Radius)
                               : 0.5 * piece.Radius * piece.Radius;
  box.Add(isSphere || isCurved ? own.Inflated(room) : own);
}

vtkIdType CountGhosts(vtkDataSet* data)
{
  const std::vector<unsigned char> counts = SkdFindCounts(data, vtkDataObject::CELL, {});
  return std::count(counts.begin(), counts.end(), 0);
}
}

//------------------------------------------------------------------------------
// The tree is bare: no search, only which cells count, their ids and readers by type. Cells are
// read in blocks, whose lists no other thread touches.
bool SkdOverlapPieces::Read(vtkDataSet* data, const SkdOverlapSurface& surface,
  const SkdOverlapReading& reading, SkdLoop& loop)
{
  SkdTreeSettings settings;
  settings.IsBare = true;
  settings.SkipsGhosts = reading.SkipsGhosts;
  const SkdCellTree tree(data, settings);
  const std::uint32_t count = tree.Cells().NumberOfCells();
  this->NumberOfAllCells = data->GetNumberOfCells();
  this->NumberOfGhosts = reading.SkipsGhosts ? CountGhosts(data) : 0;
  this->Ids.resize(count);
  this->Bounds.resize(count);
  this->Blocks.resize((count + BlockSize - 1) / BlockSize);
  const auto blocks = static_cast<vtkIdType>(this->Blocks.size());
  loop.SetTotal(blocks);
  const bool isDone = loop.For(blocks,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkNew<vtkGenericCell> scratch;
      for (vtkIdType i = begin; i < end; ++i)
      {
        this->ReadBlock(
          static_cast<std::uint32_t>(i), { tree, { data, scratch }, surface, reading });
      }
    });
  if (isDone)
  {
    this->FindFaults();
  }
  return isDone;
}

//------------------------------------------------------------------------------
// The pieces of cell i of the block, which its reader appends, are FirstPiece[i] ..
// FirstPiece[i+1]; so are the points of its own.
void SkdOverlapPieces::ReadBlock(std::uint32_t number, const ReadFrom& from)
{
  SkdOverlapBlock& block = this->Blocks[number];
  SkdOverlapReader reader(from.Tree, from.Source, from.Surface, from.Reading, block);
  const std::uint32_t last = std::min(this->GetNumberOfCells(), (number + 1) * BlockSize);
  block.FirstPiece.push_back(0);
  block.FirstOwnPoint.push_back(0);
  for (std::uint32_t cell = number * BlockSize; cell < last; ++cell)
  {
    reader.Read(cell);
    this->Ids[cell] = from.Tree.Cells().IdOf(cell);
    for (std::size_t i = block.FirstPiece.back(); i < block.Pieces.size(); ++i)
    {
      AddBounds(block, block.Pieces[i], from.Surface, this->Bounds[cell]);
    }
    block.FirstPiece.push_back(static_cast<std::uint32_t>(block.Pieces.size()));
    block.FirstOwnPoint.push_back(block.OwnPoints.size());
  }
}

//------------------------------------------------------------------------------
// A mesh is ordered one way, seen from outside the sphere counter-clockwise if there is no telling:
// a large cell that is ordered the other way round is what is left of the sphere. Of small cells
// that would be nearly all of it.
void SkdOverlapPieces::FindFaults()
{
  const auto markOf = [&](std::uint32_t cell)
  { return this->BlockOf(cell).Marks[cell % BlockSize]; };
  vtkIdType reversals = 0;
  for (std::uint32_t cell = 0; cell < this->GetNumberOfCells(); ++cell)
  {
    reversals += markOf(cell).Orientation;
  }
  const int unusual = reversals < -1 ? 1 : -1;
  for (std::uint32_t cell = 0; cell < this->GetNumberOfCells(); ++cell)
  {
    const SkdPolygonMark mark = markOf(cell);
    if (mark.CrossesItself)
    {
      this->Crossing.push_back(this->IdOf(cell));
    }
    if (mark.IsLarge && mark.Orientation == unusual)
    {
      this->TooLarge.push_back(this->IdOf(cell));
      this->Bounds[cell] = {};
      const Range range = this->PiecesOf(cell);
      for (std::uint32_t i = range.First; i < range.Last; ++i)
      {
        this->Blocks[cell / BlockSize].Pieces[i].Own = {};
      }
    }
  }
}

//------------------------------------------------------------------------------
skd::Moments SkdOverlapPieces::MomentsOf(std::uint32_t cell, const skd::Vector3& reference) const
{
  skd::Moments sum;
  const Range range = this->PiecesOf(cell);
  const std::vector<SkdOverlapPiece>& pieces = this->BlockOf(cell).Pieces;
  for (std::uint32_t i = range.First; i < range.Last; ++i)
  {
    sum.Add(pieces[i].Own.Moved(reference - pieces[i].Reference), pieces[i].Sign);
  }
  return sum;
}

//------------------------------------------------------------------------------
skd::Vector3 SkdOverlapPieces::NormalOf(std::uint32_t cell) const
{
  skd::Vector3 sum{ { 0.0, 0.0, 0.0 } };
  const Range range = this->PiecesOf(cell);
  for (std::uint32_t i = range.First; i < range.Last; ++i)
  {
    const SkdPieceView piece(this->BlockOf(cell), i);
    sum = sum + static_cast<double>(piece.Piece.Sign) * SkdAreaVectorOf(piece);
  }
  return (1.0 / Norm(sum)) * sum;
}

//------------------------------------------------------------------------------
void SkdOverlapPieces::Measure(const SkdOverlapSurface& surface, SkdOverlapCells& cells)
{
  const auto number = static_cast<std::size_t>(this->NumberOfAllCells);
  cells.Measures.assign(number, 0.0);
  cells.Centroids.assign(number, { { 0.0, 0.0, 0.0 } });
  cells.Covered.assign(number, 0.0);
  cells.LeftOut = this->NumberOfAllCells - this->NumberOfGhosts;
  const bool isCurved = surface.GetSpace() == SkdOverlapSpace::CurvedSurface;
  cells.Normals.assign(isCurved ? number : 0, { { 0.0, 0.0, 0.0 } });
  this->Measures.assign(this->Ids.size(), 0.0);
  this->Centres.assign(this->Ids.size(), { { 0.0, 0.0, 0.0 } });
  for (std::uint32_t cell = 0; cell < this->GetNumberOfCells(); ++cell)
  {
    const Range range = this->PiecesOf(cell);
    if (range.First == range.Last)
    {
      continue;
    }
    const skd::Vector3& reference = this->BlockOf(cell).Pieces[range.First].Reference;
    const skd::Moments moments = this->MomentsOf(cell, reference);
    if (moments.Measure > 0.0)
    {
      const auto id = static_cast<std::size_t>(this->Ids[cell]);
      this->Measures[cell] = moments.Measure;
      this->Centres[cell] = reference + (1.0 / moments.Measure) * moments.First;
      cells.Measures[id] = surface.Measure(moments.Measure);
      cells.Centroids[id] = surface.Unproject(this->Centres[cell]);
      if (isCurved)
      {
        cells.Normals[id] = this->NormalOf(cell);
      }
      --cells.LeftOut;
    }
  }
  cells.LeftOut -= static_cast<vtkIdType>(this->TooLarge.size());
  cells.LeftOut -= std::count_if(this->Crossing.begin(), this->Crossing.end(),
    [&](vtkIdType id) { return cells.Measures[static_cast<std::size_t>(id)] == 0.0; });
  cells.TooLarge = this->TooLarge;
  cells.Crossing = this->Crossing;
}

//------------------------------------------------------------------------------
bool SkdOverlapPair::Read(vtkDataSet* donor, vtkDataSet* target, const SkdOverlapSurface& surface,
  const SkdOverlapSettings& settings, bool intoSimplices, vtkAlgorithm* algorithm, double first,
  double last)
{
  const double middle = 0.5 * (first + last);
  SkdLoop ofDonor(algorithm, 0, first, middle, FewestBlocks);
  SkdLoop ofTarget(algorithm, 0, middle, last, FewestBlocks);
  const SkdOverlapReading donorAs{ settings.DonorIsLonLat && !intoSimplices, settings.SkipsGhosts,
    intoSimplices };
  const SkdOverlapReading targetAs{ settings.TargetIsLonLat, settings.SkipsGhosts, false };
  return surface.GetProblem().empty() && this->Donor.Read(donor, surface, donorAs, ofDonor) &&
    this->Target.Read(target, surface, targetAs, ofTarget);
}
}
