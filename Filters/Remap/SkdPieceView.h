// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPieceView_h
#define SkdPieceView_h

#include "Core/Geometry/Overlap/LonLatCell.h"
#include "Core/Geometry/Overlap/PolygonOverlap.h"
#include "Core/Geometry/Overlap/SolidOverlap.h"
#include "Remap/SkdOverlapBlock.h"

namespace skdtree
{
/// A piece and its corners.
struct SkdPieceView
{
  const SkdOverlapPiece& Piece;
  const skd::Vector3* Corners;

  SkdPieceView(const SkdOverlapBlock& block, std::uint32_t number)
    : Piece(block.Pieces[number])
    , Corners(block.Corners.data() + block.Pieces[number].FirstCorner)
  {
  }

  skd::PolygonView AsPolygon() const { return { this->Corners, this->Piece.Size }; }
  skd::SolidView AsSolid() const { return { this->Corners, this->Piece.Topology }; }
  skd::LonLatCell AsLonLat() const
  {
    return { this->Corners[0][0], this->Corners[0][1], this->Corners[1][0], this->Corners[1][1] };
  }
};
}

#endif
