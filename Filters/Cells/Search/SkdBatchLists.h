// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBatchLists_h
#define SkdBatchLists_h

#include "Cells/Search/SkdBatch.h"

#include "vtkIdTypeArray.h"
#include "vtkNew.h"

#include <vector>

namespace skdtree
{
/// What SkdBatchLists calls for queries that are answered one by one: find(slot, values).
template <class Find>
auto SkdOneByOne(const SkdBatch& batch, const Find& find)
{
  return [&batch, find](vtkIdType piece, auto& values, const auto& close)
  {
    batch.ForEachIn(piece,
      [&](vtkIdType slot)
      {
        find(slot, values);
        close(slot);
      });
  };
}

/// The answers of a batch of queries with several answers each: computed in parallel piece by
/// piece, then concatenated in the order of the slots.
template <class Value>
class SkdBatchLists
{
public:
  /// find(piece, values, close) appends the answers of a piece's queries in turn, and calls
  /// close(slot) after those of each. `offsets` gets, for slot i, tuples i and i + 1: the first of
  /// its values, and one past the last. It may be nullptr.
  template <class Find>
  SkdBatchLists(const SkdBatch& batch, vtkIdTypeArray* offsets, const Find& find)
    : Batch(batch)
    , Pieces(static_cast<std::size_t>(batch.GetNumberOfPieces()))
  {
    vtkIdTypeArray* array = offsets ? offsets : this->OwnOffsets.Get();
    array->SetName("SkdOffsets");
    array->SetNumberOfComponents(1);
    array->SetNumberOfTuples(batch.GetNumberOfQueries() + 1);
    this->Offsets = array->GetPointer(0);
    batch.ForEachPiece(
      [&](vtkIdType piece)
      {
        std::vector<Value>& values = this->Pieces[static_cast<std::size_t>(piece)];
        std::size_t before = 0;
        find(piece, values,
          [&](vtkIdType slot)
          {
            this->Offsets[slot + 1] = static_cast<vtkIdType>(values.size() - before);
            before = values.size();
          });
      });
    this->Offsets[0] = 0;
    for (vtkIdType slot = 0; slot < batch.GetNumberOfQueries(); ++slot)
    {
      this->Offsets[slot + 1] += this->Offsets[slot];
    }
  }

  vtkIdType GetNumberOfValues() const { return this->Offsets[this->Batch.GetNumberOfQueries()]; }

  /// Calls store(index, slot, value) in parallel; indices of a slot are those that its offsets say.
  template <class Store>
  void ForEach(const Store& store) const
  {
    this->Batch.ForEachPiece(
      [&](vtkIdType piece)
      {
        const Value* value = this->Pieces[static_cast<std::size_t>(piece)].data();
        this->Batch.ForEachIn(piece,
          [&](vtkIdType slot)
          {
            for (vtkIdType i = this->Offsets[slot]; i < this->Offsets[slot + 1]; ++i)
            {
              store(i, slot, *value++);
            }
          });
      });
  }

private:
  const SkdBatch& Batch;
  std::vector<std::vector<Value>> Pieces;
  vtkNew<vtkIdTypeArray> OwnOffsets; // for those who want none
  vtkIdType* Offsets;
};
}

#endif
