// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Search/SkdCellStore.h"

#include "Cells/Curved/SkdChordalDeviation.h"
#include "Cells/Read/SkdCellReader.h"
#include "Cells/Read/SkdEnclose.h"
#include "Cells/Read/SkdFaceReader.h"
#include "Cells/Read/SkdFillCell.h"
#include "Cells/Read/SkdForEach.h"
#include "Cells/Read/SkdShape.h"
#include "Core/Geometry/PointBounds.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkPointSet.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPThreadLocalObject.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace skdtree
{
namespace
{
void RequireRange(vtkIdType number, const char* what)
{
  if (number >= static_cast<vtkIdType>(std::numeric_limits<std::uint32_t>::max()) / 2)
  {
    throw std::length_error(std::string("more than 2^31 ") + what + " in one tree");
  }
}
}

//------------------------------------------------------------------------------
SkdCellStore::SkdCellStore(
  vtkDataSet* data, SkdUniformCells&& uniform, bool skipGhosts, const SkdMagnitudes& magnitudes)
  : Magnitudes(magnitudes)
{
  if (!data || data->GetNumberOfCells() == 0 || data->GetNumberOfPoints() == 0)
  {
    return;
  }
  RequireRange(data->GetNumberOfCells(), "cells");
  RequireRange(data->GetNumberOfPoints(), "points");
  const SkdCellReader reader(data);
  this->ReadPoints(data);
  if (uniform.AreThere() && this->ArePointsFinite())
  {
    this->Take(std::move(uniform));
    return;
  }
  this->ReadCells(reader, data, skipGhosts);
  this->ReadFaces(data);
  this->Compact();
  this->ReadCurvedExtents(data);
  if (this->Count > 0)
  {
    this->FindBounds();
  }
}

//------------------------------------------------------------------------------
SkdCellStore::SkdCellStore(const SkdCellStore& whole, const std::vector<std::uint32_t>& cells)
  : Magnitudes(whole.Magnitudes)
  , Count(static_cast<std::uint32_t>(cells.size()))
  , CommonShape(whole.CommonShape)
  , CommonSize(whole.CommonSize)
  , Largest(whole.Largest)
  , Bounds(whole.Bounds)
  , Points(whole.Points)
  , NumberOfPoints(whole.NumberOfPoints)
{
  const auto copyIf = [&cells](const auto& from, auto& to)
  {
    if (!from.empty())
    {
      to.reserve(cells.size());
      std::transform(cells.begin(), cells.end(), std::back_inserter(to),
        [&from](std::uint32_t cell) { return from[cell]; });
    }
  };
  copyIf(whole.Shapes, this->Shapes);
  copyIf(whole.CurvedExtents, this->CurvedExtents);
  for (const std::uint32_t cell : cells)
  {
    this->Ids.push_back(static_cast<std::uint32_t>(whole.IdOf(cell)));
    if (!whole.Offsets.empty())
    {
      this->Offsets.push_back(this->PointIds.size());
    }
    if (!whole.FaceOffsets.empty())
    {
      this->FaceOffsets.push_back(this->FaceStream.size());
      this->FaceStream.insert(this->FaceStream.end(),
        whole.FaceStream.begin() + static_cast<std::ptrdiff_t>(whole.FaceOffsets[cell]),
        whole.FaceStream.begin() + static_cast<std::ptrdiff_t>(whole.FaceOffsets[cell + 1]));
    }
    const std::uint32_t* ids = whole.PointIdsOf(cell);
    this->PointIds.insert(this->PointIds.end(), ids, ids + whole.SizeOf(cell));
  }
  if (!whole.Offsets.empty())
  {
    this->Offsets.push_back(this->PointIds.size());
  }
  if (!whole.FaceOffsets.empty())
  {
    this->FaceOffsets.push_back(this->FaceStream.size());
  }
}

//------------------------------------------------------------------------------
// Of a polyhedron without faces its points are what is certain.
void SkdCellStore::ReadFaces(vtkDataSet* data)
{
  const auto isPolyhedron = [](SkdShape shape) { return shape == SkdShape::Polyhedron; };
  if (std::none_of(this->Shapes.begin(), this->Shapes.end(), isPolyhedron))
  {
    return;
  }
  std::vector<std::vector<std::uint32_t>> streams(this->Count);
  vtkSMPThreadLocal<SkdFaceReader> readers;
  vtkSMPThreadLocalObject<vtkIdList> lists;
  vtkSMPThreadLocalObject<vtkGenericCell> cells;
  SkdForEach(this->Count,
    [&](std::size_t cell)
    {
      if (!isPolyhedron(this->Shapes[cell]))
      {
        return;
      }
      vtkIdList* faces = lists.Local();
      SkdReadFaces(data, this->IdOf(static_cast<std::uint32_t>(cell)), cells.Local(), faces);
      const std::uint64_t first = this->Offsets[cell];
      streams[cell] = readers.Local().Read(faces, this->PointIds.data() + first,
        static_cast<std::uint32_t>(this->Offsets[cell + 1] - first), this->Points);
      this->Shapes[cell] = streams[cell].empty() ? SkdShape::PolyVertex : SkdShape::Polyhedron;
    });
  this->FaceOffsets.push_back(0);
  for (const std::vector<std::uint32_t>& stream : streams)
  {
    this->FaceOffsets.push_back(this->FaceOffsets.back() + stream.size());
  }
  this->FaceStream.reserve(this->FaceOffsets.back());
  for (const std::vector<std::uint32_t>& stream : streams)
  {
    this->FaceStream.insert(this->FaceStream.end(), stream.begin(), stream.end());
  }
}

//------------------------------------------------------------------------------
void SkdCellStore::ReadCurvedExtents(vtkDataSet* data)
{
  const auto isGeneric = [](SkdShape shape) { return shape == SkdShape::Generic; };
  if (!isGeneric(this->CommonShape) &&
    std::none_of(this->Shapes.begin(), this->Shapes.end(), isGeneric))
  {
    return;
  }
  SkdChordalDeviation deviation(data);
  for (std::uint32_t cell = 0; cell < this->Count; ++cell)
  {
    if (!isGeneric(this->ShapeOf(cell)))
    {
      continue;
    }
    const vtkIdType id = this->IdOf(cell);
    const SkdPolyCell gathered = this->GatherPoly(cell);
    const double extent =
      deviation.FactorOf(id, data->GetCellType(id), gathered.Points, gathered.Size);
    if (extent > 1.0)
    {
      this->CurvedExtents.resize(this->Count, 1.0f);
      this->CurvedExtents[cell] =
        std::nextafter(static_cast<float>(extent), std::numeric_limits<float>::max());
    }
  }
}

//------------------------------------------------------------------------------
// Of meshes of one shape whose cells have any number of points; SizeFor sees to the others.
void SkdCellStore::Compact()
{
  const bool isUniform = !this->Shapes.empty() &&
    std::all_of(this->Shapes.begin(), this->Shapes.end(),
      [this](SkdShape shape) { return shape == this->Shapes.front(); });
  if (isUniform)
  {
    this->CommonShape = this->Shapes.front();
    skd::RawVector<SkdShape>().swap(this->Shapes);
  }
}

//------------------------------------------------------------------------------
void SkdCellStore::Take(SkdUniformCells&& uniform)
{
  this->CommonShape = uniform.Shape;
  this->CommonSize = static_cast<std::uint32_t>(SkdNumberOfPoints(uniform.Shape));
  this->PointIds = std::move(uniform.PointIds);
  this->Count = static_cast<std::uint32_t>(this->PointIds.size() / this->CommonSize);
  this->Bounds = uniform.Bounds;
  this->Largest = skd::LargestCoordinate(this->Bounds);
}

//------------------------------------------------------------------------------
void SkdCellStore::FindBounds()
{
  static constexpr std::size_t piece = 256;
  const std::size_t number = this->PointIds.size();
  const skd::Box3 box = SkdEnclose((number + piece - 1) / piece,
    [this, number](std::size_t i)
    {
      const std::size_t first = piece * i;
      skd::PointBounds bounds;
      bounds.Add(this->Points, this->PointIds.data() + first, std::min(piece, number - first));
      return bounds.Box();
    });
  this->Largest = skd::LargestCoordinate(box);
  this->Bounds = box;
  if (this->HasCurvedExtents())
  {
    this->Bounds.Add(SkdEnclose(this->Count,
      [this](std::size_t cell) { return this->ExtentOf(static_cast<std::uint32_t>(cell)); }));
  }
}

//------------------------------------------------------------------------------
std::int64_t SkdCellStore::FindCellOfId(vtkIdType id) const
{
  const auto found = std::lower_bound(this->Ids.begin(), this->Ids.end(), id,
    [](std::uint32_t stored, vtkIdType sought) { return static_cast<vtkIdType>(stored) < sought; });
  const bool isStored = found != this->Ids.end() && static_cast<vtkIdType>(*found) == id;
  return isStored ? found - this->Ids.begin() : -1;
}

//------------------------------------------------------------------------------
bool SkdCellStore::Load(std::uint32_t cell, vtkGenericCell* loaded) const
{
  const int type = SkdCellTypeOfShape(this->ShapeOf(cell));
  if (type == VTK_EMPTY_CELL)
  {
    return false;
  }
  loaded->SetCellType(type);
  return SkdFillCell(loaded, this->PointIdsOf(cell), this->SizeOf(cell), this->Points);
}

//------------------------------------------------------------------------------
SkdPolyCell SkdCellStore::GatherPoly(std::uint32_t cell) const
{
  thread_local std::vector<skd::Vector3> kept; // grown to the largest cell met
  std::vector<skd::Vector3>& points = kept;    // found once: each access to `kept` is a call
  const std::uint32_t* ids = this->PointIdsOf(cell);
  const std::uint32_t size = this->SizeOf(cell);
  points.resize(std::max<std::size_t>(points.size(), size));
  for (std::uint32_t i = 0; i < size; ++i)
  {
    points[i] = this->Point(ids[i]);
  }
  SkdPolyCell gathered{ this->ShapeOf(cell), points.data(), static_cast<int>(size), nullptr,
    nullptr };
  if (!this->FaceOffsets.empty())
  {
    gathered.Faces = this->FaceStream.data() + this->FaceOffsets[cell];
    gathered.FacesEnd = this->FaceStream.data() + this->FaceOffsets[cell + 1];
  }
  return gathered;
}

//------------------------------------------------------------------------------
skd::Box3 SkdCellStore::CurvedExtentOf(std::uint32_t cell) const
{
  const skd::Box3 bounds = this->BoundsOf(cell);
  const double factor = this->CurvedExtents[cell];
  const skd::Vector3 centre = bounds.Centroid();
  return { centre + factor * (bounds.Min - centre), centre + factor * (bounds.Max - centre) };
}

//------------------------------------------------------------------------------
vtkPoints* SkdCellStore::PointsOfAnother(vtkDataSet* data) const
{
  auto* pointSet = vtkPointSet::SafeDownCast(data);
  vtkPoints* points = pointSet ? pointSet->GetPoints() : nullptr;
  return points && points->GetData() == this->SharedCoordinates ? nullptr : this->SharedPoints;
}

//------------------------------------------------------------------------------
std::size_t SkdCellStore::MemorySize() const
{
  return this->Ids.capacity() * sizeof(std::uint32_t) + this->Shapes.capacity() +
    this->Offsets.capacity() * sizeof(std::uint64_t) +
    this->PointIds.capacity() * sizeof(std::uint32_t) +
    this->FaceOffsets.capacity() * sizeof(std::uint64_t) +
    this->FaceStream.capacity() * sizeof(std::uint32_t) +
    this->CurvedExtents.capacity() * sizeof(float) + this->OwnPoints.capacity() * sizeof(double);
}
}
