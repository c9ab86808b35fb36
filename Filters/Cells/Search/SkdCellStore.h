// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCellStore_h
#define SkdCellStore_h

#include "Cells/Kernels/SkdPolyCell.h"
#include "Cells/Read/SkdMagnitudes.h"
#include "Cells/Search/SkdMeshExtent.h"
#include "Cells/Search/SkdUniformCells.h"
#include "Core/Geometry/Box.h"
#include "Core/Geometry/CellPoints.h"
#include "Core/Search/Tree/RawVector.h"

#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkDataSet;
class vtkGenericCell;

namespace skdtree
{
class SkdCellReader;

/// The cells of a data set for the kernels: its points where they are stored, if as floats or
/// doubles, 32-bit connectivity, no virtual call. Cells that no query may return are omitted; the
/// others are numbered 0 .. N-1 in the order of their ids. Immutable; it keeps no reference to the
/// data set.
class SkdCellStore
{
public:
  struct LeftOutCounts
  {
    vtkIdType NotFinite = 0; ///< cells with points that are not finite, or too large
    vtkIdType Other = 0;     ///< ghost, blanked, empty, of unknown type
  };

  /// `data` may be nullptr; it has no broken cells (SkdRepairedMesh.h). Throws std::length_error
  /// when there are more cells or points than 32-bit numbers can count.
  SkdCellStore(vtkDataSet* data, bool skipGhosts, const SkdMagnitudes& magnitudes)
    : SkdCellStore(data, SkdReadUniformCells(data), skipGhosts, magnitudes)
  {
  }
  /// `uniform`: what SkdReadUniformCells() returns of `data`.
  SkdCellStore(
    vtkDataSet* data, SkdUniformCells&& uniform, bool skipGhosts, const SkdMagnitudes& magnitudes);

  /// Some cells of another store, ascending, which must outlive this one: it has the points.
  SkdCellStore(const SkdCellStore& whole, const std::vector<std::uint32_t>& cells);
  SkdCellStore(SkdCellStore&&) = default;
  SkdCellStore(const SkdCellStore&) = delete; // the points may be its own
  SkdCellStore& operator=(const SkdCellStore&) = delete;

  std::uint32_t NumberOfCells() const { return this->Count; }
  const LeftOutCounts& LeftOut() const { return this->Missing; }

  /// VTK's id of a stored cell, and the inverse: -1 for omitted cells and ids out of range.
  vtkIdType IdOf(std::uint32_t cell) const
  {
    return this->Ids.empty() ? static_cast<vtkIdType>(cell)
                             : static_cast<vtkIdType>(this->Ids[cell]);
  }
  std::int64_t CellOfId(vtkIdType id) const
  {
    return !this->Ids.empty()                               ? this->FindCellOfId(id)
      : id >= 0 && id < static_cast<vtkIdType>(this->Count) ? id
                                                            : -1;
  }

  bool IsAllOf(SkdShape shape) const { return this->Shapes.empty() && this->CommonShape == shape; }
  SkdShape ShapeOf(std::uint32_t cell) const
  {
    return this->Shapes.empty() ? this->CommonShape : this->Shapes[cell];
  }

  const std::uint32_t* PointIdsOf(std::uint32_t cell) const
  {
    return this->PointIds.data() +
      (this->Offsets.empty() ? std::uint64_t(cell) * this->CommonSize : this->Offsets[cell]);
  }
  std::uint32_t SizeOf(std::uint32_t cell) const
  {
    return this->Offsets.empty()
      ? this->CommonSize
      : static_cast<std::uint32_t>(this->Offsets[cell + 1] - this->Offsets[cell]);
  }

  vtkIdType GetNumberOfPoints() const { return this->NumberOfPoints; } ///< in use or not
  skd::Vector3 Point(std::uint32_t pointId) const { return this->Points.At(pointId); }

  const skd::PointArray& AllPoints() const { return this->Points; }

  /// Whether all coordinates are exact in single precision.
  bool HasFloatPoints() const { return this->Points.Floats != nullptr; }

  template <int Size>
  void Gather(std::uint32_t cell, skd::Vector3 (&points)[Size]) const
  {
    const std::uint32_t* ids = this->PointIdsOf(cell);
    for (int i = 0; i < Size; ++i)
    {
      points[i] = this->Point(ids[i]);
    }
  }

  /// A cell with a variable number of points, in a thread-local buffer that is valid until the next
  /// call.
  SkdPolyCell GatherPoly(std::uint32_t cell) const;

  /// Makes a VTK cell this one, with VTK's type, point ids and points. False if it needs more than
  /// these: a polyhedron, say.
  bool Load(std::uint32_t cell, vtkGenericCell* loaded) const;

  /// The box of the cell's points: what vtkDataSet::GetCellBounds gives.
  skd::Box3 BoundsOf(std::uint32_t cell) const
  {
    const std::uint32_t* id = this->PointIdsOf(cell);
    const std::uint32_t* const end = id + this->SizeOf(cell);
    skd::Vector3 low = this->Point(*id);
    skd::Vector3 high = low;
    while (++id < end)
    {
      const skd::Vector3 x = this->Point(*id);
      low = skd::Least(low, x);
      high = skd::Greatest(high, x);
    }
    return { low, high };
  }

  /// The box that contains the cell: curved cells extend beyond the box of their points.
  skd::Box3 ExtentOf(std::uint32_t cell) const
  {
    return this->CurvedExtents.empty() ? this->BoundsOf(cell) : this->CurvedExtentOf(cell);
  }
  /// The points of all cells; all but curved cells are in the box of theirs.
  skd::CellPoints PointsOfCells() const
  {
    return { this->Points, this->PointIds.data(),
      this->Offsets.empty() ? nullptr : this->Offsets.data(), this->CommonSize };
  }
  bool HasCurvedExtents() const { return !this->CurvedExtents.empty(); }

  /// The box that contains all cells.
  const skd::Box3& GetBounds() const { return this->Bounds; }
  SkdMeshExtent GetExtent() const { return { this->Bounds, this->Largest }; }

  /// The points that are read where they are stored, if that is not this data set; else nullptr.
  vtkPoints* PointsOfAnother(vtkDataSet* data) const;

  /// Bytes of everything that is kept, without points shared with the data set.
  std::size_t MemorySize() const;

private:
  ///@{
  /// SkdCellStoreRead.cxx.
  void ReadPoints(vtkDataSet* data);
  bool ArePointsFinite();
  void ReadCells(const SkdCellReader& reader, vtkDataSet* data, bool skipGhosts);
  template <class Id>
  bool ArePointsFinite(const Id* ids, std::size_t size) const;
  void SizeFor(std::uint32_t cells, std::uint64_t pointIds, SkdShape least, SkdShape most);
  template <class Id>
  void Put(std::uint32_t cell, vtkIdType id, SkdShape shape, std::uint64_t first, const Id* ids,
    std::size_t size);
  template <class Id>
  void PutPoints(std::uint64_t first, const Id* ids, std::size_t size);
  ///@}

  std::int64_t FindCellOfId(vtkIdType id) const;
  void ReadFaces(vtkDataSet* data);
  void ReadCurvedExtents(vtkDataSet* data);
  void Compact();
  void FindBounds();
  void Take(SkdUniformCells&& uniform);
  skd::Box3 CurvedExtentOf(std::uint32_t cell) const;

  SkdMagnitudes Magnitudes;
  std::uint32_t Count = 0;
  LeftOutCounts Missing;
  skd::RawVector<std::uint32_t> Ids;     // empty when no cell is left out
  skd::RawVector<SkdShape> Shapes;       // empty when all cells have one shape
  skd::RawVector<std::uint64_t> Offsets; // empty when all cells have one fixed size
  skd::RawVector<std::uint32_t> PointIds;
  std::vector<std::uint64_t> FaceOffsets; // empty when no cell is a polyhedron, as FaceStream
  std::vector<std::uint32_t> FaceStream;
  std::vector<float> CurvedExtents; // empty when no cell is curved
  SkdShape CommonShape = SkdShape::None;
  std::uint32_t CommonSize = 0;
  double Largest = 0.0;
  skd::Box3 Bounds;

  skd::PointArray Points;
  vtkIdType NumberOfPoints = 0;
  vtkSmartPointer<vtkPoints> SharedPoints;         // the data set's own if floats or doubles
  vtkSmartPointer<vtkDataArray> SharedCoordinates; // of these, whatever they are given later
  skd::RawVector<double> OwnPoints;
};
}

#endif
