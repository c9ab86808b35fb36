// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bodies/SkdBoundary.h"

#include "Bodies/SkdPieceSurfaces.h"
#include "Bodies/SkdTriangulation.h"
#include "Bodies/SkdWeld.h"
#include "Pipeline/SkdMakeMesh.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <utility>

namespace skdtree
{
namespace
{
/// A polygon of welded points.
struct Face
{
  std::size_t First; // of its corners
  int Size;
  SkdBoundary::Origin Origin;
  bool OfVolume;
  int Copies; // how many of it the boundary has; 0 of an inner face and of a repetition
  int Net;    // how many of these are oriented like it more than are oriented against it
};

/// The faces of all blocks, and what becomes of them.
class FaceList
{
public:
  FaceList(
    const std::vector<SkdBlock>& blocks, double chordalLength, const SkdSharedBlocks* shared);

  void KeepVolumesOrSurfaces();
  void SortByOrigin();
  void CountCopies();
  void FillBoundary(SkdBoundary& boundary) const;

private:
  void AddBlock(int block, const SkdBlockSurface& surface);
  template <class Corner>
  void AddFace(Face face, const SkdBlockSurface& surface, vtkIdType size, const Corner* corners);
  void CountCopiesOfGroup(const std::vector<std::size_t>& group);
  bool AreOrientedAlike(const Face& a, const Face& b) const;

  using Edge = std::pair<vtkIdType, vtkIdType>; // the lower end first
  Edge EdgeOf(const Face& face, int i) const;
  vtkIdType SumOverAll(vtkIdType own) const
  {
    return this->Shared ? this->Shared->SumOverAll(own) : own;
  }
  template <typename Predicate>
  vtkIdType CountOddEdges(const Predicate& isOfSurface) const;
  template <typename Predicate>
  vtkIdType CountOwn(const std::vector<Edge>& edges, const Predicate& isOfSurface) const;
  std::vector<int> FindRepeats() const;
  template <typename Number>
  vtkSmartPointer<vtkPolyData> MakeSurface(
    const Number& numberOf, std::vector<SkdBoundary::Origin>* origins) const;

  const SkdSharedBlocks* Shared; // or nullptr
  SkdWeld Weld;
  std::vector<Face> Faces;
  std::vector<vtkIdType> Corners;
  vtkIdType CoarseFaces = 0;
};

FaceList::FaceList(
  const std::vector<SkdBlock>& blocks, double chordalLength, const SkdSharedBlocks* shared)
  : Shared(shared)
{
  SkdVisitSurfaces(blocks, chordalLength,
    [this](int block, const SkdBlockSurface& surface) { this->AddBlock(block, surface); });
}

void FaceList::AddBlock(int block, const SkdBlockSurface& surface)
{
  this->CoarseFaces += surface.GetNumberOfCoarseFaces();
  surface.ForEachFace(
    [&](vtkIdType cell, vtkIdType size, const auto* corners)
    {
      const SkdBoundary::Origin origin{ block, surface.GetCellId(cell) };
      const Face like{ this->Corners.size(), 0, origin, surface.IsOfVolume(cell), 0, 0 };
      this->AddFace(like, surface, size, corners);
    });
}

template <class Corner>
void FaceList::AddFace(
  Face face, const SkdBlockSurface& surface, vtkIdType size, const Corner* corners)
{
  const auto idOf = [&](vtkIdType corner) -> vtkIdType
  {
    double x[3];
    surface.GetPoint(corner, x);
    const bool isFinite = std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
    return isFinite ? this->Weld.GetId(x) : -1;
  };
  face.Size = SkdAppendCorners(size, corners, idOf, this->Corners);
  if (face.Size > 0)
  {
    this->Faces.push_back(face);
  }
}

void FaceList::KeepVolumesOrSurfaces()
{
  const auto isOfVolume = [](const Face& face) { return face.OfVolume; };
  const bool isAny = std::any_of(this->Faces.begin(), this->Faces.end(), isOfVolume);
  if (this->SumOverAll(isAny ? 1 : 0) > 0)
  {
    this->Faces.erase(
      std::remove_if(this->Faces.begin(), this->Faces.end(), std::not_fn(isOfVolume)),
      this->Faces.end());
  }
}

void FaceList::SortByOrigin()
{
  std::stable_sort(this->Faces.begin(), this->Faces.end(),
    [](const Face& a, const Face& b)
    {
      return a.Origin.Block != b.Origin.Block ? a.Origin.Block < b.Origin.Block
                                              : a.Origin.CellId < b.Origin.CellId;
    });
}

// Two faces are the same when they have the same corners, wherever they start and whichever way
// they go around.
void FaceList::CountCopies()
{
  std::vector<vtkIdType> sorted = this->Corners;
  for (const Face& face : this->Faces)
  {
    std::sort(sorted.begin() + face.First, sorted.begin() + face.First + face.Size);
  }
  const auto compare = [&](std::size_t a, std::size_t b)
  {
    const auto beginA = sorted.begin() + this->Faces[a].First;
    const auto beginB = sorted.begin() + this->Faces[b].First;
    const int sizeA = this->Faces[a].Size;
    const int sizeB = this->Faces[b].Size;
    if (sizeA == sizeB)
    {
      const auto [atA, atB] = std::mismatch(beginA, beginA + sizeA, beginB);
      return atA == beginA + sizeA ? 0 : (*atA < *atB ? -1 : 1);
    }
    return sizeA < sizeB ? -1 : 1;
  };
  std::vector<std::size_t> order(this->Faces.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  vtkSMPTools::Sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    {
      const int difference = compare(a, b);
      return difference != 0 ? difference < 0 : a < b;
    });

  std::vector<std::size_t> group;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    group.push_back(order[i]);
    if (i + 1 == order.size() || compare(order[i], order[i + 1]) != 0)
    {
      this->CountCopiesOfGroup(group);
      group.clear();
    }
  }
}

void FaceList::CountCopiesOfGroup(const std::vector<std::size_t>& group)
{
  const int copies = static_cast<int>(group.size());
  Face& first = this->Faces[group.front()];
  first.Copies = first.OfVolume ? copies % 2 : copies;
  first.Net = first.Copies;
  if (!first.OfVolume)
  {
    first.Net = 0;
    for (const std::size_t face : group)
    {
      first.Net += this->AreOrientedAlike(first, this->Faces[face]) ? 1 : -1;
    }
  }
}

// Of faces that have the same corners.
bool FaceList::AreOrientedAlike(const Face& a, const Face& b) const
{
  const vtkIdType* corners = this->Corners.data() + b.First;
  const vtkIdType* end = corners + b.Size;
  const vtkIdType* same = std::find(corners, end, this->Corners[a.First]);
  const vtkIdType before = same == corners ? end[-1] : same[-1];
  return before != this->Corners[a.First + 1];
}

FaceList::Edge FaceList::EdgeOf(const Face& face, int i) const
{
  const vtkIdType a = this->Corners[face.First + i];
  const vtkIdType b = this->Corners[face.First + (i + 1) % face.Size];
  return { std::min(a, b), std::max(a, b) };
}

template <typename Predicate>
vtkIdType FaceList::CountOddEdges(const Predicate& isOfSurface) const
{
  std::vector<Edge> edges;
  for (const Face& face : this->Faces)
  {
    for (int i = 0; isOfSurface(face) && i < face.Size; ++i)
    {
      edges.push_back(this->EdgeOf(face, i));
    }
  }
  vtkSMPTools::Sort(edges.begin(), edges.end());
  std::vector<Edge> odd;
  for (auto edge = edges.begin(); edge != edges.end();)
  {
    const auto next = std::find_if(edge, edges.end(), [&](const auto& e) { return e != *edge; });
    if ((next - edge) % 2 == 1)
    {
      odd.push_back(*edge);
    }
    edge = next;
  }
  return this->Shared ? this->SumOverAll(this->CountOwn(odd, isOfSurface))
                      : static_cast<vtkIdType>(odd.size());
}

// An edge counts on the process that has the first face at it.
template <typename Predicate>
vtkIdType FaceList::CountOwn(const std::vector<Edge>& edges, const Predicate& isOfSurface) const
{
  std::vector<char> isVisited(edges.size(), 0);
  vtkIdType own = 0;
  for (const Face& face : this->Faces)
  {
    for (int i = 0; isOfSurface(face) && i < face.Size; ++i)
    {
      const Edge edge = this->EdgeOf(face, i);
      const auto found = std::lower_bound(edges.begin(), edges.end(), edge);
      const auto at = static_cast<std::size_t>(found - edges.begin());
      if (found != edges.end() && *found == edge && isVisited[at] == 0)
      {
        isVisited[at] = 1;
        own += this->Shared->IsOwn(face.Origin) ? 1 : 0;
      }
    }
  }
  return own;
}

// So many copies of each face, of a negative number reversed.
template <typename Number>
vtkSmartPointer<vtkPolyData> FaceList::MakeSurface(
  const Number& numberOf, std::vector<SkdBoundary::Origin>* origins) const
{
  const std::vector<skd::Vector3>& points = this->Weld.GetPoints();
  vtkNew<vtkCellArray> cells;
  SkdTriangulation triangulation;
  for (const Face& face : this->Faces)
  {
    const int number = numberOf(face);
    if (number == 0)
    {
      continue;
    }
    const vtkIdType* const ids = this->Corners.data() + face.First;
    const auto cornerOf = [&](vtkIdType i) { return points[static_cast<std::size_t>(ids[i])]; };
    vtkIdList* triangles = triangulation.Cut(face.Size, cornerOf);
    for (vtkIdType i = 0; i < triangles->GetNumberOfIds(); i += 3)
    {
      const vtkIdType* cut = triangles->GetPointer(i);
      vtkIdType corners[3] = { ids[cut[0]], ids[cut[1]], ids[cut[2]] };
      if (number < 0)
      {
        std::swap(corners[1], corners[2]);
      }
      for (int copy = 0; copy < std::abs(number); ++copy)
      {
        cells->InsertNextCell(3, corners);
      }
    }
    if (origins)
    {
      origins->resize(cells->GetNumberOfCells(), face.Origin);
    }
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(SkdMakePoints(static_cast<vtkIdType>(points.size()),
    [&points](vtkIdType i) { return points[static_cast<std::size_t>(i)]; }));
  surface->SetPolys(cells);
  return surface;
}

// One number a triangle of all faces that are there.
std::vector<int> FaceList::FindRepeats() const
{
  std::vector<int> repeats;
  bool isAny = false;
  for (const Face& face : this->Faces)
  {
    if (face.Copies > 0)
    {
      const int number = face.Net != 0 ? face.Net : 1;
      repeats.insert(repeats.end(), static_cast<std::size_t>(face.Size - 2), number);
      isAny = isAny || number != 1;
    }
  }
  return isAny ? repeats : std::vector<int>();
}

// Equal faces are either a face between two touching bodies, which must be removed, or duplicates
// of one face, which must be kept. The alternative that leaves fewer open edges is chosen. For
// touching bodies with duplicates, the difference of the numbers of both orientations of a face
// counts.
void FaceList::FillBoundary(SkdBoundary& boundary) const
{
  const auto isThere = [](const Face& face) { return face.Copies > 0; };
  const auto isOdd = [](const Face& face) { return face.Net % 2 != 0; };
  boundary.CoarseFaces = this->CoarseFaces;
  boundary.Faces = this->MakeSurface(isThere, &boundary.Origins);
  boundary.Surface = boundary.Faces;
  boundary.Repeats = this->FindRepeats();
  boundary.SurfaceOrigins = this->Shared ? boundary.Origins : std::vector<SkdBoundary::Origin>();
  boundary.OpenEdges = this->CountOddEdges(isThere);
  const vtkIdType others = boundary.OpenEdges > 0 ? this->CountOddEdges(isOdd) : 0;
  if (others < boundary.OpenEdges)
  {
    boundary.SurfaceOrigins.clear();
    boundary.Surface = this->MakeSurface(
      [](const Face& face) { return face.Net; }, this->Shared ? &boundary.SurfaceOrigins : nullptr);
    boundary.Repeats.clear();
    boundary.OpenEdges = others;
  }
}
}

SkdBoundary SkdBoundaryOf(
  const std::vector<SkdBlock>& blocks, double chordalLength, const SkdSharedBlocks* shared)
{
  FaceList faces(blocks, chordalLength, shared);
  faces.KeepVolumesOrSurfaces();
  faces.SortByOrigin();
  faces.CountCopies();
  SkdBoundary boundary;
  faces.FillBoundary(boundary);
  return boundary;
}
}
