// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Rays/SkdSurfaceNormals.h"

#include "Bodies/SkdPieceSurfaces.h"
#include "Cells/Curved/SkdCurvedFaces.h"
#include "Cells/Read/SkdForEach.h"
#include "Core/Geometry/Distance/ClosestPointOnTriangle.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdShownElements.h"
#include "Pipeline/SkdVolumeCells.h"
#include "Search/Rays/SkdCurvedFacePoints.h"
#include "Search/Rays/SkdNormalSums.h"
#include "Search/Rays/SkdUnitVector.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace skdtree
{
namespace
{
using skd::Vector3;

/// How many of a surface cell's points are its corners; 0 of other cells.
int CornersOf(int type, int size)
{
  switch (type)
  {
    case VTK_POLYGON:
    case VTK_QUAD:
    case VTK_PIXEL:
    case VTK_TRIANGLE:
    case VTK_TRIANGLE_STRIP:
      return size;
    case VTK_QUADRATIC_POLYGON:
      return size / 2;
    case VTK_QUADRATIC_TRIANGLE:
    case VTK_BIQUADRATIC_TRIANGLE:
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_BEZIER_TRIANGLE:
      return std::min(size, 3);
    case VTK_QUADRATIC_QUAD:
    case VTK_BIQUADRATIC_QUAD:
    case VTK_QUADRATIC_LINEAR_QUAD:
    case VTK_LAGRANGE_QUADRILATERAL:
    case VTK_BEZIER_QUADRILATERAL:
      return std::min(size, 4);
    default:
      return 0;
  }
}

/// A corner of a facet: the id of the point, and where it is.
struct Corner
{
  vtkIdType Id;
  Vector3 Point;
};
using Facet = std::vector<Corner>;

Vector3 NormalOf(const Facet& facet)
{
  Vector3 area{ { 0.0, 0.0, 0.0 } };
  for (std::size_t i = 1; i + 1 < facet.size(); ++i)
  {
    const Vector3& from = facet[0].Point;
    area = area + skd::Cross(facet[i].Point - from, facet[i + 1].Point - from);
  }
  return SkdUnit(area);
}

double AngleBetween(const Vector3& a, const Vector3& b)
{
  return std::atan2(skd::Norm(skd::Cross(a, b)), skd::Dot(a, b));
}

/// Calls visit(facet) for the facet of a surface cell, or the triangles of a strip. Thread-safe.
template <class Visit>
void ForEachFacet(vtkDataSet* mesh, vtkIdType cell, const Visit& visit)
{
  thread_local vtkNew<vtkIdList> ids;
  thread_local Facet facet;
  const int type = mesh->GetCellType(cell);
  mesh->GetCellPoints(cell, ids);
  const int corners = CornersOf(type, static_cast<int>(ids->GetNumberOfIds()));
  facet.clear();
  const auto add = [&](int i)
  {
    Corner corner{ ids->GetId(i), {} };
    mesh->GetPoint(corner.Id, corner.Point.X);
    facet.push_back(corner);
  };
  if (type == VTK_TRIANGLE_STRIP)
  {
    for (int i = 0; i + 2 < corners; ++i)
    {
      facet.clear();
      add(i);
      add(i + 1 + i % 2);
      add(i + 2 - i % 2);
      visit(facet);
    }
    return;
  }
  for (int i = 0; i < corners; ++i)
  {
    add(type == VTK_PIXEL && i >= 2 ? 5 - i : i);
  }
  if (corners >= 3)
  {
    visit(facet);
  }
}
}

//------------------------------------------------------------------------------
Vector3 SkdNormalOfCell(vtkDataSet* mesh, vtkIdType cell, const Vector3& x)
{
  if (const auto facePoint = SkdNearestOnCurvedCell(mesh, cell, x))
  {
    return facePoint->Normal;
  }
  Vector3 normal{ { 0.0, 0.0, 0.0 } };
  double least = std::numeric_limits<double>::infinity();
  const bool isStrip = mesh->GetCellType(cell) == VTK_TRIANGLE_STRIP;
  ForEachFacet(mesh, cell,
    [&](const Facet& facet)
    {
      const double distance2 = isStrip
        ? skd::ClosestPointOnTriangle(facet[0].Point, facet[1].Point, facet[2].Point, x).Dist2
        : 0.0;
      if (distance2 < least)
      {
        least = distance2;
        normal = NormalOf(facet);
      }
    });
  return normal;
}

//------------------------------------------------------------------------------
std::vector<Vector3> SkdNormalsOfCells(vtkDataSet* mesh)
{
  SkdTouchCells(mesh);
  std::vector<Vector3> normals(static_cast<std::size_t>(mesh->GetNumberOfCells()));
  SkdForEach(mesh->GetNumberOfCells(),
    [&](vtkIdType cell)
    {
      Vector3 normal{ { 0.0, 0.0, 0.0 } };
      bool isFirst = true;
      ForEachFacet(mesh, cell,
        [&](const Facet& facet)
        {
          normal = isFirst ? NormalOf(facet) : normal;
          isFirst = false;
        });
      const auto facePoint = SkdMiddleOfCurvedCell(mesh, cell);
      normals[static_cast<std::size_t>(cell)] = facePoint ? facePoint->Normal : normal;
    });
  return normals;
}

namespace
{
/// Calls add(point, angle, normal) for all points of those surface cells that `counts` and that
/// have corners only.
template <class Counts, class Add>
void ForEachNormal(vtkDataSet* mesh, const Counts& counts, const Add& add)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    if (!counts(cell))
    {
      continue;
    }
    ForEachFacet(mesh, cell,
      [&](const Facet& facet)
      {
        const Vector3 normal = NormalOf(facet);
        const std::size_t n = facet.size();
        for (std::size_t i = 0; i < n; ++i)
        {
          const Vector3& x = facet[i].Point;
          const double angle =
            AngleBetween(facet[(i + 1) % n].Point - x, facet[(i + n - 1) % n].Point - x);
          add(facet[i].Id, angle, normal);
        }
        mesh->GetCellPoints(cell, ids);
        const bool hasMiddles = mesh->GetCellType(cell) == VTK_QUADRATIC_POLYGON;
        for (vtkIdType i = static_cast<vtkIdType>(n); hasMiddles && i < ids->GetNumberOfIds(); ++i)
        {
          add(ids->GetId(i), vtkMath::Pi(), normal);
        }
      });
  }
}

/// The same of all surface cells, curved ones, too, or the outer faces of a mesh of volume cells.
template <class Add>
void ForEachNormalOf(vtkDataSet* mesh, const SkdBlockSurface* outer, const Add& add)
{
  const auto isFlat = [mesh](vtkIdType cell)
  {
    const int type = mesh->GetCellType(cell);
    return !SkdIsCurvedCellType(type) || type == VTK_QUADRATIC_POLYGON;
  };
  if (outer)
  {
    ForEachNormal(
      outer->Get(), [&](vtkIdType face) { return isFlat(outer->GetCellId(face)); },
      [&](vtkIdType point, double angle, const Vector3& normal)
      {
        if (outer->GetPointId(point) >= 0)
        {
          add(outer->GetPointId(point), angle, normal);
        }
      });
  }
  else
  {
    const std::vector<unsigned char> shown = SkdFindShown(mesh, vtkDataObject::CELL);
    ForEachNormal(
      mesh,
      [&](vtkIdType cell) { return shown[static_cast<std::size_t>(cell)] != 0 && isFlat(cell); },
      add);
  }
  if (SkdHasCurvedCells(mesh))
  {
    SkdVisitCurvedFacePoints(mesh,
      [&](vtkIdType point, const SkdCurvedFacePoint& facePoint)
      { add(point, facePoint.Angle, facePoint.Normal); });
  }
}
}

//------------------------------------------------------------------------------
std::vector<Vector3> SkdNormalsOfPoints(vtkDataSet* mesh)
{
  std::optional<SkdBlockSurface> outer;
  if (SkdHasVolumeCells(mesh))
  {
    outer.emplace(mesh, SkdChordalLength({ { mesh, 0 } }, 1.0)); // flat faces count
  }
  const SkdBlockSurface* faces = outer ? &*outer : nullptr;
  SkdNormalSums sums(mesh->GetNumberOfPoints());
  ForEachNormalOf(
    mesh, faces, [&](vtkIdType point, double angle, const Vector3&) { sums.Expect(point, angle); });
  ForEachNormalOf(mesh, faces,
    [&](vtkIdType point, double angle, const Vector3& normal) { sums.Add(point, angle, normal); });
  std::vector<Vector3> normals(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  SkdForEach(normals.size(),
    [&](std::size_t i) { normals[i] = SkdUnit(sums.Get(static_cast<vtkIdType>(i))); });
  return normals;
}

namespace
{
/// Calls add(number among the points of all pieces, angle, normal) for all outer faces of a piece.
template <class Add>
void ForEachNormalOfPiece(const SkdPieceSurface& piece, const Add& add)
{
  ForEachNormal(
    piece.Faces->Get(), [&](vtkIdType face) { return piece.Faces->IsOfVolume(face); },
    [&](vtkIdType point, double angle, const Vector3& normal)
    { add(piece.Numbers[static_cast<std::size_t>(point)], angle, normal); });
}

std::vector<Vector3> NormalsOfPiece(
  vtkDataSet* mesh, const SkdPieceSurface& piece, const SkdNormalSums& sums)
{
  std::vector<Vector3> normals(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (std::size_t i = 0; i < piece.Numbers.size(); ++i)
  {
    const vtkIdType point = piece.Faces->GetPointId(static_cast<vtkIdType>(i));
    if (point >= 0 && piece.Numbers[i] >= 0)
    {
      normals[static_cast<std::size_t>(point)] = SkdUnit(sums.Get(piece.Numbers[i]));
    }
  }
  return normals;
}
}

//------------------------------------------------------------------------------
std::vector<std::vector<Vector3>> SkdNormalsOfPieces(const std::vector<SkdBlock>& blocks)
{
  std::vector<std::vector<Vector3>> normals(blocks.size());
  const std::vector<std::vector<std::size_t>> meshes = SkdPiecesOfMeshes(blocks);
  const auto isCurved = [](const SkdBlock& block) { return SkdHasCurvedCells(block.Mesh); };
  if (meshes.empty() || std::any_of(blocks.begin(), blocks.end(), isCurved))
  {
    return normals;
  }
  const std::vector<SkdPieceSurface> pieces = SkdSurfacesOfPieces(blocks, 0.0);
  for (const std::vector<std::size_t>& mesh : meshes)
  {
    SkdNormalSums sums(static_cast<vtkIdType>(pieces[mesh.front()].NumberOfAll));
    for (const std::size_t i : mesh)
    {
      ForEachNormalOfPiece(pieces[i],
        [&](vtkIdType point, double angle, const Vector3&) { sums.Expect(point, angle); });
    }
    for (const std::size_t i : mesh)
    {
      ForEachNormalOfPiece(pieces[i],
        [&](vtkIdType point, double angle, const Vector3& normal)
        { sums.Add(point, angle, normal); });
    }
    for (const std::size_t i : mesh)
    {
      normals[i] = NormalsOfPiece(blocks[i].Mesh, pieces[i], sums);
    }
  }
  return normals;
}
}
