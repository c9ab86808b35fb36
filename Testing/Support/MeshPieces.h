// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshPieces_h
#define MeshPieces_h

#include "Support/FilterRun.h"
#include "Support/StructuredMeshes.h"
#include "Support/SurfaceMeshes.h"
#include "Support/VolumeMeshes.h"

#include "vtkExtentTranslator.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace skdtest
{

using Pieces = std::vector<vtkSmartPointer<vtkDataSet>>;

/// The cells of a mesh with the points that they use.
inline Mesh Compact(const Mesh& mesh)
{
  Mesh compact;
  std::map<vtkIdType, vtkIdType> known;
  const auto idOf = [&](vtkIdType& id)
  {
    const auto found = known.find(id);
    id = found != known.end()
      ? found->second
      : (known[id] = compact.Add(mesh.Points[static_cast<std::size_t>(id)]));
  };
  for (CellSpec cell : mesh.Cells)
  {
    if (cell.Type == VTK_POLYHEDRON)
    {
      for (std::size_t at = 1; at < cell.Points.size(); at += 1 + cell.Points[at])
      {
        std::for_each(&cell.Points[at] + 1, &cell.Points[at] + 1 + cell.Points[at], idOf);
      }
    }
    else
    {
      std::for_each(cell.Points.begin(), cell.Points.end(), idOf);
    }
    compact.Add(cell.Type, cell.Points);
  }
  return compact;
}

/// Cells numbered by their positions, so that the number is the same in every piece.
template <class Pointer>
Pointer WithValues(Pointer mesh)
{
  AddLinear(mesh, "Linear");
  const auto bounds = [&](vtkIdType i)
  {
    double box[6];
    mesh->GetCellBounds(i, box);
    return box[0] + 10.0 * box[2] + 100.0 * box[4];
  };
  mesh->GetCellData()->AddArray(MakeArray("Place", mesh->GetNumberOfCells(), bounds));
  return mesh;
}

/// A mesh to be divided into pieces.
struct PieceCase
{
  std::string Name;
  Mesh Whole;
  bool IsSurface;

  vtkSmartPointer<vtkDataSet> Make(const Mesh& mesh) const
  {
    return this->IsSurface ? vtkSmartPointer<vtkDataSet>(WithValues(MakePolyData(mesh)))
                           : vtkSmartPointer<vtkDataSet>(WithValues(MakeGrid(mesh)));
  }
};

inline std::vector<PieceCase> PieceCases()
{
  return {
    { "Hexahedra", Hexahedra(3), false },
    { "Mixed", MixedCells(2), false },
    { "Polyhedra", Polyhedra(2), false },
    { "Triangles", SphereTriangles(4), true },
    { "Kinds",
      Together({ Strips(3), Helix(9, VTK_POLY_LINE), SphereQuads(3), Cloud(5, VTK_VERTEX) }),
      true },
  };
}

/// Each cell on one of some processes at random.
inline std::vector<int> RandomOwners(const Mesh& mesh, int processes, int seed)
{
  Random random(seed);
  std::vector<int> owners(mesh.Cells.size());
  for (int& owner : owners)
  {
    owner = random.Index(processes);
  }
  return owners;
}

template <class Grid>
vtkSmartPointer<vtkDataSet> Cropped(vtkSmartPointer<Grid> grid, int* extent)
{
  auto piece = vtkSmartPointer<Grid>::New();
  piece->ShallowCopy(grid);
  piece->Crop(extent);
  return piece;
}

/// Three pieces of a structured grid, not in order, with layers of ghosts that are not marked.
template <class Grid>
Pieces PiecesOfGrid(vtkSmartPointer<Grid> grid, int ghosts)
{
  vtkNew<vtkExtentTranslator> translator;
  translator->SetWholeExtent(grid->GetExtent());
  translator->SetNumberOfPieces(3);
  translator->SetGhostLevel(ghosts);
  Pieces pieces;
  for (int piece : { 2, 0, 1 })
  {
    translator->SetPiece(piece);
    translator->PieceToExtent();
    pieces.push_back(Cropped(grid, translator->GetExtent()));
  }
  return pieces;
}

}

#endif
