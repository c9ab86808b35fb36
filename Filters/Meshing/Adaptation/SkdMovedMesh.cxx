// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Adaptation/SkdMovedMesh.h"

#include "Bodies/SkdWeld.h"
#include "Cells/Read/SkdCellReader.h"
#include "Cells/Read/SkdMagnitudes.h"
#include "Pipeline/SkdMakeArray.h"
#include "Pipeline/SkdShownElements.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace skdtree
{
namespace
{
constexpr std::uint32_t None = skd::MeshEdge::None;

enum class Use
{
  Moves,
  Follows, // points and lines, and what is hidden: what they do does not matter
  Holds
};

Use UseOf(int type)
{
  switch (type)
  {
    case VTK_TRIANGLE:
    case VTK_QUAD:
    case VTK_PIXEL:
    case VTK_POLYGON:
      return Use::Moves;
    case VTK_EMPTY_CELL:
    case VTK_VERTEX:
    case VTK_POLY_VERTEX:
    case VTK_LINE:
    case VTK_POLY_LINE:
      return Use::Follows;
    default:
      return Use::Holds;
  }
}

/// A new order of things, and where each of them is then.
struct Order
{
  template <class Less>
  Order(std::size_t size, const Less& less)
    : Old(size)
    , New(size)
  {
    std::iota(this->Old.begin(), this->Old.end(), 0u);
    std::sort(this->Old.begin(), this->Old.end(), less);
    for (std::size_t i = 0; i < size; ++i)
    {
      this->New[this->Old[i]] = static_cast<std::uint32_t>(i);
    }
  }

  void Renumber(std::vector<std::uint32_t>& numbers) const
  {
    for (std::uint32_t& number : numbers)
    {
      number = number == None ? None : this->New[number];
    }
  }

  std::vector<std::uint32_t> Old; // by new number
  std::vector<std::uint32_t> New; // by old number
};

/// Of rows, by what is in them.
Order OrderOf(const skd::IndexRows& rows)
{
  return { rows.size(),
    [&rows](std::uint32_t a, std::uint32_t b)
    {
      const skd::IndexRows::Row first = rows[a];
      const skd::IndexRows::Row second = rows[b];
      return std::lexicographical_compare(first.begin(), first.end(), second.begin(), second.end());
    } };
}
}

/// Reads block after block; those without points of their own have nothing to move.
class SkdMovedMesh::Reader
{
public:
  explicit Reader(SkdMovedMesh& to)
    : To(to)
  {
  }

  void Read(vtkDataSet* mesh)
  {
    this->Data = mesh;
    this->Meshes.push_back(mesh);
    this->To.Blocks.emplace_back();
    Block& block = this->To.Blocks.back();
    block.NodeOfPoint.assign(static_cast<std::size_t>(mesh->GetNumberOfPoints()), None);
    block.CellOfCell.assign(static_cast<std::size_t>(mesh->GetNumberOfCells()), None);
    if (!vtkPointSet::SafeDownCast(mesh))
    {
      return;
    }
    const std::vector<unsigned char> shown = SkdFindShown(mesh, vtkDataObject::CELL);
    const SkdCellReader reader(mesh);
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      const int type = reader.TypeOf(cell);
      const Use use = shown[static_cast<std::size_t>(cell)] != 0 ? UseOf(type) : Use::Follows;
      if (use != Use::Follows)
      {
        this->Gather(reader, cell, type);
        this->Add(static_cast<std::size_t>(cell), use == Use::Moves && this->IsSound());
      }
    }
  }

  /// Once all is read.
  void Finish()
  {
    this->LetPointsFollow();
    std::copy_n(
      this->Weld.GetPoints().begin(), this->To.Mesh.Points.size(), this->To.Mesh.Points.begin());
    this->SortPoints();
    this->SortCells();
    this->To.Mesh.FindEdges();
    for (const std::uint32_t node : this->Held)
    {
      this->To.Mesh.Freedom[node] = skd::PointFreedom::Fixed;
    }
  }

private:
  /// Points that were dropped, and those of lines and hidden cells, go with the node where they
  /// are, if any.
  void LetPointsFollow()
  {
    const auto nodes = static_cast<vtkIdType>(this->Weld.GetPoints().size());
    for (std::size_t i = 0; i < this->Meshes.size(); ++i)
    {
      std::vector<std::uint32_t>& nodeOf = this->To.Blocks[i].NodeOfPoint;
      for (std::size_t point = 0; point < nodeOf.size(); ++point)
      {
        const vtkIdType node =
          this->Weld.GetId(this->Meshes[i]->GetPoint(static_cast<vtkIdType>(point)));
        nodeOf[point] = node < nodes ? static_cast<std::uint32_t>(node) : None;
      }
    }
    this->To.Mesh.Points.resize(static_cast<std::size_t>(nodes));
  }

  // Steps of the solver end early, and what is left depends on the order of points and cells, by
  // some 1e-5 of a cell, which later steps enlarge. With this order Input may have any: its pieces
  // may come from any processes.
  void SortPoints()
  {
    const std::vector<skd::Vector3> points = this->To.Mesh.Points;
    const Order order(
      points.size(), [&points](std::uint32_t a, std::uint32_t b) { return points[a] < points[b]; });
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      this->To.Mesh.Points[i] = points[order.Old[i]];
    }
    for (Block& block : this->To.Blocks)
    {
      order.Renumber(block.NodeOfPoint);
    }
    order.Renumber(this->Held);
    this->CopyCells(
      [](std::size_t cell) { return cell; }, [&](std::uint32_t node) { return order.New[node]; });
  }

  void SortCells()
  {
    const Order order = OrderOf(this->To.Mesh.Cells);
    for (Block& block : this->To.Blocks)
    {
      order.Renumber(block.CellOfCell);
    }
    this->CopyCells(
      [&](std::size_t cell) { return order.Old[cell]; }, [](std::uint32_t node) { return node; });
  }

  template <class OldCell, class NewNode>
  void CopyCells(const OldCell& oldCell, const NewNode& newNode)
  {
    const skd::IndexRows cells = std::exchange(this->To.Mesh.Cells, skd::IndexRows());
    std::vector<std::uint32_t> nodes;
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
    {
      const skd::IndexRows::Row row = cells[oldCell(cell)];
      nodes.resize(row.size());
      std::transform(row.begin(), row.end(), nodes.begin(), newNode);
      this->To.Mesh.Cells.Add(nodes.begin(), nodes.end());
    }
  }

  /// The points of a cell.
  void Gather(const SkdCellReader& reader, vtkIdType cell, int type)
  {
    this->Ids.clear();
    reader.VisitPoints(cell, this->List,
      [&](const auto* ids, std::size_t size)
      {
        for (std::size_t i = 0; i < size; ++i)
        {
          this->Ids.push_back(static_cast<vtkIdType>(ids[i]));
        }
      });
    if (type == VTK_PIXEL && this->Ids.size() == 4)
    {
      std::swap(this->Ids[2], this->Ids[3]);
    }
    this->Finite = true;
    this->Positions.clear();
    for (const vtkIdType id : this->Ids)
    {
      this->Positions.emplace_back();
      this->Data->GetPoint(id, this->Positions.back().X);
      this->Finite = this->Finite && SkdIsWithin(this->Positions.back(), SkdMeasurable.Largest);
    }
  }

  /// Whether the points make a polygon, once those that repeat the next are dropped.
  bool IsSound()
  {
    std::vector<vtkIdType> ids;
    std::vector<skd::Vector3> positions;
    for (std::size_t i = 0; i < this->Ids.size(); ++i)
    {
      const std::size_t next = (i + 1) % this->Ids.size();
      if (!(this->Positions[i] == this->Positions[next]))
      {
        ids.push_back(this->Ids[i]);
        positions.push_back(this->Positions[i]);
      }
    }
    this->Ids = ids;
    this->Positions = positions;
    const std::set<skd::Vector3> distinct(positions.begin(), positions.end());
    return this->Finite && ids.size() >= 3 && distinct.size() == ids.size();
  }

  void Add(std::size_t cell, bool doesMove)
  {
    Block& block = this->To.Blocks.back();
    std::vector<std::uint32_t> nodes;
    for (std::size_t i = 0; i < this->Ids.size() && this->Finite; ++i)
    {
      nodes.push_back(static_cast<std::uint32_t>(this->Weld.GetId(this->Positions[i].X)));
    }
    if (doesMove)
    {
      block.CellOfCell[cell] = static_cast<std::uint32_t>(this->To.Mesh.Cells.size());
      this->To.Mesh.Cells.Add(nodes.begin(), nodes.end());
      return;
    }
    ++this->To.CellsLeftOut;
    this->Held.insert(this->Held.end(), nodes.begin(), nodes.end());
  }

  SkdMovedMesh& To;
  std::vector<vtkDataSet*> Meshes;
  vtkDataSet* Data = nullptr;
  SkdWeld Weld;
  vtkNew<vtkIdList> List;
  std::vector<vtkIdType> Ids;
  std::vector<skd::Vector3> Positions;
  std::vector<std::uint32_t> Held;
  bool Finite = true;
};

//------------------------------------------------------------------------------
SkdMovedMesh::SkdMovedMesh(const std::vector<SkdBlock>& blocks)
{
  Reader reader(*this);
  for (const SkdBlock& block : blocks)
  {
    reader.Read(block.Mesh);
    this->Blocks.back().Index = block.BlockIndex;
  }
  reader.Finish();
}

vtkSmartPointer<vtkPolyData> SkdMovedMesh::MakePolyData(const skd::Vector3& origin) const
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(this->Mesh.Points.size()));
  for (std::size_t i = 0; i < this->Mesh.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), (this->Mesh.Points[i] - origin).X);
  }
  vtkNew<vtkCellArray> cells;
  for (std::size_t cell = 0; cell < this->Mesh.Cells.size(); ++cell)
  {
    const skd::IndexRows::Row corners = this->Mesh.Cells[cell];
    cells->InsertNextCell(static_cast<int>(corners.size()));
    for (const std::uint32_t corner : corners)
    {
      cells->InsertCellPoint(static_cast<vtkIdType>(corner));
    }
  }
  auto made = vtkSmartPointer<vtkPolyData>::New();
  made->SetPoints(points);
  made->SetPolys(cells);
  return made;
}

std::string SkdMovedMesh::NameOf(std::uint32_t cell) const
{
  for (std::size_t i = 0; i < this->Blocks.size(); ++i)
  {
    const std::vector<std::uint32_t>& cells = this->Blocks[i].CellOfCell;
    const auto at = std::find(cells.begin(), cells.end(), cell);
    if (at != cells.end())
    {
      const std::string name = "cell " + std::to_string(at - cells.begin());
      return this->Blocks.size() > 1 ? name + " of block " + std::to_string(this->Blocks[i].Index)
                                     : name;
    }
  }
  return "a cell";
}

void SkdMovedMesh::SetPoints(std::size_t block, vtkPointSet* output) const
{
  const vtkIdType n = output->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(n);
  const auto moves = SkdMakeArray<vtkDoubleArray>("SkdDisplacement", 3, n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const std::uint32_t node = this->Blocks[block].NodeOfPoint[static_cast<std::size_t>(i)];
    skd::Vector3 was;
    output->GetPoint(i, was.X);
    const skd::Vector3 is = node == None ? was : this->Mesh.Points[node];
    points->SetPoint(i, is.X);
    const skd::Vector3 nothing{ { 0.0, 0.0, 0.0 } };
    const skd::Vector3 move = node == None ? nothing : is - was;
    moves->SetTuple(i, move.X);
  }
  output->SetPoints(points);
  output->GetPointData()->AddArray(moves);
}

void SkdMovedMesh::AddCellArray(
  std::size_t block, vtkDataSet* output, const char* name, const std::vector<double>& values) const
{
  const vtkIdType n = output->GetNumberOfCells();
  const auto array = SkdMakeArray<vtkDoubleArray>(name, 1, n, vtkMath::Nan());
  for (vtkIdType i = 0; i < n; ++i)
  {
    const std::uint32_t cell = this->Blocks[block].CellOfCell[static_cast<std::size_t>(i)];
    if (cell != None && cell < values.size())
    {
      array->SetValue(i, values[cell]);
    }
  }
  output->GetCellData()->AddArray(array);
}
}
