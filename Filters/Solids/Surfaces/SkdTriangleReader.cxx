// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdTriangleReader.h"

#include "Bodies/SkdOuterSurface.h"
#include "Core/Geometry/Predicates/ExactScale.h"
#include "Pipeline/SkdVolumeCells.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace skdtree
{
namespace
{
bool IsFinite(const skd::Vector3& x)
{
  return 0.0 * x[0] + 0.0 * x[1] + 0.0 * x[2] == 0.0;
}

/// Twice the area of a triangle, seen along the axis where that is largest.
inline double AreaOf(const SkdReadTriangles& of, const SkdReadTriangles::Corners& ids)
{
  const skd::Vector3& a = of.Points[ids[0]];
  const skd::Vector3 normal = skd::Cross(of.Points[ids[1]] - a, of.Points[ids[2]] - a);
  return std::max(std::max(std::abs(normal[0]), std::abs(normal[1])), std::abs(normal[2]));
}
}

//------------------------------------------------------------------------------
void SkdReadTriangles::LeaveOutCollapsed(std::size_t from)
{
  std::size_t count = from;
  for (std::size_t i = from; i < this->Triangles.size(); ++i)
  {
    const Corners corners = this->Triangles[i];
    const skd::Vector3& a = this->Points[corners[0]];
    const skd::Vector3& b = this->Points[corners[1]];
    const skd::Vector3& c = this->Points[corners[2]];
    if (!(a == b || b == c || c == a))
    {
      this->CellOf[count] = this->CellOf[i];
      this->Triangles[count++] = corners;
    }
  }
  this->CellOf.resize(count);
  this->Triangles.resize(count);
}

//------------------------------------------------------------------------------
void SkdReadTriangles::FindExtents()
{
  this->Bounds = {};
  this->LeastCoordinate = this->LeastArea = std::numeric_limits<double>::infinity();
  for (const skd::Vector3& x : this->Points)
  {
    this->Bounds.Add(x);
    this->LeastCoordinate = SkdLeastCoordinateOf(this->LeastCoordinate, x);
  }
  for (const Corners& ids : this->Triangles)
  {
    this->LeastArea = std::min(this->LeastArea, AreaOf(*this, ids));
  }
}

//------------------------------------------------------------------------------
inline bool SkdTriangleReader::AreSame(std::uint32_t a, std::uint32_t b) const
{
  return this->To.Points[a] == this->To.Points[b];
}

//------------------------------------------------------------------------------
inline bool SkdTriangleReader::HasEqualCorners(const Corners& ids) const
{
  return this->AreSame(ids[0], ids[1]) || this->AreSame(ids[1], ids[2]) ||
    this->AreSame(ids[2], ids[0]);
}

//------------------------------------------------------------------------------
// Returns whether it is more than 0, so that no corners are the same. Not of NaN.
inline bool SkdTriangleReader::TakeArea(const Corners& ids)
{
  const double area = AreaOf(this->To, ids);
  this->To.LeastArea = std::min(this->To.LeastArea, area > 0.0 ? area : this->To.LeastArea);
  return area > 0.0;
}

//------------------------------------------------------------------------------
inline void SkdTriangleReader::Append(const SkdTriangleCell& cell, const Corners& ids, bool hasArea)
{
  SkdReadTriangles& to = this->To;
  const SkdTriangleCell* last = to.Cells.data() + this->NumberOfCells - 1;
  const bool isNext = this->NumberOfCells == 0 || *last < cell;
  if (isNext || cell < *last)
  {
    this->IsSorted = this->IsSorted && isNext;
    to.Cells[this->NumberOfCells++] = cell;
  }
  to.LeastArea = hasArea ? to.LeastArea : 0.0;
  to.Triangles[this->NumberOfTriangles] = ids;
  to.CellOf[this->NumberOfTriangles] = static_cast<std::uint32_t>(this->NumberOfCells - 1);
  ++this->NumberOfTriangles;
}

//------------------------------------------------------------------------------
inline void SkdTriangleReader::AddTriangle(const SkdTriangleCell& cell, const Corners& ids)
{
  const bool isFinite = std::max({ ids[0], ids[1], ids[2] }) < NotFinite;
  const bool hasArea = isFinite && this->TakeArea(ids);
  if (isFinite && (hasArea || !this->HasEqualCorners(ids)))
  {
    this->Append(cell, ids, hasArea);
  }
  else
  {
    ++this->To.LeftOut;
  }
}

//------------------------------------------------------------------------------
void SkdTriangleReader::Read(int block, vtkDataSet* mesh, const SkdBlockSurface& surface)
{
  this->To.CoarseFaces += surface.GetNumberOfCoarseFaces();
  this->MarkPoints(surface);
  this->ReadPoints(block, surface);
  const bool hasVolumes = SkdHasVolumeCells(mesh);
  this->HasVolumes = this->HasVolumes || hasVolumes;
  const std::uint32_t* const ids = this->Ids.data();
  const auto add = [&](vtkIdType face, vtkIdType size, const auto* corners)
  {
    const SkdTriangleCell cell{ block, surface.GetCellId(face) };
    if (size == 3)
    {
      this->AddTriangle(cell, { ids[corners[0]], ids[corners[1]], ids[corners[2]] });
      return;
    }
    this->AddPolygon(cell, size, corners);
  };
  const auto addTurned = [&](vtkIdType face, vtkIdType size, const auto* corners)
  {
    if (surface.IsOfVolume(face))
    {
      add(face, size, this->BeginAtLeast(size, corners));
      return;
    }
    add(face, size, corners);
  };
  hasVolumes ? surface.ForEachFace(addTurned) : surface.ForEachFace(add);
  this->To.Triangles.resize(this->NumberOfTriangles);
  this->To.CellOf.resize(this->NumberOfTriangles);
  this->To.Cells.resize(this->NumberOfCells);
}

//------------------------------------------------------------------------------
// A corner that is not finite is no least one.
template <class Corner>
const vtkIdType* SkdTriangleReader::BeginAtLeast(vtkIdType size, const Corner* corners)
{
  const auto isBefore = [this](vtkIdType a, vtkIdType b)
  {
    const std::uint32_t first = this->Ids[static_cast<std::size_t>(a)];
    const std::uint32_t second = this->Ids[static_cast<std::size_t>(b)];
    return first != NotFinite &&
      (second == NotFinite || this->To.Points[first] < this->To.Points[second]);
  };
  std::vector<vtkIdType>& turned = this->Turned;
  turned.assign(corners, corners + size);
  std::rotate(
    turned.begin(), std::min_element(turned.begin(), turned.end(), isBefore), turned.end());
  return turned.data();
}

//------------------------------------------------------------------------------
// Makes room for all faces, too.
void SkdTriangleReader::MarkPoints(const SkdBlockSurface& surface)
{
  this->Ids.assign(static_cast<std::size_t>(surface.Get()->GetNumberOfPoints()), Unused);
  std::uint32_t* const ids = this->Ids.data();
  std::size_t faces = 0;
  std::size_t triangles = 0; // at most
  surface.ForEachFace(
    [&faces, &triangles, ids](vtkIdType, vtkIdType size, const auto* corners)
    {
      ++faces;
      triangles += size > 3 ? static_cast<std::size_t>(size - 2) : 1;
      if (size == 3)
      {
        ids[corners[0]] = ids[corners[1]] = ids[corners[2]] = Used;
        return;
      }
      for (vtkIdType i = 0; i < size; ++i)
      {
        ids[corners[i]] = Used;
      }
    });
  this->To.Cells.resize(this->NumberOfCells + faces);
  this->To.Triangles.resize(this->NumberOfTriangles + triangles);
  this->To.CellOf.resize(this->NumberOfTriangles + triangles);
}

//------------------------------------------------------------------------------
void SkdTriangleReader::ReadPoints(int block, const SkdBlockSurface& surface)
{
  std::uint32_t* const ids = this->Ids.data();
  const auto size = static_cast<vtkIdType>(this->Ids.size());
  std::size_t count = this->To.Points.size();
  this->To.Points.resize(count + this->Ids.size());
  this->To.Origins.resize(count + this->Ids.size());
  skd::Box3 bounds = this->To.Bounds;
  double least = this->To.LeastCoordinate;
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (ids[i] == Used)
    {
      skd::Vector3 x;
      surface.GetPoint(i, x.X);
      ids[i] = NotFinite;
      if (IsFinite(x))
      {
        ids[i] = static_cast<std::uint32_t>(count);
        bounds.Add(x);
        least = SkdLeastCoordinateOf(least, x);
        this->To.Points[count] = x;
        this->To.Origins[count] = { block, surface.GetPointId(i) };
        ++count;
      }
    }
  }
  this->To.Bounds = bounds;
  this->To.LeastCoordinate = least;
  this->To.Points.resize(count);
  this->To.Origins.resize(count);
}

//------------------------------------------------------------------------------
// A cut may leave triangles with equal corners. They have no area, and are counted as such.
template <class Corner>
void SkdTriangleReader::AddPolygon(
  const SkdTriangleCell& cell, vtkIdType size, const Corner* corners)
{
  const auto idOf = [this](vtkIdType corner)
  {
    const std::uint32_t id = this->Ids[static_cast<std::size_t>(corner)];
    return id == NotFinite ? vtkIdType(-1) : static_cast<vtkIdType>(id);
  };
  const auto areSame = [this](vtkIdType a, vtkIdType b)
  { return this->AreSame(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)); };
  this->Polygon.clear();
  SkdAppendCorners(size, corners, idOf, this->Polygon, areSame);
  this->To.LeftOut += this->Polygon.empty();
  const auto append = [&](vtkIdType a, vtkIdType b, vtkIdType c)
  {
    const auto at = [this](vtkIdType i) { return static_cast<std::uint32_t>(this->Polygon[i]); };
    const Corners ids{ at(a), at(b), at(c) };
    this->Append(cell, ids, this->TakeArea(ids));
  };
  if (this->Polygon.size() == 3)
  {
    append(0, 1, 2);
  }
  else if (this->Polygon.size() > 3)
  {
    if (!this->Triangulation)
    {
      this->Triangulation.emplace();
    }
    const auto size = static_cast<vtkIdType>(this->Polygon.size());
    vtkIdList* cut = this->Triangulation->Cut(size,
      [&](vtkIdType i) { return this->To.Points[static_cast<std::size_t>(this->Polygon[i])]; });
    for (vtkIdType i = 0; i < cut->GetNumberOfIds(); i += 3)
    {
      append(cut->GetId(i), cut->GetId(i + 1), cut->GetId(i + 2));
    }
  }
}

//------------------------------------------------------------------------------
SkdReadTriangles SkdTriangleReader::Take(double largestCoordinate)
{
  if (!this->IsSorted || this->HasVolumes)
  {
    this->Sort();
  }
  this->TakeTinyAsZero(largestCoordinate);
  return std::move(this->To);
}

//------------------------------------------------------------------------------
// Triangles whose corners become equal are left out.
void SkdTriangleReader::TakeTinyAsZero(double largestCoordinate)
{
  SkdReadTriangles& to = this->To;
  const double least = skd::LeastExactCoordinate * largestCoordinate;
  if (!(to.LeastCoordinate < least))
  {
    return;
  }
  to.Bounds = {};
  to.LeastArea = 0.0;
  to.LeastCoordinate = least;
  for (skd::Vector3& x : to.Points)
  {
    to.TinyPoints += skd::TakeTinyAsZero(x, least);
    to.Bounds.Add(x);
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < to.Triangles.size(); ++i)
  {
    if (!this->HasEqualCorners(to.Triangles[i]))
    {
      to.Triangles[count] = to.Triangles[i];
      to.CellOf[count++] = to.CellOf[i];
    }
  }
  to.LeftOut += static_cast<vtkIdType>(to.Triangles.size() - count);
  to.Triangles.resize(count);
  to.CellOf.resize(count);
}

//------------------------------------------------------------------------------
void SkdTriangleReader::Sort()
{
  const SkdReadTriangles from = this->To;
  const auto cellOf = [&](std::uint32_t triangle) -> const SkdTriangleCell&
  { return from.Cells[from.CellOf[triangle]]; };
  std::vector<std::uint32_t> order(from.Triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto isBefore = [&](std::uint32_t a, std::uint32_t b)
  {
    if (cellOf(a) < cellOf(b) || cellOf(b) < cellOf(a) || !this->HasVolumes)
    {
      return cellOf(a) < cellOf(b);
    }
    return std::lexicographical_compare(from.Triangles[a].begin(), from.Triangles[a].end(),
      from.Triangles[b].begin(), from.Triangles[b].end(),
      [&](std::uint32_t one, std::uint32_t other)
      { return from.Points[one] < from.Points[other]; });
  };
  std::stable_sort(order.begin(), order.end(), isBefore);
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
}
