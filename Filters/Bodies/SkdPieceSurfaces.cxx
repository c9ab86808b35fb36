// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bodies/SkdPieceSurfaces.h"

#include "Bodies/SkdInnerFaces.h"
#include "Pipeline/SkdQueryPoints.h"
#include "Pipeline/SkdVolumeCells.h"
#include "vtkCellArray.h"
#include "vtkNew.h"

#include <algorithm>
#include <map>
#include <utility>

namespace skdtree
{
namespace
{
std::vector<skd::Vector3> PointsOf(const SkdBlockSurface& surface)
{
  std::vector<skd::Vector3> points(static_cast<std::size_t>(surface.Get()->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    surface.GetPoint(static_cast<vtkIdType>(i), points[i].X);
  }
  return points;
}

/// The surfaces of the pieces of one mesh, which take turns: each is given twice, in one order.
class Joint
{
public:
  explicit Joint(const std::vector<vtkDataSet*>& pieces)
    : Inner(pieces)
  {
  }

  void AddFaces(std::size_t piece, vtkDataSet* mesh, const SkdBlockSurface& surface);
  void FindInner();
  void LeaveOutInner(SkdPieceSurface& piece);

private:
  SkdInnerFaces Inner;
  std::vector<unsigned char> IsInner; // each face that was added
  std::vector<unsigned char> IsLeft;  // each point, that a face has which is not
  std::size_t Next = 0;
};

void Joint::AddFaces(std::size_t piece, vtkDataSet* mesh, const SkdBlockSurface& surface)
{
  const SkdQueryPoints middles(mesh, SkdQueryPoints::At::Middles);
  std::vector<skd::Vector3> points;
  surface.ForEachFace(
    [&](vtkIdType cell, vtkIdType size, const auto* corners)
    {
      if (surface.IsOfVolume(cell))
      {
        points.resize(static_cast<std::size_t>(size));
        for (std::size_t i = 0; i < points.size(); ++i)
        {
          surface.GetPoint(static_cast<vtkIdType>(corners[i]), points[i].X);
        }
        skd::Vector3 middle;
        middles.GetPoint(surface.GetCellId(cell), middle.X);
        this->Inner.Add(piece, points, middle);
      }
    });
}

void Joint::FindInner()
{
  this->IsInner = this->Inner.Find();
  this->IsLeft.assign(this->Inner.GetNumberOfPoints(), 0);
  for (std::size_t face = 0; face < this->IsInner.size(); ++face)
  {
    for (const vtkIdType corner : this->Inner.GetCorners(face))
    {
      this->IsLeft[static_cast<std::size_t>(corner)] |= this->IsInner[face] == 0 ? 1 : 0;
    }
  }
}

void Joint::LeaveOutInner(SkdPieceSurface& piece)
{
  std::vector<skd::Vector3> points = PointsOf(*piece.Faces);
  std::map<vtkIdType, vtkIdType> added; // points of smaller faces, by their numbers
  std::vector<vtkIdType> cells;
  vtkNew<vtkCellArray> polygons;
  std::vector<vtkIdType> ids;
  std::vector<vtkIdType> all;
  piece.Numbers.assign(points.size(), -1);
  const auto number = [&](std::size_t point, vtkIdType corner)
  {
    piece.Numbers[point] = corner;
    points[point] = this->Inner.GetPoint(corner);
  };
  const auto add = [&](const auto* given, std::size_t face)
  {
    const auto corners = this->Inner.GetCorners(face);
    this->Inner.FindAllCorners(face, this->IsLeft, all);
    ids.clear();
    std::size_t next = 0; // of the given corners
    for (const vtkIdType corner : all)
    {
      if (next < corners.size() && corners[next] == corner)
      {
        ids.push_back(static_cast<vtkIdType>(given[next++]));
        number(static_cast<std::size_t>(ids.back()), corner);
        continue;
      }
      const auto [known, isNew] = added.emplace(corner, static_cast<vtkIdType>(points.size()));
      ids.push_back(known->second);
      if (isNew)
      {
        points.emplace_back();
        piece.Numbers.push_back(-1);
        number(points.size() - 1, corner);
      }
    }
  };
  piece.Faces->ForEachFace(
    [&](vtkIdType cell, vtkIdType size, const auto* corners)
    {
      ids.assign(corners, corners + size);
      if (piece.Faces->IsOfVolume(cell))
      {
        const std::size_t face = this->Next++;
        if (this->IsInner[face] != 0)
        {
          return;
        }
        add(corners, face);
      }
      polygons->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
      cells.push_back(cell);
    });
  piece.NumberOfAll = this->Inner.GetNumberOfPoints();
  piece.Faces->SetFaces(cells, polygons, points);
}

bool HasFacesWithin(vtkDataSet* piece)
{
  const std::optional<SkdVoxelLattice> lattice = SkdVoxelLatticeOf(piece);
  return lattice && lattice->HasSeveralSizes();
}
}

//------------------------------------------------------------------------------
std::vector<std::vector<std::size_t>> SkdPiecesOfMeshes(const std::vector<SkdBlock>& blocks)
{
  std::map<int, std::vector<std::size_t>> pieces; // by the first
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    if (blocks[i].FirstPiece >= 0)
    {
      pieces[blocks[i].FirstPiece].push_back(i);
    }
  }
  std::vector<std::vector<std::size_t>> meshes;
  for (auto& [first, some] : pieces)
  {
    const auto hasNoVolume = [&](std::size_t i) { return !SkdHasVolumeCells(blocks[i].Mesh); };
    some.erase(std::remove_if(some.begin(), some.end(), hasNoVolume), some.end());
    if (some.size() > 1 || (some.size() == 1 && HasFacesWithin(blocks[some.front()].Mesh)))
    {
      meshes.push_back(std::move(some));
    }
  }
  return meshes;
}

//------------------------------------------------------------------------------
std::vector<SkdPieceSurface> SkdSurfacesOfPieces(
  const std::vector<SkdBlock>& blocks, double chordalLength)
{
  std::vector<SkdPieceSurface> surfaces(blocks.size());
  for (const std::vector<std::size_t>& mesh : SkdPiecesOfMeshes(blocks))
  {
    std::vector<vtkDataSet*> pieces;
    for (const std::size_t i : mesh)
    {
      pieces.push_back(blocks[i].Mesh);
    }
    Joint joint(pieces);
    for (std::size_t piece = 0; piece < mesh.size(); ++piece)
    {
      std::optional<SkdBlockSurface>& faces = surfaces[mesh[piece]].Faces;
      faces.emplace(pieces[piece], chordalLength);
      joint.AddFaces(piece, pieces[piece], *faces);
    }
    joint.FindInner();
    for (const std::size_t i : mesh)
    {
      joint.LeaveOutInner(surfaces[i]);
    }
  }
  return surfaces;
}
}
