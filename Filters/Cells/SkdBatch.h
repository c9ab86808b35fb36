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

/// What the components of a query are.
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

/// The tuples of an array of numbers, read without a virtual call if these are doubles. The array
/// must live. Thread-safe.
class SkdTuples
{
public:
  explicit SkdTuples(vtkDataArray* array)
    : Array(array)
    , Components(array->GetNumberOfComponents())
  {
    auto* doubles = vtkDoubleArray::FastDownCast(array);
    this->Doubles = doubles ? doubles->GetPointer(0) : nullptr;
  }

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

/// Many queries of one kind, the tuples of an array, asked in parallel in an order in which
/// neighbours in space follow each other: along a Morton curve through their centres. So a query
/// finds in the processor's caches what the one before has read. Queries that are not finite come
/// last. The order, and its pieces, depend on the queries alone, not on the number of threads.
///
/// 8 bytes and some ten nanoseconds a query.
class SkdBatch
{
public:
  /// So many queries that follow each other are one thread's.
  static constexpr vtkIdType PieceSize = 256;

  /// The array must live, and have the right number of components.
  SkdBatch(vtkDataArray* queries, SkdBatchOf kind);

  vtkIdType GetNumberOfQueries() const { return this->Count; }
  vtkIdType GetNumberOfPieces() const { return (this->Count + PieceSize - 1) / PieceSize; }

  /// The tuple of a slot. Thread-safe.
  void Read(vtkIdType slot, double* tuple) const { this->Queries.Read(slot, tuple); }

  /// The slot at a place of the order.
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

  /// Calls body(state, slot) for all queries in parallel, and counts how often that is true. Each
  /// piece has a state of its own, from makeState().
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
    const vtkIdType end = std::min(this->Count, (piece + 1) * PieceSize);
    for (vtkIdType at = piece * PieceSize; at < end; ++at)
    {
      body(this->GetSlot(at));
    }
  }

private:
  void Arrange();
  void SortByCount(const std::vector<std::uint32_t>& keys, std::uint32_t largestKey);

  SkdTuples Queries;
  SkdBatchOf Kind;
  vtkIdType Count;
  std::vector<std::uint32_t> Order; // slots; empty: as they come
};

#endif
