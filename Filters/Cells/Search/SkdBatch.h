// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBatch_h
#define SkdBatch_h

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

namespace skdtree
{
/// The meaning of a query's components.
enum class SkdBatchOf
{
  Points, ///< x, y, z
  Lines,  ///< those of one end, then those of the other
  Boxes,  ///< xmin, xmax, ymin, ymax, zmin, zmax
  Spheres ///< x, y, z, radius
};

inline int SkdNumberOfComponents(SkdBatchOf kind)
{
  return kind == SkdBatchOf::Points ? 3 : kind == SkdBatchOf::Spheres ? 4 : 6;
}

/// The tuples of a numeric array, or of none, read without a virtual call if they are doubles. The
/// array must outlive it. Thread-safe.
class SkdTuples
{
public:
  explicit SkdTuples(vtkDataArray* array)
    : Array(array)
    , Components(array ? array->GetNumberOfComponents() : 0)
  {
    auto* doubles = vtkDoubleArray::FastDownCast(array);
    this->Doubles = doubles ? doubles->GetPointer(0) : nullptr;
  }

  bool IsGiven() const { return this->Array != nullptr; }

  void Read(vtkIdType i, double* tuple) const
  {
    if (this->Doubles)
    {
      std::copy_n(this->Doubles + i * this->Components, this->Components, tuple);
      return;
    }
    this->Array->GetTuple(i, tuple);
  }

private:
  vtkDataArray* Array;
  const double* Doubles; // nullptr of an array of something else
  int Components;
};

/// Many queries of one kind, the tuples of an array, processed in parallel along a Morton curve
/// through their centres, so that data read by one query are still in the processor's caches for
/// the next. Queries that are not finite come last. Long lines are processed as they come. The
/// order and its pieces depend only on the queries, not on the number of threads.
///
/// 8 bytes and some ten nanoseconds a query that is sorted.
class SkdBatch
{
public:
  /// The number of consecutive queries for one thread.
  static constexpr vtkIdType PieceSize = 256;

  /// The array must outlive it and have the right number of components. Unless `isSorted`, queries
  /// are processed as they come.
  SkdBatch(vtkDataArray* queries, SkdBatchOf kind, bool isSorted = true);

  /// Lines from two arrays of the same length, of 3 components each.
  SkdBatch(vtkDataArray* starts, vtkDataArray* ends, bool isSorted);

  vtkIdType GetNumberOfQueries() const { return this->Count; }
  vtkIdType GetNumberOfPieces() const { return (this->Count + PieceSize - 1) / PieceSize; }

  /// The tuple of a slot. Thread-safe.
  void Read(vtkIdType slot, double* tuple) const { this->Queries.Read(slot, tuple); }

  /// The same for a query of any kind, and for lines from two arrays.
  void ReadWithEnds(vtkIdType slot, double (&tuple)[6]) const
  {
    this->Read(slot, tuple);
    if (this->Ends.IsGiven())
    {
      this->Ends.Read(slot, tuple + 3);
    }
  }

  /// One past the last index of the order that is in a piece.
  vtkIdType EndOf(vtkIdType piece) const { return std::min(this->Count, (piece + 1) * PieceSize); }

  /// The slot at an index of the order.
  vtkIdType GetSlot(vtkIdType at) const
  {
    return this->Order.empty() ? at : static_cast<vtkIdType>(this->Order[at]);
  }

  /// Calls body(piece) in parallel.
  template <class Body>
  void ForEachPiece(const Body& body) const
  {
    vtkSMPTools::For(0, this->GetNumberOfPieces(), 1,
      [&body](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType piece = begin; piece < end; ++piece)
        {
          body(piece);
        }
      });
  }

  /// Calls body(state, slot) for all queries in parallel, and counts how often it returns true.
  /// Each piece has its own state, from makeState().
  template <class MakeState, class Body>
  vtkIdType CountTrue(const MakeState& makeState, const Body& body) const
  {
    std::atomic<vtkIdType> total(0);
    this->ForEachPiece(
      [&](vtkIdType piece)
      {
        auto state = makeState();
        vtkIdType count = 0;
        this->ForEachIn(piece, [&](vtkIdType slot) { count += body(state, slot) ? 1 : 0; });
        total += count;
      });
    return total;
  }

  /// Calls body(slot) for the queries of a piece, in their order.
  template <class Body>
  void ForEachIn(vtkIdType piece, const Body& body) const
  {
    const vtkIdType end = this->EndOf(piece);
    for (vtkIdType at = piece * PieceSize; at < end; ++at)
    {
      body(this->GetSlot(at));
    }
  }

  /// The same of up to `Most` at once: calls body(slots, count).
  template <int Most, class Body>
  void ForEachFewIn(vtkIdType piece, const Body& body) const
  {
    vtkIdType slots[Most];
    int count = 0;
    this->ForEachIn(piece,
      [&](vtkIdType slot)
      {
        slots[count++] = slot;
        if (count == Most)
        {
          body(slots, count);
          count = 0;
        }
      });
    if (count > 0)
    {
      body(slots, count);
    }
  }

private:
  void Arrange();
  /// Of lines: in the mean of some of them at most half as long as the box of their centres.
  bool AreShort() const;
  void SortByCount(const std::vector<std::uint32_t>& keys, std::uint32_t largestKey);

  SkdTuples Queries;
  SkdTuples Ends; // of lines whose ends are in an array of their own
  SkdBatchOf Kind;
  vtkIdType Count;
  std::vector<std::uint32_t> Order; // slots; empty: as they come
};
}

#endif
