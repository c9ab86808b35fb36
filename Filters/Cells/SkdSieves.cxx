// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/SkdSieves.h"

#include "Core/Geometry/CellFaces.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <vector>

namespace
{
using Node = skd::Node<3>;

skd::Raster RasterOf(const Node& bottom)
{
  skd::FloatBox<3> box = bottom.Boxes.Get(0);
  for (int lane = 1; lane < bottom.Count; ++lane)
  {
    skd::Enclose(box, bottom.Boxes.Get(lane));
  }
  return skd::Raster(box);
}

/// The corners of a cell on a raster, and a direction out of each of its faces.
struct Faceted
{
  std::vector<skd::Vector3> Points;
  std::vector<skd::Vector3> Directions;

  void Clear()
  {
    this->Points.clear();
    this->Directions.clear();
  }

  template <class Shape>
  void AddFaces()
  {
    for (int face = 0; face < Shape::NumberOfFaces; ++face)
    {
      this->AddOutward(
        skd::FaceNormal<Shape>(this->Points.data(), face), this->Points[Shape::Faces[face][0]]);
    }
  }

  void AddFaces(const skd::PolyhedronView& cell)
  {
    for (const std::uint32_t* at = cell.Faces; at != cell.End; at += 1 + *at)
    {
      const std::uint32_t* ids = at + 1;
      const skd::Vector3& first = this->Points[ids[0]];
      skd::Vector3 sum{ { 0.0, 0.0, 0.0 } };
      for (std::uint32_t i = 2; i < *at; ++i)
      {
        sum = sum + skd::Cross(this->Points[ids[i - 1]] - first, this->Points[ids[i]] - first);
      }
      this->AddOutward(sum, first);
    }
  }

private:
  /// Faces may be ordered either way: outward is where fewer of the cell is.
  void AddOutward(const skd::Vector3& normal, const skd::Vector3& onFace)
  {
    double above = 0.0;
    double below = 0.0;
    for (const skd::Vector3& point : this->Points)
    {
      const double height = skd::Dot(normal, point - onFace);
      above = std::max(above, height);
      below = std::max(below, -height);
    }
    this->Directions.push_back(above > below ? -1.0 * normal : normal);
  }
};

/// Calls visit(shape) with a linear volume cell that may be turned; a voxel's box says it all.
template <class Visit>
void VisitVolume(SkdShape shape, Visit visit)
{
  switch (shape)
  {
    case SkdShape::Tetrahedron:
      visit(skd::Tetrahedron());
      return;
    case SkdShape::Hexahedron:
      visit(skd::Hexahedron());
      return;
    case SkdShape::Wedge:
      visit(skd::Wedge());
      return;
    case SkdShape::Pyramid:
      visit(skd::Pyramid());
      return;
    default:
      return;
  }
}

int NumberOfPlanes(const SkdCellStore& store, std::uint32_t cell)
{
  constexpr int enough = 16;
  int count = 0;
  if (store.ShapeOf(cell) == SkdShape::Polyhedron)
  {
    const skd::PolyhedronView view = store.GatherPoly(cell).AsPolyhedron();
    for (const std::uint32_t* at = view.Faces; at != view.End; at += 1 + *at)
    {
      ++count;
    }
  }
  VisitVolume(store.ShapeOf(cell), [&](auto shape) { count = shape.NumberOfFaces; });
  return std::min(count, enough);
}

void AddFaces(const SkdCellStore& store, std::uint32_t cell, Faceted& faceted)
{
  if (store.ShapeOf(cell) == SkdShape::Polyhedron)
  {
    faceted.AddFaces(store.GatherPoly(cell).AsPolyhedron());
  }
  VisitVolume(store.ShapeOf(cell), [&](auto shape) { faceted.AddFaces<decltype(shape)>(); });
}
}

//------------------------------------------------------------------------------
SkdSieves::SkdSieves(const SkdCellStore& store, skd::Tree<3>& tree, double rounding)
{
  this->Number(store, tree);
  vtkSMPTools::For(0, static_cast<vtkIdType>(tree.NumberOfNodes()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i)
      {
        const Node& node = tree.Open(i);
        if (skd::TrianglePacks::Has(node))
        {
          this->FillTriangles(store, tree, node);
        }
        else if (HasPlanes(node))
        {
          tree.SetNote(i, this->FillPlanes(store, tree, node, rounding));
        }
      }
    });
}

//------------------------------------------------------------------------------
void SkdSieves::Number(const SkdCellStore& store, skd::Tree<3>& tree)
{
  std::uint32_t packs = 0;
  std::uint32_t rows = 0;
  for (std::uint32_t i = 0; i < tree.NumberOfNodes(); ++i)
  {
    const Node& node = tree.Open(i);
    int least = std::numeric_limits<int>::max();
    int most = 0;
    std::uint32_t triangles = 0;
    for (std::uint32_t lane = 0; node.IsBottom && lane < node.Count; ++lane)
    {
      const std::uint32_t cell = tree.Element(node.First + lane);
      const int planes = NumberOfPlanes(store, cell);
      least = std::min(least, planes);
      most = std::max(most, planes);
      triangles += store.ShapeOf(cell) == SkdShape::Triangle ? 1 : 0;
    }
    if (triangles > 0 && triangles == node.Count)
    {
      tree.SetTag(i, skd::TrianglePacks::TagOf(packs++));
    }
    else if (most > 0 && least > 0 && rows < Node::NoTag / 4)
    {
      tree.SetTag(i, 2 * rows + 1);
      rows += static_cast<std::uint32_t>(most);
    }
  }
  this->Triangles.resize(packs);
  this->Rows.resize(rows);
}

//------------------------------------------------------------------------------
void SkdSieves::FillTriangles(
  const SkdCellStore& store, const skd::Tree<3>& tree, const Node& bottom)
{
  skd::TrianglePack& pack = this->Triangles[bottom.Tag >> 1];
  pack = {};
  pack.Raster = RasterOf(bottom);
  for (int lane = 0; lane < bottom.Count; ++lane)
  {
    const std::uint32_t* ids =
      store.PointIdsOf(tree.Element(bottom.First + static_cast<std::uint32_t>(lane)));
    for (int corner = 0; corner < 3; ++corner)
    {
      const skd::Vector3 world = store.Point(ids[corner]);
      pack.Set(corner, lane, tree.GetFrame().Local(world));
    }
  }
}

//------------------------------------------------------------------------------
SkdSieves::PlaneNote SkdSieves::FillPlanes(
  const SkdCellStore& store, const skd::Tree<3>& tree, const Node& bottom, double rounding)
{
  skd::PlaneRow* rows = this->Rows.data() + (bottom.Tag >> 1);
  PlaneNote note{ RasterOf(bottom), 0 };
  const skd::Frame<3>& frame = tree.GetFrame();
  const double margin = rounding * frame.Scale / note.Raster.Unit + skd::PlaneRow::Rounding;
  thread_local Faceted faceted;
  for (int lane = 0; lane < bottom.Count; ++lane)
  {
    const std::uint32_t cell = tree.Element(bottom.First + static_cast<std::uint32_t>(lane));
    const auto count = static_cast<std::uint32_t>(NumberOfPlanes(store, cell));
    faceted.Clear();
    for (std::uint32_t i = 0; i < store.SizeOf(cell); ++i)
    {
      const skd::Vector3 world = store.Point(store.PointIdsOf(cell)[i]);
      faceted.Points.push_back(note.Raster.Of(frame.Local(world)));
    }
    AddFaces(store, cell, faceted);
    for (; note.Count < count; ++note.Count)
    {
      rows[note.Count] = {};
    }
    for (std::uint32_t i = 0; i < count; ++i)
    {
      rows[i].Set(lane, faceted.Directions[i], faceted.Points.data(),
        static_cast<int>(faceted.Points.size()), margin);
    }
  }
  return note;
}

//------------------------------------------------------------------------------
std::size_t SkdSieves::MemorySize() const
{
  return this->Triangles.capacity() * sizeof(skd::TrianglePack) +
    this->Rows.capacity() * sizeof(skd::PlaneRow);
}
