// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdMeshOutput.h"

#include "Cells/Read/SkdCellReader.h"
#include "Cells/Read/SkdForEach.h"
#include "Meshing/Refine/SkdBlockPoints.h"
#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdMakeArray.h"
#include "Pipeline/SkdShownElements.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <set>

namespace skdtree
{
namespace
{
using Cell = skd::RefinedMesh::Cell;

/// A cell of the output.
struct Part
{
  std::uint32_t Cell; // of the refined mesh
  int Type;
  bool IsWhole; // it is the input's cell, as it was
};

int TypeOf(const Cell& cell)
{
  switch (cell.Kind)
  {
    case skd::CellKind::Line:
      return VTK_LINE;
    case skd::CellKind::Triangle:
      return VTK_TRIANGLE;
    case skd::CellKind::Polygon:
      return cell.Size == 4 ? VTK_QUAD : VTK_POLYGON;
    case skd::CellKind::Tetrahedron:
      return VTK_TETRA;
    case skd::CellKind::Pyramid:
      return VTK_PYRAMID;
    case skd::CellKind::Wedge:
      return VTK_WEDGE;
    case skd::CellKind::Hexahedron:
      return VTK_HEXAHEDRON;
    case skd::CellKind::Fixed:
      break;
  }
  return VTK_EMPTY_CELL;
}

/// Where vtkPolyData has cells of a type: vertices, lines, polygons, strips.
int KindOfPolyData(int type)
{
  switch (type)
  {
    case VTK_VERTEX:
    case VTK_POLY_VERTEX:
      return 0;
    case VTK_LINE:
    case VTK_POLY_LINE:
      return 1;
    case VTK_TRIANGLE_STRIP:
      return 3;
    default:
      return 2;
  }
}

/// Writes one block.
class BlockWriter
{
public:
  BlockWriter(const SkdReadMesh& read, const SkdReadMesh::Block& block)
    : Read(read)
    , Block(block)
    , Input(block.Input.Mesh)
    , Reader(block.Input.Mesh)
    , Points(read, block)
    , Shown(SkdFindShown(block.Input.Mesh, vtkDataObject::CELL))
  {
    for (std::uint32_t cell = block.FirstCell; cell < block.LastCell; ++cell)
    {
      this->ListLeavesOf(cell, this->InputOf(cell));
    }
  }

  void WriteCells(vtkPolyData* output)
  {
    std::stable_sort(this->Parts.begin(), this->Parts.end(),
      [](const Part& a, const Part& b) { return KindOfPolyData(a.Type) < KindOfPolyData(b.Type); });
    vtkNew<vtkCellArray> kinds[4];
    for (const Part& part : this->Parts)
    {
      const std::vector<vtkIdType>& ids = this->IdsOf(part);
      kinds[KindOfPolyData(part.Type)]->InsertNextCell(
        static_cast<vtkIdType>(ids.size()), ids.data());
    }
    output->SetVerts(kinds[0]);
    output->SetLines(kinds[1]);
    output->SetPolys(kinds[2]);
    output->SetStrips(kinds[3]);
  }

  void WriteCells(vtkUnstructuredGrid* output)
  {
    auto grid = vtkUnstructuredGrid::SafeDownCast(this->Input);
    vtkNew<vtkIdList> faces;
    output->Allocate(static_cast<vtkIdType>(this->Parts.size()));
    for (const Part& part : this->Parts)
    {
      if (grid && part.Type == VTK_POLYHEDRON)
      {
        grid->GetFaceStream(this->InputOf(part.Cell), faces);
        output->InsertNextCell(part.Type, faces);
        continue;
      }
      const std::vector<vtkIdType>& ids = this->IdsOf(part);
      output->InsertNextCell(part.Type, static_cast<vtkIdType>(ids.size()), ids.data());
    }
  }

  /// Once cells are written.
  void WritePoints(int precision, vtkPointSet* output) const
  {
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto shaped = vtkPointSet::SafeDownCast(this->Input);
    const int own = shaped && shaped->GetPoints() ? shaped->GetPoints()->GetDataType() : VTK_DOUBLE;
    points->SetDataType(precision == vtkAlgorithm::DOUBLE_PRECISION ? VTK_DOUBLE
        : precision == vtkAlgorithm::SINGLE_PRECISION               ? VTK_FLOAT
                                                                    : own);
    points->SetNumberOfPoints(this->Points.GetNumberOfPoints());
    const vtkIdType old = this->Points.GetNumberOfOldPoints();
    for (vtkIdType i = 0; i < old; ++i)
    {
      double x[3];
      this->Input->GetPoint(i, x);
      points->SetPoint(i, x);
    }
    for (vtkIdType i = old; i < this->Points.GetNumberOfPoints(); ++i)
    {
      points->SetPoint(i, this->Read.Mesh.Point(this->NodeOf(i)).X);
    }
    output->SetPoints(points);
  }

  void WritePointData(const skd::HangingNodes& hanging, vtkPointData* target) const;
  void WriteCellData(vtkCellData* target) const;

private:
  vtkIdType InputOf(std::uint32_t cell) const
  {
    return static_cast<vtkIdType>(this->Read.Mesh[cell].Input - this->Block.FirstInput);
  }
  std::uint32_t NodeOf(vtkIdType newPoint) const
  {
    return this->Points.GetNode(
      static_cast<std::size_t>(newPoint - this->Points.GetNumberOfOldPoints()));
  }

  /// Cells that are hidden by their points, too, have no type in a grid of listed cells.
  int TypeOfInput(vtkIdType cell) const
  {
    const bool isShown = this->Shown[static_cast<std::size_t>(cell)] != 0;
    return isShown || !SkdIsStructured(this->Input) ? this->Reader.TypeOf(cell) : VTK_EMPTY_CELL;
  }

  void ListLeavesOf(std::uint32_t cell, vtkIdType input)
  {
    const Cell& at = this->Read.Mesh[cell];
    for (std::uint32_t i = 0; i < at.Children; ++i)
    {
      this->ListLeavesOf(at.FirstChild + i, input);
    }
    if (at.IsLeaf())
    {
      const int inputType = this->TypeOfInput(input);
      const bool isStrip = inputType == VTK_TRIANGLE_STRIP && at.Size > 0;
      const bool isWhole = cell < this->Block.LastCell && !isStrip;
      this->Parts.push_back({ cell, isWhole ? inputType : TypeOf(at), isWhole });
    }
  }

  /// The points of the input's cell.
  const std::vector<vtkIdType>& InputIdsOf(vtkIdType input)
  {
    if (input != this->InputIdsAre)
    {
      this->InputIdsAre = input;
      this->InputIds.clear();
      this->Reader.VisitPoints(input, this->List,
        [this](const auto* ids, std::size_t size)
        { this->InputIds.insert(this->InputIds.end(), ids, ids + size); });
    }
    return this->InputIds;
  }

  const std::vector<vtkIdType>& IdsOf(const Part& part)
  {
    const std::vector<vtkIdType>& before = this->InputIdsOf(this->InputOf(part.Cell));
    if (part.IsWhole)
    {
      return before;
    }
    this->Points.SetCell(before);
    this->Ids.clear();
    for (const std::uint32_t node : this->Read.Mesh.NodesOf(part.Cell))
    {
      this->Ids.push_back(this->Points.IdOf(node));
    }
    return this->Ids;
  }

  const SkdReadMesh& Read;
  const SkdReadMesh::Block& Block;
  vtkDataSet* Input;
  SkdCellReader Reader;
  SkdBlockPoints Points;
  std::vector<unsigned char> Shown; // of the input's cells
  std::vector<Part> Parts;
  vtkNew<vtkIdList> List;
  vtkIdType InputIdsAre = -1;
  std::vector<vtkIdType> InputIds;
  std::vector<vtkIdType> Ids;
};

/// The arrays that are active in one become so in the other, where it has them.
void CopyActive(vtkDataSetAttributes* from, vtkDataSetAttributes* to)
{
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    vtkAbstractArray* active = from->GetAbstractAttribute(type);
    const bool isOfIds =
      type == vtkDataSetAttributes::GLOBALIDS || type == vtkDataSetAttributes::PEDIGREEIDS;
    if (active && active->GetName() && !isOfIds && to->HasArray(active->GetName()))
    {
      to->SetActiveAttribute(active->GetName(), type);
    }
  }
}

vtkSmartPointer<vtkUnsignedCharArray> MakeGhosts(vtkDataSetAttributes* from, vtkIdType n)
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  return vtkUnsignedCharArray::SafeDownCast(from->GetArray(name))
    ? SkdMakeArray<vtkUnsignedCharArray>(name, 1, n)
    : nullptr;
}

//------------------------------------------------------------------------------
void BlockWriter::WritePointData(const skd::HangingNodes& hanging, vtkPointData* target) const
{
  const vtkIdType n = this->Points.GetNumberOfPoints();
  const vtkIdType old = this->Points.GetNumberOfOldPoints();
  std::set<std::string> refused;
  SkdArrayGather gather =
    SkdGatherInto(target, n, { this->Block.Input }, vtkDataObject::POINT, refused);
  auto marks = SkdMakeArray<vtkUnsignedCharArray>(SkdMeshArrays::HangingName, 1, n, 0.0);
  vtkPointData* source = this->Input->GetPointData();
  auto ghosts = MakeGhosts(source, n);
  auto oldGhosts =
    vtkUnsignedCharArray::SafeDownCast(source->GetArray(vtkDataSetAttributes::GhostArrayName()));
  vtkSMPTools::For(0, n,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkNew<vtkIdList> ids;
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (i < old)
        {
          gather.Take(i, 0, i);
          if (ghosts)
          {
            ghosts->SetValue(i, oldGhosts->GetValue(i));
          }
          continue;
        }
        SkdBlockPoints::Recipe recipe = this->Points.GetRecipe(static_cast<std::size_t>(i - old));
        ids->SetNumberOfIds(static_cast<vtkIdType>(recipe.Ids.size()));
        std::copy(recipe.Ids.begin(), recipe.Ids.end(), ids->GetPointer(0));
        gather.Interpolate(i, 0, ids, recipe.Weights.data());
        marks->SetValue(i, hanging[this->NodeOf(i)]);
        unsigned char ghost = 0xff;
        for (const vtkIdType id : recipe.Ids)
        {
          ghost = static_cast<unsigned char>(ghost & (ghosts ? oldGhosts->GetValue(id) : 0));
        }
        if (ghosts)
        {
          ghosts->SetValue(i, ghost);
        }
      }
    });
  if (ghosts)
  {
    target->AddArray(ghosts);
  }
  target->AddArray(marks);
  CopyActive(source, target);
}

void BlockWriter::WriteCellData(vtkCellData* target) const
{
  const auto n = static_cast<vtkIdType>(this->Parts.size());
  std::set<std::string> refused;
  SkdArrayGather gather =
    SkdGatherInto(target, n, { this->Block.Input }, vtkDataObject::CELL, refused);
  auto parents = SkdMakeArray<vtkIdTypeArray>(SkdMeshArrays::ParentName, 1, n);
  auto levels = SkdMakeArray<vtkUnsignedCharArray>(SkdMeshArrays::LevelName, 1, n);
  vtkCellData* source = this->Input->GetCellData();
  auto ghosts = MakeGhosts(source, n);
  auto oldGhosts =
    vtkUnsignedCharArray::SafeDownCast(source->GetArray(vtkDataSetAttributes::GhostArrayName()));
  SkdForEach(n,
    [&](vtkIdType i)
    {
      const Part& part = this->Parts[static_cast<std::size_t>(i)];
      const vtkIdType parent = this->InputOf(part.Cell);
      gather.Take(i, 0, parent);
      parents->SetValue(i, parent);
      levels->SetValue(i, static_cast<unsigned char>(this->Read.Mesh[part.Cell].Level()));
      if (ghosts)
      {
        ghosts->SetValue(i, oldGhosts->GetValue(parent));
      }
    });
  if (ghosts)
  {
    target->AddArray(ghosts);
  }
  target->AddArray(parents);
  target->AddArray(levels);
  CopyActive(source, target);
  if (!target->GetScalars())
  {
    target->SetActiveScalars(SkdMeshArrays::LevelName);
  }
}
}

//------------------------------------------------------------------------------
int SkdRefinedTypeOf(vtkDataSet* mesh)
{
  return vtkPolyData::SafeDownCast(mesh) ? VTK_POLY_DATA : VTK_UNSTRUCTURED_GRID;
}

void SkdWriteBlock(const SkdReadMesh& read, const SkdReadMesh::Block& block,
  const skd::HangingNodes& hanging, int precision, vtkPointSet* output)
{
  BlockWriter writer(read, block);
  if (auto surface = vtkPolyData::SafeDownCast(output))
  {
    writer.WriteCells(surface);
  }
  else
  {
    writer.WriteCells(vtkUnstructuredGrid::SafeDownCast(output));
  }
  writer.WritePoints(precision, output);
  writer.WritePointData(hanging, output->GetPointData());
  writer.WriteCellData(output->GetCellData());
  output->GetFieldData()->PassData(block.Input.Mesh->GetFieldData());
}
}
