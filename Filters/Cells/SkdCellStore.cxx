// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/SkdCellStore.h"

#include "Cells/SkdBulge.h"
#include "Cells/SkdFaceReader.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace
{
/// Tells which cells of a data set belong in the tree. Constant: threads may share it.
class CellSieve
{
public:
  CellSieve(vtkDataSet* data, bool skipGhosts)
    : CellGhosts(data->GetCellGhostArray())
    , PointGhosts(IsStructured(data) ? data->GetPointGhostArray() : nullptr)
    , Unwanted(vtkDataSetAttributes::HIDDENCELL)
  {
    if (skipGhosts)
    {
      this->Unwanted |= vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::REFINEDCELL;
    }
  }

  bool Keeps(vtkIdType cellId, vtkIdList* pointIds) const
  {
    if (this->CellGhosts && (this->CellGhosts->GetValue(cellId) & this->Unwanted) != 0)
    {
      return false;
    }
    return !this->PointGhosts || !this->HasHiddenPoint(pointIds);
  }

private:
  // Structured data are blanked by points, too: a cell with a hidden point is not visible.
  static bool IsStructured(vtkDataSet* data)
  {
    return vtkImageData::SafeDownCast(data) || vtkRectilinearGrid::SafeDownCast(data) ||
      vtkStructuredGrid::SafeDownCast(data);
  }

  bool HasHiddenPoint(vtkIdList* pointIds) const
  {
    for (vtkIdType i = 0; i < pointIds->GetNumberOfIds(); ++i)
    {
      if (this->PointGhosts->GetValue(pointIds->GetId(i)) & vtkDataSetAttributes::HIDDENPOINT)
      {
        return true;
      }
    }
    return false;
  }

  vtkUnsignedCharArray* CellGhosts;
  vtkUnsignedCharArray* PointGhosts;
  int Unwanted;
};

void RequireRange(vtkIdType number, const char* what)
{
  if (number >= static_cast<vtkIdType>(std::numeric_limits<std::uint32_t>::max()) / 2)
  {
    throw std::length_error(std::string("more than 2^31 ") + what + " in one tree");
  }
}

/// Calls body(index) for 0 .. count - 1 in parallel.
template <class Body>
void ForEach(std::size_t count, const Body& body)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(count),
    [&body](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        body(static_cast<std::size_t>(i));
      }
    });
}
}

//------------------------------------------------------------------------------
SkdCellStore::SkdCellStore(vtkDataSet* data, bool skipGhosts)
{
  if (!data || data->GetNumberOfCells() == 0 || data->GetNumberOfPoints() == 0)
  {
    return;
  }
  RequireRange(data->GetNumberOfCells(), "cells");
  RequireRange(data->GetNumberOfPoints(), "points");
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    if (mesh->NeedToBuildCells())
    {
      mesh->BuildCells(); // lazily made by VTK, which is not thread-safe
    }
  }
  this->ReadPoints(data);
  this->ReadCells(data, skipGhosts);
  this->ReadReaches(data);
  this->FindLargestCoordinate();
}

//------------------------------------------------------------------------------
void SkdCellStore::ReadPoints(vtkDataSet* data)
{
  this->NumberOfPoints = data->GetNumberOfPoints();
  auto* pointSet = vtkPointSet::SafeDownCast(data);
  auto* doubles =
    pointSet ? vtkDoubleArray::FastDownCast(pointSet->GetPoints()->GetData()) : nullptr;
  if (doubles)
  {
    this->SharedPoints = doubles;
    this->Coordinates = doubles->GetPointer(0);
    return;
  }
  this->OwnPoints.resize(3 * static_cast<std::size_t>(this->NumberOfPoints));
  double x[3];
  data->GetPoint(0, x); // what is made at the first call must not be made by many threads
  ForEach(static_cast<std::size_t>(this->NumberOfPoints),
    [this, data](std::size_t i)
    { data->GetPoint(static_cast<vtkIdType>(i), this->OwnPoints.data() + 3 * i); });
  this->Coordinates = this->OwnPoints.data();
}

//------------------------------------------------------------------------------
void SkdCellStore::ReadCells(vtkDataSet* data, bool skipGhosts)
{
  const CellSieve sieve(data, skipGhosts);
  const auto numberOfCells = static_cast<std::size_t>(data->GetNumberOfCells());
  std::vector<Finding> findings(numberOfCells);
  vtkSMPThreadLocalObject<vtkIdList> lists;
  data->GetCellPoints(0, lists.Local()); // what is made at the first call, as in ReadPoints
  ForEach(numberOfCells,
    [&](std::size_t i)
    {
      const auto id = static_cast<vtkIdType>(i);
      vtkIdList* ids = lists.Local();
      data->GetCellPoints(id, ids);
      findings[i] = this->Examine(data->GetCellType(id), ids);
      if (!sieve.Keeps(id, ids))
      {
        findings[i].Shape = SkdShape::None;
      }
    });
  this->Number(findings);
  ForEach(this->Ids.size(),
    [&](std::size_t cell)
    {
      vtkIdList* ids = lists.Local();
      data->GetCellPoints(static_cast<vtkIdType>(this->Ids[cell]), ids);
      std::copy_n(ids->GetPointer(0), ids->GetNumberOfIds(),
        this->PointIds.begin() + static_cast<std::ptrdiff_t>(this->Offsets[cell]));
    });
  this->ReadFaces(data);
  this->Compact();
}

//------------------------------------------------------------------------------
SkdCellStore::Finding SkdCellStore::Examine(int cellType, vtkIdList* ids) const
{
  Finding finding;
  finding.Shape = SkdShapeOfCellType(cellType);
  finding.Size = static_cast<std::uint32_t>(ids->GetNumberOfIds());
  for (vtkIdType i = 0; i < ids->GetNumberOfIds() && finding.IsFinite; ++i)
  {
    const vtkIdType id = ids->GetId(i);
    const bool exists = id >= 0 && id < this->NumberOfPoints;
    finding.IsFinite = exists && skd::IsFinite(this->Point(static_cast<std::uint32_t>(id)));
  }
  const auto expected = static_cast<std::uint32_t>(SkdNumberOfPoints(finding.Shape));
  const bool isWhole = finding.Size > 0 && (expected == 0 || finding.Size == expected);
  if (!isWhole || !finding.IsFinite)
  {
    finding.Shape = SkdShape::None;
  }
  return finding;
}

//------------------------------------------------------------------------------
void SkdCellStore::Number(const std::vector<Finding>& findings)
{
  std::uint64_t total = 0;
  this->Offsets.push_back(0);
  for (std::size_t i = 0; i < findings.size(); ++i)
  {
    if (findings[i].Shape == SkdShape::None)
    {
      ++(findings[i].IsFinite ? this->Missing.Other : this->Missing.NotFinite);
      continue;
    }
    total += findings[i].Size;
    this->Ids.push_back(static_cast<std::uint32_t>(i));
    this->Shapes.push_back(findings[i].Shape);
    this->Offsets.push_back(total);
  }
  this->Count = static_cast<std::uint32_t>(this->Ids.size());
  this->PointIds.resize(total);
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
  ForEach(this->Count,
    [&](std::size_t cell)
    {
      if (!isPolyhedron(this->Shapes[cell]))
      {
        return;
      }
      vtkIdList* faces = lists.Local();
      SkdReadFaces(data, static_cast<vtkIdType>(this->Ids[cell]), cells.Local(), faces);
      const std::uint64_t first = this->Offsets[cell];
      streams[cell] = readers.Local().Read(faces, this->PointIds.data() + first,
        static_cast<std::uint32_t>(this->Offsets[cell + 1] - first), this->Coordinates);
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
void SkdCellStore::ReadReaches(vtkDataSet* data)
{
  SkdBulge bulge(data);
  for (std::uint32_t cell = 0; cell < this->Count; ++cell)
  {
    if (this->ShapeOf(cell) != SkdShape::Generic)
    {
      continue;
    }
    const vtkIdType id = this->IdOf(cell);
    const SkdPolyCell gathered = this->GatherPoly(cell);
    const double reach = bulge.FactorOf(id, data->GetCellType(id), gathered.Points, gathered.Size);
    if (reach > 1.0)
    {
      this->Reaches.resize(this->Count, 1.0f);
      this->Reaches[cell] =
        std::nextafter(static_cast<float>(reach), std::numeric_limits<float>::max());
    }
  }
}

//------------------------------------------------------------------------------
// Meshes of one shape are the rule: these need neither shapes nor offsets.
void SkdCellStore::Compact()
{
  if (this->Missing.NotFinite + this->Missing.Other == 0)
  {
    std::vector<std::uint32_t>().swap(this->Ids);
  }
  const bool isUniform = this->Count > 0 &&
    std::all_of(this->Shapes.begin(), this->Shapes.end(),
      [this](SkdShape shape) { return shape == this->Shapes.front(); });
  if (!isUniform)
  {
    return;
  }
  this->CommonShape = this->Shapes.front();
  std::vector<SkdShape>().swap(this->Shapes);
  this->CommonSize = static_cast<std::uint32_t>(SkdNumberOfPoints(this->CommonShape));
  if (this->CommonSize > 0)
  {
    std::vector<std::uint64_t>().swap(this->Offsets);
  }
}

//------------------------------------------------------------------------------
void SkdCellStore::FindLargestCoordinate()
{
  for (const std::uint32_t id : this->PointIds)
  {
    const skd::Vector3 x = this->Point(id);
    this->Largest = std::max({ this->Largest, std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) });
  }
}

//------------------------------------------------------------------------------
std::int64_t SkdCellStore::CellOfId(vtkIdType id) const
{
  if (this->Ids.empty())
  {
    return id >= 0 && id < static_cast<vtkIdType>(this->Count) ? id : -1;
  }
  const auto found = std::lower_bound(this->Ids.begin(), this->Ids.end(), id,
    [](std::uint32_t kept, vtkIdType sought) { return static_cast<vtkIdType>(kept) < sought; });
  const bool isKept = found != this->Ids.end() && static_cast<vtkIdType>(*found) == id;
  return isKept ? found - this->Ids.begin() : -1;
}

//------------------------------------------------------------------------------
SkdPolyCell SkdCellStore::GatherPoly(std::uint32_t cell) const
{
  thread_local std::vector<skd::Vector3> points; // grown to the largest cell met
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
skd::Box3 SkdCellStore::BoundsOf(std::uint32_t cell) const
{
  skd::Box3 bounds;
  const std::uint32_t* ids = this->PointIdsOf(cell);
  const std::uint32_t size = this->SizeOf(cell);
  for (std::uint32_t i = 0; i < size; ++i)
  {
    bounds.Add(this->Point(ids[i]));
  }
  return bounds;
}

//------------------------------------------------------------------------------
skd::Box3 SkdCellStore::ReachOf(std::uint32_t cell) const
{
  const skd::Box3 bounds = this->BoundsOf(cell);
  if (this->Reaches.empty())
  {
    return bounds;
  }
  const double factor = this->Reaches[cell];
  const skd::Vector3 centre = bounds.Centroid();
  return { centre + factor * (bounds.Min - centre), centre + factor * (bounds.Max - centre) };
}

//------------------------------------------------------------------------------
std::size_t SkdCellStore::MemorySize() const
{
  return this->Ids.capacity() * sizeof(std::uint32_t) + this->Shapes.capacity() +
    this->Offsets.capacity() * sizeof(std::uint64_t) +
    this->PointIds.capacity() * sizeof(std::uint32_t) +
    this->FaceOffsets.capacity() * sizeof(std::uint64_t) +
    this->FaceStream.capacity() * sizeof(std::uint32_t) + this->Reaches.capacity() * sizeof(float) +
    this->OwnPoints.capacity() * sizeof(double);
}
