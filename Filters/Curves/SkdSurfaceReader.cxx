// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/SkdSurfaceReader.h"

#include "Bodies/SkdInnerFaces.h"
#include "Bodies/SkdPieceSurfaces.h"
#include "Cells/Curved/SkdBezierCell.h"
#include "Cells/Curved/SkdCurvedFaces.h"
#include "Cells/Read/SkdFaceList.h"
#include "Core/Geometry/Polygons/ConvexHull.h"
#include "Pipeline/SkdQueryPoints.h"
#include "Pipeline/SkdReport.h"
#include "Pipeline/SkdShownElements.h"
#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"

#include <algorithm>
#include <array>

namespace skdtree
{
namespace
{
skd::Vector3 PointOf(vtkCell* cell, vtkIdType i)
{
  skd::Vector3 point;
  cell->GetPoints()->GetPoint(i, point.X);
  return point;
}

bool IsFiniteCell(vtkCell* cell)
{
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    if (!skd::IsFinite(PointOf(cell, i)))
    {
      return false;
    }
  }
  return true;
}

/// Flat to within rounding: the fourth corner is in the plane of the others.
bool IsFlat(const skd::Vector3 (&p)[4])
{
  const skd::Vector3 normal = skd::Cross(p[2] - p[0], p[3] - p[1]);
  double largest = 0.0;
  for (const skd::Vector3& point : p)
  {
    largest = std::max({ largest, std::abs(point[0]), std::abs(point[1]), std::abs(point[2]) });
  }
  const double rounding = 8.0 * std::numeric_limits<double>::epsilon() * largest;
  return std::abs(skd::Dot(normal, p[1] - p[0])) <= rounding * skd::Norm(normal);
}

/// The faces of a convex point set: the triangles of its hull. VTK's cell has none at hand. A flat
/// one has none, nor has one with points that are not finite, nor no cell.
class HullOfCell
{
public:
  explicit HullOfCell(vtkCell* cell)
    : Cell(cell)
  {
    std::vector<skd::Vector3> points;
    for (vtkIdType i = 0; cell && i < cell->GetNumberOfPoints(); ++i)
    {
      points.push_back(PointOf(cell, i));
    }
    if (cell && IsFiniteCell(cell))
    {
      this->Triangles = skd::ConvexHullOf(points.data(), points.size()).Triangles;
    }
  }

  int GetNumberOfFaces() const { return static_cast<int>(this->Triangles.size()); }

  std::array<vtkIdType, 3> PointsOf(int face) const
  {
    const auto& corners = this->Triangles[static_cast<std::size_t>(face)];
    return { this->Cell->GetPointId(corners[0]), this->Cell->GetPointId(corners[1]),
      this->Cell->GetPointId(corners[2]) };
  }

  std::array<skd::Vector3, 3> CornersOf(int face) const
  {
    const auto& corners = this->Triangles[static_cast<std::size_t>(face)];
    return { PointOf(this->Cell, corners[0]), PointOf(this->Cell, corners[1]),
      PointOf(this->Cell, corners[2]) };
  }

private:
  vtkCell* Cell;
  std::vector<skd::ConvexHull::Triangle> Triangles;
};

/// The volume cells that count.
std::vector<vtkIdType> VolumesOf(vtkDataSet* mesh)
{
  const std::vector<unsigned char> counted = SkdFindCounted(mesh);
  std::vector<vtkIdType> volumes;
  for (vtkIdType cellId = 0; cellId < mesh->GetNumberOfCells(); ++cellId)
  {
    if (counted[static_cast<std::size_t>(cellId)] != 0 &&
      SkdDimensionOfCellType(mesh->GetCellType(cellId)) == 3)
    {
      volumes.push_back(cellId);
    }
  }
  return volumes;
}

/// The faces of volume cells that no other one of the data set has.
std::vector<SkdCellFace> OuterFacesOf(vtkDataSet* mesh)
{
  SkdFaceList faces;
  for (const vtkIdType cellId : VolumesOf(mesh))
  {
    vtkCell* cell = mesh->GetCell(cellId);
    const bool isHull = cell->GetCellType() == VTK_CONVEX_POINT_SET;
    const HullOfCell hull(isHull ? cell : nullptr);
    for (int i = 0; i < hull.GetNumberOfFaces(); ++i)
    {
      const auto points = hull.PointsOf(i);
      faces.Add({ cellId, i }, points.begin(), points.end());
    }
    for (int i = 0; !isHull && i < cell->GetNumberOfFaces(); ++i)
    {
      vtkIdList* points = cell->GetFace(i)->GetPointIds();
      faces.Add({ cellId, i }, points->begin(), points->end());
    }
  }
  return faces.TakeOuter();
}

std::vector<skd::Vector3> PointsOf(vtkDataSet* mesh, const SkdCellFace& face)
{
  vtkCell* cell = mesh->GetCell(face.CellId);
  std::vector<skd::Vector3> points;
  if (cell->GetCellType() == VTK_CONVEX_POINT_SET)
  {
    const auto corners = HullOfCell(cell).CornersOf(face.Face);
    points.assign(corners.begin(), corners.end());
    return points;
  }
  vtkCell* side = cell->GetFace(face.Face);
  for (vtkIdType i = 0; i < side->GetNumberOfPoints(); ++i)
  {
    points.push_back(PointOf(side, i));
  }
  return points;
}
}

//------------------------------------------------------------------------------
void SkdSurfaceReader::FindOuterFaces(const std::vector<SkdBlock>& blocks)
{
  for (const std::vector<std::size_t>& mesh : SkdPiecesOfMeshes(blocks))
  {
    std::vector<vtkDataSet*> pieces;
    for (const std::size_t i : mesh)
    {
      pieces.push_back(blocks[i].Mesh);
    }
    SkdInnerFaces inner(pieces);
    std::vector<std::pair<int, SkdCellFace>> faces;
    for (std::size_t piece = 0; piece < mesh.size(); ++piece)
    {
      const SkdQueryPoints middles(pieces[piece], SkdQueryPoints::At::Middles);
      for (const SkdCellFace& face : OuterFacesOf(pieces[piece]))
      {
        skd::Vector3 middle;
        middles.GetPoint(face.CellId, middle.X);
        inner.Add(piece, PointsOf(pieces[piece], face), middle);
        faces.emplace_back(static_cast<int>(mesh[piece]), face);
      }
    }
    const std::vector<unsigned char> isInner = inner.Find();
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      std::vector<SkdCellFace>& ofBlock = this->OuterFaces[faces[i].first];
      if (isInner[i] == 0)
      {
        ofBlock.push_back(faces[i].second);
      }
    }
  }
}

//------------------------------------------------------------------------------
void SkdSurfaceReader::Read(vtkDataSet* mesh, int block)
{
  this->Block = block;
  const std::vector<unsigned char> counted = SkdFindCounted(mesh);
  bool hasVolumes = false;
  for (vtkIdType cellId = 0; cellId < mesh->GetNumberOfCells(); ++cellId)
  {
    if (counted[static_cast<std::size_t>(cellId)] == 0 ||
      mesh->GetCellType(cellId) == VTK_EMPTY_CELL)
    {
      continue;
    }
    vtkCell* cell = mesh->GetCell(cellId);
    if (cell->GetCellDimension() == 3 && this->WithVolumes)
    {
      hasVolumes = true;
    }
    else if (cell->GetCellDimension() != 2)
    {
      ++this->NotSurfaces;
    }
    else
    {
      this->CellId = cellId;
      this->IsWhole = true;
      this->AddCell(cell);
    }
  }
  if (hasVolumes)
  {
    this->ReadFaces(mesh);
  }
}

//------------------------------------------------------------------------------
void SkdSurfaceReader::ReadFaces(vtkDataSet* mesh)
{
  const auto known = this->OuterFaces.find(this->Block);
  const std::vector<SkdCellFace> faces =
    known != this->OuterFaces.end() ? std::move(known->second) : OuterFacesOf(mesh);
  this->IsWhole = false;
  for (const auto& [cellId, face] : faces)
  {
    this->CellId = cellId;
    vtkCell* cell = mesh->GetCell(cellId);
    if (cell->GetCellType() == VTK_CONVEX_POINT_SET)
    {
      const auto [a, b, c] = HullOfCell(cell).CornersOf(face);
      this->AddTriangle(a, b, c);
    }
    else
    {
      this->AddCell(cell->GetFace(face));
    }
  }
}

//------------------------------------------------------------------------------
template <class CornerOf>
void SkdSurfaceReader::AddPolygon(vtkIdType size, const CornerOf& cornerOf)
{
  const bool wasWhole = std::exchange(this->IsWhole, false);
  vtkIdList* cut = this->Triangulation.Cut(size, cornerOf);
  for (vtkIdType i = 0; i + 2 < cut->GetNumberOfIds(); i += 3)
  {
    this->AddTriangle(
      cornerOf(cut->GetId(i)), cornerOf(cut->GetId(i + 1)), cornerOf(cut->GetId(i + 2)));
  }
  this->IsWhole = wasWhole;
}

//------------------------------------------------------------------------------
void SkdSurfaceReader::AddCell(vtkCell* cell)
{
  if (!IsFiniteCell(cell))
  {
    ++this->NotFinite;
    return;
  }
  switch (cell->GetCellType())
  {
    case VTK_TRIANGLE:
      this->AddTriangle(PointOf(cell, 0), PointOf(cell, 1), PointOf(cell, 2));
      return;
    case VTK_QUAD:
      this->AddQuad({ PointOf(cell, 0), PointOf(cell, 1), PointOf(cell, 2), PointOf(cell, 3) });
      return;
    case VTK_PIXEL:
      this->AddQuad({ PointOf(cell, 0), PointOf(cell, 1), PointOf(cell, 3), PointOf(cell, 2) });
      return;
    case VTK_TRIANGLE_STRIP:
      this->AddStrip(cell);
      return;
    case VTK_POLYGON:
      this->AddPolygon(cell->GetNumberOfPoints(), [&](vtkIdType i) { return PointOf(cell, i); });
      return;
    default:
      this->AddNative(cell);
  }
}

//------------------------------------------------------------------------------
void SkdSurfaceReader::AddTriangle(
  const skd::Vector3& a, const skd::Vector3& b, const skd::Vector3& c)
{
  this->Elements.push_back(
    { this->Corners.size(), this->CellId, this->Block, 1, 1, false, true, this->IsWhole });
  this->Corners.insert(this->Corners.end(), { a, b, c });
}

//------------------------------------------------------------------------------
void SkdSurfaceReader::AddPatch(const skd::BezierPatch& patch, const skd::Vector3& origin)
{
  this->Elements.push_back(
    { this->Controls.size(), this->CellId, this->Block, static_cast<std::uint8_t>(patch.DegreeR),
      static_cast<std::uint8_t>(patch.DegreeS), true, patch.IsTriangle, this->IsWhole });
  this->Controls.push_back(skd::Weighted(origin, 1.0));
  this->Controls.insert(this->Controls.end(), patch.Points, patch.Points + patch.Size());
}

//------------------------------------------------------------------------------
// Cut as a polygon is, when it is flat: the cut goes inside, also of one that is not convex.
void SkdSurfaceReader::AddQuad(const skd::Vector3 (&corners)[4])
{
  if (!IsFlat(corners))
  {
    skd::BezierPatch patch;
    for (int i = 0; i < 4; ++i)
    {
      const int order[4] = { 0, 1, 3, 2 };
      patch.Points[order[i]] = skd::Weighted(corners[i], 1.0);
    }
    this->AddPatch(patch, skd::Vector3{}); // seen from 0: the very coordinates decide at its edges
    return;
  }
  this->AddPolygon(4, [&](vtkIdType i) { return corners[i]; });
}

//------------------------------------------------------------------------------
void SkdSurfaceReader::AddStrip(vtkCell* cell)
{
  const bool wasWhole = std::exchange(this->IsWhole, false);
  for (vtkIdType i = 0; i + 2 < cell->GetNumberOfPoints(); ++i)
  {
    this->AddTriangle(PointOf(cell, i), PointOf(cell, i + 1 + i % 2), PointOf(cell, i + 2 - i % 2));
  }
  this->IsWhole = wasWhole;
}

//------------------------------------------------------------------------------
void SkdSurfaceReader::AddNative(vtkCell* cell)
{
  const auto read = SkdReadBezierPatch(cell);
  switch (read.Fault)
  {
    case SkdBezierFault::None:
      this->AddPatch(read.Form, read.Origin);
      return;
    case SkdBezierFault::Weight:
      ++this->BadWeights;
      return;
    case SkdBezierFault::Degree:
      ++this->TooHigh;
      return;
    default:
      ++this->NotSurfaces;
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> SkdSurfaceReader::GetFaults() const
{
  return SkdFaultsOf({ { this->NotSurfaces, " cells are not surfaces" },
    { this->NotFinite, " surface cells have points that are not finite" },
    { this->BadWeights, " surface cells have a weight that is not positive" },
    { this->TooHigh, " surface cells have a degree above 10" } });
}
}
