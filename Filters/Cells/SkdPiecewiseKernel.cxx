// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/SkdPiecewiseKernel.h"

#include "Cells/SkdPolyKernels.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// A tetrahedron or wedge by its points' places in the cell.
struct Piece
{
  int Size;
  std::array<int, 6> Points;
};

struct Pieces
{
  std::vector<skd::Vector3> Points;
  std::vector<Piece> List;

  void Gather(const Piece& piece, skd::Vector3* points) const
  {
    for (int i = 0; i < piece.Size; ++i)
    {
      points[i] = this->Points[static_cast<std::size_t>(piece.Points[static_cast<std::size_t>(i)])];
    }
  }
};

/// The vectors are the calling thread's, and keep their size.
Pieces& EmptyPieces(vtkCell* cell)
{
  thread_local Pieces pieces;
  pieces.List.clear();
  pieces.Points.resize(static_cast<std::size_t>(cell->GetNumberOfPoints()));
  for (std::size_t i = 0; i < pieces.Points.size(); ++i)
  {
    cell->GetPoints()->GetPoint(static_cast<vtkIdType>(i), pieces.Points[i].X);
  }
  return pieces;
}

/// Both ends cut into a fan of triangles.
void AddWedges(Pieces& pieces)
{
  const int n = static_cast<int>(pieces.Points.size()) / 2;
  for (int i = 1; i + 1 < n; ++i)
  {
    pieces.List.push_back({ 6, { 0, i, i + 1, n, n + i, n + i + 1 } });
  }
}

/// VTK's own tetrahedra. Their points are told apart by where they are.
void AddTetrahedra(vtkCell* cell, Pieces& pieces)
{
  vtkNew<vtkIdList> ids;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  cell->Triangulate(0, ids, points);
  for (vtkIdType i = 0; i + 3 < points->GetNumberOfPoints(); i += 4)
  {
    Piece piece{ 4, {} };
    for (int corner = 0; corner < 4; ++corner)
    {
      skd::Vector3 x;
      points->GetPoint(i + corner, x.X);
      const auto found = std::find(pieces.Points.begin(), pieces.Points.end(), x);
      const bool isPoint = found != pieces.Points.end();
      piece.Points[static_cast<std::size_t>(corner)] =
        isPoint ? static_cast<int>(found - pieces.Points.begin()) : 0;
    }
    pieces.List.push_back(piece);
  }
}

const Pieces& PiecesOf(vtkCell* cell)
{
  Pieces& pieces = EmptyPieces(cell);
  if (cell->GetCellType() == VTK_CONVEX_POINT_SET)
  {
    AddTetrahedra(cell, pieces);
  }
  else
  {
    AddWedges(pieces);
  }
  return pieces;
}

struct PiecePoint
{
  skd::VolumePoint Nearest;
  int Index; ///< of the piece
};

PiecePoint FindNearest(const Pieces& pieces, const skd::Vector3& x)
{
  PiecePoint best{ skd::VolumePoint::Nowhere(x), -1 };
  best.Nearest.Dist2 = Infinity;
  for (std::size_t i = 0; i < pieces.List.size() && best.Nearest.Dist2 > 0.0; ++i)
  {
    const Piece& piece = pieces.List[i];
    skd::Vector3 points[6];
    pieces.Gather(piece, points);
    const double limit2 = best.Nearest.Dist2;
    const skd::VolumePoint found = piece.Size == 4
      ? skd::ClosestPointInCell<skd::Tetrahedron>(points, x, limit2)
      : skd::ClosestPointInCell<skd::Wedge>(points, x, limit2);
    if (found.Dist2 < limit2)
    {
      best = { found, static_cast<int>(i) };
    }
  }
  return best;
}

/// A flat set of points has no tetrahedra: its points are what is certain.
SkdCellPoint NearestPoint(const Pieces& pieces, const skd::Vector3& x)
{
  const auto nearest = std::min_element(pieces.Points.begin(), pieces.Points.end(),
    [&x](const skd::Vector3& a, const skd::Vector3& b)
    { return skd::Distance2(a, x) < skd::Distance2(b, x); });
  return { *nearest, { { 0.0, 0.0, 0.0 } }, skd::Distance2(*nearest, x) };
}

void WeighPiece(const Piece& piece, const skd::Vector3& pcoords, double* weights)
{
  double local[6];
  if (piece.Size == 4)
  {
    skd::Tetrahedron::Weights(pcoords, local);
  }
  else
  {
    skd::Wedge::Weights(pcoords, local);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(piece.Size); ++i)
  {
    weights[piece.Points[i]] += local[i];
  }
}

/// Of a convex point set those of the tetrahedron, as VTK has it; of a prism those that its points
/// have, weighed as they are.
skd::Vector3 PCoordsOf(vtkCell* cell, const skd::Vector3& inPiece, const double* weights)
{
  if (cell->GetCellType() == VTK_CONVEX_POINT_SET)
  {
    return inPiece;
  }
  const double* ofPoints = cell->GetParametricCoords();
  skd::Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    const double* p = ofPoints + 3 * i;
    sum = sum + weights[i] * skd::Vector3{ { p[0], p[1], p[2] } };
  }
  return sum;
}

//------------------------------------------------------------------------------
// Lines meet a prism's quads, and the fans of triangles that its ends are.

std::optional<SkdLineHit> HitPrism(
  vtkCell* cell, const skd::SegmentView& view, const SkdReach& reach)
{
  const Pieces& pieces = EmptyPieces(cell);
  const double* ofPoints = cell->GetParametricCoords();
  std::optional<SkdLineHit> first;
  const auto tryFace = [&](std::initializer_list<int> face)
  {
    skd::Vector3 points[4];
    skd::Vector3 pcoords[4];
    int size = 0;
    for (const int i : face)
    {
      points[size] = pieces.Points[static_cast<std::size_t>(i)];
      pcoords[size++] = { { ofPoints[3 * i], ofPoints[3 * i + 1], ofPoints[3 * i + 2] } };
    }
    SkdHitFace(points, pcoords, size, view, reach, first);
  };
  const int n = static_cast<int>(pieces.Points.size()) / 2;
  for (int i = 0; i < n; ++i)
  {
    const int next = (i + 1) % n;
    tryFace({ i, next, n + next, n + i });
    if (i > 0 && next > 0)
    {
      tryFace({ 0, i, next });
      tryFace({ n, n + i, n + next });
    }
  }
  return first;
}

//------------------------------------------------------------------------------
// Lines meet a convex point set's outer faces: those of only one of its tetrahedra.

struct TetrahedronFace
{
  std::array<int, 3> Name; ///< its points in ascending order
  int Tetrahedron;
  int Opposite; ///< the corner that it does not have

  bool operator<(const TetrahedronFace& other) const { return this->Name < other.Name; }
};

const std::vector<TetrahedronFace>& FacesOf(const Pieces& pieces)
{
  thread_local std::vector<TetrahedronFace> faces;
  faces.clear();
  for (std::size_t i = 0; i < pieces.List.size(); ++i)
  {
    const auto& p = pieces.List[i].Points;
    for (int corner = 0; corner < 4; ++corner)
    {
      std::array<int, 3> name;
      std::remove_copy(p.begin(), p.begin() + 4, name.begin(), p[static_cast<std::size_t>(corner)]);
      std::sort(name.begin(), name.end());
      faces.push_back({ name, static_cast<int>(i), corner });
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

void HitTetrahedron(const Pieces& pieces, const TetrahedronFace& face, const skd::SegmentView& view,
  const SkdReach& reach, std::optional<SkdLineHit>& first)
{
  constexpr double ofCorners[4][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  skd::Vector3 corners[6];
  pieces.Gather(pieces.List[static_cast<std::size_t>(face.Tetrahedron)], corners);
  skd::Vector3 points[3];
  skd::Vector3 pcoords[3];
  for (int i = 0, corner = 0; corner < 4; ++corner)
  {
    if (corner != face.Opposite)
    {
      points[i] = corners[corner];
      const double* p = ofCorners[corner];
      pcoords[i++] = { { p[0], p[1], p[2] } };
    }
  }
  std::optional<SkdLineHit> hit;
  SkdHitFace(points, pcoords, 3, view, reach, hit);
  if (hit && (!first || hit->T < first->T))
  {
    first = hit;
    first->SubId = face.Tetrahedron;
  }
}

std::optional<SkdLineHit> HitConvexPointSet(
  vtkCell* cell, const skd::SegmentView& view, const SkdReach& reach)
{
  const Pieces& pieces = PiecesOf(cell);
  const std::vector<TetrahedronFace>& faces = FacesOf(pieces);
  std::optional<SkdLineHit> first;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const bool isShared = (i > 0 && faces[i - 1].Name == faces[i].Name) ||
      (i + 1 < faces.size() && faces[i + 1].Name == faces[i].Name);
    if (!isShared)
    {
      HitTetrahedron(pieces, faces[i], view, reach, first);
    }
  }
  return first;
}

//------------------------------------------------------------------------------
// Quadratic polygons: the corners come first, then what is between them.

int PlaceInTurn(int i, int size)
{
  return i % 2 == 0 ? i / 2 : size / 2 + i / 2;
}

SkdPolyCell PointsInTurn(vtkCell* cell)
{
  thread_local std::vector<skd::Vector3> points;
  const int size = static_cast<int>(cell->GetNumberOfPoints());
  points.resize(static_cast<std::size_t>(size));
  for (int i = 0; i < size; ++i)
  {
    cell->GetPoints()->GetPoint(PlaceInTurn(i, size), points[static_cast<std::size_t>(i)].X);
  }
  return { SkdShape::Polygon, points.data(), size, nullptr, nullptr };
}

void LocateInTurn(vtkCell* cell, SkdCellPoint& found, double* weights)
{
  thread_local std::vector<double> inTurn;
  const SkdPolyCell polygon = PointsInTurn(cell);
  inTurn.resize(static_cast<std::size_t>(polygon.Size));
  SkdPolyKernels::Locate(polygon, found, weights ? inTurn.data() : nullptr);
  for (int i = 0; weights && i < polygon.Size; ++i)
  {
    weights[PlaceInTurn(i, polygon.Size)] = inTurn[static_cast<std::size_t>(i)];
  }
}
}

//------------------------------------------------------------------------------
bool SkdPiecewiseKernel::Knows(int cellType)
{
  return cellType == VTK_CONVEX_POINT_SET || cellType == VTK_PENTAGONAL_PRISM ||
    cellType == VTK_HEXAGONAL_PRISM || cellType == VTK_QUADRATIC_POLYGON;
}

//------------------------------------------------------------------------------
SkdCellPoint SkdPiecewiseKernel::Closest(vtkCell* cell, const skd::Vector3& x)
{
  if (cell->GetCellType() == VTK_QUADRATIC_POLYGON)
  {
    return SkdPolyKernels::Closest(PointsInTurn(cell), x, Infinity);
  }
  const Pieces& pieces = PiecesOf(cell);
  const PiecePoint best = FindNearest(pieces, x);
  if (best.Index < 0)
  {
    return NearestPoint(pieces, x);
  }
  const skd::VolumePoint& nearest = best.Nearest;
  return { nearest.Point, nearest.PCoords, nearest.Dist2, 0, nearest.Dist2 == 0.0 };
}

//------------------------------------------------------------------------------
std::optional<SkdLineHit> SkdPiecewiseKernel::Intersect(
  vtkCell* cell, const skd::Segment<3>& segment, const SkdReach& reach)
{
  const skd::SegmentView view(segment);
  switch (cell->GetCellType())
  {
    case VTK_QUADRATIC_POLYGON:
      return SkdPolyKernels::Intersect(PointsInTurn(cell), view, reach);
    case VTK_CONVEX_POINT_SET:
      return HitConvexPointSet(cell, view, reach);
    default:
      return HitPrism(cell, view, reach);
  }
}

//------------------------------------------------------------------------------
void SkdPiecewiseKernel::Locate(vtkCell* cell, SkdCellPoint& found, double* weights)
{
  if (cell->GetCellType() == VTK_QUADRATIC_POLYGON)
  {
    LocateInTurn(cell, found, weights);
    return;
  }
  thread_local std::vector<double> spare;
  const Pieces& pieces = PiecesOf(cell);
  spare.resize(pieces.Points.size());
  double* target = weights ? weights : spare.data();
  std::fill_n(target, pieces.Points.size(), 0.0);
  const PiecePoint best = FindNearest(pieces, found.Point);
  if (best.Index < 0)
  {
    return;
  }
  WeighPiece(pieces.List[static_cast<std::size_t>(best.Index)], best.Nearest.PCoords, target);
  found.PCoords = PCoordsOf(cell, best.Nearest.PCoords, target);
  found.SubId = cell->GetCellType() == VTK_CONVEX_POINT_SET ? best.Index : 0;
}
