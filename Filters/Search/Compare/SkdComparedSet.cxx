// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Compare/SkdComparedSet.h"

#include "Bodies/SkdPieceSurfaces.h"
#include "Cells/Read/SkdMagnitudes.h"
#include "Core/Geometry/Distance/ClosestPointOnTriangle.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdMakeMesh.h"
#include "Pipeline/SkdShownElements.h"

#include <algorithm>
#include <limits>

namespace skdtree
{
namespace
{
bool IsUsable(const skd::Vector3& x)
{
  return SkdIsWithin(x, SkdMeasurable.Largest);
}
}

void SkdComparedSet::Update(const std::vector<SkdBlock>& blocks, bool wantsSide, double epsilon,
  double chordalDeviation, const SkdReduction& all)
{
  this->Release();
  this->CoarseFaces = 0;
  this->ChordalLength = SkdChordalLength(blocks, chordalDeviation);
  SkdVisitSurfaces(blocks, this->ChordalLength,
    [&](int block, const SkdBlockSurface& surface)
    { this->AddFaces(block, blocks[static_cast<std::size_t>(block)].Mesh, surface); });
  this->Surface = !this->Elements.empty();
  for (std::size_t block = 0; block < blocks.size() && !this->Surface; ++block)
  {
    this->AddPoints(static_cast<int>(block), blocks[block].Mesh);
  }
  this->FindOwn(blocks, all);
  this->TreesBuilt = this->Trees.Update({ { this->MakeMesh(), 0 } }, epsilon);
  if (wantsSide && this->Surface)
  {
    this->TreesBuilt += this->Side.Update(SkdBlocksWithCells(blocks), epsilon, chordalDeviation);
    this->Sided = this->Side.GetNumberOfFaces() > 0;
  }
  else
  {
    this->Side.Clear();
  }
}

void SkdComparedSet::AddFaces(int block, vtkDataSet* mesh, const SkdBlockSurface& surface)
{
  this->CoarseFaces += surface.GetNumberOfCoarseFaces();
  const auto first = static_cast<vtkIdType>(this->Points.size());
  const vtkIdType number = surface.Get()->GetNumberOfPoints();
  const std::size_t facesBefore = this->Elements.size();
  this->Points.resize(this->Points.size() + static_cast<std::size_t>(number));
  for (vtkIdType i = 0; i < number; ++i)
  {
    surface.GetPoint(i, this->Points[first + i].X);
  }
  FaceBuffers buffers;
  const SkdJoinedIds joined(mesh);
  surface.ForEachFace(
    [&](vtkIdType cell, vtkIdType size, const auto* corners) {
      this->AddFace(buffers, { block, joined.Of(surface.GetCellId(cell)) }, first, size, corners);
    });
  if (this->Elements.size() == facesBefore)
  {
    this->Points.resize(static_cast<std::size_t>(first)); // of lines and vertices
  }
}

template <class Corner>
void SkdComparedSet::AddFace(FaceBuffers& buffers, const Origin& origin, vtkIdType first,
  vtkIdType size, const Corner* corners)
{
  std::vector<vtkIdType>& ids = buffers.Ids;
  ids.clear();
  const auto idOf = [&](vtkIdType corner)
  { return IsUsable(this->Points[first + corner]) ? first + corner : vtkIdType(-1); };
  const int appended = SkdAppendCorners(size, corners, idOf, ids);
  if (appended == 0)
  {
    return;
  }
  vtkIdList* cut = buffers.Triangulation.Cut(
    appended, [&](vtkIdType i) -> const auto& { return this->Points[ids[i]]; });
  for (vtkIdType i = 0; i + 2 < cut->GetNumberOfIds(); i += 3)
  {
    this->Elements.push_back(
      { ids[cut->GetId(i)], ids[cut->GetId(i + 1)], ids[cut->GetId(i + 2)] });
    this->Origins.push_back(origin);
  }
}

void SkdComparedSet::AddPoints(int block, vtkDataSet* mesh)
{
  const std::vector<unsigned char> shown = SkdFindShown(mesh, vtkDataObject::POINT);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    skd::Vector3 x;
    mesh->GetPoint(i, x.X);
    if (shown[static_cast<std::size_t>(i)] != 0 && IsUsable(x))
    {
      const auto id = static_cast<vtkIdType>(this->Points.size());
      this->Points.push_back(x);
      this->Elements.push_back({ id, id, id });
      this->Origins.push_back({ block, i });
    }
  }
}

void SkdComparedSet::FindOwn(const std::vector<SkdBlock>& blocks, const SkdReduction& all)
{
  std::vector<std::vector<unsigned char>> own;
  std::vector<SkdJoinedIds> joined;
  bool isSpread = false;
  for (const SkdBlock& block : blocks)
  {
    own.push_back(SkdOwnCellsOf(block.Mesh));
    joined.emplace_back(block.Mesh);
    isSpread = isSpread || !own.back().empty();
  }
  const auto number = static_cast<vtkIdType>(this->Elements.size());
  this->FirstOwn = number * all.GetRank() / all.GetNumberOfProcesses();
  this->NumberOfOwn = number * (all.GetRank() + 1) / all.GetNumberOfProcesses() - this->FirstOwn;
  if (isSpread)
  {
    for (vtkIdType element = 0; element < number; ++element)
    {
      const Origin& origin = this->Origins[element];
      if (own[origin.Block][joined[origin.Block].Find(origin.CellId)] != 0)
      {
        this->OwnElements.push_back(element);
      }
    }
    this->NumberOfOwn = static_cast<vtkIdType>(this->OwnElements.size());
  }
}

std::vector<unsigned char> SkdComparedSet::FindOwnPoints() const
{
  std::vector<unsigned char> isOwn(this->Points.size(), 0);
  for (vtkIdType i = 0; i < this->NumberOfOwn; ++i)
  {
    for (const vtkIdType id : this->Elements[this->GetOwn(i)])
    {
      isOwn[id] = 1;
    }
  }
  return isOwn;
}

vtkSmartPointer<vtkPolyData> SkdComparedSet::MakeMesh() const
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(SkdMakePoints(
    static_cast<vtkIdType>(this->Points.size()), [this](vtkIdType i) -> const auto& {
      return this->Points[i];
    }));
  const auto cells = SkdMakeCells(
    this->Surface ? 3 : 1, this->Elements,
    [](const SkdTriangleIds& ids) -> const auto& { return ids; });
  if (this->Surface)
  {
    mesh->SetPolys(cells);
  }
  else
  {
    mesh->SetVerts(cells);
  }
  return mesh;
}

double SkdComparedSet::GetDistance2(vtkIdType element, const skd::Vector3& x) const
{
  const skd::Vector3& a = this->GetCorner(element, 0);
  return this->Surface
    ? skd::ClosestPointOnTriangle(a, this->GetCorner(element, 1), this->GetCorner(element, 2), x)
        .Dist2
    : skd::Distance2(a, x);
}

void SkdComparedSet::GetBounds(skd::Vector3& low, skd::Vector3& high) const
{
  constexpr double most = std::numeric_limits<double>::max();
  low = { { most, most, most } };
  high = -1.0 * low;
  for (const SkdTriangleIds& element : this->Elements)
  {
    for (const vtkIdType id : element)
    {
      low = skd::Least(low, this->Points[id]);
      high = skd::Greatest(high, this->Points[id]);
    }
  }
}

void SkdComparedSet::Release()
{
  this->Points = {};
  this->Elements = {};
  this->Origins = {};
  this->OwnElements = {};
  this->NumberOfOwn = 0;
  this->Sided = false;
  this->SpreadSides = nullptr;
}
}
