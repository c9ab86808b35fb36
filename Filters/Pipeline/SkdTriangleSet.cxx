// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdTriangleSet.h"

#include "Pipeline/SkdLeafSurface.h"
#include "Pipeline/SkdTriangulation.h"
#include "Pipeline/SkdWeld.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

/// The faces of all leaves before they are cut.
class SkdTriangleSet::Faces
{
public:
  explicit Faces(const std::vector<SkdLeaf>& leaves)
  {
    for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf)
    {
      this->AddLeaf(static_cast<int>(leaf), leaves[leaf].Mesh);
    }
    const auto isBefore = [](const Face& a, const Face& b) { return a.Origin < b.Origin; };
    if (!std::is_sorted(this->List.begin(), this->List.end(), isBefore))
    {
      std::stable_sort(this->List.begin(), this->List.end(), isBefore);
    }
  }

  SkdWeld Weld;
  std::vector<Origin> Origins;
  std::vector<Face> List;
  std::vector<vtkIdType> Corners;
  vtkIdType LeftOut = 0;

private:
  static constexpr vtkIdType Unknown = -2;

  void AddLeaf(int leaf, vtkDataSet* mesh)
  {
    const SkdLeafSurface surface(mesh);
    std::vector<vtkIdType> ids(surface.Get()->GetNumberOfPoints(), Unknown);
    const auto idOf = [&](vtkIdType corner)
    {
      vtkIdType& id = ids[corner];
      id = id == Unknown ? this->FindId(leaf, surface, corner) : id;
      return id;
    };
    surface.ForEachFace(
      [&](vtkIdType cell, vtkIdType size, const vtkIdType* corners)
      {
        const std::size_t first = this->Corners.size();
        const int rest = SkdAppendCorners(size, corners, idOf, this->Corners);
        if (rest > 0)
        {
          this->List.push_back({ { leaf, surface.GetCellId(cell) }, first, rest });
        }
        this->LeftOut += rest == 0;
      });
  }

  vtkIdType FindId(int leaf, const SkdLeafSurface& surface, vtkIdType corner)
  {
    double x[3];
    surface.GetPoint(corner, x);
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
    {
      return -1;
    }
    const vtkIdType id = this->Weld.GetId(x);
    this->Origins.push_back({ static_cast<std::uint32_t>(id), leaf, surface.GetPointId(corner) });
    return id;
  }
};

bool SkdTriangleSet::Update(const std::vector<SkdLeaf>& leaves)
{
  const bool isSame = this->IsBuilt &&
    std::equal(this->Meshes.begin(), this->Meshes.end(), leaves.begin(), leaves.end(),
      [](const SkdKeptMesh& kept, const SkdLeaf& leaf) { return kept.IsSameAs(leaf.Mesh); });
  if (!isSame)
  {
    this->Build(leaves);
    this->BuildTree();
    this->IsBuilt = true;
  }
  return !isSame;
}

void SkdTriangleSet::Build(const std::vector<SkdLeaf>& leaves)
{
  *this = SkdTriangleSet();
  this->Meshes.resize(leaves.size());
  std::vector<SkdLeaf> structures = leaves;
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    this->Meshes[i].Keep(leaves[i].Mesh);
    structures[i].Mesh = this->Meshes[i].Get();
  }
  Faces faces(structures);
  this->Origins = std::move(faces.Origins);
  this->LeftOut = faces.LeftOut;
  this->TakePoints(faces.Weld.GetPoints());
  SkdTriangulation triangulation(faces.Weld.GetPoints());
  this->Triangles.reserve(faces.List.size());
  this->CellOf.reserve(faces.List.size());
  for (const Face& face : faces.List)
  {
    if (this->Cells.empty() || this->Cells.back() < face.Origin)
    {
      this->Cells.push_back(face.Origin);
    }
    const vtkIdType* corners = faces.Corners.data() + face.First;
    if (face.Size == 3)
    {
      this->AddTriangle(corners);
      continue;
    }
    vtkIdList* cut = triangulation.Cut(corners, face.Size);
    for (vtkIdType i = 0; i < cut->GetNumberOfIds(); i += 3)
    {
      this->AddTriangle(cut->GetPointer(i));
    }
  }
}

void SkdTriangleSet::AddTriangle(const vtkIdType* corners)
{
  this->Triangles.push_back({ static_cast<std::uint32_t>(corners[0]),
    static_cast<std::uint32_t>(corners[1]), static_cast<std::uint32_t>(corners[2]) });
  this->CellOf.push_back(static_cast<std::uint32_t>(this->Cells.size() - 1));
}

std::vector<SkdTriangleSet::Origin> SkdTriangleSet::FindOrigins() const
{
  std::vector<Origin> origins = this->Origins;
  vtkSMPTools::Sort(origins.begin(), origins.end());
  return origins;
}

void SkdTriangleSet::TakePoints(vtkPoints* points)
{
  this->Points.resize(points->GetNumberOfPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->GetPoint(i, this->Points[i].X);
    for (const double coordinate : this->Points[i].X)
    {
      this->Reach = std::max(this->Reach, std::abs(coordinate));
    }
  }
}

void SkdTriangleSet::BuildTree()
{
  std::vector<skd::Box3> boxes;
  boxes.reserve(this->Triangles.size());
  for (const Corners& triangle : this->Triangles)
  {
    skd::Box3 box;
    for (const std::uint32_t corner : triangle)
    {
      box.Add(this->Points[corner]);
    }
    boxes.push_back(box);
  }
  this->Tree = skd::LazyTree<3>(skd::MakeTreeInput(boxes, 0.0));
}
