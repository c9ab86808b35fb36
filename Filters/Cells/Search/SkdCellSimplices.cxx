// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Search/SkdCellTree.h"

#include "Cells/Curved/SkdCurvedSimplices.h"
#include "Cells/Kernels/SkdFaceTriangles.h"
#include "Cells/Kernels/SkdKernels.h"
#include "Cells/Kernels/SkdParametricCell.h"
#include "Core/Geometry/Intersection/BoxOverlap.h"
#include "Core/Geometry/Polygons/EarClipping.h"
#include "Core/Geometry/Simplices/SimplexContact.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"

namespace skdtree
{
namespace
{
using skd::SimplexSet;
using skd::Vector3;

void AddPoints(SimplexSet& set, const Vector3* points, int size)
{
  for (int i = 0; i < size; ++i)
  {
    set.Add(points[i]);
  }
}

void Start(SimplexSet& set, int dimension, bool isConvex, const Vector3* points, int size)
{
  set.Clear(dimension);
  set.IsConvex = isConvex;
  AddPoints(set, points, size);
}

void AddQuad(SimplexSet& set, const Vector3* p, const int (&slots)[4])
{
  const Vector3 quad[4] = { p[slots[0]], p[slots[1]], p[slots[2]], p[slots[3]] };
  for (const auto& i : SkdQuadSplit(quad).Triangles)
  {
    set.AddSimplex(slots[i[0]], slots[i[1]], slots[i[2]]);
  }
}

//------------------------------------------------------------------------------
void Read(SimplexSet& set, const Vector3* p, SkdVertexKernel)
{
  Start(set, 0, true, p, 1);
  set.AddSimplex(0, 0, 0);
}

void Read(SimplexSet& set, const Vector3* p, SkdLineKernel)
{
  Start(set, 1, true, p, 2);
  set.AddSimplex(0, 1, 1);
}

void Read(SimplexSet& set, const Vector3* p, SkdTriangleKernel)
{
  Start(set, 2, true, p, 3);
  set.AddSimplex(0, 1, 2);
}

void Read(SimplexSet& set, const Vector3* p, SkdQuadKernel)
{
  Start(set, 2, false, p, 4);
  AddQuad(set, p, { 0, 1, 2, 3 });
}

void Read(SimplexSet& set, const Vector3* p, SkdPixelKernel)
{
  Start(set, 2, true, p, 4);
  AddQuad(set, p, { 0, 1, 3, 2 });
}

template <class Shape>
void Read(SimplexSet& set, const Vector3* p, SkdVolumeKernel<Shape>)
{
  constexpr bool isConvex =
    std::is_same<Shape, skd::Tetrahedron>::value || std::is_same<Shape, skd::Voxel>::value;
  Start(set, 3, isConvex, p, Shape::Size);
  SkdForEachFaceCorners<Shape>(p, [&set](int a, int b, int c) { set.AddSimplex(a, b, c); });
}

void Read(SimplexSet& set, const Vector3* p, SkdVoxelKernel)
{
  Read(set, p, SkdVolumeKernel<skd::Voxel>());
}

//------------------------------------------------------------------------------
void ReadPolygon(SimplexSet& set, const SkdPolyCell& cell)
{
  Start(set, 2, false, cell.Points, cell.Size);
  if (cell.Size < 3)
  {
    set.AddSimplex(0, cell.Size - 1, cell.Size - 1);
    return;
  }
  skd::EarClipping<const Vector3*> ears(cell.Points, cell.Size);
  ears.ForEachTriangle([&set](int a, int b, int c) { set.AddSimplex(a, b, c); });
}

/// Strips, polylines and polyvertices: too few points are lines, or a vertex.
void ReadPieces(SimplexSet& set, const SkdPolyCell& cell)
{
  const int wanted = cell.Shape == SkdShape::Strip ? 3 : (cell.Shape == SkdShape::PolyLine ? 2 : 1);
  const int last = std::min(wanted, cell.Size) - 1;
  Start(set, last, cell.Size == last + 1, cell.Points, cell.Size);
  for (int i = 0; i + last < cell.Size; ++i)
  {
    set.AddSimplex(i, i + std::min(last, 1), i + last);
  }
}

void ReadPolyhedron(SimplexSet& set, const SkdPolyCell& cell)
{
  Start(set, 3, false, cell.Points, cell.Size);
  cell.AsPolyhedron().ForEachFace(
    [&](const skd::PolyhedronFace& face)
    {
      int middle = -1;
      skd::ForEachTriangle(face,
        [&](const skd::FaceTriangle& triangle)
        {
          int slots[3];
          for (int i = 0; i < 3; ++i)
          {
            const int corner = triangle.Corners[i];
            if (corner == skd::FaceTriangle::Middle && middle < 0)
            {
              middle = set.Add(triangle.Points[i]);
            }
            slots[i] =
              corner == skd::FaceTriangle::Middle ? middle : static_cast<int>(face.Ids[corner]);
          }
          set.AddSimplex(slots[0], slots[1], slots[2]);
        });
    });
}

/// What is nothing but points, be it for want of faces.
void ReadPoints(SimplexSet& set, const SkdPolyCell& cell)
{
  ReadPieces(set, { SkdShape::PolyVertex, cell.Points, cell.Size, nullptr, nullptr });
}

void ReadPoly(SimplexSet& set, const SkdPolyCell& cell)
{
  if (cell.Shape == SkdShape::Polygon)
  {
    ReadPolygon(set, cell);
  }
  else if (cell.Shape != SkdShape::Polyhedron)
  {
    ReadPieces(set, cell);
  }
  else if (cell.Faces < cell.FacesEnd)
  {
    ReadPolyhedron(set, cell);
  }
  else
  {
    ReadPoints(set, cell);
  }
}

//------------------------------------------------------------------------------
/// The boundary of what `size` points in turn are a piece of each: of tetrahedra the triangles that
/// one alone has. Points at the same position are one.
class Pieces
{
public:
  Pieces(SimplexSet& set, vtkPoints* points)
    : Set(set)
    , Points(points)
  {
  }

  void AddTriangles()
  {
    for (vtkIdType i = 0; i + 2 < this->Points->GetNumberOfPoints(); i += 3)
    {
      this->Set.AddSimplex(this->NumberOf(i), this->NumberOf(i + 1), this->NumberOf(i + 2));
    }
  }

private:
  int NumberOf(vtkIdType i)
  {
    Vector3 x;
    this->Points->GetPoint(i, x.X);
    const std::vector<Vector3>& known = this->Set.Points;
    const auto found = std::find(known.begin(), known.end(), x);
    return found != known.end() ? static_cast<int>(found - known.begin()) : this->Set.Add(x);
  }

  SimplexSet& Set;
  vtkPoints* Points;
};

/// A cell that is straight between its points, taken apart by itself: prisms.
void ReadStraight(SimplexSet& set, vtkCell* cell, const SkdPolyCell& gathered)
{
  vtkNew<vtkIdList> ids;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  set.Clear(cell->GetCellDimension());
  AddPoints(set, gathered.Points, gathered.Size);
  if (set.Dimension == 3)
  {
    for (int i = 0; i < cell->GetNumberOfFaces(); ++i)
    {
      cell->GetFace(i)->Triangulate(0, ids, points);
      Pieces(set, points).AddTriangles();
    }
  }
  else if (set.Dimension == 2)
  {
    cell->Triangulate(0, ids, points);
    Pieces(set, points).AddTriangles();
  }
  if (set.Simplices.empty())
  {
    ReadPoints(set, gathered);
  }
}

/// The points of a quadratic polygon: its corners, then the middles of its edges.
void ReadQuadraticPolygon(SimplexSet& set, const SkdPolyCell& gathered)
{
  std::vector<Vector3> ordered;
  for (int i = 0; i < gathered.Size; ++i)
  {
    ordered.push_back(gathered.Points[i / 2 + (i % 2 == 0 ? 0 : gathered.Size / 2)]);
  }
  ReadPolygon(set, { SkdShape::Polygon, ordered.data(), gathered.Size, nullptr, nullptr });
}
}

//------------------------------------------------------------------------------
bool SkdCellTree::GetStraightSimplices(std::uint32_t cell, skd::SimplexSet& simplices) const
{
  const SkdShape shape = this->Store.ShapeOf(cell);
  const auto read = [&](auto kernel)
  {
    Vector3 points[kernel.Size];
    this->Store.Gather(cell, points);
    Read(simplices, points, kernel);
  };
  if (shape != SkdShape::Generic && !SkdVisitKernel(shape, read))
  {
    ReadPoly(simplices, this->Store.GatherPoly(cell));
  }
  return shape != SkdShape::Generic;
}

void SkdCellTree::GetSimplices(
  std::uint32_t cell, const SkdCellSource& source, skd::SimplexSet& simplices) const
{
  if (this->GetStraightSimplices(cell, simplices))
  {
    return;
  }
  vtkCell* loaded = source.Load(this->Store.IdOf(cell));
  if (SkdParametricCell::DomainOf(loaded->GetCellType()))
  {
    SkdReadCurved(simplices, loaded, this->Store.BoundsOf(cell));
  }
  else if (loaded->GetCellType() == VTK_QUADRATIC_POLYGON)
  {
    ReadQuadraticPolygon(simplices, this->Store.GatherPoly(cell));
  }
  else
  {
    ReadStraight(simplices, loaded, this->Store.GatherPoly(cell));
  }
}

//------------------------------------------------------------------------------
bool SkdCellTree::Meets(std::uint32_t cell, const skd::SimplexSet& set) const
{
  const skd::Box3 bounds = this->Store.ExtentOf(cell);
  if (!bounds.Inflated(this->TheRounding).Overlaps(set.Bounds))
  {
    return false;
  }
  thread_local skd::SimplexSet own; // keeps its memory
  if (this->GetStraightSimplices(cell, own))
  {
    return skd::Meet(own, set, this->TheRounding);
  }
  const auto overlaps = [&](const skd::SimplexSet::Simplex& simplex)
  {
    const auto corners = set.Corners(simplex);
    return skd::Overlaps(bounds, corners[0], corners[1], corners[2]);
  };
  return std::any_of(set.Simplices.begin(), set.Simplices.end(), overlaps) ||
    skd::Encloses(set, this->Store.Point(*this->Store.PointIdsOf(cell)));
}

//------------------------------------------------------------------------------
bool SkdCellTree::IsWithin(std::uint32_t cell, const SkdCellSource& source,
  const skd::SimplexSet& set, double maxDistance2) const
{
  if (!(skd::MinDistance2(this->SafetyBoxOf(cell), set.Bounds) <= maxDistance2))
  {
    return false;
  }
  thread_local skd::SimplexSet own; // keeps its memory
  this->GetSimplices(cell, source, own);
  return skd::MinDistance2(own, set, maxDistance2) <= maxDistance2;
}
}
