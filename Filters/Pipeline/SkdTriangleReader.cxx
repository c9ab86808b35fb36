// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdTriangleReader.h"

#include "Pipeline/SkdLeafSurface.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
/// Lowers `least` to the width of a triangle: the area along the axis where it is largest, over the
/// length of two edges. 0 where that cannot be told.
void TakeWidth(const skd::Vector3& a, const skd::Vector3& b, const skd::Vector3& c, double& least)
{
  const skd::Vector3 ab = b - a;
  const skd::Vector3 ac = c - a;
  const skd::Vector3 normal = skd::Cross(ab, ac);
  const double area = std::max({ std::abs(normal[0]), std::abs(normal[1]), std::abs(normal[2]) });
  const double length = std::abs(ab[0]) + std::abs(ab[1]) + std::abs(ab[2]) + std::abs(ac[0]) +
    std::abs(ac[1]) + std::abs(ac[2]);
  if (!(area >= least * length)) // also of NaN
  {
    const double width = area / length;
    least = width > 0.0 ? width : 0.0;
  }
}
}

SkdTriangleReader::SkdTriangleReader()
  : Triangulation(this->Local)
{
  this->Local->SetDataTypeToDouble();
}

//------------------------------------------------------------------------------
void SkdTriangleReader::Read(int leaf, vtkDataSet* mesh)
{
  const SkdLeafSurface surface(mesh);
  this->MakeRoom(surface);
  surface.ForEachFace(
    [&](vtkIdType face, vtkIdType size, const vtkIdType* corners)
    {
      const SkdTriangleCell cell{ leaf, surface.GetCellId(face) };
      if (size == 3)
      {
        Corners ids{ Unknown, Unknown, Unknown };
        for (int i = 0; i < 3 && (i == 0 || ids[i - 1] != NotFinite); ++i)
        {
          ids[i] = this->IdOf(leaf, surface, corners[i]);
        }
        this->AddTriangle(cell, ids);
        return;
      }
      const auto idOf = [&](vtkIdType corner)
      {
        const std::uint32_t id = this->IdOf(leaf, surface, corner);
        return id == NotFinite ? vtkIdType(-1) : static_cast<vtkIdType>(id);
      };
      this->Polygon.clear();
      SkdAppendCorners(size, corners, idOf, this->Polygon,
        [this](vtkIdType a, vtkIdType b)
        { return this->AreSame(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)); });
      this->AddPolygon(cell);
    });
}

//------------------------------------------------------------------------------
void SkdTriangleReader::MakeRoom(const SkdLeafSurface& surface)
{
  const auto points = static_cast<std::size_t>(surface.Get()->GetNumberOfPoints());
  const auto faces = static_cast<std::size_t>(
    surface.Get()->GetNumberOfPolys() + surface.Get()->GetNumberOfStrips());
  this->Ids.assign(points, Unknown);
  this->To.Points.reserve(this->To.Points.size() + points);
  this->To.Origins.reserve(this->To.Origins.size() + points);
  this->To.Triangles.reserve(this->To.Triangles.size() + faces);
  this->To.Cells.reserve(this->To.Cells.size() + faces);
  this->To.CellOf.reserve(this->To.CellOf.size() + faces);
}

//------------------------------------------------------------------------------
std::uint32_t SkdTriangleReader::IdOf(int leaf, const SkdLeafSurface& surface, vtkIdType corner)
{
  std::uint32_t& id = this->Ids[static_cast<std::size_t>(corner)];
  id = id == Unknown ? this->Visit(leaf, surface, corner) : id;
  return id;
}

//------------------------------------------------------------------------------
std::uint32_t SkdTriangleReader::Visit(int leaf, const SkdLeafSurface& surface, vtkIdType corner)
{
  skd::Vector3 x;
  surface.GetPoint(corner, x.X);
  if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
  {
    return NotFinite;
  }
  this->To.Bounds.Add(x);
  this->To.Points.push_back(x);
  this->To.Origins.push_back({ leaf, surface.GetPointId(corner) });
  return static_cast<std::uint32_t>(this->To.Points.size() - 1);
}

//------------------------------------------------------------------------------
bool SkdTriangleReader::AreSame(std::uint32_t a, std::uint32_t b) const
{
  return this->To.Points[a] == this->To.Points[b];
}

//------------------------------------------------------------------------------
void SkdTriangleReader::AddTriangle(const SkdTriangleCell& cell, const Corners& ids)
{
  const bool isFinite = std::max({ ids[0], ids[1], ids[2] }) < NotFinite;
  if (!isFinite || this->AreSame(ids[0], ids[1]) || this->AreSame(ids[1], ids[2]) ||
    this->AreSame(ids[2], ids[0]))
  {
    ++this->To.LeftOut;
    return;
  }
  this->Append(cell, ids);
}

//------------------------------------------------------------------------------
// A cut may leave triangles with equal corners. They have no area, and are counted as such.
void SkdTriangleReader::AddPolygon(const SkdTriangleCell& cell)
{
  const auto size = static_cast<vtkIdType>(this->Polygon.size());
  this->To.LeftOut += size == 0;
  this->Local->SetNumberOfPoints(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    this->Local->SetPoint(i, this->To.Points[this->Polygon[i]].X);
  }
  std::array<vtkIdType, 3> all = { 0, 1, 2 };
  vtkIdList* cut = nullptr;
  if (size > 3)
  {
    this->Order.resize(this->Polygon.size());
    std::iota(this->Order.begin(), this->Order.end(), 0);
    cut = this->Triangulation.Cut(this->Order.data(), static_cast<int>(size));
  }
  const vtkIdType corners = size > 3 ? cut->GetNumberOfIds() : size;
  for (vtkIdType i = 0; i < corners; i += 3)
  {
    const vtkIdType* at = cut ? cut->GetPointer(i) : all.data();
    const auto idOf = [&](int k) { return static_cast<std::uint32_t>(this->Polygon[at[k]]); };
    this->Append(cell, { idOf(0), idOf(1), idOf(2) });
  }
}

//------------------------------------------------------------------------------
void SkdTriangleReader::Append(const SkdTriangleCell& cell, const Corners& ids)
{
  SkdReadTriangles& to = this->To;
  const bool isNext = to.Cells.empty() || to.Cells.back() < cell;
  if (isNext || cell < to.Cells.back())
  {
    this->IsSorted = this->IsSorted && isNext;
    to.Cells.push_back(cell);
  }
  to.Triangles.push_back(ids);
  to.CellOf.push_back(static_cast<std::uint32_t>(to.Cells.size() - 1));
  TakeWidth(to.Points[ids[0]], to.Points[ids[1]], to.Points[ids[2]], to.LeastWidth);
}

//------------------------------------------------------------------------------
SkdReadTriangles SkdTriangleReader::Take()
{
  if (!this->IsSorted)
  {
    this->Sort();
  }
  return std::move(this->To);
}

//------------------------------------------------------------------------------
void SkdTriangleReader::Sort()
{
  const SkdReadTriangles from = this->To;
  const auto cellOf = [&](std::uint32_t triangle) -> const SkdTriangleCell&
  { return from.Cells[from.CellOf[triangle]]; };
  std::vector<std::uint32_t> order(from.Triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
    [&](std::uint32_t a, std::uint32_t b) { return cellOf(a) < cellOf(b); });
  this->To.Cells.clear();
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const SkdTriangleCell& cell = cellOf(order[i]);
    if (this->To.Cells.empty() || this->To.Cells.back() < cell)
    {
      this->To.Cells.push_back(cell);
    }
    this->To.Triangles[i] = from.Triangles[order[i]];
    this->To.CellOf[i] = static_cast<std::uint32_t>(this->To.Cells.size() - 1);
  }
}
