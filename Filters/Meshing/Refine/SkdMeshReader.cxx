// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdMeshReader.h"

#include "Bodies/SkdWeld.h"
#include "Cells/Read/SkdCellReader.h"
#include "Cells/Read/SkdMagnitudes.h"
#include "Pipeline/SkdShownElements.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkNew.h"

#include <set>
#include <stdexcept>

namespace skdtree
{
namespace
{
using Nodes = std::vector<std::uint32_t>;

/// What a cell is, or Fixed.
skd::CellKind KindOf(int type)
{
  switch (type)
  {
    case VTK_LINE:
      return skd::CellKind::Line;
    case VTK_TRIANGLE:
    case VTK_TRIANGLE_STRIP:
      return skd::CellKind::Triangle;
    case VTK_QUAD:
    case VTK_PIXEL:
    case VTK_POLYGON:
      return skd::CellKind::Polygon;
    case VTK_TETRA:
      return skd::CellKind::Tetrahedron;
    case VTK_PYRAMID:
      return skd::CellKind::Pyramid;
    case VTK_WEDGE:
      return skd::CellKind::Wedge;
    case VTK_HEXAHEDRON:
    case VTK_VOXEL:
      return skd::CellKind::Hexahedron;
    default:
      return skd::CellKind::Fixed;
  }
}

std::size_t LeastSizeOf(skd::CellKind kind)
{
  switch (kind)
  {
    case skd::CellKind::Line:
      return 2;
    case skd::CellKind::Triangle:
    case skd::CellKind::Polygon:
      return 3;
    case skd::CellKind::Tetrahedron:
      return 4;
    case skd::CellKind::Pyramid:
      return 5;
    case skd::CellKind::Wedge:
      return 6;
    case skd::CellKind::Hexahedron:
      return 8;
    case skd::CellKind::Fixed:
      break;
  }
  return 0;
}

/// Adds the cells of one block.
class CellAdder
{
public:
  CellAdder(SkdReadMesh& read, const SkdReadMesh::Block& block)
    : Read(read)
    , Block(block)
    , Reader(block.Input.Mesh)
    , Shown(SkdFindShown(block.Input.Mesh, vtkDataObject::CELL))
  {
  }

  void Add(vtkIdType cell)
  {
    const int type = this->Reader.TypeOf(cell);
    const auto input = static_cast<std::uint32_t>(this->Block.FirstInput + cell);
    const skd::CellKind kind = KindOf(type);
    if (this->Shown[static_cast<std::size_t>(cell)] == 0)
    {
      return this->AddFixed(input, true);
    }
    if (kind == skd::CellKind::Fixed || !this->Gather(cell) || !this->IsFinite())
    {
      return this->AddFixed(input, type == VTK_VERTEX || type == VTK_POLY_VERTEX);
    }
    this->PutInOrder(type);
    if (type == VTK_TRIANGLE_STRIP)
    {
      return this->AddStrip(input);
    }
    this->AddOrFix(kind, input);
  }

private:
  /// False if a point does not exist.
  bool Gather(vtkIdType cell)
  {
    this->Nodes.clear();
    bool isSound = true;
    this->Reader.VisitPoints(cell, this->List,
      [&](const auto* ids, std::size_t size)
      {
        for (std::size_t i = 0; i < size; ++i)
        {
          const bool exists =
            ids[i] >= 0 && static_cast<std::size_t>(ids[i]) < this->Block.NodeOfPoint.size();
          isSound = isSound && exists;
          this->Nodes.push_back(
            exists ? this->Block.NodeOfPoint[static_cast<std::size_t>(ids[i])] : 0);
        }
      });
    return isSound;
  }

  bool IsFinite() const
  {
    return std::all_of(this->Nodes.begin(), this->Nodes.end(),
      [this](std::uint32_t node)
      { return SkdIsWithin(this->Read.Mesh.FlatPoint(node), SkdComparable.Largest); });
  }

  /// Pixels and voxels count along axes.
  void PutInOrder(int type)
  {
    if ((type == VTK_PIXEL && this->Nodes.size() == 4) ||
      (type == VTK_VOXEL && this->Nodes.size() == 8))
    {
      for (std::size_t i = 2; i < this->Nodes.size(); i += 4)
      {
        std::swap(this->Nodes[i], this->Nodes[i + 1]);
      }
    }
  }

  /// Of points and hidden cells nothing is to be told.
  void AddFixed(std::uint32_t input, bool isQuiet)
  {
    this->Read.Mesh.AddCell(skd::CellKind::Fixed, nullptr, 0, input, 0);
    this->Read.CellsNotRefinable += isQuiet ? 0 : 1;
  }

  /// Triangles that use a node twice, which is how strips go on elsewhere, are left out.
  void AddStrip(std::uint32_t input)
  {
    bool isAny = false;
    for (std::size_t i = 0; i + 2 < this->Nodes.size(); ++i)
    {
      const std::size_t parity = i % 2; // every other triangle goes around the other way
      const std::uint32_t t[3] = { this->Nodes[i], this->Nodes[i + 1 + parity],
        this->Nodes[i + 2 - parity] };
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
      {
        this->Read.Mesh.AddCell(skd::CellKind::Triangle, t, 3, input, 0);
        isAny = true;
      }
    }
    if (!isAny)
    {
      this->AddFixed(input, false);
    }
  }

  void AddOrFix(skd::CellKind kind, std::uint32_t input)
  {
    if (kind == skd::CellKind::Polygon)
    {
      this->DropRepeats();
    }
    const std::set<std::uint32_t> distinct(this->Nodes.begin(), this->Nodes.end());
    const std::size_t least = LeastSizeOf(kind);
    const bool isSized = kind == skd::CellKind::Polygon || this->Nodes.size() == least;
    if (!isSized || distinct.size() != this->Nodes.size() || distinct.size() < least)
    {
      return this->AddFixed(input, false);
    }
    const bool isTriangle = kind == skd::CellKind::Polygon && this->Nodes.size() == 3;
    this->Read.Mesh.AddCell(isTriangle ? skd::CellKind::Triangle : kind, this->Nodes.data(),
      static_cast<std::uint32_t>(this->Nodes.size()), input, 0);
  }

  /// Corners that are the one before once more: quads that end in a pole, say.
  void DropRepeats()
  {
    std::vector<std::uint32_t> used;
    for (const std::uint32_t node : this->Nodes)
    {
      if (used.empty() || used.back() != node)
      {
        used.push_back(node);
      }
    }
    while (used.size() > 1 && used.front() == used.back())
    {
      used.pop_back();
    }
    this->Nodes = used;
  }

  SkdReadMesh& Read;
  const SkdReadMesh::Block& Block;
  SkdCellReader Reader;
  std::vector<unsigned char> Shown;
  vtkNew<vtkIdList> List;
  std::vector<std::uint32_t> Nodes;
};

void CheckSizes(const std::vector<SkdBlock>& inputs)
{
  constexpr vtkIdType most = 0x7fffffff;
  vtkIdType cells = 0;
  for (const SkdBlock& input : inputs)
  {
    cells += input.Mesh->GetNumberOfCells();
  }
  if (cells > most || SkdCountPoints(inputs) > most)
  {
    throw std::length_error("there are more cells or points than 2^31");
  }
}
}

//------------------------------------------------------------------------------
void SkdReadBlocks(const std::vector<SkdBlock>& inputs,
  const std::vector<std::vector<unsigned char>>* counted, SkdReadMesh& read)
{
  CheckSizes(inputs);
  SkdWeld weld;
  std::uint32_t cellsBefore = 0;
  for (const SkdBlock& input : inputs)
  {
    SkdReadMesh::Block block;
    block.Input = input;
    block.FirstInput = cellsBefore;
    cellsBefore += static_cast<std::uint32_t>(input.Mesh->GetNumberOfCells());
    block.NodeOfPoint.resize(static_cast<std::size_t>(input.Mesh->GetNumberOfPoints()));
    for (std::size_t i = 0; i < block.NodeOfPoint.size(); ++i)
    {
      double x[3];
      input.Mesh->GetPoint(static_cast<vtkIdType>(i), x);
      block.NodeOfPoint[i] = static_cast<std::uint32_t>(weld.GetId(x));
      if (block.NodeOfPoint[i] == read.Mesh.NumberOfNodes())
      {
        read.Mesh.AddNode({ { x[0], x[1], x[2] } });
      }
    }
    read.Blocks.push_back(std::move(block));
  }
  read.NumberOfPointNodes = read.Mesh.NumberOfNodes();
  const std::vector<unsigned char> all;
  for (std::size_t i = 0; i < read.Blocks.size(); ++i)
  {
    SkdReadMesh::Block& block = read.Blocks[i];
    block.FirstCell = read.Mesh.NumberOfCells();
    CellAdder adder(read, block);
    const std::vector<unsigned char>& counts = counted ? (*counted)[i] : all;
    for (vtkIdType cell = 0; cell < block.Input.Mesh->GetNumberOfCells(); ++cell)
    {
      if (counts.empty() || counts[static_cast<std::size_t>(cell)] != 0)
      {
        adder.Add(cell);
      }
    }
    block.LastCell = read.Mesh.NumberOfCells();
  }
}
}
