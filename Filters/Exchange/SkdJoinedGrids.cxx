// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdJoinedGrids.h"

#include "Exchange/SkdGridLattice.h"
#include "Exchange/SkdPieceArrays.h"
#include "Pipeline/SkdBlocks.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <array>

namespace skdtree
{
namespace
{
using Extent = std::array<int, 6>;
using Lattice = SkdGridLattice;

Extent UnionOf(const SkdPieces& pieces)
{
  Extent all = SkdExtentOf(pieces.front());
  for (vtkDataSet* piece : pieces)
  {
    SkdUniteExtents(all, SkdExtentOf(piece));
  }
  return all;
}

//------------------------------------------------------------------------------
/// Which piece each point or cell of the box is taken from.
class Assembly
{
public:
  Assembly(const SkdPieces& pieces, const Extent& box, int type)
    : Whole(box, type)
    , Tuples(pieces.size())
    , Origins(static_cast<std::size_t>(this->Whole.GetSize()), SkdPieceCell{ -1, -1 })
  {
    for (const bool areDuplicates : { false, true })
    {
      for (std::size_t piece = 0; piece < pieces.size(); ++piece)
      {
        this->Add(pieces[piece], static_cast<int>(piece), type, areDuplicates);
      }
    }
  }

  bool IsFull() const
  {
    return std::all_of(this->Origins.begin(), this->Origins.end(),
      [](const SkdPieceCell& origin) { return origin.Piece >= 0; });
  }

  vtkIdType GetSize() const { return this->Whole.GetSize(); }
  const std::vector<SkdPieceTuples>& GetTuples() const { return this->Tuples; }
  const std::vector<SkdPieceCell>& GetOrigins() const { return this->Origins; }

private:
  void Add(vtkDataSet* mesh, int piece, int type, bool areDuplicates)
  {
    const std::vector<unsigned char> ghosts = SkdIncompleteOf(mesh, type);
    const Lattice own(SkdExtentOf(mesh), type);
    vtkIdType from = 0;
    own.VisitAll(
      [&](const int(&ijk)[3])
      {
        const vtkIdType to = this->Whole.IdOf(ijk);
        SkdPieceCell& origin = this->Origins[static_cast<std::size_t>(to)];
        const bool isDuplicate = !ghosts.empty() && ghosts[static_cast<std::size_t>(from)];
        if (origin.Piece < 0 && isDuplicate == areDuplicates)
        {
          origin = { piece, from };
          this->Tuples[static_cast<std::size_t>(piece)].Add(from, to);
        }
        ++from;
      });
  }

  Lattice Whole;
  std::vector<SkdPieceTuples> Tuples;
  std::vector<SkdPieceCell> Origins;
};

//------------------------------------------------------------------------------
void SetGeometry(const SkdPieces& pieces, const Extent& box, const Assembly&, vtkImageData* image)
{
  auto* first = vtkImageData::SafeDownCast(pieces.front());
  Extent extent = box;
  image->SetExtent(extent.data());
  image->SetOrigin(first->GetOrigin());
  image->SetSpacing(first->GetSpacing());
  image->SetDirectionMatrix(first->GetDirectionMatrix());
}

void SetGeometry(
  const SkdPieces& pieces, const Extent& box, const Assembly& points, vtkStructuredGrid* grid)
{
  Extent extent = box;
  grid->SetExtent(extent.data());
  grid->SetPoints(SkdJoinPoints(pieces, points.GetTuples(), points.GetSize()));
}

vtkDataArray* CoordinatesOf(vtkRectilinearGrid* grid, int axis)
{
  return axis == 0 ? grid->GetXCoordinates()
    : axis == 1    ? grid->GetYCoordinates()
                   : grid->GetZCoordinates();
}

void SetGeometry(
  const SkdPieces& pieces, const Extent& box, const Assembly&, vtkRectilinearGrid* grid)
{
  Extent extent = box;
  grid->SetExtent(extent.data());
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkDataArray* like = CoordinatesOf(vtkRectilinearGrid::SafeDownCast(pieces.front()), axis);
    const auto joined = vtkSmartPointer<vtkDataArray>::Take(like->NewInstance());
    joined->SetNumberOfTuples(box[2 * axis + 1] - box[2 * axis] + 1);
    for (vtkDataSet* piece : pieces)
    {
      vtkDataArray* own = CoordinatesOf(vtkRectilinearGrid::SafeDownCast(piece), axis);
      joined->InsertTuples(
        SkdExtentOf(piece)[2 * axis] - box[2 * axis], own->GetNumberOfTuples(), 0, own);
    }
    axis == 0     ? grid->SetXCoordinates(joined)
      : axis == 1 ? grid->SetYCoordinates(joined)
                  : grid->SetZCoordinates(joined);
  }
}

template <class Grid>
void SetGeometryIf(
  const SkdPieces& pieces, const Extent& box, const Assembly& points, vtkDataSet* mesh)
{
  if (Grid* grid = Grid::SafeDownCast(mesh))
  {
    SetGeometry(pieces, box, points, grid);
  }
}

bool AreOfOneGrid(const SkdPieces& pieces)
{
  vtkDataSet* first = pieces.front();
  return SkdIsStructured(first) &&
    std::all_of(pieces.begin(), pieces.end(),
      [first](vtkDataSet* piece)
      {
        return piece->GetDataObjectType() == first->GetDataObjectType() &&
          SkdLatticeOfImage(piece) == SkdLatticeOfImage(first);
      });
}
}

bool SkdJoinGrids(const std::vector<vtkSmartPointer<vtkDataSet>>& pieces, SkdJoinedPieces& joined)
{
  if (!AreOfOneGrid(pieces))
  {
    return false;
  }
  const Extent box = UnionOf(pieces);
  const Assembly points(pieces, box, vtkDataObject::POINT);
  const Assembly cells(pieces, box, vtkDataObject::CELL);
  if (!points.IsFull() || !cells.IsFull())
  {
    return false;
  }
  const auto mesh = vtkSmartPointer<vtkDataSet>::Take(pieces.front()->NewInstance());
  SetGeometryIf<vtkImageData>(pieces, box, points, mesh);
  SetGeometryIf<vtkRectilinearGrid>(pieces, box, points, mesh);
  SetGeometryIf<vtkStructuredGrid>(pieces, box, points, mesh);
  SkdJoinArrays(
    pieces, points.GetTuples(), vtkDataObject::POINT, points.GetSize(), mesh->GetPointData());
  SkdJoinArrays(
    pieces, cells.GetTuples(), vtkDataObject::CELL, cells.GetSize(), mesh->GetCellData());
  joined.Mesh = mesh;
  joined.Origins = cells.GetOrigins();
  return true;
}
}
