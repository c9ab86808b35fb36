// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Kernels/SkdPiecewiseKernel.h"

#include "Cells/Kernels/SkdKernels.h"
#include "Cells/Kernels/SkdPolyKernels.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace skdtree
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// A wedge by its points' indices in the cell.
using Piece = std::array<std::size_t, 6>;

struct Pieces
{
  std::vector<skd::Vector3> Points;
  std::vector<Piece> List;

  void Gather(const Piece& piece, skd::Vector3* points) const
  {
    std::transform(
      piece.begin(), piece.end(), points, [this](std::size_t i) { return this->Points[i]; });
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
  const std::size_t n = pieces.Points.size() / 2;
  for (std::size_t i = 1; i + 1 < n; ++i)
  {
    pieces.List.push_back({ 0, i, i + 1, n, n + i, n + i + 1 });
  }
}

const Pieces& PiecesOf(vtkCell* cell)
{
  Pieces& pieces = EmptyPieces(cell);
  AddWedges(pieces);
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
    const skd::VolumePoint found = skd::ClosestPointInCell<skd::Wedge>(points, x, limit2);
    if (found.Dist2 < limit2)
    {
      best = { found, static_cast<int>(i) };
    }
  }
  return best;
}

/// Where no piece can be looked at its points are what is certain.
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
  skd::Wedge::Weights(pcoords, local);
  for (std::size_t i = 0; i < piece.size(); ++i)
  {
    weights[piece[i]] += local[i];
  }
}

/// Those that its points have, weighed as they are.
skd::Vector3 PCoordsOf(vtkCell* cell, const double* weights)
{
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
  vtkCell* cell, const skd::SegmentView& view, const SkdHitTolerance& hitTolerance)
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
    SkdHitFace(points, pcoords, size, view, hitTolerance, first);
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
// Quadratic polygons: the corners come first, then what is between them.

int CyclicIndex(int i, int size)
{
  return i % 2 == 0 ? i / 2 : size / 2 + i / 2;
}

SkdPolyCell PointsInCyclicOrder(vtkCell* cell)
{
  thread_local std::vector<skd::Vector3> points;
  const int size = static_cast<int>(cell->GetNumberOfPoints());
  points.resize(static_cast<std::size_t>(size));
  for (int i = 0; i < size; ++i)
  {
    cell->GetPoints()->GetPoint(CyclicIndex(i, size), points[static_cast<std::size_t>(i)].X);
  }
  return { SkdShape::Polygon, points.data(), size, nullptr, nullptr };
}

void LocateInCyclicOrder(vtkCell* cell, SkdCellPoint& found, double* weights)
{
  thread_local std::vector<double> sorted;
  const SkdPolyCell polygon = PointsInCyclicOrder(cell);
  sorted.resize(static_cast<std::size_t>(polygon.Size));
  SkdPolyKernels::Locate(polygon, found, weights ? sorted.data() : nullptr);
  for (int i = 0; weights && i < polygon.Size; ++i)
  {
    weights[CyclicIndex(i, polygon.Size)] = sorted[static_cast<std::size_t>(i)];
  }
}
}

//------------------------------------------------------------------------------
bool SkdPiecewiseKernel::Knows(int cellType)
{
  return cellType == VTK_PENTAGONAL_PRISM || cellType == VTK_HEXAGONAL_PRISM ||
    cellType == VTK_QUADRATIC_POLYGON;
}

//------------------------------------------------------------------------------
SkdCellPoint SkdPiecewiseKernel::Closest(vtkCell* cell, const skd::Vector3& x)
{
  if (cell->GetCellType() == VTK_QUADRATIC_POLYGON)
  {
    return SkdPolyKernels::Closest(PointsInCyclicOrder(cell), x, Infinity);
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
  vtkCell* cell, const skd::Segment<3>& segment, const SkdHitTolerance& hitTolerance)
{
  const skd::SegmentView view(segment);
  return cell->GetCellType() == VTK_QUADRATIC_POLYGON
    ? SkdPolyKernels::Intersect(PointsInCyclicOrder(cell), view, hitTolerance)
    : HitPrism(cell, view, hitTolerance);
}

//------------------------------------------------------------------------------
void SkdPiecewiseKernel::Locate(vtkCell* cell, SkdCellPoint& found, double* weights)
{
  if (cell->GetCellType() == VTK_QUADRATIC_POLYGON)
  {
    LocateInCyclicOrder(cell, found, weights);
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
  found.PCoords = PCoordsOf(cell, target);
  found.SubId = 0;
}
}
