// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Curved/SkdCurvedFaces.h"

#include "Cells/Read/SkdCellReader.h"
#include "Core/Geometry/Vector.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGridBase.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

namespace skdtree
{
namespace
{
using DimensionTable = std::array<unsigned char, VTK_NUMBER_OF_CELL_TYPES>;

DimensionTable MakeDimensionTable()
{
  DimensionTable table{};
  for (int type = 0; type < VTK_NUMBER_OF_CELL_TYPES; ++type)
  {
    const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
    table[static_cast<std::size_t>(type)] =
      static_cast<unsigned char>(cell ? cell->GetCellDimension() : 0);
  }
  return table;
}

/// The points of a cell that a face has.
using FacePoints = std::vector<vtkIdType>;

/// The faces of volume cells by the indices of their points in the cell: the same for all cells of
/// a type, number of points and degrees, so VTK's cell is queried once for each.
class FaceTable
{
public:
  explicit FaceTable(vtkDataSet* mesh)
    : Mesh(mesh)
    , Degrees(mesh->GetCellData()->GetHigherOrderDegrees())
  {
  }

  const std::vector<FacePoints>& FacesOf(vtkIdType cellId, int type, std::size_t size)
  {
    std::vector<int> key = { type, static_cast<int>(size) };
    for (int i = 0; this->Degrees && i < this->Degrees->GetNumberOfComponents(); ++i)
    {
      key.push_back(static_cast<int>(this->Degrees->GetComponent(cellId, i)));
    }
    if (key != this->LastKey)
    {
      auto found = this->Tables.find(key);
      if (found == this->Tables.end())
      {
        found = this->Tables.emplace(key, this->Read(cellId)).first;
      }
      this->Last = &found->second;
      this->LastKey = key;
    }
    return *this->Last;
  }

private:
  std::vector<FacePoints> Read(vtkIdType cellId)
  {
    SkdLoadCell(this->Mesh, cellId, this->Scratch);
    vtkIdList* ids = this->Scratch->GetPointIds();
    std::iota(ids->begin(), ids->end(), vtkIdType(0));
    std::vector<FacePoints> faces;
    for (int i = 0; i < this->Scratch->GetNumberOfFaces(); ++i)
    {
      vtkIdList* points = this->Scratch->GetFace(i)->GetPointIds();
      faces.emplace_back(points->begin(), points->end());
    }
    return faces;
  }

  vtkDataSet* Mesh;
  vtkDataArray* Degrees; // of Lagrange and Bezier cells, where they differ by direction
  vtkNew<vtkGenericCell> Scratch;
  std::map<std::vector<int>, std::vector<FacePoints>> Tables; // which does not move what it holds
  std::vector<int> LastKey;
  const std::vector<FacePoints>* Last = nullptr;
};

skd::Vector3 PointOf(vtkCell* cell, vtkIdType i)
{
  skd::Vector3 point;
  cell->GetPoints()->GetPoint(i, point.X);
  return point;
}

skd::Vector3 MiddleOf(vtkCell* cell)
{
  skd::Vector3 sum{};
  const vtkIdType size = cell->GetNumberOfPoints();
  for (vtkIdType i = 0; i < size; ++i)
  {
    sum = sum + PointOf(cell, i);
  }
  return (1.0 / static_cast<double>(size)) * sum;
}

/// By the corners of the face, which come first, and where the cell's points are.
bool IsInward(vtkCell* face, vtkCell* cell)
{
  const bool isTriangle = face->GetNumberOfEdges() == 3;
  const skd::Vector3 a = PointOf(face, 0);
  const skd::Vector3 b = PointOf(face, 1);
  const skd::Vector3 c = PointOf(face, 2);
  const skd::Vector3 normal = skd::Cross(c - a, isTriangle ? c - b : PointOf(face, 3) - b);
  return skd::Dot(normal, MiddleOf(face) - MiddleOf(cell)) < 0.0;
}
}

//------------------------------------------------------------------------------
int SkdDimensionOfCellType(int cellType)
{
  static const DimensionTable table = MakeDimensionTable();
  const bool isKnown = cellType >= 0 && cellType < VTK_NUMBER_OF_CELL_TYPES;
  return isKnown ? table[static_cast<std::size_t>(cellType)] : 0;
}

bool SkdIsCurvedCellType(int cellType)
{
  return (cellType >= VTK_QUADRATIC_EDGE && cellType <= VTK_TRIQUADRATIC_PYRAMID) ||
    (cellType >= VTK_LAGRANGE_CURVE && cellType <= VTK_BEZIER_PYRAMID);
}

// Not by vtkCellTypes: its methods differ between versions of VTK, and some print a warning.
bool SkdHasCurvedCells(vtkDataSet* mesh)
{
  if (!vtkUnstructuredGridBase::SafeDownCast(mesh))
  {
    return false;
  }
  const SkdCellReader reader(mesh);
  const vtkIdType size = mesh->GetNumberOfCells();
  for (vtkIdType id = 0; id < size; ++id)
  {
    if (SkdIsCurvedCellType(reader.TypeOf(id)))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
std::vector<SkdCellFace> SkdFindCurvedFaces(vtkDataSet* mesh)
{
  constexpr int hidden = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;
  vtkUnsignedCharArray* ghosts = mesh->GetCellGhostArray();
  const SkdCellReader reader(mesh);
  vtkNew<vtkIdList> list;
  FaceTable table(mesh);
  SkdFaceList volumes;
  std::vector<SkdCellFace> found;
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
  {
    const int type = reader.TypeOf(id);
    const int mark = ghosts ? ghosts->GetValue(id) : 0;
    if (!SkdIsCurvedCellType(type) || (mark & hidden))
    {
      continue;
    }
    const int dimension = SkdDimensionOfCellType(type);
    if (dimension == 2 && mark == 0)
    {
      found.push_back({ id, -1 });
    }
    if (dimension == 3)
    {
      reader.VisitPoints(id, list,
        [&](const auto* ids, std::size_t size)
        {
          int face = 0;
          for (FacePoints points : table.FacesOf(id, type, size))
          {
            std::transform(points.begin(), points.end(), points.begin(),
              [ids](vtkIdType corner) { return static_cast<vtkIdType>(ids[corner]); });
            volumes.Add({ id, face++ }, points.begin(), points.end(), mark != 0);
          }
        });
    }
  }
  const std::vector<SkdCellFace> outer = volumes.TakeOuter();
  const auto cells = static_cast<std::ptrdiff_t>(found.size());
  found.insert(found.end(), outer.begin(), outer.end());
  std::inplace_merge(found.begin(), found.begin() + cells, found.end());
  return found;
}

//------------------------------------------------------------------------------
void SkdVisitFaces(vtkDataSet* mesh, const std::vector<SkdCellFace>& faces,
  const std::function<void(const SkdCellFace&, vtkCell*, bool)>& visit)
{
  vtkNew<vtkGenericCell> scratch;
  vtkIdType loaded = -1;
  for (const SkdCellFace& face : faces)
  {
    if (face.CellId != loaded)
    {
      SkdLoadCell(mesh, face.CellId, scratch);
      loaded = face.CellId;
    }
    vtkCell* cell = scratch->GetRepresentativeCell();
    vtkCell* part = face.Face < 0 ? cell : scratch->GetFace(face.Face);
    visit(face, part, part != cell && IsInward(part, cell));
  }
}
}
