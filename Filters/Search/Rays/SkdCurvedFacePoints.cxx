// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Rays/SkdCurvedFacePoints.h"

#include "Cells/Curved/SkdCurvedFaces.h"
#include "Cells/Kernels/SkdParametricCell.h"
#include "Cells/Read/SkdCellReader.h"
#include "Cells/Search/SkdLocatorState.h"
#include "Pipeline/SkdBlocks.h"
#include "Search/Rays/SkdUnitVector.h"
#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkMath.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
using skd::Vector3;

/// How far off, towards the middle, normals are taken for a point where the face has none: where a
/// side is drawn together to a point. Those at this and half this distance are extrapolated.
constexpr double BesideDegenerate = 1e-4;
/// The sine of the angle between tangents below which there is no normal.
constexpr double LeastSine = 1e-6;

bool IsParametricFace(vtkCell* cell)
{
  const skd::ParameterDomain* domain = SkdParametricCell::DomainOf(cell->GetCellType());
  return domain && domain->Dimension == 2;
}

Vector3 MiddleOf(const SkdParametricCell& face)
{
  const bool isTriangle = face.Domain().Size == 3;
  return isTriangle ? Vector3{ { 1.0 / 3.0, 1.0 / 3.0, 0.0 } } : Vector3{ { 0.5, 0.5, 0.0 } };
}

Vector3 FirstPointOf(vtkCell* cell)
{
  Vector3 first;
  cell->GetPoints()->GetPoint(0, first.X);
  return first;
}

/// 0 where tangents are parallel, or there are none.
Vector3 NormalAt(const SkdParametricCell& face, const Vector3& p)
{
  Vector3 tangents[3];
  face.Tangents(p, tangents);
  const Vector3 across = skd::Cross(tangents[0], tangents[1]);
  const double length = skd::Norm(across);
  const double lengths[2] = { skd::Norm(tangents[0]), skd::Norm(tangents[1]) };
  const auto [least, most] = std::minmax(lengths[0], lengths[1]);
  const bool isThere = least > LeastSine * most && length > LeastSine * least * most;
  return isThere ? (1.0 / length) * across : Vector3{ { 0.0, 0.0, 0.0 } };
}

/// Of the corner of a face between its sides; of another point on a side or within the face half a
/// turn, or a whole one.
double AngleAt(const SkdParametricCell& face, const Vector3& p)
{
  const skd::ParameterDomain& domain = face.Domain();
  int sides = 0;
  for (int i = 0; i < domain.Size; ++i)
  {
    sides += std::abs(skd::Slack(domain.Sides[i], p)) < LeastSine ? 1 : 0;
  }
  if (sides < 2)
  {
    return sides == 1 ? vtkMath::Pi() : 2.0 * vtkMath::Pi();
  }
  Vector3 t[3];
  face.Tangents(p, t);
  Vector3 along[2] = { (p[0] < 0.5 ? 1.0 : -1.0) * t[0], (p[1] < 0.5 ? 1.0 : -1.0) * t[1] };
  if (domain.Size == 3 && p[0] > 0.5)
  {
    along[1] = t[1] - t[0];
  }
  if (domain.Size == 3 && p[1] > 0.5)
  {
    along[0] = t[0] - t[1];
  }
  return std::atan2(skd::Norm(skd::Cross(along[0], along[1])), skd::Dot(along[0], along[1]));
}

/// The parameters and all else are relative to the origin that the face has.
SkdCurvedFacePoint PointAt(
  const SkdParametricCell& face, const Vector3& origin, const Vector3& p, bool isInward)
{
  Vector3 normal = NormalAt(face, p);
  double angle = AngleAt(face, p);
  if (!(skd::Norm2(normal) > 0.0))
  {
    const Vector3 toMiddle = BesideDegenerate * (MiddleOf(face) - p);
    normal = SkdUnit(2.0 * NormalAt(face, p + 0.5 * toMiddle) - NormalAt(face, p + toMiddle));
    angle = vtkMath::Pi();
  }
  return { origin + face.Value(p), (isInward ? -1.0 : 1.0) * normal, angle };
}

/// The cell of the calling thread; nullptr unless it is a curved surface cell.
vtkCell* LoadFace(vtkDataSet* mesh, vtkIdType cell)
{
  const int type = mesh->GetCellType(cell);
  if (!SkdIsCurvedCellType(type) || SkdDimensionOfCellType(type) != 2)
  {
    return nullptr;
  }
  vtkGenericCell* scratch = SkdScratchCell();
  SkdLoadCell(mesh, cell, scratch);
  vtkCell* face = scratch->GetRepresentativeCell();
  return face->GetNumberOfPoints() > 0 && IsParametricFace(face) ? face : nullptr;
}

bool IsBezier(int type)
{
  return type >= VTK_BEZIER_CURVE && type <= VTK_BEZIER_PYRAMID;
}
}

//------------------------------------------------------------------------------
void SkdVisitCurvedFacePoints(
  vtkDataSet* mesh, const std::function<void(vtkIdType, const SkdCurvedFacePoint&)>& visit)
{
  SkdVisitFaces(mesh, SkdFindCurvedFaces(mesh),
    [&](const SkdCellFace&, vtkCell* cell, bool isInward)
    {
      if (!IsParametricFace(cell) || cell->GetNumberOfPoints() == 0)
      {
        return;
      }
      const Vector3 origin = FirstPointOf(cell);
      const SkdParametricCell face(cell, origin);
      for (int i = 0; i < face.NumberOfPoints(); ++i)
      {
        visit(cell->GetPointId(i), PointAt(face, origin, face.ParametersOfPoint(i), isInward));
      }
    });
}

std::optional<SkdCurvedFacePoint> SkdMiddleOfCurvedCell(vtkDataSet* mesh, vtkIdType cell)
{
  vtkCell* loaded = LoadFace(mesh, cell);
  if (!loaded)
  {
    return std::nullopt;
  }
  const Vector3 origin = FirstPointOf(loaded);
  const SkdParametricCell face(loaded, origin);
  return PointAt(face, origin, MiddleOf(face), false);
}

std::optional<SkdCurvedFacePoint> SkdNearestOnCurvedCell(
  vtkDataSet* mesh, vtkIdType cell, const Vector3& x)
{
  vtkCell* loaded = LoadFace(mesh, cell);
  if (!loaded)
  {
    return std::nullopt;
  }
  const Vector3 vtkParameters = SkdParametricKernel::Closest(loaded, x).PCoords;
  return PointAt(SkdParametricCell(loaded, x), x, vtkParameters, false);
}

void SkdPutControlPointsOnFaces(vtkDataSet* mesh, std::vector<Vector3>& points)
{
  bool hasControls = false;
  const vtkIdType cells = SkdHasCurvedCells(mesh) ? mesh->GetNumberOfCells() : 0;
  for (vtkIdType cell = 0; cell < cells && !hasControls; ++cell)
  {
    hasControls = IsBezier(mesh->GetCellType(cell));
  }
  if (!hasControls)
  {
    return;
  }
  std::vector<char> isPut(points.size(), 0);
  SkdVisitCurvedFacePoints(mesh,
    [&](vtkIdType id, const SkdCurvedFacePoint& onFace)
    {
      const auto point = static_cast<std::size_t>(id);
      if (!isPut[point])
      {
        points[point] = onFace.Point;
        isPut[point] = 1;
      }
    });
}
}
