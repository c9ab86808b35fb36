// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/HarmedMeshes.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkSkdTreeVersion.h"

#include <cmath>
#include <limits>
#include <optional>

namespace skdtest
{

namespace
{
constexpr std::size_t Harmed = 3; // the cell that is harmed; of offsets also the next

bool HasFreeSize(int type)
{
  return type == VTK_POLY_VERTEX || type == VTK_POLY_LINE || type == VTK_POLYGON ||
    type == VTK_TRIANGLE_STRIP || type == VTK_CONVEX_POINT_SET;
}

/// Of two points or more.
bool IsCurve(int type)
{
  return type == VTK_POLY_LINE || type == VTK_LAGRANGE_CURVE || type == VTK_BEZIER_CURVE;
}

/// Of a polyhedron these are its faces.
bool ChangePoints(CellSpec& cell, Harm harm, vtkIdType numberOfPoints)
{
  const bool isPolyhedron = cell.Type == VTK_POLYHEDRON;
  switch (harm)
  {
    case Harm::TooFewPoints:
      if (isPolyhedron)
      {
        cell.Points = { 1, 3, cell.Points[2], cell.Points[3], cell.Points[4] };
        return true;
      }
      cell.Points.resize(HasFreeSize(cell.Type) ? 2 : cell.Points.size() - 1);
      if (IsCurve(cell.Type) || cell.Type == VTK_POLY_VERTEX)
      {
        cell.Points.resize(cell.Type == VTK_POLY_VERTEX ? 0 : 1);
      }
      return true;
    case Harm::TooManyPoints:
      cell.Points.push_back(cell.Points.front());
      return !HasFreeSize(cell.Type) && !isPolyhedron && !IsCurve(cell.Type) &&
        cell.Type != VTK_LAGRANGE_TRIANGLE && cell.Type != VTK_BEZIER_TRIANGLE; // 7 are right
    case Harm::IdTooLarge:
      cell.Points.back() = numberOfPoints + 1000000000;
      return true;
    case Harm::IdNegative:
      cell.Points.back() = -1000000000;
      return true;
    case Harm::FacesOfOthers:
      return isPolyhedron;
    case Harm::FacesMissing:
      return isPolyhedron && !VTK_SKD_FACES_ARE_CELLS;
    default:
      return true;
  }
}

void Move(Mesh& mesh, Harm harm)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto map = [&](const std::function<Point(const Point&)>& where) { mesh.Map(where); };
  switch (harm)
  {
    case Harm::NaN:
      mesh.Points[Harmed * mesh.Points.size() / 8][1] = std::nan("");
      return;
    case Harm::Infinite:
      mesh.Points[Harmed * mesh.Points.size() / 8][2] = -infinity;
      return;
    case Harm::Far:
      return map([](const Point& p) { return p + Point{ 1e15, -2e15, 3e15 }; });
    case Harm::Tiny:
      return map([](const Point& p) { return 1e-160 * p; });
    case Harm::Huge:
      return map([](const Point& p) { return 1e150 * p; });
    case Harm::Flat:
      return map([](const Point& p) { return Point{ p[0], p[1], 0.25 }; });
    case Harm::OnePoint:
      return map([](const Point&) { return Point{ 1, 2, 3 }; });
    default:
      return;
  }
}

void ChangeOffsets(vtkCellArray* cells, Harm harm)
{
  if (harm == Harm::OffsetTooLarge || harm == Harm::OffsetDecreases)
  {
    cells->ConvertTo64BitStorage();
    auto* offsets = vtkAOSDataArrayTemplate<vtkTypeInt64>::FastDownCast(cells->GetOffsetsArray());
    offsets->SetValue(
      Harmed + 1, harm == Harm::OffsetDecreases ? -1000000000000 : 1000000000000000);
  }
}

#if VTK_SKD_FACES_ARE_CELLS
void ChangeFaces(vtkUnstructuredGrid* grid, Harm harm)
{
  if (harm == Harm::FacesOfOthers)
  {
    vtkNew<vtkIdList> ids;
    vtkNew<vtkIdList> faces;
    grid->GetPolyhedronFaceLocations()->GetCellAtId(Harmed, faces);
    grid->GetPolyhedronFaces()->GetCellAtId(faces->GetId(1), ids);
    ids->SetId(0, 0);
    grid->GetPolyhedronFaces()->ReplaceCellAtId(faces->GetId(1), ids);
  }
}
#else
void ChangeFaces(vtkUnstructuredGrid* grid, Harm harm)
{
  const bool isMissing = harm == Harm::FacesMissing;
  if (harm == Harm::FacesOfOthers || isMissing)
  {
    const vtkIdType first = grid->GetFaceLocations()->GetValue(Harmed);
    grid->GetFaces()->SetValue(first + (isMissing ? 0 : 3), isMissing ? 1000000 : 0);
  }
}
#endif

std::optional<Mesh> HarmedCells(int type, Harm harm, int order)
{
  Mesh mesh = Block(ReferenceCell(type, order), Unmoved);
  CellSpec& cell = mesh.Cells[Harmed];
  if ((type == VTK_EMPTY_CELL && IsBroken(harm)) ||
    !ChangePoints(cell, harm, static_cast<vtkIdType>(mesh.Points.size())))
  {
    return std::nullopt;
  }
  Move(mesh, harm);
  return mesh;
}

Mesh CellsWithoutHarmed(int type, Harm harm, int order)
{
  Mesh mesh = Block(ReferenceCell(type, order), Unmoved);
  mesh.Cells[Harmed].Points.clear();
  if (harm == Harm::OffsetTooLarge || harm == Harm::OffsetDecreases)
  {
    mesh.Cells[Harmed + 1].Points.clear();
  }
  return mesh;
}
}

std::string NameOf(Harm harm)
{
  constexpr const char* names[NumberOfHarms] = { "None", "TooFewPoints", "TooManyPoints",
    "IdTooLarge", "IdNegative", "OffsetTooLarge", "OffsetDecreases", "FacesOfOthers",
    "FacesMissing", "NaN", "Infinite", "Far", "Tiny", "Huge", "Flat", "OnePoint" };
  return names[static_cast<int>(harm)];
}

bool IsBroken(Harm harm)
{
  return harm > Harm::None && harm < Harm::NaN;
}

GridPointer MakeHarmed(int type, Harm harm, int order)
{
  const std::optional<Mesh> mesh = HarmedCells(type, harm, order);
  if (!mesh)
  {
    return nullptr;
  }
  GridPointer grid = MakeGrid(*mesh);
  ChangeOffsets(grid->GetCells(), harm);
  ChangeFaces(grid, harm);
  return grid;
}

GridPointer MakeWithoutHarmed(int type, Harm harm, int order)
{
  Mesh mesh = CellsWithoutHarmed(type, harm, order);
  for (CellSpec& cell : mesh.Cells)
  {
    cell.Type = cell.Points.empty() ? VTK_EMPTY_CELL : cell.Type;
  }
  return MakeGrid(mesh);
}

PolyDataPointer MakeHarmedPolyData(int type, Harm harm, bool ids32)
{
  const std::optional<Mesh> mesh = HarmedCells(type, harm, 1);
  if (!mesh || (harm == Harm::TooFewPoints && mesh->Cells[Harmed].Points.empty()))
  {
    return nullptr;
  }
  PolyDataPointer made = MakePolyData(*mesh, VTK_DOUBLE, ids32);
  for (vtkCellArray* cells :
    { made->GetVerts(), made->GetLines(), made->GetPolys(), made->GetStrips() })
  {
    if (cells->GetNumberOfCells() > 0)
    {
      ChangeOffsets(cells, harm);
    }
  }
  return made;
}

PolyDataPointer MakePolyDataWithoutHarmed(int type, Harm harm)
{
  return MakePolyData(CellsWithoutHarmed(type, harm, 1));
}

}
