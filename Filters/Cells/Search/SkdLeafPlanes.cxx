// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Search/SkdLeafPlanes.h"

#include "Cells/Kernels/SkdKernels.h"
#include "Core/Geometry/Cells/CellFaces.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <vector>

namespace skdtree
{
namespace
{
template <class Kernel, class Visit>
void VisitShapeOf(const Kernel&, const Visit&)
{
}
template <class Shape, class Visit>
void VisitShapeOf(const SkdVolumeKernel<Shape>&, const Visit& visit)
{
  visit(Shape());
}

/// Calls visit(shape) with a linear volume cell that may be rotated; a voxel's box says it all.
template <class Visit>
void VisitVolume(SkdShape shape, const Visit& visit)
{
  SkdVisitKernel(shape, [&](auto kernel) { VisitShapeOf(kernel, visit); });
}

/// Twice the area vector of a face.
skd::Vector3 Across(const skd::Vector3* points, const std::uint32_t* ids, std::uint32_t size)
{
  const skd::Vector3& first = points[ids[0]];
  skd::Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (std::uint32_t i = 2; i < size; ++i)
  {
    sum = sum + skd::Cross(points[ids[i - 1]] - first, points[ids[i]] - first);
  }
  return sum;
}

/// Whether opposite faces of a hexahedron are so nearly parallel that it fills most of its slabs.
bool FillsSlabs(const SkdCellStore& store, std::uint32_t cell)
{
  using Shape = skd::Hexahedron;
  skd::Vector3 points[Shape::Size];
  store.Gather(cell, points);
  bool fills = true;
  for (int face = 0; face < Shape::NumberOfFaces; face += 2)
  {
    const skd::Vector3 normal =
      skd::FaceNormal<Shape>(points, face) - skd::FaceNormal<Shape>(points, face + 1);
    double spread = 0.0;
    double thickness = 0.0;
    for (const int side : { face, face + 1 })
    {
      double heights[4];
      std::transform(Shape::Faces[side], Shape::Faces[side] + 4, heights,
        [&](int id) { return skd::Dot(normal, points[id]); });
      const auto [least, most] = std::minmax_element(heights, heights + 4);
      const double mean = 0.25 * (heights[0] + heights[1] + heights[2] + heights[3]);
      spread += *most - *least;
      thickness += side == face ? mean : -mean;
    }
    fills = fills && spread <= 0.25 * std::abs(thickness);
  }
  return fills;
}
}

//------------------------------------------------------------------------------
int SkdNumberOfPlanes(const SkdCellStore& store, std::uint32_t cell)
{
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
  return std::min(count, SkdMostPlanes);
}

//------------------------------------------------------------------------------
// A few hundred of them tell.
bool SkdFillSlabs(const SkdCellStore& store)
{
  if (!store.IsAllOf(SkdShape::Hexahedron))
  {
    return false;
  }
  const std::uint32_t step = store.NumberOfCells() / 512 + 1;
  std::uint32_t warped = 0;
  for (std::uint32_t cell = 0; cell < store.NumberOfCells(); cell += step)
  {
    warped += FillsSlabs(store, cell) ? 0 : 1;
  }
  return warped <= store.NumberOfCells() / step / 8;
}

//------------------------------------------------------------------------------
void SkdLeafPlanes::Set(const std::uint32_t* cells, unsigned lanes, skd::PlaneRow* rows) const
{
  while (lanes != 0)
  {
    lanes &= ~this->SetLike(skd::LowestBit(lanes), cells, lanes, rows);
  }
}

//------------------------------------------------------------------------------
void SkdLeafPlanes::Set(const std::uint32_t* cells, unsigned lanes, skd::SlabPacket& packet) const
{
  const auto corners = this->CornersOf<skd::Hexahedron>(cells, lanes);
  for (int i = 0; i < skd::SlabPacket::Number; ++i)
  {
    packet.Slabs[i].SetBetweenFaces(lanes, 2 * i, corners, this->Margin);
  }
}

//------------------------------------------------------------------------------
/// Selects the cells that have the shape of one of them. Returns their bits.
unsigned SkdLeafPlanes::SetLike(
  int first, const std::uint32_t* cells, unsigned lanes, skd::PlaneRow* rows) const
{
  const SkdShape shape = this->Store.ShapeOf(cells[first]);
  unsigned alike = 0;
  skd::ForEachLane(
    lanes, [&](int lane) { alike |= this->Store.ShapeOf(cells[lane]) == shape ? 1u << lane : 0u; });
  if (shape == SkdShape::Polyhedron)
  {
    skd::ForEachLane(alike, [&](int lane) { this->SetPolyhedron(lane, cells[lane], rows); });
  }
  constexpr std::size_t few = 3; // so many cost less one by one than all lanes at once
  const bool areFew = std::bitset<skd::PlaneRow::Width>(alike).count() <= few;
  VisitVolume(shape,
    [&](auto kind)
    {
      if (areFew)
      {
        this->SetEach<decltype(kind)>(cells, alike, rows);
      }
      else
      {
        this->SetTogether<decltype(kind)>(cells, alike, rows);
      }
    });
  return alike;
}

//------------------------------------------------------------------------------
template <class Shape>
void SkdLeafPlanes::SetEach(const std::uint32_t* cells, unsigned lanes, skd::PlaneRow* rows) const
{
  skd::ForEachLane(lanes,
    [&](int lane)
    {
      skd::Vector3 points[Shape::Size];
      this->Gather(
        cells[lane], Shape::Size, [&](int i, const skd::Vector3& point) { points[i] = point; });
      for (int face = 0; face < Shape::NumberOfFaces; ++face)
      {
        rows[face].SetAlongFace(lane, skd::FaceNormal<Shape>(points, face),
          points[Shape::Faces[face][0]], points, Shape::Size, this->Margin);
      }
    });
}

//------------------------------------------------------------------------------
template <class Shape>
void SkdLeafPlanes::SetTogether(
  const std::uint32_t* cells, unsigned lanes, skd::PlaneRow* rows) const
{
  const auto corners = this->CornersOf<Shape>(cells, lanes);
  for (int face = 0; face < Shape::NumberOfFaces; ++face)
  {
    rows[face].SetAlongFaces(lanes, face, corners, this->Margin);
  }
}

//------------------------------------------------------------------------------
/// Of the first faces of a polyhedron.
void SkdLeafPlanes::SetPolyhedron(int lane, std::uint32_t cell, skd::PlaneRow* rows) const
{
  const int count = SkdNumberOfPlanes(this->Store, cell);
  thread_local std::vector<skd::Vector3> points;
  points.resize(this->Store.SizeOf(cell));
  this->Gather(cell, static_cast<int>(points.size()),
    [&](int i, const skd::Vector3& point) { points[static_cast<std::size_t>(i)] = point; });
  const skd::PolyhedronView view = this->Store.GatherPoly(cell).AsPolyhedron();
  const std::uint32_t* at = view.Faces;
  for (int i = 0; i < count; ++i, at += 1 + *at)
  {
    rows[i].SetAlongFace(lane, Across(points.data(), at + 1, *at), points[at[1]], points.data(),
      static_cast<int>(points.size()), this->Margin);
  }
}

//------------------------------------------------------------------------------
template <class Shape>
skd::CornerLanes<Shape> SkdLeafPlanes::CornersOf(const std::uint32_t* cells, unsigned lanes) const
{
  skd::CornerLanes<Shape> corners;
  skd::ForEachLane(lanes,
    [&](int lane)
    {
      this->Gather(cells[lane], Shape::Size,
        [&](int i, const skd::Vector3& point) { corners.Set(lane, i, point); });
    });
  return corners;
}

//------------------------------------------------------------------------------
template <class Visit>
void SkdLeafPlanes::Gather(std::uint32_t cell, int count, const Visit& visit) const
{
  const std::uint32_t* ids = this->Store.PointIdsOf(cell);
  const skd::QuantizationGrid grid = this->Grid; // of our own: its inverse is made once
  for (int i = 0; i < count; ++i)
  {
    const skd::Vector3 world = this->Store.Point(ids[i]);
    visit(i, grid.Of(this->Frame.Local(world)));
  }
}
}
